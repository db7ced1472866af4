// SPDX-License-Identifier: MIT
// A partial order on bricks as two bit matrices, everything below and everything above each
// brick. Closure is maintained when an edge is added, O(n^2 / 64) words, so queries are
// single words. 6000 bricks take 9 MB.
#include "compiler/precedence.h"

#include <algorithm>
#include <cassert>
#include <optional>

namespace stig::compiler {

namespace {

/// Every brick after those that it waits for. Topological sort (A. Kahn 1962). A cycle
/// would leave bricks out, which the constructor asserts.
std::vector<std::uint32_t> sorted(const std::vector<std::vector<std::uint32_t>>& before) {
  std::vector<std::vector<std::uint32_t>> after(before.size());
  std::vector<std::size_t> waits(before.size());
  for (std::uint32_t i = 0; i < before.size(); ++i) {
    waits[i] = before[i].size();
    for (const std::uint32_t one : before[i]) after[one].push_back(i);
  }
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < before.size(); ++i) {
    if (waits[i] == 0) out.push_back(i);
  }
  for (std::size_t next = 0; next < out.size(); ++next) {
    for (const std::uint32_t one : after[out[next]]) {
      if (--waits[one] == 0) out.push_back(one);
    }
  }
  return out;
}

}  // namespace

Precedence::Precedence(const std::vector<std::vector<std::uint32_t>>& before) {
  const std::vector<std::uint32_t> order = sorted(before);
  assert(order.size() == before.size() && before.size() <= kMostOrderedBricks);
  below_.assign(before.size(), BrickSet(before.size()));
  above_ = below_;
  for (const std::uint32_t i : order) {
    below_[i].add(i);
    for (const std::uint32_t one : before[i]) below_[i].add(below_[one]);
  }
  for (auto at = order.rbegin(); at != order.rend(); ++at) {
    above_[*at].add(*at);
    for (const std::uint32_t one : before[*at]) above_[one].add(above_[*at]);
  }
}

/// All below `first` is now below all above `then`.
void Precedence::add(std::uint32_t first, std::uint32_t then) {
  assert(!below_[first].has(then));
  if (below_[then].has(first)) return;
  for (std::size_t i = 0; i < bricks(); ++i) {
    if (below_[first].has(i)) above_[i].add(above_[then]);
    if (above_[then].has(i)) below_[i].add(below_[first]);
  }
}

bool Precedence::all_before(const BrickSet& state, std::uint32_t brick) const {
  assert(brick < bricks());
  return state.contains_but(below_[brick], brick);
}

/// Ordered by the number of predecessors: a predecessor has strictly fewer.
std::vector<std::uint32_t> Precedence::order() const {
  std::vector<std::size_t> rank;
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < bricks(); ++i) {
    rank.push_back(below_[i].count());
    out.push_back(i);
  }
  std::stable_sort(out.begin(), out.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return rank[a] < rank[b]; });
  return out;
}

namespace {

/// By brick, some of those that come before it: what its rules demand, those left out that can
/// never fire by what is known of the order.
std::vector<std::vector<std::uint32_t>> demanded(const TargetStates& target,
                                                 const TargetStates::ComesBefore& known) {
  std::vector<std::vector<std::uint32_t>> before(target.bricks());
  for (std::uint32_t i = static_cast<std::uint32_t>(target.start_bricks()); i < target.bricks();
       ++i) {
    for (std::uint32_t s = 0; s < target.start_bricks(); ++s) before[i].push_back(s);
    const Demands asked = target.demands(i, known);
    before[i].insert(before[i].end(), asked.always.begin(), asked.always.end());
    // If a rule forbids a neighbour always, the neighbour can only come later: the proof
    // has shown that every order ends in the whole structure.
    for (const std::uint32_t later : asked.never) before[later].push_back(i);
  }
  return before;
}

}  // namespace

/// Every round is right by the one before: whatever stands is closed under what is known, so
/// rules that match no closed structure never fire, and the others may demand more.
Precedence precedence_of(const TargetStates& target) {
  constexpr int kMostRounds = 32;
  auto before = demanded(target, [](std::uint32_t, std::uint32_t) { return false; });
  Precedence out(before);
  for (int round = 0; round < kMostRounds; ++round) {
    auto more = demanded(target, [&](std::uint32_t first, std::uint32_t then) {
      return out.below(then).has(first);
    });
    if (more == before) break;
    before = std::move(more);
    out = Precedence(before);
  }
  return out;
}

