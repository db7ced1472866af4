// SPDX-License-Identifier: MIT
// The final check of a synthesised set, by the definition: at every site, in every local
// state, the compiled rules must place the right brick when it is due and nothing otherwise
// (docs/synthesis.md, "What must hold"). It uses the rule table that engines use and none
// of the synthesiser's own matching. Stage 1 is the only stage of such a set.
#include "synthesis/check_rules.h"

#include <fmt/format.h>

#include <cassert>

#include "rules/cell_text.h"
#include "rules/rule_table.h"
#include "synthesis/local_views.h"

namespace stig::synthesis {
std::optional<std::string> find_fault(const Schedule& schedule, const Colouring& colours,
                                      const RuleSet& rules) {
  const Frame& frame = *schedule.frame;
  assert(colours.size() == frame.orbits.size());
  const RuleTable table(rules);
  std::vector<Match> matches;
  for (std::size_t s = 0; s < frame.sites.size(); ++s) {
    const Site& site = frame.sites[s];
    for (const std::uint32_t mask : schedule.states.of(s)) {
      const bool intended = schedule.intended(site, mask);
      table.matches(view_of(frame, site, mask, colours), site.at.z, 1, matches);
      if (matches.empty() && intended) {
        return fmt::format("no rule places the brick at {}", cell_text(site.at));
      }
      for (const Match& match : matches) {
        if (!intended) {
          return fmt::format("rule '{}' fires at {} when it must not", rules.rules[match.rule].name,
                             cell_text(site.at));
        }
        if (table.place(match.rule) != colours[static_cast<std::size_t>(site.orbit)]) {
          return fmt::format("rule '{}' places another brick at {}", rules.rules[match.rule].name,
                             cell_text(site.at));
        }
      }
    }
  }
  // Sites that see no brick of the target at all, on the floor or in the air, stand for
  // everything farther away.
  for (const bool on_floor : {false, true}) {
    Site bare;
    bare.on_floor = on_floor;
    if (on_floor && !frame.floor) continue;
    table.matches(view_of(frame, bare, 0, colours), 0, 1, matches);
    if (!matches.empty()) {
      return fmt::format("rule '{}' fires far from everything",
                         rules.rules[matches.front().rule].name);
    }
  }
  return std::nullopt;
}

}  // namespace stig::synthesis
