// SPDX-License-Identifier: MIT
// What is measured of every candidate, declared once: the scores of a search are weighted sums of
// these, and MAP-Elites (Mouret & Clune 2015, arXiv:1504.04909) spreads its finds over them.
// docs/search.md has the table, which a test holds to this one.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lattice/measures.h"
#include "search/coordination.h"
#include "search/genome.h"
#include "search/judges.h"
#include "search/screen.h"
#include "search/trials.h"
#include "search/uses.h"

namespace stig::search {

/// A genome, what it built, and what was found out on the way.
struct Outcome {
  const Genome& genome;
  const Screening& run;
  const std::vector<PlacedBrick>& bricks;  ///< in the order of cells, the start included
  const Measures& shape;
  Trials trials{};
  Coordination coordination = Coordination::not_asked;
  double distance = 1;  ///< to the plan's target (shapes.h)
  RobotWork work{};     ///< of the plan's robot
};

struct Objective {
  std::string_view name;    ///< as plans and tables of results have it
  std::string_view doc;     ///< one line
  std::string_view source;  ///< where the measure is from
  double (*value)(const Outcome& outcome) = nullptr;
};

/// All of them, in the order in which values are kept.
std::span<const Objective> objectives();
/// The number of the objective with this name.
std::optional<std::size_t> objective_number(std::string_view name);

}  // namespace stig::search
