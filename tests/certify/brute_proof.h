// SPDX-License-Identifier: MIT
// Certificates read off an exhaustive search: every structure that some order of events
// reaches is written down first, then what is true of all of them. Nothing here is
// shared with the checker.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "certify/certificate.h"
#include "support/uses.h"

namespace stig {

using Bricks = std::vector<PlacedBrick>;  ///< by cell

/// All that a stage can reach from the structures it finds.
struct ReachedStage {
  Bricks start;
  std::map<Bricks, Bricks> events;  ///< of each structure, the start among them
  std::set<Bricks> ends;            ///< without an event, or with the stage's number of deposits
};

/// Stage by stage, as long as each has one end; the last may have several. Nothing when
/// there are more than `most` structures. The rule set has a box with an origin.
std::optional<std::vector<ReachedStage>> reach_all(const RuleSet& rules, std::size_t most);

/// What becomes a window's group.
enum class Grouping { none, all, some };

/// Claims that the end of each stage is its first, by order of cells. Inside rc::check.
Certificate certificate_of(const RuleSet& rules, const std::vector<ReachedStage>& stages,
                           Grouping grouping);

}  // namespace stig
