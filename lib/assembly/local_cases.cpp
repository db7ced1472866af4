// SPDX-License-Identifier: MIT
#include "assembly/local_cases.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <tuple>

#include "compiler/columns.h"
#include "compiler/lanes.h"
#include "compiler/local_policy.h"
#include "compiler/local_situations.h"

namespace stig::assembly {

namespace {

/// The candidate's bricks without colours: where they are is what counts.
TargetBricks uncoloured(const TargetBricks& target) {
  std::vector<PlacedBrick> bricks;
  for (std::size_t i = 0; i < target.bricks(); ++i) bricks.push_back({target.cell(i), 1});
  return {bricks, 1};
}

/// What rules can ask of neighbours, and what robots see to besides.
Precedence precedence_of(const CandidateOrder& candidate, const TargetBricks& target,
                         const Builders& builders, Lanes& lanes) {
  std::vector<std::vector<std::uint32_t>> before(candidate.before.size());
  for (std::uint32_t i = 0; i < before.size(); ++i) {
    // A brick waits for earlier ones alone, so k < i covers all of them.
    for (std::uint32_t k = 0; k < i; ++k) {
      if (candidate.before[i].has(k)) before[i].push_back(k);
    }
  }
  Precedence out(before);
  // Besides, robots wait with bricks that would close a lane that is still needed. This is no rule:
  // their program sees to it, and here it takes situations away.
  wait_for_lanes(target, builders.sides, builders.robot, lanes, out);
  return out;
}

class LocalCases {
 public:
  LocalCases(const CandidateOrder& candidate, const Builders& builders,
             const std::shared_ptr<Visibility>& visibility)
      : builders_(builders),
        target_(uncoloured(*candidate.target)),
        lanes_(target_, builders.robot),
        precedence_(precedence_of(candidate, target_, builders, lanes_)),
        sight_(target_, visibility),
        local_(target_, precedence_, sight_) {}

  std::optional<Cases> run(std::size_t& looked) {
    find_lasting();
    std::size_t left = kMostLocalSituations;
    const BrickSet none(target_.bricks());
    for (const ApproachSide side : builders_.sides) {
      // One bound for all columns together and one for each, so that a single wide column cannot
      // use up what the others need.
      for (const auto& [u, v] : local_.columns(side)) {
        const std::size_t most = std::min(left, kMostAtColumn);
        std::size_t here = most;
        if (!local_.for_each(side, u, v, none, none, here,
                             [&](const LocalSituation& at) { look(at); })) {
          return std::nullopt;
        }
        left -= most - here;
        looked += most - here;
      }
    }
    if (!add_ways_on()) return std::nullopt;
    return std::move(out_);
  }

 private:
  /// From which sides a brick can be put as long as it is due.
  void find_lasting() {
    for (const ApproachSide side : builders_.sides) {
      std::vector<bool>& lasting = lasting_[static_cast<std::size_t>(side)];
      lasting.assign(target_.bricks(), false);
      // Brick 0 is the start, which stands already.
      for (std::uint32_t q = 1; q < target_.bricks(); ++q) {
        lasting[q] = always_in_reach(target_, precedence_, lanes_, builders_.robot, q, side);
      }
    }
  }

  using Key = std::tuple<ApproachSide, int, int, std::vector<std::uint8_t>>;
  Key key_of(const LocalSituation& at) {
    return {at.side, at.u, at.v, sight_.look(at.least, at.side, at.u, at.v).cells};
  }

  void look(const LocalSituation& at) {
    // Cases are told apart by what is seen without colours for bricks, hence by place as well: two
    // columns are two cases even where they look the same.
    Key key = key_of(at);
    const auto number = static_cast<std::uint32_t>(out_.cases.size());
    const auto [found, added] = numbers_.emplace(std::move(key), number);
    std::vector<Choice> choices = choices_of(at);
    if (added) {
      out_.cases.push_back(case_of(at, std::get<3>(found->first)));
      out_.cases.back().choices = std::move(choices);
      return;
    }
    // The same can be seen while hidden bricks differ. What is done there has to be right for all
    // of them, so only common choices stay.
    std::erase_if(out_.cases[found->second].choices, [&](const Choice& one) {
      return std::none_of(choices.begin(), choices.end(),
                          [&](const Choice& other) { return other.brick == one.brick; });
    });
  }

