// SPDX-License-Identifier: MIT
// Bytes compressed into one zstd frame, with a checksum of what was compressed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stig {

std::string packed(std::string_view bytes);
/// Nothing when the frame is damaged, followed by more, or holds more than `most` bytes.
std::optional<std::string> unpacked(std::string_view frame, std::size_t most);

}  // namespace stig
