// SPDX-License-Identifier: MIT
// Pairs whose images may overlap are compared by planes; the order is then that of Kahn
// ("Topological sorting of large networks", 1962), of those that nobody waits for the farthest
// first. Balls have too many faces to look at all of them for a plane that parts, and no need: the
// one across the line between the middles does.
#include "physical/render/painting_order.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>

namespace stig::physics {

namespace {

constexpr double kOverlap = 1e-3;        ///< m, by which bodies that touch may overlap
constexpr std::size_t kMostPlanes = 64;  ///< of a body, which are looked at

struct Plane {
  Vec3 normal;
  double offset = 0;  ///< of the points p with normal · p = offset

  double above(const Vec3& p) const { return dot(normal, p) - offset; }
};

/// A body as the order needs it.
struct Solid {
  std::vector<Vec3> corners;
  std::vector<Plane> planes;
  double low_x = 0, low_y = 0, high_x = 0, high_y = 0;  ///< pixels
  double distance = 0;                                  ///< m, from the eye
};

Solid solid_of(const PictureBody& body, const PictureView& view) {
  Solid out;
  const Mat3 r = matrix(body.X_WB.q);
  const std::vector<SolidFace> faces = body.faces.empty() ? faces_of(body.shape) : body.faces;
  for (const SolidFace& face : faces) {
    for (const Vec3& corner : face.corners) out.corners.push_back(body.X_WB.p + r * corner);
    const Vec3 normal = r * face.normal;
    if (faces.size() <= kMostPlanes)
      out.planes.push_back({normal, dot(normal, out.corners.back())});
  }
  constexpr double kFar = std::numeric_limits<double>::infinity();
  out.low_x = out.low_y = kFar;
  out.high_x = out.high_y = -kFar;
  const Pose X_CW = inverse(view.X_WC);
  for (const Vec3& corner : out.corners) {
    const auto pixel = project(view.camera, X_CW * corner);
    // What is beside the eye may be anywhere.
    if (!pixel) out.low_x = out.low_y = -kFar, out.high_x = out.high_y = kFar;
    if (!pixel) continue;
    out.low_x = std::min(out.low_x, pixel->x), out.high_x = std::max(out.high_x, pixel->x);
    out.low_y = std::min(out.low_y, pixel->y), out.high_y = std::max(out.high_y, pixel->y);
  }
  out.distance = length(body.X_WB.p - view.X_WC.p);
  return out;
}

bool may_overlap(const Solid& a, const Solid& b) {
  return a.low_x <= b.high_x && b.low_x <= a.high_x && a.low_y <= b.high_y && b.low_y <= a.high_y;
}

/// Are all corners of a solid above a plane?
bool is_above(const Plane& plane, const Solid& solid) {
  return std::all_of(solid.corners.begin(), solid.corners.end(),
                     [&](const Vec3& p) { return plane.above(p) > -kOverlap; });
}

/// A plane across the line between the middles, with all of `from` below it and `to` above.
std::optional<Plane> between(const Solid& from, const Solid& to, const Vec3& way) {
  const double size = length(way);
  if (size < 1e-9) return std::nullopt;
  Plane plane{way * (1 / size), 0};
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : from.corners) most = std::max(most, dot(plane.normal, p));
  plane.offset = most;
  return is_above(plane, to) ? std::optional(plane) : std::nullopt;
}

/// May b hide a part of a, and a none of b? Nothing: no plane parts them.
std::optional<bool> is_before(const Solid& a, const Solid& b, const Vec3& way, const Vec3& eye) {
  if (const auto plane = between(a, b, way)) return plane->above(eye) > 0;
  for (const Plane& plane : a.planes) {
    if (is_above(plane, b)) return plane.above(eye) > 0;
  }
  for (const Plane& plane : b.planes) {
    if (is_above(plane, a)) return plane.above(eye) <= 0;
  }
  return std::nullopt;
}

/// Who waits for whom.
struct Waiting {
  std::vector<std::vector<std::size_t>> later;  ///< than each
  std::vector<std::size_t> count;               ///< of those before each

  void add(std::size_t first, std::size_t second) {
    later[first].push_back(second);
    ++count[second];
  }
};

Waiting waiting_among(const std::vector<PictureBody>& bodies, const std::vector<Solid>& solids,
                      const Vec3& eye) {
  Waiting out{std::vector<std::vector<std::size_t>>(solids.size()),
              std::vector<std::size_t>(solids.size())};
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t k = i + 1; k < solids.size(); ++k) {
      if (!may_overlap(solids[i], solids[k])) continue;
      const Vec3 way = bodies[k].X_WB.p - bodies[i].X_WB.p;
      const auto before = is_before(solids[i], solids[k], way, eye);
      if (before.value_or(solids[i].distance > solids[k].distance)) {
        out.add(i, k);
      } else {
        out.add(k, i);
      }
    }
  }
  return out;
}

}  // namespace

std::vector<PictureBody> painting_order(std::vector<PictureBody> bodies, const PictureView& view) {
  std::vector<Solid> solids;
  for (const PictureBody& body : bodies) solids.push_back(solid_of(body, view));
  Waiting waiting = waiting_among(bodies, solids, view.X_WC.p);
  // In a ring nobody is free: then the farthest of all goes first.
  std::set<std::pair<double, std::size_t>> free, held;  // by how near they are
  for (std::size_t i = 0; i < solids.size(); ++i) {
    (waiting.count[i] == 0 ? free : held).insert({-solids[i].distance, i});
  }
  std::vector<PictureBody> out;
  while (!free.empty() || !held.empty()) {
    auto& from = free.empty() ? held : free;
    const std::size_t next = from.begin()->second;
    from.erase(from.begin());
    out.push_back(std::move(bodies[next]));
    for (const std::size_t later : waiting.later[next]) {
      if (waiting.count[later] == 0 || --waiting.count[later] > 0) continue;
      if (held.erase({-solids[later].distance, later}) == 1) {
        free.insert({-solids[later].distance, later});
      }
    }
  }
  return out;
}

}  // namespace stig::physics
