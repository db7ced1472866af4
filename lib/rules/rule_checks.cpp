// SPDX-License-Identifier: MIT
// The static checks, one function for each diagnostic or two. Each works on a rule set that
// was read completely, or, with CheckScope::certain, on what could be read of a faulty
// file; then nothing is said that a missing part could refute.
#include "rules/rule_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/text.h"
#include "rules/conflicts.h"
#include "rules/rule_printer.h"
#include "rules/site_condition.h"
#include "rules/view_search.h"

namespace stig::rules {

namespace {

/// One of the two views that occur without any brick: empty space, or bare floor.
View bare_view(Lattice lattice, bool on_floor) {
  const Neighbourhood& neighbours = neighbourhood(lattice);
  View view;
  for (int i = neighbours.first_below; on_floor && i < neighbours.size; ++i) {
    view.at[static_cast<std::size_t>(i)] = kFloor;
  }
  return view;
}

/// What a rule demands, right way up and, under inversion, upside down. Turns about the
/// vertical are left out: they permute cells within a level, which neither bare views nor
/// counts nor heights can tell apart.
std::vector<Demand> demands(const RuleSet& rules, const Rule& rule) {
  std::vector<Demand> out = {demand_of(rule)};
  if (!rules.inversion_of(rule)) return out;
  const auto group = orientations(rules.lattice, Symmetry::none, true);
  out.push_back(out[0]);
  out[1].pattern = turned(rule.pattern, group.back(), rules.lattice);
  return out;
}

/// Height at which a demand matches bare surroundings, if it does. In a world with floor, a
/// site on it sees it below, and any other sees none.
bool matches_bare(const RuleSet& rules, const Demand& demand, bool on_floor) {
  const View view = bare_view(rules.lattice, on_floor);
  if (on_floor) return fulfils(demand, rules.lattice, view, 0);
  const std::int32_t lowest = rules.floor ? 1 : INT32_MIN;
  const auto z = allowed_height(demand.where, {lowest, INT32_MAX});
  return z && fulfils(demand, rules.lattice, view, *z);
}

/// A rule that fires in empty space would fill the world from nothing; agents act beside
/// bricks only, but such a rule is never what its author means.
void check_bare(const RuleSet& rules, const Rule& rule, Diagnostics& out) {
  for (const Demand& demand : demands(rules, rule)) {
    const bool space = matches_bare(rules, demand, false);
    const bool floor = rules.floor && matches_bare(rules, demand, true);
    if (!space && !floor) continue;
    out.add(Code::R304, rule_place(rule),
            fmt::format("rule {} fires everywhere: it matches {} without a brick",
                        in_quotes(rule.name), floor ? "the floor" : "empty space"));
    return;
  }
}

/// Could the rule match if the demand were weaker by what `weaken` takes out of it? Used to
/// find out which condition stands in the way, by leaving them out one at a time.
template <class Weaken>
bool possible_without(const RuleSet& rules, const Rule& rule, Budget& budget, Weaken weaken) {
  for (Demand demand : demands(rules, rule)) {
    weaken(demand);
    Example example;
    if (find_view(rules, demand, example, budget) == Answer::yes) return true;
  }
  return false;
}

/// Which condition is it that nothing fulfils?
void note_obstacle(const RuleSet& rules, const Rule& rule, Budget& budget, Diagnostic& diagnostic) {
  const bool has_height = !allows_every_height(site_condition(rule));
  const auto no_height = [](Demand& demand) { demand.where = {}; };
  if (has_height && possible_without(rules, rule, budget, no_height)) {
    diagnostic.note(rules.floor ? "without its height it could: the floor is seen below a site at "
                                  "height 0, and at that height nothing else is"
                                : "without its height it could");
  }
  const auto no_counts = [](Demand& demand) { demand.counts.clear(); };
  if (!rule.counts.empty() && possible_without(rules, rule, budget, no_counts)) {
    diagnostic.note(
        "without its counts it could: no neighbourhood that fits the drawing meets them");
  }
}

/// One rule at a time: whether other rules build what it needs is a question for
/// never_fires.h and for proofs.
void check_possible(const RuleSet& rules, const Rule& rule, Budget& budget, Diagnostics& out) {
  for (const Demand& demand : demands(rules, rule)) {
    Example example;
    const Answer answer = find_view(rules, demand, example, budget);
    if (answer == Answer::yes) return;
    if (answer == Answer::unknown) {
      out.add(
          Code::R302, rule_place(rule),
          fmt::format("whether rule {} can ever match could not be decided", in_quotes(rule.name)));
      return;
    }
  }
  note_obstacle(
      rules, rule, budget,
      out.add(Code::R305, rule_place(rule),
              fmt::format("rule {} never matches: no neighbourhood fulfils its drawing and "
                          "conditions",
                          in_quotes(rule.name))));
}

void check_used_bricks(const RuleSet& rules, Diagnostics& out) {
  std::set<Colour> used;
  for (const PlacedBrick& brick : rules.start) used.insert(brick.brick);
  for (const Rule& rule : rules.rules) used.insert(rule.place);
  for (Colour c = 1; c <= rules.colours(); ++c) {
    if (used.count(c) > 0) continue;
    out.add(Code::R306, rules.brick(c).range,
            fmt::format("no rule places the brick {} and the start does not have it",
                        in_quotes(rules.brick(c).symbol)));
  }
}

void check_leds(const RuleSet& rules, Diagnostics& out) {
  std::map<std::string, const Brick*> seen;
  for (const Brick& brick : rules.bricks) {
    if (brick.led.empty()) continue;
    const auto [first, added] = seen.emplace(brick.led, &brick);
    if (added) continue;
    out.add(Code::R312, brick.range,
            fmt::format("the bricks {} and {} both have the block colour {}",
                        in_quotes(first->second->symbol), in_quotes(brick.symbol), brick.led))
        .note(first->second->range, "the first one");
  }
}

/// Rule sets made by a program have no places; their diagnostics have none either.
SourceRange start_place(const RuleSet& rules, std::size_t i) {
  return i < rules.places.start_bricks.size() ? rules.places.start_bricks[i] : SourceRange{};
}

bool inside(const BoxSpec& box, Cell cell) {
  const Offset o = cell - *box.origin;
  return o.x >= 0 && o.y >= 0 && o.z >= 0 && o.x < box.size.x && o.y < box.size.y &&
         o.z < box.size.z;
}

std::string shown(Cell c) { return fmt::format("[{}, {}, {}]", c.x, c.y, c.z); }

void check_start_cells(const RuleSet& rules, Diagnostics& out) {
  std::map<Cell, std::size_t> seen;
  for (std::size_t i = 0; i < rules.start.size(); ++i) {
    const Cell at = rules.start[i].at;
    const auto [first, added] = seen.emplace(at, i);
    if (!added) {
      out.add(Code::R308, start_place(rules, i), fmt::format("a second brick at {}", shown(at)))
          .note(start_place(rules, first->second), "the first one");
    }
    if (rules.floor && at.z < 0) {
      out.add(Code::R309, start_place(rules, i),
              fmt::format("{} is below the floor, which is at z = 0", shown(at)));
    }
    if (rules.box && rules.box->origin && !inside(*rules.box, at)) {
      out.add(Code::R310, start_place(rules, i), fmt::format("{} is outside the box", shown(at)));
    }
  }
}

/// A box without an origin is centred on the start, so only its size can be wrong.
void check_start_fits(const RuleSet& rules, Diagnostics& out) {
  if (!rules.box || rules.box->origin || rules.start.empty()) return;
  Cell low = rules.start[0].at, high = low;
  for (const PlacedBrick& b : rules.start) {
    low = {std::min(low.x, b.at.x), std::min(low.y, b.at.y), std::min(low.z, b.at.z)};
    high = {std::max(high.x, b.at.x), std::max(high.y, b.at.y), std::max(high.z, b.at.z)};
  }
  if (rules.floor) low.z = std::min(low.z, 0);  // such a box stands on the floor
  const Offset needed = high - low + Offset{1, 1, 1};
  const Offset size = rules.box->size;
  if (needed.x <= size.x && needed.y <= size.y && needed.z <= size.z) return;
  out.add(Code::R310, rules.places.start,
          fmt::format("the start needs {} × {} × {} cells, the box has {} × {} × {}", needed.x,
                      needed.y, needed.z, size.x, size.y, size.z));
}

void check_stages(const RuleSet& rules, Diagnostics& out) {
  std::map<int, const Rule*> named;
  for (const Rule& rule : rules.rules) {
    if (rule.stage > 0) named.emplace(rule.stage, &rule);
  }
  // Stages are numbered without gaps, since each begins when the one before has ended.
  int next = 1;
  for (const auto& [stage, rule] : named) {
    if (stage > next) {
      out.add(Code::R314, rule_place(*rule),
              fmt::format("rule {} belongs to stage {}, but no rule belongs to stage {}",
                          in_quotes(rule->name), stage, next));
    }
    next = stage + 1;
  }
  for (const auto& [stage, deposits] : rules.stages) {
    if (named.count(stage) > 0) continue;
    const auto place = rules.places.stages.find(stage);
    out.add(Code::R315, place == rules.places.stages.end() ? SourceRange{} : place->second,
            fmt::format("no rule belongs to stage {}", stage));
  }
}

/// One warning is enough when the key stands at the top of the file.
void check_inversion(const RuleSet& rules, Diagnostics& out) {
  for (const Rule& rule : rules.rules) {
    const bool height = !allows_every_height(site_condition(rule));
    if (!rules.inversion_of(rule) || (!height && !rules.floor)) continue;
    const SourceRange place = rule.inversion ? rule_place(rule) : rules.places.inversion;
    Diagnostic& warning = out.add(Code::R316, place,
                                  fmt::format("inversion turns drawings upside down, but not {}",
                                              rules.floor ? "the floor" : "heights"));
    if (!rule.inversion) {
      warning.note(rule_place(rule), "the first rule it holds for");
      return;
    }
  }
}

void check_expected_structure(const RuleSet& rules, const Expectation& expect, Diagnostics& out) {
  const auto amount = static_cast<std::int64_t>(expect.structure.size());
  if (amount == 0) return;
  if (expect.bricks && *expect.bricks != amount) {
    out.add(Code::R311, expect.structure_range,
            fmt::format("the structure has {}, expected are {}",
                        counted(static_cast<std::uint64_t>(amount), "brick"), *expect.bricks))
        .note(expect.bricks_range, "expected here");
  }
  // Bricks are never removed, so the end has at least the start's bricks of each colour.
  std::vector<std::int64_t> left(static_cast<std::size_t>(rules.colours()) + 1);
  for (const PlacedBrick& brick : expect.structure) ++left[brick.brick];
  for (const PlacedBrick& brick : rules.start) --left[brick.brick];
  for (Colour c = 1; c <= rules.colours(); ++c) {
    if (left[c] >= 0) continue;
    out.add(Code::R311, expect.structure_range,
            fmt::format("the structure has fewer bricks {} than the start",
                        in_quotes(rules.brick(c).symbol)))
        .note(rules.places.start, "the start");
  }
}

void check_expectation(const RuleSet& rules, Diagnostics& out) {
  if (!rules.expect) return;
  const Expectation& expect = *rules.expect;
  check_expected_structure(rules, expect, out);
  const auto start = static_cast<std::int64_t>(rules.start.size());
  if (expect.bricks && *expect.bricks < start) {
    out.add(Code::R311, expect.bricks_range,
            fmt::format("the end cannot have {}: the start has {}",
                        counted(static_cast<std::uint64_t>(*expect.bricks), "brick"), start))
        .note(rules.places.start, "the start");
  }
  const bool end = expect.bricks || !expect.structure.empty();
  if (expect.verdict == Verdict::endless && end) {
    out.add(Code::R311, expect.verdict_range,
            "a set that builds without end has no number of bricks and no structure in the end")
        .note(expect.bricks ? expect.bricks_range : expect.structure_range, "expected here");
  }
}

}  // namespace

void check_rule_set(const RuleSet& rules, CheckScope scope, Diagnostics& diagnostics) {
  // Shared by all rules, in the steps of kBudget in conflicts.cpp: well below a second.
  Budget budget = 200'000'000;
  for (const Rule& rule : rules.rules) {
    check_bare(rules, rule, diagnostics);
    check_possible(rules, rule, budget, diagnostics);
  }
  check_repetitions(rules, diagnostics);
  check_conflicts(rules, diagnostics);
  check_start_cells(rules, diagnostics);
  check_start_fits(rules, diagnostics);
  check_leds(rules, diagnostics);
  if (scope == CheckScope::certain) return;
  if (rules.start.empty()) {
    diagnostics.add(Code::R307, rules.places.start, "the start has no brick");
  }
  check_expectation(rules, diagnostics);
  check_used_bricks(rules, diagnostics);
  check_stages(rules, diagnostics);
  check_inversion(rules, diagnostics);
}

}  // namespace stig::rules
