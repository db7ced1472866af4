// SPDX-License-Identifier: MIT
// Are there rules at all, in so few colours, that robots could follow? Asked of all colourings, all
// sets of rules and all that robots may decide at once, for targets with few structures on the way.
//
// Structures are all that bricks beside bricks lead to from the start. Variables are the
// colours of the bricks; for each site with what stands about it, whether a rule fires there; for
// each view of a column, whether robots that have it put a brick at a place next to the column; and
// of each structure, whether the rules' events lead there, and whether robots come there. Then
//
//     rules    in a structure that events lead to, no rule fires beside the target, and where one
//              fires at a brick's site, an event leads on to the structure with that brick; sites
//              at one height that look the same want the same
//     robots   come to the start. Where they come and put a brick, a rule fires, the brick is
//              within reach, and they come to what then stands; views that are the same, from one
//              side, lead to the same. Where they come there is something to put, unless all stands
//
// Every rule set that builds the target in whatever order of events, with every program that the
// compiler accepts for it, answers this. So when a solver refutes it, for each start, there is
// none. That it can be answered proves nothing.
#pragma once

#include <cstdint>
#include <memory>

#include "assembly/last_brick.h"
#include "assembly/uses.h"
#include "compiler/compile.h"
#include "compiler/sight.h"
#include "synthesis/colouring.h"
#include "synthesis/effort.h"

namespace stig::assembly {

/// Whether the target can be asked about: more structures than that are not looked at.
inline constexpr std::size_t kMostAsked = 1000;

struct RuleQuestion {
  const TargetBricks& target;  ///< whatever its colours
  const Builders& builders;
  std::shared_ptr<Visibility> visibility;
  int colours = kBlockColours;
};

struct RuleAnswer {
  Answered rules = Answered::given_up;  ///< no: there are none, and the proof of it was checked
  std::size_t structures = 0, clauses = 0;
};

RuleAnswer any_rules(const RuleQuestion& question, std::uint32_t start, const Allowance& allowance);

}  // namespace stig::assembly
