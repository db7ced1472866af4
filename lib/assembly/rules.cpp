// SPDX-License-Identifier: MIT
// One rule for each brick that is put, merged only where two are alike in every way. They are not
// generalised: a rule that asks for less could hold where none was meant to.
#include "assembly/rules.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <set>

#include "rules/neighbourhood.h"

namespace stig::assembly {

namespace {

/// Free colours numbered in the order in which they come. A solver's colours come with gaps and in
/// any order; a file reads better when they are numbered as they are first used. Colours that the
/// target names keep their numbers.
std::vector<Colour> renumbered(const std::vector<Colour>& colours, std::size_t named) {
  std::map<Colour, Colour> number;
  std::vector<Colour> out;
  for (const Colour c : colours) {
    if (c <= named) {
      out.push_back(c);
      continue;
    }
    const auto next = static_cast<Colour>(named + number.size() + 1);
    out.push_back(number.emplace(c, next).first->second);
  }
  return out;
}

/// What stands about a brick's site when it is due.
Pattern pattern_of(const CandidateOrder& candidate, std::uint32_t brick,
                   const std::vector<Colour>& colours) {
  const Neighbourhood& n = neighbourhood(Lattice::cubic);
  const TargetBricks& target = *candidate.target;
  Pattern out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    const Cell cell = target.cell(brick) + n.offsets[i];
    const std::uint32_t other = target.brick_at(cell);
    if (other != TargetBricks::kNone && candidate.before[brick].has(other)) {
      out.allowed[i] = StateSet::of(colours[other]);
    } else if (other != TargetBricks::kNone && candidate.free[brick].has(other)) {
      // A free neighbour may be there or not: the rule holds in both cases.
      out.allowed[i] = StateSet::of(colours[other]) | StateSet::empty_cell();
    } else {
      out.allowed[i] = cell.z < 0 ? StateSet::floor() : StateSet::empty_cell();
    }
  }
  return out;
}

/// Bricks whose rules would also hold on another level, where they must not.
std::set<std::uint32_t> that_need_heights(const RuleView& view, const Colouring& by_orbit) {
  std::set<std::uint32_t> out;
  const Schedule& schedule = *view.schedule;
  // Painting lets sites of different levels clash, as a height can tell them apart: those that
  // still clash under these colours get one.
  // Bricks are noted as they are met, one clash for each: there may be far more clashes than
  // could be listed, and none of the bricks may be missed.
  constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  find_clashes(schedule, by_orbit, kAll, kAll, {}, [&](const Clash& clash) {
    const auto from = schedule.keys[static_cast<std::size_t>(clash.key)].site;
    out.insert(view.brick[static_cast<std::size_t>(from)]);
    return false;
  });
  return out;
}

struct ExactRules {
  std::vector<MergedRule> rules;
  std::vector<std::optional<std::pair<int, int>>> heights;  ///< beside `rules`
};

struct SameRule {
  Pattern pattern;
  Colour place = 0;
  std::set<int> levels;
  bool needs_height = false;
  std::int32_t rank = 0;
};

void add_rules(const SameRule& same, ExactRules& out) {
  const MergedRule rule{same.pattern, same.place, same.rank};
  if (!same.needs_height) {
    out.rules.push_back(rule);
    out.heights.emplace_back();
    return;
  }
  // Levels that follow each other are one range, since a rule has one range of heights.
  for (auto level = same.levels.begin(); level != same.levels.end();) {
    const int low = *level;
    int high = low;
    for (++level; level != same.levels.end() && *level == high + 1; ++level) ++high;
    out.rules.push_back(rule);
    out.heights.emplace_back(std::pair(low, high));
  }
}

ExactRules exact_rules(const CandidateOrder& candidate, const std::vector<Colour>& colours,
                       const std::set<std::uint32_t>& need_heights) {
  std::vector<SameRule> found;
  for (std::uint32_t i = 1; i < candidate.target->bricks(); ++i) {
    const Pattern pattern = pattern_of(candidate, i, colours);
    const auto same = [&](const SameRule& one) {
      return one.pattern == pattern && one.place == colours[i];
    };
    // Linear in rules found so far, which merging keeps short for regular structures.
    auto at = std::find_if(found.begin(), found.end(), same);
    if (at == found.end()) {
      // The rank of the first brick that needs it orders rules as work goes.
      at = found.insert(at, {pattern, colours[i], {}, false, static_cast<std::int32_t>(i)});
    }
    at->levels.insert(candidate.target->cell(i).z);
    at->needs_height = at->needs_height || need_heights.contains(i);
  }
  ExactRules out;
  for (const SameRule& one : found) add_rules(one, out);
  return out;
}

/// Every brick gets a block colour that no other has. LEDs are how robots read a colour off a
/// block. Names that the target gave stay; others take the lowest that is free.
void add_leds(RuleSet& rules) {
  std::set<std::string> taken;
  for (const Brick& brick : rules.bricks) taken.insert(brick.led);
  for (Brick& brick : rules.bricks) {
    for (int q = 1; brick.led.empty() && q <= kMaxColours; ++q) {
      const std::string led = "Q" + std::to_string(q);
      if (taken.insert(led).second) brick.led = led;
    }
  }
}

}  // namespace

RuleSet rules_of(const Target& target, const CandidateOrder& candidate, const RuleView& view,
                 const std::vector<Colour>& colours, const std::vector<ApproachSide>& sides,
                 std::optional<int> robots, const Wording& wording) {
  assert(view.schedule && colours.size() == candidate.target->bricks());
  const std::vector<Colour> painted = renumbered(colours, target.bricks.size());
  Colouring by_orbit(view.brick.size());
  for (std::size_t i = 0; i < by_orbit.size(); ++i) by_orbit[i] = painted[view.brick[i]];
  const ExactRules exact = exact_rules(candidate, painted, that_need_heights(view, by_orbit));
  const int count = std::max<int>(*std::max_element(painted.begin(), painted.end()),
                                  static_cast<int>(target.bricks.size()));
  RuleSet out = make_rule_set(view.frame, by_orbit, count, target.bricks, exact.rules, wording);
  for (std::size_t i = 0; i < out.rules.size(); ++i) {
    if (!exact.heights[i]) continue;
    out.rules[i].height_min = exact.heights[i]->first;
    out.rules[i].height_max = exact.heights[i]->second;
  }
  add_leds(out);
  out.physical.emplace();
  for (const ApproachSide side : sides) out.physical->sides.emplace_back(to_string(side));
  out.physical->robots = robots;
  return out;
}

}  // namespace stig::assembly
