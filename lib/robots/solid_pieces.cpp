// SPDX-License-Identifier: MIT
// All pieces have their frame in the solid's middle of mass, so that their masses and moments add
// up without any shift. A body's moments are about its own axes, and devices are measured along the
// file's: of a solid whose principal axes are others, the first piece has moments that are alike
// about all axes, and the others, turned, what is left.
#include "robots/solid_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include "base/hull.h"

namespace stig::robots {

namespace {

/// Products below this part of the moments are rounding.
constexpr double kAskew = 1e-9;

Vec3 moments_from(const Vec3& squares) {
  return {squares.y + squares.z, squares.x + squares.z, squares.x + squares.y};
}

/// How far a ball about the origin reaches before it leaves the hull of the points.
double room_within(const std::vector<Vec3>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (const HullFace& face : hull_faces(points)) {
    least = std::min(least, dot(face.normal, points[face.corners[0]]));
  }
  return least;
}

class Split {
 public:
  Split(BodyModel whole, const SolidModel& solid) : solid_(solid) {
    mass_ = whole.mass;
    moments_ = whole.inertia;
    whole.visual = std::make_shared<VisualMesh>(surface());
    for (const std::vector<Vec3>& corners : solid.pieces) add_piece(whole, corners);
  }

  std::vector<BodyModel> bodies() {
    const Vec3& o = solid_.products;
    const double most = std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)});
    const Vec3& s = solid_.squares;
    if (moments_ || most <= kAskew * (s.x + s.y + s.z)) {
      share(moments_ ? *moments_ : moments_from(s) * mass_, 0);
    } else {
      share_askew(principal_frame(s, o));
    }
    return std::move(out_);
  }

 private:
  VisualMesh surface() const {
    VisualMesh out = solid_.surface;
    for (Vec3& p : out.points) p -= solid_.centre;
    return out;
  }

  void add_piece(const BodyModel& whole, const std::vector<Vec3>& corners) {
    out_.push_back(whole);
    BodyModel& piece = out_.back();
    piece.points = corners;
    for (Vec3& p : piece.points) p -= solid_.centre;
    // Without a surface the pieces are looked at themselves.
    if (solid_.surface.triangles.empty()) piece.visual = nullptr;
    if (out_.size() == 1) return;
    piece.name = fmt::format("{} piece {}", whole.name, out_.size());
    if (piece.visual) piece.visual = std::make_shared<VisualMesh>();
  }

  /// Mass and moments of the bodies from the first on, by their volumes.
  void share(const Vec3& moments, std::size_t first) {
    std::vector<double> volumes;
    for (std::size_t i = first; i < out_.size(); ++i) volumes.push_back(volume_of(out_[i]));
    const double all = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    for (std::size_t i = first; i < out_.size(); ++i) {
      const double part = volumes[i - first] / all;
      out_[i].mass = mass_ * part;
      out_[i].inertia = moments * part;
    }
  }

  void share_askew(const PrincipalFrame& frame) {
    const Vec3 all = moments_from(frame.squares) * mass_;
    if (out_.size() == 1) add_core();
    // A quarter of what each moment is less than the other two together: neither part is then a
    // body that cannot be.
    const double spare = all.x + all.y + all.z - 2 * std::max({all.x, all.y, all.z});
    const Vec3 alike = Vec3{1, 1, 1} * (spare / 4);
    const double whole = mass_;
    mass_ = whole / 2;
    share(all - alike, 1);
    mass_ = whole;
    out_[0].mass = whole / 2;
    out_[0].inertia = alike;
    for (std::size_t i = 1; i < out_.size(); ++i) {
      out_[i].X_RB.q = normalised(out_[i].X_RB.q * frame.q);
      for (Vec3& p : out_[i].points) p = rotate(conjugate(frame.q), p);
    }
  }

  /// A ball within a single piece, which touches nothing and has the moments that are left.
  void add_core() {
    BodyModel core = out_[0];
    core.name += " core";
    core.shape = ShapeType::sphere;
    core.size = Vec3{1, 1, 1} * room_within(core.points);
    core.points.clear();
    core.visual = std::make_shared<VisualMesh>();
    out_.push_back(std::move(core));
  }

  const SolidModel& solid_;
  double mass_ = 0;
  std::optional<Vec3> moments_;
  std::vector<BodyModel> out_;
};

}  // namespace

std::vector<BodyModel> pieces_of(BodyModel whole, const SolidModel& solid) {
  assert(!solid.pieces.empty());
  return Split(std::move(whole), solid).bodies();
}

}  // namespace stig::robots
