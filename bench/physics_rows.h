// SPDX-License-Identifier: MIT
// What the physical world is held to, row by row: bench_physics prints them.
//
// Times are of the processor, so that other programs on the machine do not count. `stock` is
// DART's own step on the same scene in the same run, where it is built in and can finish.
#pragma once

#include <string>
#include <vector>

#include "robots/block.h"
#include "support/uses.h"

namespace stig::bench {

struct Row {
  std::string what, held_to, measured, stock;
  bool held = false;
};

/// The rows of one trial, which may fill several.
using Rows = std::vector<Row>;

/// A trial of this name; names are what the program's arguments choose by.
struct Trial {
  const char* name;
  Rows (*run)(const BlockModel& block);
};

extern const std::vector<Trial> kSpeedTrials;   ///< physics_speed.cpp
extern const std::vector<Trial> kFigureTrials;  ///< physics_figures.cpp

double processor_seconds();
/// Bytes that are allocated now, and the most that were since the last reset.
std::size_t allocated_bytes();
std::size_t peak_bytes(bool reset);

}  // namespace stig::bench