  Case case_of(const LocalSituation& at, const std::vector<std::uint8_t>& cells) const {
    assert(cells.size() <= kMostCells);
    Case out;
    out.side = at.side;
    out.bricks.assign(cells.size(), 0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      out.empty[i] = cells[i] == kSeenEmpty;
      out.filled[i] = cells[i] > kSeenBrick;
      if (!out.filled[i]) continue;
      const WindowCell cell = window_cell(i);
      out.bricks[i] = target_.brick_at(
          cell_from(at.side, {at.u + cell.du, at.v + cell.dv, cell.z + target_.floor_level()}));
    }
    return out;
  }

  std::vector<Choice> choices_of(const LocalSituation& at) const {
    std::vector<Choice> out;
    for (const std::uint32_t brick : bricks_about(target_, at.side, at.u, at.v)) {
      if (at.most.has(brick) || !lasting_[static_cast<std::size_t>(at.side)][brick] ||
          !precedence_.all_before(at.least, brick)) {
        continue;
      }
      auto where = next_to_column(target_, at.least, at.side, at.u, at.v, brick);
      if (!where) continue;
      // On top of the column there is one place only, so its height is not a part of the choice.
      if (where->du == 0 && where->dv == 0) where->z = 0;
      out.push_back({*where, brick});
    }
    return out;
  }

  /// Whatever brick can be the next in an order of ways on, is. False when none can.
  bool add_ways_on() {
    return can_go_on(target_, precedence_, [&](std::uint32_t q, const BrickSet& before) {
      return add_ways_on(q, before);
    });
  }

  /// False when there is none, whatever is done.
  bool add_ways_on(std::uint32_t q, const BrickSet& before) {
    std::vector<WayOn> ways;
    for (const ApproachSide side : builders_.sides) {
      const SideCell site = seen_from(side, target_.cell(q));
      for (const auto& [du, dv] : kColumnsAbout) {
        WayOn way = way_on(side, site.u + du, site.v + dv, q, before);
        if (!way.empty()) ways.push_back(std::move(way));
      }
    }
    if (ways.empty()) return false;
    out_.ways_on.push_back(std::move(ways));
    return true;
  }

  WayOn way_on(ApproachSide side, int u, int v, std::uint32_t q, const BrickSet& before) {
    // A way on must lead to an observation for certain, whatever else has been built meanwhile.
    if (!local_.always_comes(side, u, v, q, before)) return {};
    WayOn out;
    bool open = true;
    std::size_t most = kMostAtColumn;
    const bool all = local_.for_each(side, u, v, before, precedence_.above(q), most,
                                     [&](const LocalSituation& at) {
                                       out.push_back(numbers_.at(key_of(at)));
                                       open = open && !out_.cases[out.back()].choices.empty();
                                     });
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    // One situation without work is enough to close the way: the robot may find just that one.
    return all && open ? out : WayOn{};
  }

  const Builders& builders_;
  TargetBricks target_;
  Lanes lanes_;
  Precedence precedence_;
  Sight sight_;
  LocalSituations local_;
  std::array<std::vector<bool>, kAllSides.size()> lasting_;
  std::map<Key, std::uint32_t> numbers_;
  Cases out_;
};

}  // namespace

std::optional<Cases> local_cases(const CandidateOrder& candidate, const Builders& builders,
                                 const std::shared_ptr<Visibility>& visibility,
                                 std::size_t& looked) {
  if (candidate.before.size() > kMostOrderedBricks) return std::nullopt;
  return LocalCases(candidate, builders, visibility).run(looked);
}

}  // namespace stig::assembly
