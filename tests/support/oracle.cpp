// SPDX-License-Identifier: MIT
#include "support/oracle.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <unordered_set>
#include <utility>

#include "base/hash.h"
#include "base/random.h"
#include "support/uses.h"

namespace stig {
namespace {

constexpr int kSide = 64;

/// Where a cell is kept; off the rim, so that its neighbours are kept too.
std::size_t place_of(Cell c) {
  const auto inside = [](std::int32_t v) { return v > -kSide / 2 && v < kSide / 2 - 1; };
  assert(inside(c.x) && inside(c.y) && inside(c.z));
  return static_cast<std::size_t>(((c.z + kSide / 2) * kSide + c.y + kSide / 2) * kSide + c.x +
                                  kSide / 2);
}

bool pattern_fits(const Pattern& pattern, const Orientation& g, const Neighbourhood& n,
                  const View& view) {
  for (int i = 0; i < n.size; ++i) {
    const Offset seen = g.apply(n.offsets[static_cast<std::size_t>(i)]);
    const int there = n.index_of(seen);
    const State state = view.at[static_cast<std::size_t>(there)];
    if (!pattern.allowed[static_cast<std::size_t>(i)].contains(state)) return false;
  }
  return true;
}

bool counts_fit(const Rule& rule, const Neighbourhood& n, const View& view) {
  for (const CountCondition& condition : rule.counts) {
    int number = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      const bool asked = !condition.faces_only || n.is_face[i];
      if (asked && condition.of.contains(view.at[i])) ++number;
    }
    if (number < condition.min || number > condition.max) return false;
  }
  return true;
}

bool height_fits(const Rule& rule, std::int32_t z) {
  if (rule.height_min && z < *rule.height_min) return false;
  if (rule.height_max && z > *rule.height_max) return false;
  return true;
}

bool any_height(const RuleSet& rules) {
  return std::any_of(rules.rules.begin(), rules.rules.end(),
                     [](const Rule& r) { return r.height_min || r.height_max; });
}

}  // namespace

BrickMap start_of(const RuleSet& rules) {
  BrickMap bricks;
  for (const PlacedBrick& b : rules.start) bricks[b.at] = b.brick;
  return bricks;
}

OracleMatcher::OracleMatcher(const RuleSet& rules) : rules_(rules) {
  for (const Rule& rule : rules.rules) {
    groups_.push_back(
        orientations(rules.lattice, rules.symmetry_of(rule), rules.inversion_of(rule)));
  }
}

std::vector<Match> OracleMatcher::matches(const View& view, std::int32_t z, int stage) const {
  const Neighbourhood& n = neighbourhood(rules_.lattice);
  std::vector<Match> found;
  for (std::uint32_t r = 0; r < rules_.rules.size(); ++r) {
    const Rule& rule = rules_.rules[r];
    if (rule.stage != 0 && rule.stage != stage) continue;
    if (!height_fits(rule, z) || !counts_fit(rule, n, view)) continue;
    for (std::uint32_t g = 0; g < groups_[r].size(); ++g) {
      if (!pattern_fits(rule.pattern, groups_[r][g], n, view)) continue;
      found.push_back({r, g});
      break;
    }
  }
  return found;
}

OracleWorld::OracleWorld(const RuleSet& rules, std::optional<Box> box)
    : rules_(rules),
      matcher_(rules),
      box_(box),
      heights_matter_(any_height(rules)),
      cells_(static_cast<std::size_t>(kSide) * kSide * kSide, kEmpty),
      round_(cells_.size(), 0) {
  if (rules.floor) std::fill_n(cells_.begin(), cells_.size() / 2, kFloor);
  const Neighbourhood& n = neighbourhood(rules.lattice);
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    const Offset o = n.offsets[i];
    steps_.push_back((o.z * kSide + o.y) * kSide + o.x);
  }
}

void OracleWorld::place(const PlacedBrick& brick) {
  assert(cells_[place_of(brick.at)] == kEmpty);
  cells_[place_of(brick.at)] = brick.brick;
  bricks_.emplace(brick.at, brick.brick);
}

void OracleWorld::remove(const PlacedBrick& brick) {
  assert(cells_[place_of(brick.at)] == brick.brick);
  cells_[place_of(brick.at)] = kEmpty;
  bricks_.erase(brick.at);
}

View OracleWorld::view(Cell site) const {
  const State* here = &cells_[place_of(site)];
  View view;
  for (std::size_t i = 0; i < steps_.size(); ++i) view.at[i] = here[steps_[i]];
  return view;
}

