// SPDX-License-Identifier: MIT
#include "support/small_worlds.h"
#include "support/uses.h"

#include <map>
#include <random>
#include <string>
#include <vector>

namespace stig {
namespace {

class Maker {
 public:
  explicit Maker(std::uint64_t seed) : words_(seed * 2654435761 + 17) {}

  RuleSet make() {
    RuleSet rules;
    rules.name = "small world";
    rules.lattice = one_in(3) ? Lattice::hexagonal : Lattice::cubic;
    rules.symmetry = one_in(3) ? static_cast<Symmetry>(number(1, 2)) : Symmetry::none;
    rules.floor = one_in(4);
    rules.inversion = !rules.floor && one_in(8);
    rules.bricks = {{"1", "one", "#e6194b", "", {}}, {"2", "two", "#3cb44b", "", {}}};
    const Offset size{number(1, 4), number(1, 4), number(1, 3)};
    rules.box = BoxSpec{size, Cell{0, 0, 0}, one_in(8)};
    const Cell at{number(0, size.x - 1), number(0, size.y - 1), number(0, size.z - 1)};
    rules.start = {{at, 1}};
    rules.conflicts = static_cast<Conflicts>(number(0, 2));
    const int stages = one_in(8) ? 2 : 1;
    const int count = number(2, 8);
    for (int r = 0; r < count; ++r) rules.rules.push_back(rule(rules, stages, r));
    if (stages == 2) rules.rules.front().stage = 2;
    if (stages == 2 && one_in(3)) rules.stages[1] = number(1, 4);
    return rules;
  }

 private:
  int number(int low, int high) {
    return low + static_cast<int>(words_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(int n) { return number(1, n) == 1; }

  Rule rule(const RuleSet& rules, int stages, int number_of_rule) {
    Rule rule;
    rule.name = "r" + std::to_string(number_of_rule);
    rule.place = static_cast<Colour>(number(1, 2));
    const Neighbourhood& n = neighbourhood(rules.lattice);
    const int manner = number(0, 3);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      rule.pattern.allowed[i] = cell(rules, manner, i < static_cast<std::size_t>(n.first_below));
    }
    // Without a brick to stand beside, a rule fires everywhere.
    std::size_t must = 0;
    do {
      must = static_cast<std::size_t>(number(0, n.size - 1));
    } while (!n.is_face[must] && !one_in(4));
    if (one_in(20)) return finish(stages, rule);  // it acts beside whatever there is
    rule.pattern.allowed[must] =
        one_in(3) ? StateSet::bricks(2) : StateSet::of(static_cast<State>(number(1, 2)));
    return finish(stages, rule);
  }

  Rule finish(int stages, Rule rule) {
    if (one_in(6)) rule.height_min = number(0, 1);
    if (one_in(6)) rule.height_max = number(0, 2);
    if (one_in(6)) {
      CountCondition count;
      count.of = one_in(2) ? StateSet::bricks(2) : StateSet::of(static_cast<State>(number(0, 2)));
      count.faces_only = one_in(2);
      count.min = number(0, 2);
      count.max = number(count.min, one_in(2) ? 3 : 26);
      rule.counts.push_back(count);
    }
    if (one_in(8)) rule.probability = 0.5;
    if (one_in(6)) rule.symmetry = static_cast<Symmetry>(number(0, 2));
    rule.stage = stages == 1 ? 0 : number(0, 2);
    return rule;
  }

  /// Manners: faces of interest only, mostly anything, mostly empty, mixed.
  StateSet cell(const RuleSet& rules, int manner, bool above_or_level) {
    const int odds[] = {16, 8, 2, 4};
    if (manner == 2) {
      if (rules.floor && !above_or_level) return StateSet::anything();
      return one_in(9) ? StateSet::of(static_cast<State>(number(1, 2))) : StateSet::empty_cell();
    }
    if (!one_in(odds[manner])) return StateSet::anything();
    switch (number(0, 4)) {
      case 0:
        return StateSet::bricks(2);
      case 1:
        return StateSet::of(static_cast<State>(number(1, 2)));
      case 2:
        return StateSet(static_cast<std::uint64_t>(number(1, 7)));
      default:
        return StateSet::empty_cell();
    }
  }

  std::mt19937_64 words_;
};

/// The set's box, cell by cell.
class TinyWorld {
 public:
  explicit TinyWorld(const RuleSet& rules)
      : rules_(rules), matcher_(rules), low_(*rules.box->origin), size_(rules.box->size) {}

  using States = std::vector<State>;

  States start() const {
    States states(static_cast<std::size_t>(size_.x * size_.y * size_.z), kEmpty);
    for (const PlacedBrick& brick : rules_.start) states[index(brick.at)] = brick.brick;
    return states;
  }
  /// Adds every structure that one event leads to.
  void successors(const States& states, int stage, std::set<States>& out) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (states[i] != kEmpty) continue;
      for (const Colour colour : placed(states, cell(i), stage)) {
        States next = states;
        next[i] = colour;
        out.insert(std::move(next));
      }
    }
  }
  const std::set<std::uint32_t>& fired() const { return fired_; }
  BrickMap bricks(const States& states) const {
    BrickMap map;
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (states[i] != kEmpty) map[cell(i)] = states[i];
    }
    return map;
  }

