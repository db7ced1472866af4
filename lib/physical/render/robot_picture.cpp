// SPDX-License-Identifier: MIT
// A robot as `stigc describe` shows it, as a picture and as glTF: its bodies with their real
// shapes, and over them the lines of what no body shows, frames, axes, sight, rays and ranges.
#include "physical/render/robot_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/glb.h"
#include "physical/render/scene_picture.h"

namespace stig::physics {

namespace {

constexpr int kCircleSides = 32;  ///< sides of a circle
constexpr Rgb kRed{214, 40, 40}, kGreen{34, 139, 60}, kBlue{38, 84, 200};
constexpr Rgb kSight{196, 110, 0}, kRay{170, 30, 120}, kRadio{0, 120, 150};
constexpr double kThrough = 0.6;   ///< bias of what shows through bodies
constexpr double kSurface = 4e-4;  ///< of what is hidden by them

/// Lines of a robot's devices, robot's frame.
class Marks {
 public:
  explicit Marks(const RobotModel& robot) : robot_(robot) {
    // The frame of the robot itself, a little larger than those of its devices.
    frame({}, 0.04);
    for (const JointModel& joint : robot.joints) {
      if (!joint.axes.empty()) axes(joint);
    }
    for (const CameraDevice& camera : robot.cameras) sight(camera);
    for (const RangeDevice& device : robot.rangefinders) ray(device);
    for (const RadioDevice& device : robot.radios) reach(device);
  }
  std::vector<PictureLine> lines;

 private:
  void line(const Vec3& a, const Vec3& b, double width, Rgb colour, double bias) {
    lines.push_back({a, b, width, colour, bias});
  }
  const Pose& body(std::size_t i) const { return robot_.bodies[i].X_RB; }

  void frame(const Pose& X, double size) {
    line(X.p, X * Vec3{size, 0, 0}, 2, kRed, kThrough);
    line(X.p, X * Vec3{0, size, 0}, 2, kGreen, kThrough);
    line(X.p, X * Vec3{0, 0, size}, 2, kBlue, kThrough);
  }

  // Through the joint both ways, in the pose that the file gives.
  void axes(const JointModel& joint) {
    for (const AxisModel& axis : joint.axes) {
      // Axes of turning and of sliding differ by their colours; length has no meaning.
      const Vec3 way = rotate(joint.X_RJ.q, axis.axis) * 0.025;
      line(joint.X_RJ.p - way, joint.X_RJ.p + way, 1.5, axis.angular ? kBlue : kGreen, kThrough);
    }
  }

  /// The frustum, with distortion: its corners are where the image's corners look.
  void sight(const CameraDevice& camera) {
    const Pose X_RC = body(camera.body) * camera.X_BC;
    // The outermost pixels' middles, so width - 1.
    const double w = camera.intrinsics.width - 1, h = camera.intrinsics.height - 1;
    std::array<Vec3, 4> way;
    const std::array<ImagePoint, 4> corners = {{{0, 0}, {w, 0}, {w, h}, {0, h}}};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto direction = unproject(camera.intrinsics, corners[i]);
      // A lens without inverse at a corner has no frustum to draw.
      if (!direction) return;
      way[i] = *direction;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3& next = way[(i + 1) % 4];
      line(X_RC * (way[i] * camera.near), X_RC * (way[i] * camera.far), 1.2, kSight, kSurface);
      for (const double z : {camera.near, camera.far}) {
        line(X_RC * (way[i] * z), X_RC * (next * z), 1.2, kSight, kSurface);
      }
    }
    frame(X_RC, 0.02);
  }

  void ray(const RangeDevice& device) {
    const Pose& X = body(device.body);
    const Vec3 from = X * device.p_B;
    line(from, from + rotate(X.q, device.direction) * device.range, 1, kRay, kSurface);
  }

  /// Three circles of the ball that the radio reaches.
  void reach(const RadioDevice& device) {
    const Vec3 middle = body(device.body) * device.p_B;
    const Mat3 axes;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 u = axes.column(axis) * device.range,
                 v = axes.column((axis + 1) % 3) * device.range;
      const auto on = [&](int i) {
        const double a = 2 * std::numbers::pi * i / kCircleSides;
        return middle + u * std::cos(a) + v * std::sin(a);
      };
      for (int i = 0; i < kCircleSides; ++i) line(on(i), on(i + 1), 1, kRadio, kThrough);
    }
  }

