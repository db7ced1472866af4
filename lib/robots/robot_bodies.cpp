// SPDX-License-Identifier: MIT
// Bodies and joints of a robot file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "base/degree.h"
#include "base/hull.h"
#include "base/text.h"
#include "robots/robot_parts.h"

namespace stig::robots {

namespace {

constexpr std::array<std::string_view, 4> kShapes = {"box", "cylinder", "sphere", "hull"};

// Euler angles z, y', x'': yaw, then pitch, then roll, each about the axes that the ones before
// have left.
Quat turned(const Vec3& degrees_zyx) {
  return rotation(Vec3{0, 0, 1} * (degrees_zyx.x * kDegree)) *
         rotation(Vec3{0, 1, 0} * (degrees_zyx.y * kDegree)) *
         rotation(Vec3{1, 0, 0} * (degrees_zyx.z * kDegree));
}

// Bodies are read even where the file has errors: a bad value has been reported, and a default in
// its place lets the checks that follow find more in one go. The model itself is given out only
// when nothing was reported. Hence defaults such as 1 for a length: they must not cause messages of
// their own.
class BodyReader {
 public:
  BodyReader(const FormView& view, const RobotParts& parts) : view_(view), parts_(parts) {}

  BodyModel read() {
    body_.name = view_.text("name");
    body_.place = parts_.document.head(view_.node());
    body_.mass = view_.number("mass", 1);
    body_.material = view_.text("material", "robot");
    body_.rgb = parse_color(view_.text("color")).value_or(body_.rgb);
    check_one(kShapes, "a shape: box, cylinder, sphere or hull");
    check_one(std::array<std::string_view, 2>{"base", "center"}, "a place: base or center");
    read_shape();
    read_place();
    read_inertia();
    if (view_.has("axle")) body_.axle = parts_.direction(view_, "axle", {});
    body_.axle_friction = view_.number("axle_friction", 1);
    // The contact of a cylinder with the floor is a line, and with round wheels of finite width it
    // resists turning on the spot; as a ball it touches in one point.
    body_.rolls_as_sphere = view_.flag("rolls_as_sphere");
    return std::move(body_);
  }

 private:
  /// A body has one shape and one place; looks at the node itself, since a bad value has been
  /// reported already.
  template <std::size_t N>
  void check_one(const std::array<std::string_view, N>& keys, std::string_view what) {
    std::vector<std::string_view> found;
    for (const std::string_view key : keys) {
      if (view_.node().find(key) != nullptr) found.push_back(key);
    }
    if (found.size() == 1) return;
    parts_.out.add(Code::P604, body_.place,
                   found.empty()
                       ? fmt::format("this body has not {}", what)
                       : fmt::format("this body has both '{}' and '{}'", found[0], found[1]));
  }

  void read_shape() {
    if (view_.has("cylinder")) {
      const FormView form = view_.form("cylinder");
      // Sizes are edge lengths of the box about the shape for every shape.
      const double d = 2 * form.number("radius", 1);
      body_.shape = ShapeType::cylinder;
      body_.size = {d, d, form.number("height", 1)};
    } else if (view_.has("sphere")) {
      body_.shape = ShapeType::sphere;
      body_.size = Vec3{1, 1, 1} * (2 * view_.form("sphere").number("radius", 1));
    } else if (view_.has("hull")) {
      read_hull();
    } else {
      body_.size = view_.vector("box", {1, 1, 1});
    }
  }

  void read_hull() {
    body_.shape = ShapeType::hull;
    for (const FormView& corner : view_.forms("hull")) {
      body_.points.push_back(corner.vector("at"));
    }
    const HullMass solid = hull_mass(body_.points);
    // In m³: a cube of a tenth of a millimetre. Four corners in a plane have next to none.
    if (solid.volume <= 1e-12) {
      parts_.out.add(Code::P614, parts_.document.head(*view_.find("hull")),
                     "the corners of the hull enclose nothing");
      return;
    }
    // The model's frame is that of the middle of mass.
    body_.p_BO = -solid.centre;
    Vec3 low = body_.points[0], high = low;
    for (Vec3& p : body_.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      p -= solid.centre;
    }
    body_.size = high - low;
  }

  // X_RB is the pose of the centre of mass. "base" is the middle of the lower face, or a hull's own
  // origin, from which its devices are measured as well; "center" is the centre itself.
  void read_place() {
    body_.X_RB = {view_.vector("base", view_.vector("center")), turned(view_.vector("turn"))};
    if (view_.has("base") && body_.shape != ShapeType::hull) {
      body_.p_BO = {0, 0, -body_.size.z / 2};
    }
    // The shift is in the body's frame: a body that is turned is turned about its base.
    body_.X_RB = body_.X_RB * Pose{-body_.p_BO, {}};
  }

