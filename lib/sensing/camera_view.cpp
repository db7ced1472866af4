// SPDX-License-Identifier: MIT
// Distortion bends the borders of the image, so the directions that a camera sees are no pyramid.
// What other code asks for is a pyramid that surely contains them: found by sampling the borders
// and adding the most by which a smooth curve can leave the chords between samples.
#include "sensing/camera_view.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stig::sensing {

namespace {

constexpr int kSteps = 64;              ///< of an image border
constexpr double kSameWay = 1e-9;       ///< of the normalised image plane
constexpr double kOnBorder = 1e-9;      ///< pixels and metres: what arithmetic may add
constexpr double kMostDirection = 1e3;  ///< slope: cameras see less than 180 degrees

bool is_distorted(const CameraIntrinsics& c) {
  const auto& s = c.thin_prism;
  for (const double k : {c.k1, c.k2, c.k3, c.k4, c.k5, c.k6, c.p1, c.p2, s[0], s[1], s[2], s[3]}) {
    if (k != 0) return true;
  }
  return false;
}

/// One coordinate of the directions along a border: their range, and how much a border may
/// bulge between two samples, at most an eighth of their second difference.
struct Range {
  double low = INFINITY, high = -INFINITY, bulge = 0;
  double last = NAN, before = NAN;

  void add(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
    const double bend = std::abs(v - 2 * last + before);
    // NAN in the first two samples of a border makes this comparison false, as it should.
    if (bend > bulge) bulge = bend;
    before = last;
    last = v;
  }
  void start_border() { last = before = NAN; }
};

/// Adds the directions of the border from a to b; false when one has none.
bool add_border(const CameraIntrinsics& camera, ImagePoint a, ImagePoint b, Range& x, Range& y) {
  x.start_border();
  y.start_border();
  for (int i = 0; i <= kSteps; ++i) {
    const double t = double(i) / kSteps;
    const auto way = unproject(camera, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    if (!way || !(std::abs(way->x) + std::abs(way->y) < kMostDirection)) return false;
    x.add(way->x);
    y.add(way->y);
  }
  return true;
}

bool is_sensible(const CameraIntrinsics& c, double near, double far) {
  return c.width > 0 && c.height > 0 && c.fx > 0 && c.fy > 0 && std::isfinite(c.fx) &&
         std::isfinite(c.fy) && std::isfinite(c.cx) && std::isfinite(c.cy) && near > 0 &&
         near < far && std::isfinite(far);
}

}  // namespace

std::optional<CameraView> make_view(const CameraIntrinsics& intrinsics, double near, double far) {
  if (!is_sensible(intrinsics, near, far)) return std::nullopt;
  const double right = intrinsics.width - 0.5, bottom = intrinsics.height - 0.5;
  const std::array<ImagePoint, 5> corners = {
      {{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}, {-0.5, -0.5}}};
  Range x, y;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!add_border(intrinsics, corners[i], corners[i + 1], x, y)) return std::nullopt;
  }
  return CameraView{intrinsics,
                    near,
                    far,
                    {x.low - x.bulge - kSameWay, y.low - y.bulge - kSameWay, 1},
                    {x.high + x.bulge + kSameWay, y.high + y.bulge + kSameWay, 1},
                    is_distorted(intrinsics)};
}

// A point on the border belongs to the image, although its last bit may say otherwise after a
// projection.
bool inside_image(const CameraIntrinsics& camera, const ImagePoint& pixel) {
  constexpr double kLeast = -0.5 - kOnBorder;
  return pixel.x >= kLeast && pixel.x <= camera.width - 0.5 + kOnBorder && pixel.y >= kLeast &&
         pixel.y <= camera.height - 0.5 + kOnBorder;
}

std::optional<ImagePoint> image_of(const CameraView& view, const Vec3& p_C) {
  if (!(p_C.z >= view.near - kOnBorder && p_C.z <= view.far + kOnBorder)) return std::nullopt;
  const Vec3 way{p_C.x / p_C.z, p_C.y / p_C.z, 1};
  // The cheap test first: most points of a scene are far outside, and need no distortion for that.
  if (!(way.x >= view.low.x && way.x <= view.high.x && way.y >= view.low.y &&
        way.y <= view.high.y)) {
    return std::nullopt;
  }
  const auto pixel = project(view.intrinsics, p_C);
  if (!pixel || !inside_image(view.intrinsics, *pixel)) return std::nullopt;
  // The formula is a polynomial in r², not a lens: far outside it may turn round and lead back into
  // the image. A point that is really seen survives the way there and back.
  if (view.distorted) {
    const auto back = unproject(view.intrinsics, *pixel);
    if (!back || !(length(*back - way) < kSameWay)) return std::nullopt;
  }
  return pixel;
}

std::array<Vec3, 8> frustum_corners(const CameraView& view) {
  assert(view.near > 0 && view.near < view.far);
  std::array<Vec3, 8> out;
  const std::array<Vec3, 4> ways = {{{view.low.x, view.low.y, 1},
                                     {view.high.x, view.low.y, 1},
                                     {view.high.x, view.high.y, 1},
                                     {view.low.x, view.high.y, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    out[i] = ways[i] * view.near;
    out[i + 4] = ways[i] * view.far;
  }
  return out;
}

}  // namespace stig::sensing
