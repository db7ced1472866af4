// SPDX-License-Identifier: MIT
// One colour or none, in place of lib/synthesis/colouring.cpp: the SAT solver behind it is a
// library that is not built for browsers. With one colour there is nothing to search, one look at
// the local states decides; every other question is given up at once.
#include "synthesis/colouring.h"

namespace stig::synthesis {

ColouringSearch::ColouringSearch(const Schedule& schedule, int named, const Allowance&)
    : differences_(schedule), named_(named) {}

Answered ColouringSearch::colour(int k, const ColouringLimits& limits, Colouring& colours) {
  if (k > 1 || named_ > 1) return Answered::given_up;
  const Schedule& schedule = differences_.schedule();
  colours.assign(schedule.frame->orbits.size(), Colour{1});
  const bool clash = !find_clashes(schedule, colours, 1, 1, limits.allowance).empty();
  if (limits.allowance.out_of_time()) return Answered::given_up;
  return clash ? Answered::no : Answered::yes;
}

std::uint64_t ColouringSearch::cost() const { return 0; }
int ColouringSearch::at_least() const { return named_ > 1 ? named_ : 1; }

std::optional<Refutation> refute(const ColouringSearch&, int, int, const Allowance&) { return {}; }

std::vector<Clash> unsatisfiable_core(ColouringSearch&, int, int, const Allowance&) { return {}; }

}  // namespace stig::synthesis
