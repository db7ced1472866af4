// SPDX-License-Identifier: MIT
#include "physical/render/scene_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "physical/render/solid_faces.h"

namespace stig::physics {

namespace {

// Fine enough for smooth edges: four samples a pixel.
constexpr int kSamples = 2;         ///< a pixel, along x and y
constexpr double kDarkness = 0.13;  ///< of shadows
constexpr double kNear = 0.01;      ///< m: what is nearer to the eye is cut off
// About 30°: as a long lens sees it, with little distortion towards the borders.
constexpr double kFieldOfView = 0.52;  ///< rad, across the width
constexpr Rgb kFloorColour{238, 240, 243}, kGridColour{203, 209, 216};
constexpr Rgb kEdge{38, 42, 48}, kTagInk{45, 48, 54}, kTagPaper{240, 240, 240};
constexpr double kTagHalf = 0.22, kLedPlace = 0.36, kLedHalf = 0.05;  ///< shares of the side
// Over the shoulder of who looks from the front.
const Vec3 kLight = normalised(Vec3{0.35, -0.55, 0.95});

double shade_of(const Vec3& normal) {
  // Light from above and from one side; what is turned away is not black.
  return std::clamp(0.56 + 0.44 * dot(normal, kLight) + 0.06 * normal.z, 0.3, 1.0);
}
Rgb lit(Rgb colour, const Vec3& normal) { return blend({14, 18, 26}, colour, shade_of(normal)); }

/// Draws polygons of the world as a view sees them. Corners go from the world to the eye, are cut
/// off at the near plane, and only then projected, since what lies behind the eye has no image.
class Painter {
 public:
  Painter(PictureSink& sink, const PictureView& view)
      : sink_(sink), view_(view), r_(matrix(view.X_WC.q)) {}

  /// Faces that do not are left out: that saves half of the work, and keeps them from shining
  /// through edges.
  bool faces_eye(const Vec3& point, const Vec3& normal) const {
    return dot(view_.X_WC.p - point, normal) > 0;
  }

  void polygon(const std::vector<Vec3>& corners, Rgb colour) {
    const auto shown = on_image(corners);
    if (shown.size() > 2) sink_.polygon(shown, colour);
  }
  void shadow(const std::vector<Vec3>& corners) {
    const auto shown = on_image(corners);
    if (shown.size() > 2) sink_.shadow(shown, kDarkness);
  }
  void line(const Vec3& from, const Vec3& to, double width, Rgb colour, double bias) {
    const auto shown = on_image({from, to});
    if (shown.size() > 1) sink_.line(shown[0], shown[1], width, colour, bias);
  }
  /// Pixels across a length that faces the eye at a point.
  double pixels(const Vec3& point, double length) const {
    return view_.camera.fx * length / std::max(kNear, in_eye(point).z);
  }

 private:
  Vec3 in_eye(const Vec3& p_W) const { return r_.transposed(p_W - view_.X_WC.p); }

  /// What of a polygon, or of a line, lies before the eye: Sutherland and Hodgman's algorithm with
  /// a single plane.
  static std::vector<Vec3> clip(const std::vector<Vec3>& corners) {
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      // A line of two corners goes round as a polygon does, there and back: both ends are met.
      const Vec3& a = corners[i];
      const Vec3& b = corners[(i + 1) % corners.size()];
      if (a.z >= kNear) out.push_back(a);
      const bool crosses = (a.z >= kNear) != (b.z >= kNear);
      if (crosses) out.push_back(a + (b - a) * ((kNear - a.z) / (b.z - a.z)));
    }
    return out;
  }

  /// What of corners of the world is seen.
  std::vector<RasterPoint> on_image(const std::vector<Vec3>& corners) const {
    std::vector<Vec3> eye;
    for (const Vec3& corner : corners) eye.push_back(in_eye(corner));
    std::vector<RasterPoint> out;
    for (const Vec3& p : clip(eye)) {
      const auto pixel = project(view_.camera, p);
      out.push_back(pixel ? RasterPoint{pixel->x, pixel->y, 1 / p.z} : RasterPoint{});
    }
    return out;
  }

