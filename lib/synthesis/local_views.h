// SPDX-License-Identifier: MIT
// Local states as views: what rules are checked against. With colours chosen, every state of
// every site is a neighbourhood that an agent may meet, in any orientation, and for
// each it is known which brick, if any, belongs there.
#pragma once

#include <optional>
#include <vector>

#include "rules/neighbourhood.h"
#include "synthesis/clashes.h"
#include "synthesis/effort.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// What a site shows in a local state.
View view_of(const Frame& frame, const Site& site, std::uint32_t mask, const Colouring& colours);

struct LocalView {
  View view;
  Colour wanted = 0;  ///< to be placed; 0: nothing must be
};

/// Every distinct view of every site in every orientation, and the bare surroundings,
/// with floor and without; sorted. The colouring must be free of clashes (asserted).
/// Nothing when the time is over first.
std::optional<std::vector<LocalView>> local_views(const Schedule& schedule,
                                                  const Colouring& colours,
                                                  const Allowance& allowance);

/// One view of a class of keys that are turns of each other: the least.
struct ExactRule {
  View view;
  Colour place = 0;
  std::int32_t rank = 0;         ///< of the first site that needs it
  std::vector<View> images;      ///< under the group, each once; views.front() is `view`
  std::vector<std::int32_t> at;  ///< orbits
};
/// By rank, then view.
std::vector<ExactRule> exact_rules(const Schedule& schedule, const Colouring& colours);

}  // namespace stig::synthesis
