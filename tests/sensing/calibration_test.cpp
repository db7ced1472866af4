// SPDX-License-Identifier: MIT
// A camera's intrinsics come back from pictures that were taken through it: asymmetric circles
// in several poses, centres found in the pixels, and a least-squares fit that shares nothing with
// lib/sensing.
#include <doctest/doctest.h>

#include <array>

#include "sensing/camera_picture.h"
#include "support.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr int kRows = 11, kColumns = 4;
constexpr double kPitch = 0.010, kRadius = 0.003;  ///< m
constexpr std::size_t kCircles = std::size_t(kRows) * kColumns;

/// Centres of the pattern, about the middle of the sheet.
std::array<Vec3, kCircles> circles() {
  std::array<Vec3, kCircles> out;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      out[std::size_t(row * kColumns + column)] = {
          (row - (kRows - 1) / 2.0) * kPitch, (2 * column + row % 2 - kColumns + 0.5) * kPitch, 0};
    }
  }
  return out;
}

bool is_dark(double x, double y) {
  const int row = int(std::lround(x / kPitch + (kRows - 1) / 2.0));
  if (row < 0 || row >= kRows) return false;
  const long column = std::lround((y / kPitch + kColumns - 0.5 - row % 2) / 2);
  if (column < 0 || column >= kColumns) return false;
  static const auto kCentres = circles();
  const Vec3& c = kCentres[std::size_t(row * kColumns + column)];
  return (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y) < kRadius * kRadius;
}

CameraPicture sheet_picture(const CameraIntrinsics& camera, const Pose& X_CT) {
  CameraPicture picture(camera, {230, 230, 230});
  std::vector<ImagePoint> points;
  const auto centres = circles();
  for (const Vec3& c : centres) {
    for (const double way : {-1.0, 1.0}) {
      points.push_back(*project(camera, X_CT * (c + Vec3{way * kRadius, 0, 0})));
      points.push_back(*project(camera, X_CT * (c + Vec3{0, way * kRadius, 0})));
    }
  }
  paint(picture, camera, box_about(picture, points), 2, [&](const Vec3& way, const Vec3& ground) {
    const PlaneHit hit = meet_plane(X_CT, way);
    return hit.depth > 0 && is_dark(hit.x, hit.y) ? Vec3{20, 20, 20} : ground;
  });
  for (Vec3& p : picture.pixels) p = {std::round(p.x), std::round(p.y), std::round(p.z)};
  return picture;
}

/// Centre of darkness about a place where a circle is known to be: neighbours are farther.
ImagePoint dark_centre(const CameraPicture& picture, const ImagePoint& about, double reach) {
  double sx = 0, sy = 0, s = 0;
  const PixelBox box =
      box_about(picture, {{about.x - reach, about.y - reach}, {about.x + reach, about.y + reach}});
  for (int y = box.y0; y <= box.y1; ++y) {
    for (int x = box.x0; x <= box.x1; ++x) {
      if (std::hypot(x - about.x, y - about.y) > reach) continue;
      const double w = 230 - picture.grey(x, y);
      sx += w * x, sy += w * y, s += w;
    }
  }
  return {sx / s, sy / s};
}

constexpr std::size_t kViews = 8, kOwn = 7;  ///< fx fy cx cy k1 k2 p1
constexpr std::size_t kUnknowns = kOwn + 6 * kViews;
using Vector = std::vector<double>;

/// Residuals, written from OpenCV's formulas.
Vector residuals(const Vector& p, const std::vector<std::array<ImagePoint, kCircles>>& seen) {
  Vector out;
  const auto centres = circles();
  for (std::size_t view = 0; view < kViews; ++view) {
    const double* v = &p[kOwn + 6 * view];
    const Quat turn = rotation({v[0], v[1], v[2]});
    for (std::size_t i = 0; i < kCircles; ++i) {
      const Vec3 c = rotate(turn, centres[i]) + Vec3{v[3], v[4], v[5]};
      const double x = c.x / c.z, y = c.y / c.z, r2 = x * x + y * y;
      const double radial = 1 + p[4] * r2 + p[5] * r2 * r2;
      const double u = p[0] * (x * radial + 2 * p[6] * x * y) + p[2];
      const double w = p[1] * (y * radial + p[6] * (r2 + 2 * y * y)) + p[3];
      out.push_back(u - seen[view][i].x);
      out.push_back(w - seen[view][i].y);
    }
  }
  return out;
}

double cost(const Vector& r) {
  double sum = 0;
  for (const double e : r) sum += e * e;
  return sum;
}