  PictureSink& sink_;
  const PictureView& view_;
  Mat3 r_;
};

/// Pixels, each from several samples.
class FinePicture final : public PictureSink {
 public:
  FinePicture(int width, int height) : raster_(width * kSamples, height * kSamples, kBackdrop) {}

  void polygon(const std::vector<RasterPoint>& corners, Rgb colour) override {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      raster_.triangle(split(corners[0]), split(corners[i - 1]), split(corners[i]), colour);
    }
  }
  void shadow(const std::vector<RasterPoint>& corners, double darkness) override {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      raster_.shade(split(corners[0]), split(corners[i - 1]), split(corners[i]), darkness);
    }
  }
  void line(const RasterPoint& from, const RasterPoint& to, double width, Rgb colour,
            double bias) override {
    raster_.line(split(from), split(to), width * kSamples, colour, bias);
  }
  Image image() const { return raster_.image(kSamples); }

 private:
  /// The middles of pixels are whole numbers, before and after they are split.
  static RasterPoint split(const RasterPoint& p) {
    const auto part = [](double x) { return (x + 0.5) * kSamples - 0.5; };
    return {part(p.x), part(p.y), p.inverse_depth};
  }

  Raster raster_;
};

std::vector<Vec3> in_world(const Pose& X_WB, const std::vector<Vec3>& points) {
  const Mat3 r = matrix(X_WB.q);
  std::vector<Vec3> out;
  for (const Vec3& p : points) out.push_back(X_WB.p + r * p);
  return out;
}

/// A square in a face's plane, a hair in front of it.
std::vector<Vec3> square(const Vec3& middle, const Vec3& u, const Vec3& v, double half) {
  return {middle + (u + v) * half, middle + (v - u) * half, middle - (u + v) * half,
          middle + (u - v) * half};
}

Rgb glow_of(const PictureBody& body) { return body.glow.value_or(rgb_of(body.led)); }

void draw_block_face(Painter& painter, const std::vector<Vec3>& corners, const Vec3& normal,
                     const PictureBody& body) {
  const Vec3 middle = (corners[0] + corners[2]) * 0.5;
  const double side = length(corners[1] - corners[0]);
  // From far away tags and LEDs would be less than a pixel: noise.
  if (painter.pixels(middle, side) < 14) return;
  const Vec3 u = normalised(corners[0] - corners[1]), v = normalised(corners[1] - corners[2]);
  // The face's own plane would fight for depth with what lies on it.
  const Vec3 above = middle + normal * (side * 0.004);
  painter.polygon(square(above, u, v, side * kTagHalf), lit(kTagPaper, normal));
  painter.polygon(square(above + normal * (side * 0.002), u, v, side * kTagHalf * 0.8),
                  lit(kTagInk, normal));
  const Rgb glow = body.led == Led::off ? lit({120, 124, 130}, normal) : glow_of(body);
  for (const Vec3& way : {u, -u, v, -v}) {
    painter.polygon(square(above + way * (side * kLedPlace), u, v, side * kLedHalf), glow);
  }
}

std::vector<SolidFace> faces_of(const PictureBody& body) {
  return body.faces.empty() ? faces_of(body.shape) : body.faces;
}

void draw_body(Painter& painter, const PictureBody& body) {
  const Mat3 r = matrix(body.X_WB.q);
  // Bodies of blocks take the light of their LEDs, so that colours can be told from afar.
  const Rgb colour =
      body.block && body.led != Led::off ? blend(body.colour, glow_of(body), 0.6) : body.colour;
  for (const SolidFace& face : faces_of(body)) {
    const std::vector<Vec3> corners = in_world(body.X_WB, face.corners);
    const Vec3 normal = r * face.normal;
    if (!painter.faces_eye(corners[0], normal)) continue;
    painter.polygon(corners, lit(colour, normal));
    if (body.block && corners.size() == 4) draw_block_face(painter, corners, normal, body);
    for (std::size_t i = 0; face.edged && i < corners.size(); ++i) {
      painter.line(corners[i], corners[(i + 1) % corners.size()], 1.1,
                   blend(lit(colour, normal), kEdge, 0.75), 4e-4);
    }
  }
}

