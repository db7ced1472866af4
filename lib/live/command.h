// SPDX-License-Identifier: MIT
// What a page asks of a session, as JSON of a strict form:
//
//     {"do": "run"} {"do": "pause"} {"do": "again"} {"do": "checkpoint"}
//     {"do": "step", "count": 1}          ticks, or bricks
//     {"do": "speed", "times": 2}         null: as fast as it goes
//     {"do": "back", "checkpoint": 1}     by its number, from 1
//     {"do": "move", "block": 12, "at": [0.1, 0, 0.0275], "yaw": 0.5}    or "robot"; yaw in rad,
//     {"do": "drop", "at": [0, 0, 0.2], "yaw": 0}                        which may be left out
//     {"do": "break", "robot": 0} {"do": "mend", "robot": 0}
//
// Blocks are numbers of bodies, robots their places in the scene. Every other key is an error.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "live/uses.h"
#include "physical/trace/hand_action.h"

namespace stig::live {

enum class LiveAsk : std::uint8_t { run, pause, again, step, speed, checkpoint, back, hand };

struct LiveCommand {
  LiveAsk ask = LiveAsk::run;
  std::uint64_t number = 0;     ///< of steps, or of a checkpoint
  std::optional<double> speed;  ///< times the usual
  HandAction action;
};

inline constexpr std::size_t kMostCommandBytes = 1000;

/// Nothing with `problem` set, a sentence, when the text is no command.
std::optional<LiveCommand> read_command(std::string_view json, std::string& problem);

}  // namespace stig::live
