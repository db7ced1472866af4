// SPDX-License-Identifier: MIT
// Every kind has its counter; the compiler warns of a new one that has none.
#include "physical/simulation/event_tally.h"

#include <algorithm>

#include "physical/simulation/run_state.h"

namespace stig::physics {

void EventTally::after_step(RunState& run) {
  for (const WorldEvent& event : run.world.events()) count(event);
}

void EventTally::count(const WorldEvent& event) {
  switch (event.kind) {
    case EventKind::contact_began:
      ++tally_.contacts;
      break;
    case EventKind::slept:
      ++tally_.slept;
      break;
    case EventKind::woke:
      ++tally_.woke;
      break;
    case EventKind::snapped:
      ++tally_.snapped;
      break;
    case EventKind::let_go:
      ++tally_.let_go;
      break;
    case EventKind::left_arena:
      tally_.left.push_back(static_cast<std::uint32_t>(event.body));
      break;
  }
}

// Bytes of a checkpoint: numbers of bodies must be such.
bool EventTally::accept(const RunState& run) const {
  return tally_.left.size() <= run.world.size() &&
         std::all_of(tally_.left.begin(), tally_.left.end(),
                     [&](std::uint32_t body) { return body < run.world.size(); });
}

}  // namespace stig::physics