/// Along the light onto the floor.
void draw_shadow(Painter& painter, const PictureBody& body) {
  for (const SolidFace& face : faces_of(body)) {
    std::vector<Vec3> corners = in_world(body.X_WB, face.corners);
    for (Vec3& p : corners) {
      // The shadow of a polygon is that of its corners; its depth is a hair over the floor's.
      p -= kLight * (std::max(p.z, 0.0) / kLight.z);
      p.z = 1e-4;
    }
    painter.shadow(corners);
  }
}

/// 1, 2 or 5 times a power of ten, about an eighth of a length.
double grid_step(double extent) {
  const double wanted = extent / 8;
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= wanted) return factor * power;
  }
  return 10 * power;
}

struct Extent {
  Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};

  void add(const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

/// Bodies without those that are far from most, by the median of places and the 90th percentile of
/// distances: one block that was thrown far away must not make all others small.
std::vector<const PictureBody*> main_bodies(const std::vector<PictureBody>& bodies) {
  std::vector<double> xs, ys, far;
  for (const PictureBody& body : bodies) {
    xs.push_back(body.X_WB.p.x);
    ys.push_back(body.X_WB.p.y);
  }
  const auto quantile = [](std::vector<double> values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
  };
  std::vector<const PictureBody*> out;
  if (bodies.empty()) return out;
  const double x = quantile(xs, 0.5), y = quantile(ys, 0.5);
  const auto distance = [&](const PictureBody& body) {
    return std::hypot(body.X_WB.p.x - x, body.X_WB.p.y - y);
  };
  for (const PictureBody& body : bodies) far.push_back(distance(body));
  const double most = 4 * quantile(far, 0.9) + 0.5;
  for (const PictureBody& body : bodies) {
    if (distance(body) <= most) out.push_back(&body);
  }
  return out;
}

Extent extent_of(const std::vector<Vec3>& points) {
  Extent extent;
  for (const Vec3& p : points) extent.add(p);
  return extent;
}

/// x right, y down, z ahead, for an eye that looks along z. The quaternion comes from the
/// rotation's matrix, in the two cases that can occur (Shepperd 1978).
Quat looking(const Vec3& ahead, double azimuth) {
  // Straight down or up, the azimuth alone says what is to the right.
  const bool level = std::hypot(ahead.x, ahead.y) > 1e-9;
  const Vec3 right =
      level ? normalised(cross(ahead, {0, 0, 1})) : Vec3{-std::sin(azimuth), std::cos(azimuth), 0};
  const Vec3 down = cross(ahead, right);
  const Mat3 m{right, down, ahead};
  if (!level) return quaternion_of(m);
  const double w = std::sqrt(std::max(1e-12, 1 + m.x.x + m.y.y + m.z.z)) / 2;
  if (w > 0.1) {
    return normalised(
        Quat{w, (m.y.z - m.z.y) / (4 * w), (m.z.x - m.x.z) / (4 * w), (m.x.y - m.y.x) / (4 * w)});
  }
  const double x = std::sqrt(std::max(1e-12, 1 + m.x.x - m.y.y - m.z.z)) / 2;
  return normalised(
      Quat{(m.y.z - m.z.y) / (4 * x), x, (m.x.y + m.y.x) / (4 * x), (m.z.x + m.x.z) / (4 * x)});
}

void draw_floor(Painter& painter, const PictureFloor& extent) {
  const double step = extent.grid;
  const Vec3 middle = (extent.low + extent.high) * 0.5;
  // The floor goes on beyond what stands on it, in whole squares.
  const double reach =
      1.2 * std::max(extent.high.x - extent.low.x, extent.high.y - extent.low.y) + 4 * step;
  const auto down = [step](double x) { return std::floor(x / step) * step; };
  const double x0 = down(middle.x - reach), x1 = down(middle.x + reach) + step;
  const double y0 = down(middle.y - reach), y1 = down(middle.y + reach) + step;
  painter.polygon({{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}, kFloorColour);
  const auto lines = [&](double from, double to, auto draw) {
    const auto count = static_cast<int>(std::lround((to - from) / step));
    for (int i = 0; i <= count; ++i) draw(from + i * step);
  };
  // Lines lie in the plane of the floor, and so need a bias.
  lines(x0, x1, [&](double x) { painter.line({x, y0, 0}, {x, y1, 0}, 1, kGridColour, 1e-5); });
  lines(y0, y1, [&](double y) { painter.line({x0, y, 0}, {x1, y, 0}, 1, kGridColour, 1e-5); });
}

}  // namespace

std::vector<Vec3> points_about(const std::vector<PictureBody>& bodies) {
  std::vector<Vec3> points;
  for (const PictureBody* body : main_bodies(bodies)) {
    const double r = body->shape.radius();
    // Six points of the ball about each body, enough for a view that has a margin.
    for (const Vec3& way :
         {Vec3{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}}) {
      points.push_back(body->X_WB.p + way);
    }
  }
  if (points.empty()) points = {{-0.2, -0.2, 0}, {0.2, 0.2, 0.1}};
  return points;
}

PictureFloor floor_under(const std::vector<Vec3>& points) {
  const Extent extent = extent_of(points);
  const Vec3 size = extent.high - extent.low;
  return {extent.low, extent.high, grid_step(std::max({size.x, size.y, 0.2}))};
}

PictureView fitted_view(const std::vector<PictureBody>& bodies, const PictureLook& look) {
  return view_holding(points_about(bodies), look);
}

PictureView view_holding(const std::vector<Vec3>& points, const PictureLook& look) {
  assert(look.width > 0 && look.height > 0);
  const double c = std::cos(look.elevation);
  const Vec3 ahead{-c * std::cos(look.azimuth), -c * std::sin(look.azimuth),
                   -std::sin(look.elevation)};
  PictureView view;
  view.X_WC.q = looking(ahead, look.azimuth);
  CameraIntrinsics& camera = view.camera;
  camera.width = look.width;
  camera.height = look.height;
  camera.fx = camera.fy = look.width / 2.0 / std::tan(kFieldOfView / 2);
  camera.cx = (look.width - 1) / 2.0;
  camera.cy = (look.height - 1) / 2.0;

  const Mat3 r = matrix(view.X_WC.q);
  Extent eye;
  for (const Vec3& p : points) eye.add(r.transposed(p));
  const Vec3 middle = (eye.low + eye.high) * 0.5;
  // Far enough back for every point to be inside, with a margin: for each point there is a distance
  // at which it touches the border of the view, in x and in y, and the largest holds all.
  const double slope_x = 0.84 * std::tan(kFieldOfView / 2),
               slope_y = slope_x * look.height / look.width;
  double back = 0.05;
  for (const Vec3& p : points) {
    const Vec3 q = r.transposed(p) - middle;
    back = std::max({back, std::abs(q.x) / slope_x - q.z, std::abs(q.y) / slope_y - q.z});
  }
  view.X_WC.p = r * (middle - Vec3{0, 0, back});
  return view;
}

void paint_bodies(PictureSink& sink, const std::vector<PictureBody>& bodies,
                  const PictureView& view, const std::optional<PictureFloor>& floor,
                  const std::vector<PictureLine>& lines) {
  Painter painter(sink, view);
  if (floor) {
    draw_floor(painter, *floor);
    for (const PictureBody& body : bodies) draw_shadow(painter, body);
  }
  for (const PictureBody& body : bodies) draw_body(painter, body);
  for (const PictureLine& mark : lines) {
    painter.line(mark.from, mark.to, mark.width, mark.colour, mark.bias);
  }
}

Image draw_bodies(const std::vector<PictureBody>& bodies, const PictureView& view,
                  const std::optional<PictureFloor>& floor, const std::vector<PictureLine>& lines) {
  assert(view.camera.width > 0 && view.camera.height > 0);
  FinePicture fine(view.camera.width, view.camera.height);
  paint_bodies(fine, bodies, view, floor, lines);
  return fine.image();
}

ScenePicture draw_bodies(const std::vector<PictureBody>& bodies, const PictureView& view,
                         bool floor, const std::vector<PictureLine>& lines) {
  const PictureFloor under = floor_under(points_about(bodies));
  return {draw_bodies(bodies, view, floor ? std::optional(under) : std::nullopt, lines),
          under.grid};
}

}  // namespace stig::physics