std::size_t OracleWorld::SeenHash::operator()(const Seen& seen) const {
  std::uint64_t hash = static_cast<std::uint64_t>(seen.z) * 31 + static_cast<unsigned>(seen.stage);
  for (std::size_t i = 0; i < kMaxNeighbours; ++i) hash = hash * 0x100000001b3ULL + seen.view.at[i];
  return mix(hash);
}

const std::vector<Colour>& OracleWorld::colours_placed(Cell site, int stage) {
  const Seen seen{view(site), heights_matter_ ? site.z : 0, stage};
  const auto [entry, is_new] = memo_.try_emplace(seen);
  std::vector<Colour>& colours = entry->second;
  if (!is_new) return colours;
  for (const Match& m : matcher_.matches(seen.view, site.z, stage)) {
    colours.push_back(rules_.rules[m.rule].place);
  }
  std::sort(colours.begin(), colours.end());
  colours.erase(std::unique(colours.begin(), colours.end()), colours.end());
  return colours;
}

std::vector<Cell> OracleWorld::sites_beside_bricks() {
  const Neighbourhood& n = neighbourhood(rules_.lattice);
  std::vector<Cell> sites;
  ++rounds_;
  for (const auto& [cell, colour] : bricks_) {
    const std::size_t here = place_of(cell);
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const std::size_t there = here + static_cast<std::size_t>(steps_[i]);
      if (cells_[there] != kEmpty || std::exchange(round_[there], rounds_) == rounds_) continue;
      const Cell site = cell + n.offsets[i];
      if (!box_ || box_->contains(site)) sites.push_back(site);
    }
  }
  return sites;
}

std::vector<PlacedBrick> OracleWorld::events(int stage) {
  std::vector<PlacedBrick> events;
  for (const Cell site : sites_beside_bricks()) {
    for (const Colour colour : colours_placed(site, stage)) events.push_back({site, colour});
  }
  std::sort(events.begin(), events.end());
  return events;
}

namespace {

/// Deposits made, as sorted numbers of events: the key of a state.
using Deposits = std::u16string;

/// Follows every order, remembering the sets of deposits already seen.
class Explorer {
 public:
  Explorer(const RuleSet& rules, const BrickMap& start, int stage, std::optional<Box> box,
           ExplorationLimits limits)
      : world_(rules, box), stage_(stage), limits_(limits) {
    for (const auto& [cell, colour] : start) world_.place({cell, colour});
  }

  Exploration run() {
    visit({});
    while (!todo_.empty() && result_.complete) {
      const Deposits state = todo_.back();
      todo_.pop_back();
      expand(state);
    }
    result_.states = seen_.size();
    return result_;
  }

 private:
  void visit(const Deposits& state) {
    if (state.size() > limits_.deposits || seen_.size() >= limits_.states) {
      result_.complete = false;
    } else if (seen_.insert(state).second) {
      todo_.push_back(state);
    }
  }

  void expand(const Deposits& state) {
    for (const char16_t number : state) world_.place(events_[number]);
    const auto open = world_.events(stage_);
    if (open.empty()) result_.ends.push_back(world_.structure());
    for (const char16_t number : state) world_.remove(events_[number]);
    for (const PlacedBrick& event : open) {
      Deposits next = state;
      const char16_t number = number_of(event);
      next.insert(std::lower_bound(next.begin(), next.end(), number), number);
      visit(next);
    }
  }

  char16_t number_of(const PlacedBrick& event) {
    const auto [entry, is_new] = numbers_.try_emplace(event, static_cast<char16_t>(events_.size()));
    if (is_new) events_.push_back(event);
    return entry->second;
  }

  OracleWorld world_;
  int stage_;
  ExplorationLimits limits_;
  Exploration result_;
  std::unordered_set<Deposits> seen_;
  std::vector<Deposits> todo_;
  std::map<PlacedBrick, char16_t> numbers_;
  std::vector<PlacedBrick> events_;
};

}  // namespace

Exploration explore_orders(const RuleSet& rules, const BrickMap& start, int stage,
                           std::optional<Box> box, ExplorationLimits limits) {
  return Explorer(rules, start, stage, box, limits).run();
}

BrickMap build_in_some_order(const RuleSet& rules, const BrickMap& start, int stage,
                             std::uint64_t seed, std::optional<Box> box, std::size_t most) {
  OracleWorld world(rules, box);
  for (const auto& [cell, colour] : start) world.place({cell, colour});
  for (std::size_t step = 0; step < most; ++step) {
    const auto open = world.events(stage);
    if (open.empty()) break;
    Random random(seed, 0, Purpose::test, 0, step);
    world.place(open[static_cast<std::size_t>(random.below(open.size()))]);
  }
  return world.structure();
}

}  // namespace stig
