// SPDX-License-Identifier: MIT
// Targets by kind and seed, such as robots might be asked to build, for tests and benchmarks.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "support/uses.h"
#include "synthesis/target.h"

namespace stig {

inline constexpr std::array<std::string_view, 9> kTargetKinds = {
    "height map", "wall", "ring", "tower", "stairs", "letter", "gate", "blob", "overhang"};

/// Connected by faces and standing on z = 0, of any colours.
Target drawn_target(std::string_view kind, std::uint64_t seed);

}  // namespace stig
