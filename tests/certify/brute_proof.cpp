// SPDX-License-Identifier: MIT
#include "certify/brute_proof.h"

#include <rapidcheck.h>

#include <algorithm>
#include <map>

#include "lattice/swarm.h"
#include "rules/rule_printer.h"
#include "support/oracle.h"
#include "support/uses.h"

namespace stig {
namespace {

Box box_of(const RuleSet& rules) { return lay_box(*rules.box, rules.start, rules.floor); }

Bricks with(Bricks bricks, const PlacedBrick& brick) {
  bricks.insert(std::lower_bound(bricks.begin(), bricks.end(), brick), brick);
  return bricks;
}

Bricks without(Bricks bricks, const PlacedBrick& brick) {
  bricks.erase(std::lower_bound(bricks.begin(), bricks.end(), brick));
  return bricks;
}

bool has_brick(const Bricks& bricks, const PlacedBrick& brick) {
  return std::binary_search(bricks.begin(), bricks.end(), brick);
}

/// Sorted, each once.
Bricks events_of(const RuleSet& rules, const RuleTable& table, const OracleMatcher& matcher,
                 const Bricks& bricks, int stage) {
  const Structure structure(rules.lattice, bricks);
  Bricks events;
  for (const Cell site : enabled_sites(structure, table, box_of(rules), stage)) {
    const View view = view_at(structure, table, box_of(rules), site);
    for (const Match& match : matcher.matches(view, site.z, stage)) {
      events.push_back({site, rules.rules[match.rule].place});
      if (rules.conflicts == Conflicts::first) break;
    }
  }
  std::sort(events.begin(), events.end());
  events.erase(std::unique(events.begin(), events.end()), events.end());
  return events;
}

bool is_subset(const Bricks& part, const Bricks& whole) {
  return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
}

/// One stage's claim, made from what was reached on the way to one end.
class Claim {
 public:
  Claim(const RuleSet& rules, const ReachedStage& stage) : rules_(rules), stage_(stage) {
    end_ = *stage.ends.begin();
    for (const auto& [bricks, events] : stage.events) {
      if (is_subset(bricks, end_)) reached_.push_back(bricks);
    }
    write_order();
  }

  CertifiedStage write(Grouping grouping) {
    choose_group(grouping);
    write_before();
    write_far();
    if (!group_.empty()) write_window();
    return out_;
  }

 private:
  bool has(const Bricks& bricks, std::uint32_t position) const {
    const CertifiedBrick& brick = out_.order[position];
    return has_brick(bricks, {brick.at, brick.colour});
  }

  /// Backwards from the end, by events: that a structure is reached with a brick more does not say
  /// that a rule places that brick there. A step back is always found, since all was reached.
  void write_order() {
    Bricks now = end_;
    while (now != stage_.start) {
      Bricks last;
      for (const PlacedBrick& brick : now) {
        const auto found = stage_.events.find(without(now, brick));
        if (found != stage_.events.end() && has_brick(found->second, brick)) last.push_back(brick);
      }
      const PlacedBrick brick = *rc::gen::elementOf(last);
      now = without(now, brick);
      out_.order.push_back({brick.at, brick.brick, 0});
    }
    std::reverse(out_.order.begin(), out_.order.end());
    for (std::uint32_t i = 0; i < out_.order.size(); ++i) number_of_[out_.order[i].at] = i;
  }

  void choose_group(Grouping grouping) {
    for (std::uint32_t i = 0; i < out_.order.size(); ++i) {
      const bool in =
          grouping == Grouping::all || (grouping == Grouping::some && *rc::gen::inRange(0, 3) == 0);
      if (in) group_.insert(i);
    }
  }

  std::optional<std::uint32_t> neighbour(std::uint32_t position, std::size_t index) const {
    const Offset offset = neighbourhood(rules_.lattice).offsets[index];
    const Cell cell = box_of(rules_).wrap(out_.order[position].at + offset);
    const auto found = number_of_.find(cell);
    if (found == number_of_.end()) return std::nullopt;
    return found->second;
  }

  bool always_before(std::uint32_t p, std::uint32_t q) const {
    return p < q && std::all_of(reached_.begin(), reached_.end(), [&](const Bricks& bricks) {
             return !has(bricks, q) || has(bricks, p);
           });
  }

