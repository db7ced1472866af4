// SPDX-License-Identifier: MIT
#include "base/text_bytes.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace stig {

bool is_text(const SourceRef& source, Diagnostics& diagnostics) {
  const std::string& text = source->text();
  const auto is_control = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
  };
  const auto control = std::find_if(text.begin(), text.end(), is_control);
  if (control != text.end()) {
    const auto at = static_cast<std::uint32_t>(control - text.begin());
    diagnostics.add(Code::R003, {source, at, at + 1},
                    fmt::format("control character 0x{:02x}", static_cast<unsigned>(*control)));
    return false;
  }
  const std::size_t invalid = find_invalid_utf8(text);
  if (invalid != std::string::npos) {
    const auto at = static_cast<std::uint32_t>(invalid);
    diagnostics.add(Code::R004, {source, at, at + 1}, "this byte is not UTF-8");
    return false;
  }
  return true;
}

}  // namespace stig
