// SPDX-License-Identifier: MIT
// A segment from the place to far outside crosses each surface; a crossing outwards counts 1, one
// inwards -1. Segments that meet an edge or a corner decide nothing, and another one is taken. All
// questions are signs of determinants of the model's own numbers, which CGAL answers exactly.
#include "inside.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <optional>

namespace stig::meshes {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Place = Kernel::Point_3;

/// A triangle of the model by its number.
struct Primitive {
  using Id = std::uint32_t;
  using Point = Place;
  using Datum = Kernel::Triangle_3;
  using Datum_reference = Datum;
  using Shared_data = const Model*;

  Primitive(Id number, const Model& /*model*/) : number_(number) {}
  template <class Iterator>
  Primitive(Iterator at, const Model& /*model*/) : number_(*at) {}
  static Shared_data construct_shared_data(const Model& model) { return &model; }
  Id id() const { return number_; }
  static Place corner(const Model& model, Id number, std::size_t i) {
    const auto& p = model.points[model.triangles[number][i]];
    return {p[0], p[1], p[2]};
  }
  Datum datum(Shared_data model) const {
    return {corner(*model, number_, 0), corner(*model, number_, 1), corner(*model, number_, 2)};
  }
  Place reference_point(Shared_data model) const { return corner(*model, number_, 0); }

 private:
  Id number_;
};

/// No two of their components are in a simple ratio, so that no edge of a drawing by hand is along
/// them.
constexpr std::array<Point, 8> kDirections{{{0.5773, 0.2113, 0.7887},
                                            {-0.3217, 0.8461, 0.4252},
                                            {0.6791, -0.5519, 0.4839},
                                            {-0.7333, -0.4217, 0.5333},
                                            {0.1387, 0.3851, -0.9123},
                                            {-0.8713, 0.2657, -0.4127},
                                            {0.4421, -0.7919, -0.4211},
                                            {-0.2909, -0.6173, -0.7309}}};

enum class Meeting { none, out, in, surface, unclear };

/// How the segment from p to q meets a triangle.
Meeting meeting(const Kernel::Triangle_3& t, const Place& p, const Place& q) {
  const auto from = CGAL::orientation(t[0], t[1], t[2], p);
  const auto to = CGAL::orientation(t[0], t[1], t[2], q);
  if (from == CGAL::COPLANAR) {
    // A triangle without area has every place in its plane.
    if (t.is_degenerate()) return Meeting::none;
    return t.has_on(p) ? Meeting::surface : Meeting::none;
  }
  if (from == to) return Meeting::none;
  std::array<CGAL::Orientation, 3> sides{};
  for (int i = 0; i < 3; ++i) {
    sides[static_cast<std::size_t>(i)] = CGAL::orientation(p, q, t[i], t[(i + 1) % 3]);
  }
  const auto has = [&](CGAL::Orientation side) {
    return std::find(sides.begin(), sides.end(), side) != sides.end();
  };
  if (has(CGAL::POSITIVE) && has(CGAL::NEGATIVE)) return Meeting::none;
  if (has(CGAL::COPLANAR) || to == CGAL::COPLANAR) return Meeting::unclear;
  return to == CGAL::POSITIVE ? Meeting::out : Meeting::in;
}

}  // namespace

struct Inside::Tree {
  using Search = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  const Model& model;
  Search search;
  double far = 1;

  explicit Tree(const Model& m) : model(m) {
    std::vector<std::uint32_t> numbers(m.triangles.size());
    for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
    search.insert(numbers.begin(), numbers.end(), m);
    search.build();
    const CGAL::Bbox_3 box = search.bbox();
    for (int k = 0; k < 3; ++k) far += 4 * (box.max(k) - box.min(k));
  }

  /// Nothing where the direction decides nothing.
  std::optional<int> winding(const Place& p, const Point& direction) const {
    const Place q(p.x() + far * direction[0], p.y() + far * direction[1],
                  p.z() + far * direction[2]);
    std::vector<std::uint32_t> met;
    search.all_intersected_primitives(Kernel::Segment_3(p, q), std::back_inserter(met));
    int count = 0;
    bool unclear = false;
    for (const std::uint32_t number : met) {
      switch (meeting(Primitive(number, model).datum(&model), p, q)) {
        case Meeting::surface:
          return 1;
        case Meeting::out:
          ++count;
          break;
        case Meeting::in:
          --count;
          break;
        case Meeting::unclear:
          unclear = true;
          break;
        case Meeting::none:
          break;
      }
    }
    return unclear ? std::nullopt : std::optional(count);
  }
};

Inside::Inside(const Model& model) : tree_(std::make_unique<Tree>(model)) {}
Inside::~Inside() = default;

int Inside::winding(const Point& place) const {
  const CGAL::Bbox_3 box = tree_->search.bbox();
  for (int k = 0; k < 3; ++k) {
    const double x = place[static_cast<std::size_t>(k)];
    if (x < box.min(k) || x > box.max(k)) return 0;
  }
  const Place p(place[0], place[1], place[2]);
  // Directions of the list, then others between them: those that meet an edge are of measure 0.
  for (std::size_t i = 0; i < 1000; ++i) {
    Point direction = kDirections[i % kDirections.size()];
    const auto turn = static_cast<double>(i / kDirections.size());
    direction[i % 3] += 0.0137 * turn;
    direction[(i + 1) % 3] -= 0.0071 * turn;
    if (const auto count = tree_->winding(p, direction)) return *count;
  }
  return 0;
}

bool Inside::touches(const Point& low, const Point& high) const {
  return tree_->search.do_intersect(
      Kernel::Iso_cuboid_3(low[0], low[1], low[2], high[0], high[1], high[2]));
}

}  // namespace stig::meshes
