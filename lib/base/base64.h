// SPDX-License-Identifier: MIT
// Bytes as text (RFC 4648, section 4), for files that hold others within them.
#pragma once

#include <string>
#include <string_view>

namespace stig {

std::string base64(std::string_view bytes);

}  // namespace stig
