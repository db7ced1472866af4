// SPDX-License-Identifier: MIT
#include "robots/device_actuator.h"

#include "robots/device_parts.h"

namespace stig::robots {

const Form& ActuatorKind::form() {
  using namespace keys;
  static const Form kForm{noun,
                          {device_name(), required(words("joint", FormKind::name, "With a motor.")),
                           whole("axis", "Which of its axes, counted from 1 (default: 1).", 1, 6)}};
  return kForm;
}

ActuatorDevice ActuatorKind::read(const FormView& view, DeviceParts& parts) {
  const auto axis = static_cast<std::size_t>(view.number("axis", 1)) - 1;
  return {view.text("name"),
          parts.take_axis(view.find("joint"), axis, {"an actuator", true, true})};
}

}  // namespace stig::robots
