// SPDX-License-Identifier: MIT
#include "base/hash.h"

namespace stig {

/// Written digit by digit: a formatting library would be more than it takes, and hashes are
/// compared as text.
std::string to_hex(std::uint64_t value) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; value >>= 4) text[i] = kDigits[value & 15U];
  return text;
}

}  // namespace stig
