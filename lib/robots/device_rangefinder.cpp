// SPDX-License-Identifier: MIT
#include "robots/device_rangefinder.h"

#include <fmt/format.h>

#include <algorithm>

#include "robots/device_parts.h"
#include "robots/robot_description.h"

namespace stig::robots {

namespace {

using Calibration = RangeDevice::Calibration;

constexpr const char* kCalibrations[] = {"metres", "power", "quadratic"};

std::size_t coefficients_of(Calibration calibration) {
  return calibration == Calibration::metres ? 0 : calibration == Calibration::power ? 2 : 3;
}

void check_coefficients(const FormView& view, const DeviceParts& parts, Calibration calibration,
                        std::size_t count) {
  const std::size_t wanted = coefficients_of(calibration);
  const YamlNode* node = view.node().find("coefficients");
  if (count == wanted || (node != nullptr && !view.has("coefficients"))) return;
  parts.out.add(node == nullptr ? Code::R102 : Code::R107,
                parts.document.head(node == nullptr ? view.node() : *node),
                fmt::format("this calibration takes {} coefficients", wanted));
}

std::string description_of(const RobotModel& robot, const RangeDevice& finder) {
  std::string out =
      fmt::format("      [{}] = {{ {}, range = {:.6g}, calibration = '{}'", lua_quoted(finder.name),
                  described_place(robot.bodies[finder.body].X_RB * finder.p_B), finder.range,
                  kCalibrations[static_cast<std::size_t>(finder.calibration)]);
  if (finder.calibration != Calibration::metres) {
    const auto& c = finder.coefficients;
    out += fmt::format(", coefficients = {{ {}, {}", c[0], c[1]);
    out += finder.calibration == Calibration::power ? " }" : fmt::format(", {} }}", c[2]);
  }
  return out + " },\n";
}

}  // namespace

double without_hit(const RangeDevice& device) {
  return device.calibration == Calibration::metres ? device.range : 0;
}

const Form& RangefinderKind::form() {
  using namespace keys;
  static const Form kForm{
      noun,
      {device_name(), on_body(), at(),
       required(vector("look", "The direction of its ray, body's frame.", kFar)),
       required(above_zero("range", "Metres.", 1000)),
       choice("calibration",
              "Of its reading: the metres themselves, or with v = exp(-metres) a v^b (power) or "
              "c0 + c1 v + c2 v² (quadratic).",
              {kCalibrations[0], kCalibrations[1], kCalibrations[2]}),
       numbers("coefficients", "[a, b] or [c0, c1, c2].", 2, 3, -1e9, 1e9)}};
  return kForm;
}

RangeDevice RangefinderKind::read(const FormView& view, DeviceParts& parts) {
  RangeDevice device;
  device.name = view.text("name");
  device.body = parts.on_body(view);
  device.p_B = parts.place(view, device.body);
  device.direction = parts.direction(view, "look", {1, 0, 0});
  device.range = view.number("range");
  const std::string calibration = view.text("calibration", "metres");
  device.calibration = calibration == "power"       ? Calibration::power
                       : calibration == "quadratic" ? Calibration::quadratic
                                                    : Calibration::metres;
  const std::vector<double> c = view.numbers("coefficients");
  std::copy(c.begin(), c.end(), device.coefficients.begin());
  check_coefficients(view, parts, device.calibration, c.size());
  return device;
}

std::string RangefinderKind::description(const RobotModel& robot) {
  std::string out = "   rangefinders = {\n";
  for (const RangeDevice& finder : robot.rangefinders) out += description_of(robot, finder);
  return out + "   },\n";
}

}  // namespace stig::robots
