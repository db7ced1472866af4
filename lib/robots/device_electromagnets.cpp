// SPDX-License-Identifier: MIT
#include "robots/device_electromagnets.h"

#include <fmt/format.h>

#include "base/text.h"
#include "robots/device_parts.h"
#include "robots/robot_extent.h"

namespace stig::robots {

namespace {

const Form& pole_form() {
  using namespace keys;
  static const Form kForm{
      "pole",
      {on_body(), vector("at", "Of the dipole, metres, body's frame (default: the middle).", kFar),
       vector("direction", "Of its moment, body's frame (default: up).", kFar)}};
  return kForm;
}

}  // namespace

const Form& ElectromagnetsKind::form() {
  using namespace keys;
  static const Form kForm{
      "set of electromagnets",
      {required(parts("poles", "Its dipoles.", pole_form(), 1, 64)),
       number("passive", "Field without current, as of a block's magnets (default: 0).", 0, 1e6),
       required(number("active", "Field added for a current of 1.", 0, 1e6)),
       above_zero("charge_limit", "Where charging ends.", 1e6),
       number("charge_per_second", "Of even charging, while no current flows.", 0, 1e6),
       number("discharge_per_second", "Part of the charge that a current takes.", 0, 1e6),
       number("relax_rate", "Of charging towards the limit, a second.", 0, 1e6),
       number("sink_rate", "Of discharging towards sink_level, a second.", 0, 1e6),
       number("sink_level", "Charge that a current alone would end at.", 0, 1e6)}};
  return kForm;
}

MagnetCircuitModel ElectromagnetsKind::read(const FormView& view, DeviceParts& parts) {
  MagnetCircuitModel magnets;
  for (const FormView& pole : entries(view, "poles", parts.bad)) {
    // Unlike other devices' places, the middle: that is where a coil's dipole is.
    const std::size_t on = parts.on_body(pole);
    const Vec3 at = pole.has("at") ? parts.place(pole, on) : Vec3{};
    // No world takes it, and a compiler would look for what carries a block far from the robot.
    if (on != kNoBody && length(at) > radius_of(parts.model.bodies[on])) {
      parts.out
          .add(Code::P619, parts.range(*pole.find("at")),
               fmt::format("the pole is outside of the body {}",
                           in_quotes(parts.model.bodies[on].name)))
          .note(parts.model.bodies[on].place, "the body is here");
    }
    magnets.poles.push_back({on, at, parts.direction(pole, "direction", {0, 0, 1})});
  }
  magnets.passive = view.number("passive");
  magnets.active = view.number("active");
  magnets.charge_limit = view.number("charge_limit");
  magnets.charge_per_second = view.number("charge_per_second");
  magnets.discharge_per_second = view.number("discharge_per_second");
  magnets.relax_rate = view.number("relax_rate");
  magnets.sink_rate = view.number("sink_rate");
  magnets.sink_level = view.number("sink_level");
  return magnets;
}

/// `neutral` is the charge at which the field of a destructive current takes away the passive one.
std::string ElectromagnetsKind::description(const RobotModel& robot) {
  if (!robot.magnets || robot.magnets->poles.empty()) return {};
  const MagnetCircuitModel& magnets = *robot.magnets;
  std::string out = fmt::format("   magnets = {{ ahead = {:.6g}", middle_of_poles(robot).x);
  if (magnets.active > 0) {
    out += fmt::format(", neutral = {:.6g}", magnets.passive / magnets.active);
  }
  return out + " },\n";
}

}  // namespace stig::robots