 private:
  std::size_t index(Cell c) const {
    const Offset o = c - low_;
    return static_cast<std::size_t>((o.z * size_.y + o.y) * size_.x + o.x);
  }
  Cell cell(std::size_t i) const {
    const auto n = static_cast<std::int32_t>(i);
    return low_ + Offset{n % size_.x, n / size_.x % size_.y, n / (size_.x * size_.y)};
  }
  State at(const States& states, Cell c) const {
    if (rules_.floor && c.z < 0) return kFloor;
    Offset o = c - low_;
    if (rules_.box->periodic) {
      o.x = (o.x % size_.x + size_.x) % size_.x;
      o.y = (o.y % size_.y + size_.y) % size_.y;
      if (!rules_.floor) o.z = (o.z % size_.z + size_.z) % size_.z;
    }
    const bool inside =
        o.x >= 0 && o.x < size_.x && o.y >= 0 && o.y < size_.y && o.z >= 0 && o.z < size_.z;
    return inside ? states[index(low_ + o)] : kEmpty;
  }
  const std::vector<Colour>& placed(const States& states, Cell site, int stage) {
    const Neighbourhood& n = neighbourhood(rules_.lattice);
    View view;
    bool beside = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      view.at[i] = at(states, site + n.offsets[i]);
      beside = beside || is_brick(view.at[i]);
    }
    std::string key(view.at.begin(), view.at.end());
    key += std::to_string(site.z) + '/' + std::to_string(stage);
    const auto [it, fresh] = memo_.try_emplace(key);
    if (fresh && beside) {
      for (const Match& match : matcher_.matches(view, site.z, stage)) {
        it->second.push_back(rules_.rules[match.rule].place);
        fired_.insert(match.rule);
        if (rules_.conflicts == Conflicts::first) break;
      }
    }
    return it->second;
  }

  const RuleSet& rules_;
  OracleMatcher matcher_;
  Cell low_;
  Offset size_;
  std::map<std::string, std::vector<Colour>> memo_;
  std::set<std::uint32_t> fired_;
};

/// The world's structures at the end of a stage; nothing when more than `most` are met.
std::optional<std::set<TinyWorld::States>> follow(TinyWorld& world, const RuleSet& rules,
                                                  std::size_t most, int last) {
  std::set<TinyWorld::States> begins{world.start()};
  for (int stage = 1; stage <= last; ++stage) {
    const auto limit = rules.stages.find(stage);
    std::set<TinyWorld::States> ends;
    // A stage's limit counts its own deposits, so each beginning is followed alone.
    for (const TinyWorld::States& begin : begins) {
      std::set<TinyWorld::States> layer{begin};
      std::size_t met = 0;
      for (std::int64_t deposits = 0; !layer.empty(); ++deposits) {
        std::set<TinyWorld::States> next;
        for (const TinyWorld::States& states : layer) {
          const std::size_t had = next.size();
          std::set<TinyWorld::States> after;
          if (limit == rules.stages.end() || deposits < limit->second) {
            world.successors(states, stage, after);
          }
          if (after.empty()) ends.insert(states);
          next.merge(after);
          met += next.size() - had;
          if (met > most) return std::nullopt;
        }
        layer = std::move(next);
      }
    }
    begins = std::move(ends);
  }
  return begins;
}

}  // namespace

RuleSet small_world(std::uint64_t seed) { return Maker(seed).make(); }

RuleSet staged_small_world(std::uint64_t seed) {
  RuleSet rules = small_world(seed);
  std::mt19937_64 words(seed);
  const int stages =
      std::min(2 + static_cast<int>(words() % 2), static_cast<int>(rules.rules.size()));
  rules.stages.clear();
  for (std::size_t r = 0; r < rules.rules.size(); ++r) {
    const int turn = static_cast<int>(r) + 1;
    const auto any = static_cast<int>(words() % static_cast<std::uint64_t>(stages + 1));
    rules.rules[r].stage = turn <= stages ? turn : any;
  }
  for (int stage = 1; stage <= stages; ++stage) {
    if (words() % 6 == 0) rules.stages[stage] = static_cast<std::int64_t>(1 + words() % 4);
  }
  Rule column;
  column.name = "column";
  column.place = 2;
  column.stage = stages + 1;
  const auto below = static_cast<std::size_t>(neighbourhood(rules.lattice).index_of({0, 0, -1}));
  column.pattern.allowed[below] = StateSet::bricks(2);
  rules.rules.push_back(column);
  return rules;
}

std::set<std::uint32_t> rules_seen_to_fire(const RuleSet& rules, std::size_t most) {
  TinyWorld world(rules);
  follow(world, rules, most, rules.stage_count());
  return world.fired();
}

std::optional<std::set<BrickMap>> all_ends(const RuleSet& rules, std::size_t most, int last_stage) {
  TinyWorld world(rules);
  const auto ends = follow(world, rules, most, last_stage == 0 ? rules.stage_count() : last_stage);
  if (!ends) return std::nullopt;
  std::set<BrickMap> maps;
  for (const TinyWorld::States& states : *ends) maps.insert(world.bricks(states));
  return maps;
}

}  // namespace stig
