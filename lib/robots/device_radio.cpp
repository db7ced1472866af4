// SPDX-License-Identifier: MIT
#include "robots/device_radio.h"

#include "robots/device_parts.h"

namespace stig::robots {

const Form& RadioKind::form() {
  using namespace keys;
  static const Form kForm{
      noun, {device_name(), on_body(), at(), required(above_zero("range", "Metres.", 1000))}};
  return kForm;
}

RadioDevice RadioKind::read(const FormView& view, DeviceParts& parts) {
  const std::size_t on = parts.on_body(view);
  return {view.text("name"), on, parts.place(view, on), view.number("range")};
}

}  // namespace stig::robots