  const RobotModel& robot_;
};

}  // namespace

// By the model's own shape: a wheel that rolls as a ball is drawn as the cylinder that it is.
std::vector<SolidFace> faces_of(const BodyModel& body) {
  switch (body.shape) {
    case ShapeType::cylinder:
      return faces_of(Shape::cylinder(body.size.x / 2, body.size.z));
    case ShapeType::sphere:
      return faces_of(Shape::sphere(body.size.x / 2));
    case ShapeType::hull:
      return faces_of(Shape::hull(body.points));
    case ShapeType::box:
      break;
  }
  return faces_of(Shape::box(body.size));
}

// The boxes about the bodies serve for the view alone: `faces` are what is drawn.
std::string robot_png(const RobotModel& robot) {
  std::vector<PictureBody> bodies;
  for (const BodyModel& body : robot.bodies) {
    PictureBody picture;
    picture.shape = Shape::box(body.size);
    picture.X_WB = body.X_RB;
    picture.colour = body.rgb;
    picture.faces = faces_of(body);
    bodies.push_back(std::move(picture));
  }
  PictureLook look;
  look.azimuth = 0.75;
  const ScenePicture picture =
      draw_bodies(bodies, fitted_view(bodies, look), true, Marks(robot).lines);
  return png_of(picture.image, fmt::format("{}, {:.4g} kg; a square is {:g} m", robot.name,
                                           robot.mass(), picture.grid));
}

namespace {

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

GlbPrimitive surface_of(const BodyModel& body) {
  GlbPrimitive out;
  out.material = body.name;
  out.rgb = body.rgb;
  // Corners are not shared between faces, since each face has its own normal.
  for (const SolidFace& face : faces_of(body)) {
    const std::uint32_t first = out.vertices;
    for (const Vec3& corner : face.corners) out.add_vertex(floats(corner), floats(face.normal));
    // Faces are convex: a fan of triangles fills them.
    for (std::uint32_t i = 2; i < face.corners.size(); ++i) {
      out.add_triangle(first, first + i - 1, first + i);
    }
  }
  return out;
}

/// One primitive a colour, in the order in which colours first occur.
std::vector<GlbPrimitive> lines_of(const std::vector<PictureLine>& lines) {
  std::vector<GlbPrimitive> out;
  for (const PictureLine& line : lines) {
    // Colours are few, so a linear search is enough.
    auto to = std::find_if(out.begin(), out.end(),
                           [&](const GlbPrimitive& one) { return one.rgb == line.colour; });
    if (to == out.end()) {
      out.emplace_back();
      to = out.end() - 1;
      to->material = "devices " + to_color(line.colour);
      to->rgb = line.colour;
      to->lines = true;
    }
    const std::uint32_t a = to->add_vertex(floats(line.from), {});
    to->add_line(a, to->add_vertex(floats(line.to), {}));
  }
  return out;
}

}  // namespace

std::string robot_glb(const RobotModel& robot) {
  assert(!robot.bodies.empty());
  // The robot has z up, the file y.
  std::vector<GlbNode> nodes(1);
  nodes[0].name = robot.name;
  nodes[0].X_PN.q = rotation({-std::numbers::pi / 2, 0, 0});
  std::vector<int> node_of(robot.bodies.size(), 0);
  // From the root outwards, so that a node's parent has its number already.
  std::vector<std::size_t> todo = {robot.root()};
  while (!todo.empty()) {
    const std::size_t body = todo.back();
    todo.pop_back();
    GlbNode node;
    node.name = robot.bodies[body].name;
    node.primitives.push_back(surface_of(robot.bodies[body]));
    node.X_PN = robot.bodies[body].X_RB;
    node.parent = 0;
    // Quadratic in joints, of which forms allow few.
    for (const JointModel& joint : robot.joints) {
      if (joint.child == body) {
        node.parent = node_of[joint.parent];
        node.X_PN = inverse(robot.bodies[joint.parent].X_RB) * node.X_PN;
      }
      if (joint.parent == body) todo.push_back(joint.child);
    }
    node_of[body] = static_cast<int>(nodes.size());
    nodes.push_back(std::move(node));
  }
  GlbNode devices;
  devices.name = "devices";
  devices.primitives = lines_of(Marks(robot).lines);
  devices.parent = 0;
  nodes.push_back(std::move(devices));
  return glb_file(nodes);
}

}  // namespace stig::physics
