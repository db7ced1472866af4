// SPDX-License-Identifier: MIT
#include "robots/device_compass.h"

#include <cmath>
#include <numbers>

#include "robots/device_parts.h"
#include "sensing/gaussian.h"

namespace stig::robots {

const Form& CompassKind::form() {
  using namespace keys;
  static const Form kForm{
      noun,
      {device_name(), on_body(),
       number("noise", "Standard deviation of its heading, radians (default: 0).", 0,
              std::numbers::pi)}};
  return kForm;
}

CompassDevice CompassKind::read(const FormView& view, DeviceParts& parts) {
  return {view.text("name"), parts.on_body(view), view.number("noise")};
}

CompassReading CompassKind::sense(const CompassDevice& device, const BodyMotion& body,
                                  Random& random) {
  const Vec3 ahead = rotate(body.X_WB.q, {1, 0, 0});
  double heading = std::atan2(ahead.y, ahead.x);
  if (device.noise > 0) heading += device.noise * gaussian(random);
  return {std::remainder(heading, 2 * std::numbers::pi)};
}

}  // namespace stig::robots