  void write_before() {
    const auto size = static_cast<std::size_t>(neighbourhood(rules_.lattice).size);
    for (std::uint32_t q = 0; q < out_.order.size(); ++q) {
      for (std::size_t i = 0; i < size && group_.count(q) == 0; ++i) {
        const auto p = neighbour(q, i);
        if (p && always_before(*p, q)) out_.order[q].before |= 1U << i;
      }
    }
  }

  /// Every chain of two steps.
  void write_far() {
    const auto before = [&](std::uint32_t q) {
      std::set<std::uint32_t> earlier;
      for (std::uint32_t rest = out_.order[q].before; rest != 0; rest &= rest - 1) {
        earlier.insert(*neighbour(q, static_cast<std::size_t>(std::countr_zero(rest))));
      }
      return earlier;
    };
    for (std::uint32_t q = 0; q < out_.order.size(); ++q) {
      for (const std::uint32_t p : before(q)) {
        for (const std::uint32_t o : before(p)) out_.far.push_back({q, p, o});
      }
    }
  }

  void write_window() {
    CertifiedWindow window;
    std::set<std::uint32_t> context;
    const auto size = static_cast<std::size_t>(neighbourhood(rules_.lattice).size);
    for (const std::uint32_t g : group_) {
      window.group.push_back(g);
      for (std::size_t i = 0; i < size; ++i) {
        const auto p = neighbour(g, i);
        if (p && group_.count(*p) == 0) context.insert(*p);
      }
    }
    window.context.assign(context.begin(), context.end());
    std::vector<std::uint32_t> members = window.group;
    members.insert(members.end(), context.begin(), context.end());
    std::set<std::uint64_t> fillings;
    for (const Bricks& bricks : reached_) {
      std::uint64_t filling = 0;
      for (std::size_t i = 0; i < members.size(); ++i) {
        if (has(bricks, members[i])) filling |= std::uint64_t{1} << i;
      }
      fillings.insert(filling);
    }
    for (const std::uint64_t filling : fillings) window.fillings.push_back({filling});
    out_.windows.push_back(window);
  }

  const RuleSet& rules_;
  const ReachedStage& stage_;
  Bricks end_;
  std::vector<Bricks> reached_;  ///< on the way to the end
  std::map<Cell, std::uint32_t> number_of_;
  std::set<std::uint32_t> group_;
  CertifiedStage out_;
};

}  // namespace

std::optional<std::vector<ReachedStage>> reach_all(const RuleSet& rules, std::size_t most) {
  const RuleTable table(rules);
  const OracleMatcher matcher(rules);
  Bricks start = rules.start;
  std::sort(start.begin(), start.end());
  std::vector<ReachedStage> stages;
  for (int number = 1; number <= rules.stage_count(); ++number) {
    ReachedStage stage{start, {{start, {}}}, {}};
    std::vector<Bricks> waiting{start};
    const auto limit = static_cast<std::size_t>(table.stage_limit(number));
    while (!waiting.empty()) {
      const Bricks bricks = waiting.back();
      waiting.pop_back();
      Bricks events;
      if (limit == 0 || bricks.size() - start.size() < limit) {
        events = events_of(rules, table, matcher, bricks, number);
      }
      if (events.empty()) stage.ends.insert(bricks);
      for (const PlacedBrick& event : events) {
        const Bricks next = with(bricks, event);
        if (stage.events.try_emplace(next).second) waiting.push_back(next);
      }
      stage.events[bricks] = events;
      if (stage.events.size() > most) return std::nullopt;
    }
    stages.push_back(stage);
    if (stage.ends.size() > 1) break;
    start = *stage.ends.begin();
  }
  return stages;
}

Certificate certificate_of(const RuleSet& rules, const std::vector<ReachedStage>& stages,
                           Grouping grouping) {
  Certificate certificate;
  certificate.rule_set_hash = rule_set_hash(rules);
  certificate.box = rules.box;
  for (const ReachedStage& stage : stages) {
    certificate.stages.push_back(Claim(rules, stage).write(grouping));
  }
  certificate.stages.resize(static_cast<std::size_t>(rules.stage_count()));
  certificate.bricks = stages.back().ends.begin()->size();
  return certificate;
}

}  // namespace stig
