// SPDX-License-Identifier: MIT
// Hysteresis in time and none in place: a block becomes a brick after a second at rest and stays
// one until it is out of its cell, so that a brick which a passing robot shakes is not counted
// twice. Blocks are followed by their number; who held one last is who placed it.
#include "validate/watch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stig::validate {
namespace {

constexpr double kRestTime = 1;  ///< s
// Half a millimetre and half a degree: more than the solver's creep over a second, less than any
// deliberate motion.
constexpr double kRestWay = 0.0005, kRestTurn = 0.0087;  ///< m, rad: within this it rests
// The same as the judge's: within this a block fills the cell (judge.cpp).
constexpr double kCaptureWay = 0.012, kCaptureTurn = 0.26;
constexpr double kHandGap = 0.010;   ///< m, between the end-effector and a block that it holds
constexpr double kLeastHaul = 0.05;  ///< m
constexpr std::array<Offset, 6> kFaces = {
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

/// Is the end-effector on the block, or so near that its magnets are? Over the upper face, within
/// its outline, and no farther than magnets carry.
bool holds(const WatchedHand& hand, const Pose& X_WB, double side) {
  const Vec3 away = hand.p_W - X_WB.p;
  const double aside = std::hypot(away.x, away.y);
  return aside < side / 2 && away.z > 0 && away.z - side / 2 < kHandGap;
}

bool in_cell(const CellFit& fit) {
  return length(fit.off) <= kCaptureWay && fit.turn <= kCaptureTurn;
}

}  // namespace

void Watch::look(double time, const std::vector<WatchedBlock>& blocks,
                 const std::vector<WatchedHand>& hands) {
  for (const WatchedBlock& block : blocks) follow(time, block, hands);
  drop_leavers(time, blocks);
  find_new(time, blocks);
}

void Watch::follow(double time, const WatchedBlock& block, const std::vector<WatchedHand>& hands) {
  const auto [at, fresh] = known_.try_emplace(block.block);
  Known& known = at->second;
  if (fresh) {
    // A block comes into being at rest where it is first seen.
    known.rest = block.X_WB;
    known.since = time;
  }
  // What is fixed is in nobody's hand and never moves.
  if (block.fixed) return;
  known.holder = kNoRobot;
  for (std::size_t robot = 0; robot < hands.size() && known.holder == kNoRobot; ++robot) {
    // The first robot wins; two end-effectors do not fit over one block.
    if (holds(hands[robot], block.X_WB, target_.sites.front().pitch)) known.holder = robot;
  }
  follow_haul(time, block, known);
  const bool moved = length(block.X_WB.p - known.rest.p) > kRestWay ||
                     angle_of(conjugate(known.rest.q) * block.X_WB.q) > kRestTurn;
  // Under an end-effector it does not rest, even if it does not move.
  if (!moved && known.holder == kNoRobot) return;
  known.rest = block.X_WB;
  known.since = time;
}

void Watch::follow_haul(double time, const WatchedBlock& block, Known& known) {
  // Handed over, a block begins another haul.
  if (known.haul && hauls_[*known.haul].robot != known.holder) {
    hauls_[*known.haul].ended = true;
    known.haul.reset();
  }
  if (known.holder == kNoRobot) return;
  known.last_holder = known.holder;
  if (!known.haul) {
    known.haul = hauls_.size();
    Haul haul;
    haul.robot = known.holder;
    haul.block = block.block;
    haul.from = time;
    haul.taken = block.X_WB.p;
    hauls_.push_back(haul);
  }
  Haul& haul = hauls_[*known.haul];
  haul.to = time;
  haul.put = block.X_WB.p;
  haul.way = length(haul.put - haul.taken);
}

void Watch::drop_leavers(double time, const std::vector<WatchedBlock>& blocks) {
  for (auto& [number, known] : known_) {
    if (!known.place) continue;
    const auto [structure, cell] = *known.place;
    StandingBrick& brick = bricks_[structure].at(cell);
    const auto found =
        std::find_if(blocks.begin(), blocks.end(),
                     [number = number](const WatchedBlock& b) { return b.block == number; });
    // A block that has left the arena is not in the list, and its brick is gone.
    if (found != blocks.end()) {
      // A brick may change its colour where it stands: rules see the new one.
      brick.led = found->led;
      const CellFit fit = fit_of(target_.sites[structure], found->X_WB);
      if (fit.cell == cell && in_cell(fit)) continue;
    }
    events_.push_back(
        {BrickEvent::Kind::left, time, number, cell, brick.led, known.holder, structure});
    bricks_[structure].erase(cell);
    known.place.reset();
  }
}

/// The start's blocks hang on to nothing: with them a structure begins.
bool Watch::joins(const WatchedBlock& block, const Place& place) const {
  const std::vector<PlacedBrick>& start = target_.rules->start;
  if (block.fixed && std::any_of(start.begin(), start.end(), [&](const PlacedBrick& brick) {
        return brick.at == place.cell;
      })) {
    return true;
  }
  const auto& bricks = bricks_[place.structure];
  return std::any_of(kFaces.begin(), kFaces.end(),
                     [&](Offset face) { return bricks.contains(place.cell + face); });
}

void Watch::find_new(double time, const std::vector<WatchedBlock>& blocks) {
  struct Candidate {
    double since = 0;
    const WatchedBlock* block = nullptr;
    Place place;
  };
  std::vector<Candidate> ready;
  for (const WatchedBlock& block : blocks) {
    const Known& known = known_.at(block.block);
    if (known.place || known.holder != kNoRobot) continue;
    // A little less than the time, for sums of steps. A fixed block that is dark is furniture.
    if (block.fixed ? block.led == Led::off : time - known.since < kRestTime - 1e-9) continue;
    for (std::size_t structure = 0; structure < target_.sites.size(); ++structure) {
      const CellFit fit = fit_of(target_.sites[structure], block.X_WB);
      if (in_cell(fit)) ready.push_back({known.since, &block, {structure, fit.cell}});
    }
  }
  // By when they came to rest, which is the order of events that the rules are asked about.
  std::stable_sort(ready.begin(), ready.end(),
                   [](const Candidate& a, const Candidate& b) { return a.since < b.since; });
  // Several blocks may come to rest between two looks, each upon another: repeated until none
  // joins.
  for (bool grew = true; grew;) {
    grew = false;
    for (const Candidate& one : ready) {
      // It may have joined in the turn before, or another structure.
      if (known_.at(one.block->block).place ||
          bricks_[one.place.structure].contains(one.place.cell) || !joins(*one.block, one.place)) {
        continue;
      }
      add_brick(one.since, *one.block, one.place);
      grew = true;
    }
  }
}

void Watch::add_brick(double since, const WatchedBlock& block, const Place& place) {
  Known& known = known_.at(block.block);
  known.place = place;
  bricks_[place.structure][place.cell] = {block.block, block.led};
  // What was there from the beginning has not been placed.
  if (block.fixed) return;
  events_.push_back({BrickEvent::Kind::placed, since, block.block, place.cell, block.led,
                     known.last_holder, place.structure});
  // The last haul of that block is the one that brought it.
  for (auto haul = hauls_.rbegin(); haul != hauls_.rend(); ++haul) {
    if (haul->block != block.block) continue;
    haul->placed = place.cell;
    haul->structure = place.structure;
    break;
  }
}

std::size_t Watch::brick_count() const {
  std::size_t count = 0;
  for (const auto& bricks : bricks_) count += bricks.size();
  return count;
}

std::vector<Haul> Watch::hauls() const {
  std::vector<Haul> out;
  std::copy_if(hauls_.begin(), hauls_.end(), std::back_inserter(out), [](const Haul& haul) {
    // Short ones are touches in passing; one that still goes on counts whatever its length.
    return haul.way > kLeastHaul || (!haul.ended && haul.to > haul.from);
  });
  return out;
}

bool Watch::holding(std::size_t robot) const {
  return std::any_of(known_.begin(), known_.end(),
                     [&](const auto& one) { return one.second.holder == robot; });
}

bool Watch::held(std::size_t block) const {
  const auto found = known_.find(block);
  return found != known_.end() && found->second.holder != kNoRobot;
}

bool Watch::is_part(std::size_t block) const {
  const auto found = known_.find(block);
  return found != known_.end() && found->second.place.has_value();
}

}  // namespace stig::validate
