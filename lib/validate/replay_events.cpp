// SPDX-License-Identifier: MIT
// The rules are asked by `explain`, which tells why none fires, and not by the engine's table
// alone: speed does not matter for some dozens of placements. Bricks that left are taken away
// again, which no rule does; what is built upon a gap is judged in the structure as it then was.
#include "validate/replay_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>

#include "base/text.h"
#include "lattice/swarm.h"
#include "rules/cell_text.h"
#include "rules/drawing.h"
#include "rules/explain.h"
#include "rules/rule_printer.h"
#include "rules/rule_table.h"

namespace stig::validate {
namespace {

std::string seen_text(const RuleSet& rules, State state) {
  if (state == kEmpty) return "nothing";
  return state == kFloor ? "the floor" : rules.brick(state).name;
}

/// The rule of this colour that is nearest to firing, and what it lacks. Nearest by the number of
/// cells and conditions that fail, of the rules that place this colour: those are the ones somebody
/// would have meant.
std::string reason_for(const RuleSet& rules, const Explanation& said, Cell site, Colour colour) {
  const RuleExplanation* nearest = nullptr;
  const auto lacks = [](const RuleExplanation& one) {
    return one.cells.size() + one.conditions.size();
  };
  for (const RuleExplanation& one : said.rules) {
    if (rules.rules[one.rule].place != colour) continue;
    if (nearest == nullptr || lacks(one) < lacks(*nearest)) nearest = &one;
  }
  if (nearest == nullptr) return "no rule places this colour";
  std::string out = fmt::format("the nearest rule, '{}',", rules.rules[nearest->rule].name);
  if (!nearest->cells.empty()) {
    const FailedCell& cell = nearest->cells.front();
    return out + fmt::format(" wants {} at {} and finds {}", symbol_of(rules, cell.wanted),
                             cell_text(site + cell.offset), seen_text(rules, cell.seen));
  }
  // A rule that does not fire lacks a cell or a condition.
  const FailedCondition& failed = nearest->conditions.front();
  // A count says what it counts; all other keys of conditions are of the site itself
  // (rules/site_condition.h).
  if (failed.key != "count") return out + fmt::format(" is not for {} {}", failed.key, failed.seen);
  const CountCondition& count = rules.rules[nearest->rule].counts[failed.index];
  return out + fmt::format(" counts {}{} of {}", counted(failed.seen, "neighbour"),
                           count.faces_only ? " at its faces" : "", symbol_of(rules, count.of));
}

}  // namespace

Replayed replay_events(const BuildTarget& target, const std::vector<BrickEvent>& events) {
  assert(target.rules != nullptr);
  const RuleSet& rules = *target.rules;
  const RuleTable table(rules);
  std::map<Cell, Colour> standing;
  for (const PlacedBrick& brick : rules.start) standing[brick.at] = brick.brick;
  Replayed out;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const BrickEvent& event = events[i];
    if (event.kind == BrickEvent::Kind::left) {
      standing.erase(event.cell);
      continue;
    }
    ++out.placements;
    const Colour colour = colour_of(rules, event.led);
    std::string reason;
    if (colour == 0) {
      // A brick in no colour of the rules stands for nothing that a rule could see.
      reason = fmt::format("no brick of the rules shows '{}'", to_string(event.led));
    } else if (!out.against) {
      // After the first fault nothing is asked any more: what follows may rest on it.
      std::vector<PlacedBrick> bricks;
      bricks.reserve(standing.size());
      for (const auto& [cell, brick] : standing) bricks.push_back({cell, brick});
      // Without the box: sites beyond it are wrong by not being in the structure.
      const View view = view_at(Structure(rules.lattice, bricks), table, std::nullopt, event.cell);
      const Explanation said = explain(rules, view, event.cell.z, 1);
      const bool fires =
          std::any_of(said.rules.begin(), said.rules.end(), [&](const RuleExplanation& one) {
            return one.fires && rules.rules[one.rule].place == colour;
          });
      if (!fires) reason = reason_for(rules, said, event.cell, colour);
    }
    // Also one against the rules: it is there, and later ones were placed with it.
    if (colour != 0) standing[event.cell] = colour;
    if (out.against) continue;
    if (reason.empty()) {
      ++out.allowed;
      continue;
    }
    out.against =
        AgainstRules{i, fmt::format("{} came to rest at {:.1f} s, which no rule allows: {}",
                                    brick_text(rules, event.led, event.cell), event.time, reason)};
  }
  return out;
}

}  // namespace stig::validate
