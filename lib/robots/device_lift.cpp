// SPDX-License-Identifier: MIT
#include "robots/device_lift.h"

#include <fmt/format.h>

#include <algorithm>

#include "robots/device_parts.h"
#include "robots/robot_extent.h"

namespace stig::robots {

namespace {

const Form& lift_speed_form() {
  using namespace keys;
  static const Form kForm{
      "speed of the lift",
      {required(number("above", "Where the error is above this, metres,", 0, kFar)),
       required(above_zero("speed", "this is the speed, metres a second.", kFar))}};
  return kForm;
}

void read_lift_speeds(const FormView& view, const DeviceParts& parts, LiftModel& lift) {
  for (const FormView& speed : view.forms("speeds")) {
    const double above = speed.number("above");
    if (!lift.speeds.empty() && above >= lift.speeds.back().first) {
      parts.out.add(Code::P616, parts.document.head(speed.node()),
                    "the speeds of a lift are listed by falling errors");
    }
    lift.speeds.emplace_back(above, speed.number("speed"));
  }
}

/// What goes up and down, and what does not; as seen from above, m.
std::string described_reach(const RobotModel& robot) {
  std::vector<bool> counts = lifted_bodies(robot);
  const BodyExtent lifted = extent_of(robot, counts);
  counts.flip();
  const BodyExtent body = extent_of(robot, counts);
  const auto half_width = [](const BodyExtent& e) { return std::max(e.high.y, -e.low.y); };
  return fmt::format(
      "   effector = {{ front = {:.6g}, half_width = {:.6g} }},\n"
      "   body = {{ front = {:.6g}, back = {:.6g}, half_width = {:.6g} }},\n",
      lifted.high.x, half_width(lifted), body.high.x, -body.low.x, half_width(body));
}

}  // namespace

const Form& LiftKind::form() {
  using namespace keys;
  static const Form kForm{
      key,
      {required(words("joint", FormKind::name, "With one axis that slides.")),
       required(numbers("switches",
                        "Positions at which the limit switches close, bottom and top, metres.", 2,
                        2, -kFar, kFar)),
       above_zero("inactive_below", "Error under which it reports rest, metres.", kFar),
       required(keys::parts("speeds", "By falling error; under the last it rests.",
                            lift_speed_form(), 1, 16))}};
  return kForm;
}

LiftModel LiftKind::read(const FormView& view, DeviceParts& parts) {
  LiftModel lift;
  lift.axis = parts.take_axis(view.find("joint"), 0, {"a lift", false, false});
  const std::vector<double> switches = view.numbers("switches");
  if (switches.size() == 2) {
    lift.low = switches[0];
    lift.high = switches[1];
    if (lift.low >= lift.high) {
      parts.out.add(Code::P616, parts.range(*view.find("switches")),
                    "the bottom switch is not below the top one");
    }
  }
  read_lift_speeds(view, parts, lift);
  lift.tolerance = lift.speeds.empty() ? 0 : lift.speeds.back().first;
  lift.inactive_below = view.number("inactive_below", lift.tolerance);
  return lift;
}

std::string LiftKind::description(const RobotModel& robot) {
  if (!robot.lift) return {};
  std::string out = fmt::format("   lift = {{ top = {:.6g}, tolerance = {:.6g} }},\n",
                                robot.lift->high, robot.lift->tolerance);
  if (robot.lift->axis.joint >= robot.joints.size()) return out;
  return out + described_reach(robot);
}

}  // namespace stig::robots