namespace {

/// Bricks that have to wait for one, if it is to be put from a side whenever it is due. The
/// counterpart of reach_between: each condition there becomes a demand that some brick
/// waits.
class Waiters {
 public:
  Waiters(const TargetBricks& target, const Abilities& robot, Lanes& lanes,
          const Precedence& precedence)
      : target_(target), robot_(robot), lanes_(lanes), precedence_(precedence) {}

  /// Nothing when it cannot be put from there, whatever waits.
  std::optional<std::vector<std::uint32_t>> of(std::uint32_t brick, ApproachSide side) {
    out_.clear();
    possible_ = true;
    brick_ = brick;
    side_ = side;
    site_ = seen_from(side, target_.cell(brick));
    const BrickSet& lane = lanes_.to(brick, side);
    for (std::uint32_t i = 0; i < target_.bricks(); ++i) {
      if (lane.has(i)) make_wait(i);
    }
    leave_a_way_in();
    leave_room_for_the_effector();
    return possible_ ? std::optional(out_) : std::nullopt;
  }

 private:
  std::uint32_t at(int du, int dv, int dz) const {
    return target_.brick_at(cell_from(side_, {site_.u + du, site_.v + dv, site_.z + dz}));
  }
  bool comes_before(std::uint32_t other) const {
    return other != TargetBricks::kNone && precedence_.below(brick_).has(other);
  }
  void make_wait(std::uint32_t other) {
    if (other == TargetBricks::kNone || precedence_.above(brick_).has(other)) return;
    possible_ = possible_ && !comes_before(other);
    out_.push_back(other);
  }

  /// A site between two bricks cannot be entered, so one of the two beside it has to wait.
  void leave_a_way_in() {
    const std::uint32_t left = at(0, 1, 0), right = at(0, -1, 0);
    if (left == TargetBricks::kNone || right == TargetBricks::kNone) return;
    if (precedence_.above(brick_).has(left) || precedence_.above(brick_).has(right)) return;
    make_wait(comes_before(left) ? right : left);
  }

  void leave_room_for_the_effector() {
    const double half = robot_.block.side / 2;
    const double ahead = robot_.effector_front - (robot_.carried_x + half);
    if (ahead > robot_.magnet_reach) make_wait(at(-1, 0, 1));
    if (robot_.effector_half_width <= half) return;
    const bool stopped = comes_before(at(-1, 0, 1));
    for (const int dv : {-1, 1}) {
      make_wait(at(0, dv, 1));
      if (ahead > 0 && !stopped) make_wait(at(-1, dv, 1));
    }
  }

  const TargetBricks& target_;
  const Abilities& robot_;
  Lanes& lanes_;
  const Precedence& precedence_;
  std::uint32_t brick_ = 0;
  ApproachSide side_{};
  SideCell site_;
  bool possible_ = true;
  std::vector<std::uint32_t> out_;
};

}  // namespace

bool always_in_reach(const TargetBricks& target, const Precedence& precedence, Lanes& lanes,
                     const Abilities& robot, std::uint32_t brick, ApproachSide side) {
  assert(brick < target.bricks() && precedence.bricks() == target.bricks());
  BrickSet least = precedence.below(brick);
  least.remove(brick);
  return reach_between(target, least, target.others(precedence.above(brick)), lanes.to(brick, side),
                       target.cell(brick), side, robot);
}

/// Adding demands for one brick can take the way from another that had one, so several
/// rounds are made; what has no side after them is left to the later steps to refuse.
void wait_for_lanes(const TargetBricks& target, const std::vector<ApproachSide>& sides,
                    const Abilities& robot, Lanes& lanes, Precedence& precedence) {
  constexpr int kMostRounds = 8;  // what waits may take a side from another brick
  Waiters waiters(target, robot, lanes, precedence);
  bool changed = true;
  for (int round = 0; changed && round < kMostRounds; ++round) {
    changed = false;
    for (const std::uint32_t brick : precedence.order()) {
      if (brick < target.start_bricks()) continue;
      std::optional<std::vector<std::uint32_t>> fewest;
      for (const ApproachSide side : sides) {
        auto some = waiters.of(brick, side);
        if (some && (!fewest || some->size() < fewest->size())) fewest = std::move(some);
      }
      if (!fewest) continue;
      for (const std::uint32_t one : *fewest) {
        if (precedence.below(brick).has(one)) continue;
        precedence.add(brick, one);
        changed = true;
      }
    }
  }
}

}  // namespace stig::compiler
