// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "assembly/uses.h"
#include "rules/cell.h"

namespace stig::assembly {

/// From a brick to those that it shares a face with.
inline constexpr std::array<Offset, 6> kFaces = {
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

}  // namespace stig::assembly
