// SPDX-License-Identifier: MIT
// What became of targets that a robot was asked to build: a row a target, and tables by kind.
//
// Rows are kept as JSON, a line each, so that a measurement that takes hours can be stopped and
// taken up again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "support/uses.h"

namespace stig::bench {

/// One run of `stigc validate`.
struct BuildingRun {
  int robots = 1, seed = 1;
  bool complete = false;
  int put = 0;            ///< bricks that robots put and that stayed
  double last = 0;        ///< when the last one was, in simulated seconds
  std::string what_came;  ///< where it is not complete: the judge's verdict and first finding
};

struct AssemblyRow {
  std::string kind;
  std::uint64_t seed = 0;
  std::size_t bricks = 0;
  std::optional<bool> possible;    ///< by the oracle; none: it gave up
  bool proved_impossible = false;  ///< by the planner, for every order
  bool too_few_colours = false;    ///< proved by the planner, for every order and all rules
  bool synthesised = false;        ///< a rule set was printed
  bool compiled = false;           ///< the printed rule set was read and compiled again
  bool any_number = false;         ///< of robots may work at once
  bool for_two = false;            ///< there is a rule set for two robots, that one or another
  std::size_t sides = 0;           ///< that robots work from
  std::string tried;               ///< candidates and what became of them, in words
  double seconds = 0;              ///< of the clock, for the synthesis
  bool built = false;              ///< the runs below were made, where there are any to make
  std::vector<BuildingRun> runs;

  /// What the oracle does not refute counts as possible, unless the planner proves that it is not.
  bool counts_as_possible() const {
    return !proved_impossible && !too_few_colours && possible.value_or(true);
  }
  /// One of the two is wrong.
  bool contradicts() const {
    return compiled ? possible == false : proved_impossible && possible == true;
  }
};

std::string to_json_line(const AssemblyRow& row);
/// Nothing for a line that was not written to its end.
std::optional<AssemblyRow> row_from_json(const std::string& line);

/// One line for people, as a target is done.
std::string progress_line(const AssemblyRow& row);

/// A line a kind, in the order of `kinds`, and one for all; `built`: with what robots built.
std::string table_of(const std::vector<AssemblyRow>& rows, const std::vector<std::string>& kinds,
                     bool built);

/// The shares that are asked for, a line each, and whether each is met.
struct Shares {
  std::string lines;
  bool met = true;
};
Shares shares_of(const std::vector<AssemblyRow>& rows, bool built);

}  // namespace stig::bench
