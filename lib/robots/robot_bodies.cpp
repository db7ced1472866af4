// SPDX-License-Identifier: MIT
// Bodies and joints of a robot file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "base/degree.h"
#include "base/text.h"
#include "robots/body_reader.h"
#include "robots/robot_parts.h"

namespace stig::robots {

namespace {

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

/// Pieces of a body, fixed to it.
void fix_pieces(RobotModel& model, std::size_t whole, const std::vector<BodyModel>& pieces) {
  for (const BodyModel& piece : pieces) {
    JointModel joint;
    joint.name = piece.name;
    joint.parent = whole;
    joint.child = model.bodies.size();
    joint.X_RJ.p = piece.X_RB.p;
    joint.place = piece.place;
    model.joints.push_back(std::move(joint));
    model.bodies.push_back(piece);
  }
}

void read_wheel(const FormView& view, BodyModel& body, const RobotParts& parts) {
  if (view.has("axle")) body.axle = parts.direction(view, "axle", {});
  body.axle_friction = view.number("axle_friction", 1);
  // The contact of a cylinder with the floor is a line, and with round wheels of finite width it
  // resists turning on the spot; as a ball it touches in one point.
  body.rolls_as_sphere = view.flag("rolls_as_sphere");
}

}  // namespace

void read_bodies(const FormView& root, const RobotParts& parts) {
  std::vector<std::pair<std::string, SourceRange>> seen;
  std::vector<std::pair<std::size_t, std::vector<BodyModel>>> pieces;
  for (const FormView& view : entries(root, "bodies", parts.bad)) {
    parts.claim_name(view, "bodies", seen);
    std::vector<BodyModel> read = read_body(view, {parts.document, parts.out, parts.load}, {});
    read_wheel(view, read.front(), parts);
    pieces.emplace_back(parts.model.bodies.size(),
                        std::vector(std::next(read.begin()), read.end()));
    parts.model.bodies.push_back(std::move(read.front()));
  }
  // Last, so that what the file names has its places in the lists.
  for (const auto& [whole, rest] : pieces) fix_pieces(parts.model, whole, rest);
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