  void read_inertia() {
    if (!view_.has("inertia")) return;
    const Vec3 i = view_.vector("inertia");
    body_.inertia = i;
    // For any distribution of mass each principal moment is at most the sum of the other two.
    // Rounding of figures in the file is forgiven.
    const double most = std::max({i.x, i.y, i.z});
    if (2 * most <= (i.x + i.y + i.z) * (1 + 1e-9)) return;
    parts_.out.add(Code::P615, parts_.range(*view_.find("inertia")),
                   "no body has such moments: one is more than the other two together");
  }

  const FormView& view_;
  const RobotParts& parts_;
  BodyModel body_;
};

ActuatorMode mode_of(const std::string& text) {
  return text == "velocity"   ? ActuatorMode::velocity
         : text == "position" ? ActuatorMode::position
         : text == "force"    ? ActuatorMode::force
                              : ActuatorMode::none;
}

void read_limits(const FormView& view, AxisModel& axis, double unit, const RobotParts& parts) {
  const std::vector<double> limits = view.numbers("limits");
  if (limits.size() != 2) return;
  axis.lower = limits[0] * unit;
  axis.upper = limits[1] * unit;
  const SourceRange place = parts.range(*view.find("limits"));
  if (limits[0] > limits[1]) {
    parts.out.add(
        Code::P608, place,
        fmt::format("the lower limit {} is above the upper one {}", limits[0], limits[1]));
  } else if (limits[0] > 0 || limits[1] < 0) {
    // Joints are at 0 in the poses that the file gives, so a range without 0 would begin violated.
    parts.out.add(Code::P608, place,
                  fmt::format("the limits {} and {} do not hold 0, where every joint begins",
                              limits[0], limits[1]));
  }
}

AxisModel read_axis(const FormView& view, const RobotParts& parts) {
  AxisModel axis;
  // Looks at the node itself, as check_one does.
  const bool turns = view.node().find("turn") != nullptr;
  if (turns == (view.node().find("slide") != nullptr)) {
    parts.out.add(Code::P604, parts.document.head(view.node()),
                  turns ? "this axis has both 'turn' and 'slide'"
                        : "this axis has not a direction: turn or slide");
  }
  axis.angular = turns;
  axis.axis = parts.direction(view, turns ? "turn" : "slide", {0, 0, 1});
  const double unit = turns ? kDegree : 1;
  read_limits(view, axis, unit, parts);
  axis.actuator = mode_of(view.text("actuator"));
  axis.most_force = view.number("most_force");
  axis.most_speed = view.number("most_speed") * unit;
  axis.damping = view.number("damping");
  // Motors have limits: a motor without most_force would be either useless or infinitely strong.
  if (axis.actuator != ActuatorMode::none && view.node().find("most_force") == nullptr) {
    parts.out.add(Code::R102, parts.document.head(view.node()),
                  "an axis with a motor without the key 'most_force'");
  }
  return axis;
}

JointModel read_joint(const FormView& view, const RobotParts& parts) {
  JointModel joint;
  // Most joints are called by what they carry.
  joint.name = view.text("name", view.text("child"));
  joint.place = parts.document.head(view.node());
  joint.parent = parts.body(view, "parent").value_or(kNoBody);
  joint.child = parts.body(view, "child").value_or(kNoBody);
  if (joint.child != kNoBody) {
    const BodyModel& child = parts.model.bodies[joint.child];
    // By default a joint sits where its child is placed: a wheel turns about its own middle.
    joint.X_RJ.p = view.vector("at", child.X_RB * child.p_BO);
  }
  for (const FormView& axis : entries(view, "axes", parts.bad)) {
    joint.axes.push_back(read_axis(axis, parts));
  }
  return joint;
}

/// The most axes of all joints; with the six of its root, the degrees of freedom of a mechanism.
/// Beyond these the solver's mechanism has no room, see kMostMechanismDofs in
/// physical/solver/solver.h.
constexpr std::size_t kMostRobotAxes = 58;

void check_count(const FormView& root, const RobotParts& parts) {
  const auto& joints = parts.model.joints;
  const std::size_t axes = std::accumulate(
      joints.begin(), joints.end(), std::size_t{0},
      [](std::size_t sum, const JointModel& joint) { return sum + joint.axes.size(); });
  if (axes <= kMostRobotAxes) return;
  parts.out.add(Code::P608, parts.document.head(*root.node().find("joints")),
                fmt::format("'joints' has {} axes in all, it takes at most {}: with the six ways "
                            "in which a robot moves, what can be simulated",
                            axes, kMostRobotAxes));
}

}  // namespace

void read_bodies(const FormView& root, const RobotParts& parts) {
  std::vector<std::pair<std::string, SourceRange>> seen;
  for (const FormView& view : entries(root, "bodies", parts.bad)) {
    parts.claim_name(view, "bodies", seen);
    parts.model.bodies.push_back(BodyReader(view, parts).read());
  }
}

void read_joints(const FormView& root, const RobotParts& parts) {
  std::vector<std::pair<std::string, SourceRange>> seen;
  for (const FormView& view : entries(root, "joints", parts.bad)) {
    parts.claim_name(view, "joints", seen);
    parts.model.joints.push_back(read_joint(view, parts));
  }
  check_count(root, parts);
}

}  // namespace stig::robots
