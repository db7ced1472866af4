// SPDX-License-Identifier: MIT
// Numbers of the format of pose_trace.h, for its writer and its reader.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "physical/trace/uses.h"

namespace stig::physics {

inline constexpr std::string_view kTrailerMagic = "stigpend";
inline constexpr char kHeaderTag = 'H', kChunkTag = 'C', kEndTag = 'E';

enum TraceRecord : std::uint8_t {
  kFrameRecord = 1,
  kEventRecord,
  kHashRecord,
  kValueRecord,
  kHandRecord
};

/// Of hand records: readers refuse others.
inline constexpr std::uint8_t kHandVersion = 1;

/// By ShapeKind.
inline constexpr std::array<std::string_view, 4> kShapeNames = {"box", "sphere", "cylinder",
                                                                "hull"};

/// A body in a frame: which differences follow, and its state.
enum TraceFlags : std::uint8_t { kMoved = 1, kTurned = 2, kAwake = 4, kLeft = 8 };

}  // namespace stig::physics
