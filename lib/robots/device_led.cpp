// SPDX-License-Identifier: MIT
#include "robots/device_led.h"

#include "robots/device_parts.h"

namespace stig::robots {

const Form& LedKind::form() {
  using namespace keys;
  static const Form kForm{noun, {device_name(), on_body(), at()}};
  return kForm;
}

LedDevice LedKind::read(const FormView& view, DeviceParts& parts) {
  const std::size_t on = parts.on_body(view);
  return {view.text("name"), on, parts.place(view, on)};
}

}  // namespace stig::robots