/// (A + damping · diag A) x = b by elimination; A positive definite.
Vector solve(std::vector<Vector> a, Vector b, double damping) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) a[i][i] *= 1 + damping;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t r = i + 1; r < n; ++r) {
      const double f = a[r][i] / a[i][i];
      if (f == 0) continue;
      for (std::size_t j = i; j < n; ++j) a[r][j] -= f * a[i][j];
      b[r] -= f * b[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return b;
}

/// One round of Levenberg's and Marquardt's method with numeric derivatives.
bool improve(Vector& p, double& damping,
             const std::vector<std::array<ImagePoint, kCircles>>& seen) {
  const Vector r = residuals(p, seen);
  std::vector<Vector> columns;
  for (std::size_t k = 0; k < kUnknowns; ++k) {
    Vector moved = p;
    const double step = k < 4 ? 1e-3 : 1e-6;
    moved[k] += step;
    Vector d = residuals(moved, seen);
    for (std::size_t i = 0; i < d.size(); ++i) d[i] = (d[i] - r[i]) / step;
    columns.push_back(std::move(d));
  }
  std::vector<Vector> a(kUnknowns, Vector(kUnknowns));
  Vector b(kUnknowns);
  for (std::size_t k = 0; k < kUnknowns; ++k) {
    for (std::size_t i = 0; i < r.size(); ++i) b[k] -= columns[k][i] * r[i];
    for (std::size_t l = 0; l < kUnknowns; ++l) {
      for (std::size_t i = 0; i < r.size(); ++i) a[k][l] += columns[k][i] * columns[l][i];
    }
  }
  const Vector step = solve(a, b, damping);
  Vector tried = p;
  for (std::size_t k = 0; k < kUnknowns; ++k) tried[k] += step[k];
  const double before = cost(r), after = cost(residuals(tried, seen));
  damping *= after < before ? 0.1 : 10;
  if (after < before) p = tried;
  return !(after < before && before - after < 1e-9 * before);
}

/// The sheet's pose in a view, as a turn and a place.
std::array<double, 6> sheet_pose(std::size_t view) {
  const double a = 2 * std::numbers::pi * double(view) / kViews;
  return {0.45 * std::cos(a),     0.45 * std::sin(a),      0.2 * std::sin(3 * a),
          0.03 * std::sin(2 * a), 0.005 * std::cos(5 * a), 0.27 + 0.02 * std::cos(a)};
}
Pose pose_of(const std::array<double, 6>& v) {
  return {{v[3], v[4], v[5]}, rotation({v[0], v[1], v[2]})};
}

}  // namespace

TEST_CASE("pictures of circles give the camera's intrinsics back within one per cent") {
  CameraIntrinsics camera = paper_camera();
  camera.fy = 890;
  camera.cx = 312;
  camera.cy = 184;
  camera.k1 = -0.28;
  camera.k2 = 0.12;
  camera.p1 = 0.004;
  std::vector<std::array<ImagePoint, kCircles>> seen(kViews);
  Vector p = {800, 800, 319.5, 179.5, 0, 0, 0};  // what one would guess
  for (std::size_t view = 0; view < kViews; ++view) {
    const auto truth = sheet_pose(view);
    const Pose X_CT = pose_of(truth);
    const CameraPicture picture = sheet_picture(camera, X_CT);
    const auto centres = circles();
    for (std::size_t i = 0; i < kCircles; ++i) {
      const double reach = 1.45 * kRadius * camera.fx / truth[5];
      seen[view][i] = dark_centre(picture, *project(camera, X_CT * centres[i]), reach);
    }
    for (std::size_t k = 0; k < 6; ++k) p.push_back(truth[k] + (k < 3 ? 0.05 : 0.005));
  }
  double damping = 1e-3;
  for (int round = 0; round < 60 && improve(p, damping, seen); ++round) {
  }
  CHECK(std::sqrt(cost(residuals(p, seen)) / double(kViews * kCircles)) < 0.1);  // px
  CHECK(p[0] == doctest::Approx(camera.fx).epsilon(0.01));
  CHECK(p[1] == doctest::Approx(camera.fy).epsilon(0.01));
  CHECK(p[2] == doctest::Approx(camera.cx).epsilon(0.01));
  CHECK(p[3] == doctest::Approx(camera.cy).epsilon(0.01));
  // Distortion at the image's corner, where it is 12 px.
  const double r2 = 0.13 + 0.04;
  const double bend = camera.k1 * r2 + camera.k2 * r2 * r2;
  CHECK(p[4] * r2 + p[5] * r2 * r2 == doctest::Approx(bend).epsilon(0.03));
  CHECK(std::abs(p[6] - camera.p1) < 5e-4);
}
