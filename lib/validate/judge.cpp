// SPDX-License-Identifier: MIT
// Two tolerances, for two questions. A block *fills* a cell when it is nearer to that cell than to
// any other by a wide margin: which brick is it? It is *close* when it is within a few millimetres
// and degrees of the lattice that fits all bricks best: is it a good brick? The fit takes out what
// a start that was pushed as a whole has moved; `drift` has that.
#include "validate/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>

#include "physical/readout/lattice_reading.h"
#include "rules/cell_text.h"
#include "validate/replay_events.h"

namespace stig::validate {
namespace {

constexpr double kCellWay = 0.012, kCellTurn = 0.26;  ///< m, rad: within this a block fills a cell

struct Filled {
  const WatchedBlock* block = nullptr;
  CellFit fit;
};

bool fills(const CellFit& fit) { return length(fit.off) <= kCellWay && fit.turn <= kCellTurn; }

/// The structure's bricks: the start, then by level.
std::vector<BrickCheck> wanted(const BuildTarget& target) {
  std::vector<BrickCheck> out;
  for (const PlacedBrick& brick : target.whole.bricks()) {
    BrickCheck check;
    check.cell = brick.at;
    check.wanted = brick.brick;
    const auto& start = target.rules->start;
    check.start = std::any_of(start.begin(), start.end(),
                              [&](const PlacedBrick& one) { return one.at == brick.at; });
    out.push_back(check);
  }
  // The start first, since it is what everything is measured against.
  std::stable_sort(out.begin(), out.end(), [](const BrickCheck& a, const BrickCheck& b) {
    return std::tuple(!a.start, a.cell.z, a.cell) < std::tuple(!b.start, b.cell.z, b.cell);
  });
  return out;
}

/// The lattice that fits the bricks best, its axes and cells those of the rules. What does not hang
/// together, or is a brick alone, has that of the start.
BuildSite fitted_site(const BuildSite& site, const std::vector<PlacedBlock>& blocks) {
  // One lattice of all bricks, or none: with two the best fit has no meaning.
  const StructureReading reading = read_lattices(blocks, site.pitch);
  if (reading.lattices.size() != 1 || !reading.loose.empty()) return site;
  const ReadLattice& read = reading.lattices.front();
  // The fit counts its cells from (0, 0, 0) and knows its axes up to a turn of the cube. Both are
  // taken from the site, from which the fitted frame differs by little: the turn between the two
  // frames, and the cell that the first block has in each.
  const Pose X_SL = inverse(site.X_WL) * read.X_WL;
  BuildSite fitted = site;
  fitted.pitch = read.pitch;
  fitted.X_WL.q = site.X_WL.q * quaternion_of(beyond_cube_turn(matrix(X_SL.q)));
  const ReadBlock& first = read.blocks.front();
  const Vec3 there =
      read.X_WL * (Vec3{static_cast<double>(first.cell.x), static_cast<double>(first.cell.y),
                        static_cast<double>(first.cell.z)} *
                   read.pitch);
  const Cell cell = fit_of(site, blocks[first.block].X_WB).cell;
  // The origin drops out: the cell's centre from a frame at zero, taken from where that centre is.
  fitted.X_WL.p = {};
  fitted.X_WL.p = there - centre_of(fitted, cell);
  return fitted;
}

void measure(BrickCheck& check, const Filled& filled, const BuildTarget& target,
             const BuildSite& fitted, const Closeness& closeness) {
  const CellFit fit = fit_of(fitted, filled.block->X_WB);
  check.block = filled.block->block;
  check.led = filled.block->led;
  check.dead = filled.block->dead;
  check.off = fit.off;
  check.yaw = fit.yaw;
  check.turn = fit.turn;
  // From the start's lattice, not the fitted one.
  check.drift = filled.fit.off;
  check.close = length(check.off) <= closeness.way && check.turn <= closeness.turn;
  check.coloured = check.led == led_of(*target.rules, check.wanted);
}

/// Neighbours that are there, one against the other.
void measure_joints(Judgement& out, const Closeness& closeness) {
  // Quadratic in the bricks, which are some dozens; each pair is looked at from both sides, and
  // noted once.
  for (const BrickCheck& a : out.bricks) {
    if (!a.block) continue;
    out.worst_way = std::max(out.worst_way, length(a.off));
    out.worst_turn = std::max(out.worst_turn, a.turn);
    out.worst_drift = std::max(out.worst_drift, length(a.drift));
    for (const BrickCheck& b : out.bricks) {
      const Offset away = b.cell - a.cell;
      if (!b.block || std::abs(away.x) + std::abs(away.y) + std::abs(away.z) != 1) continue;
      // One against the other, a common drift drops out.
      const LooseJoint joint{a.cell, b.cell, length(a.drift - b.drift), std::abs(a.yaw - b.yaw)};
      out.worst_joint_way = std::max(out.worst_joint_way, joint.way);
      out.worst_joint_turn = std::max(out.worst_joint_turn, joint.turn);
      const bool close = joint.way <= closeness.way && joint.turn <= closeness.turn;
      if (!close && a.cell < b.cell) out.loose.push_back(joint);
    }
  }
}

/// The blocks that the watch has seen come to rest as bricks, and not leave again.
std::set<std::size_t> bricks_of(const std::vector<BrickEvent>& events) {
  std::set<std::size_t> out;
  for (const BrickEvent& event : events) {
    if (event.kind == BrickEvent::Kind::placed) out.insert(event.block);
    if (event.kind == BrickEvent::Kind::left) out.erase(event.block);
  }
  return out;
}

/// Blocks that fill no cell of the structure but are against what is built. Not one that has come
/// to a cell where a brick is missing: it may yet rest there, and be held against the rules then.
std::vector<StrayBrick> strays(const BuildSite& site, const std::vector<WatchedBlock>& blocks,
                               const std::vector<BrickCheck>& bricks) {
  std::vector<Vec3> built;
  for (const BrickCheck& brick : bricks) {
    if (brick.block) built.push_back(centre_of(site, brick.cell));
  }
  std::vector<StrayBrick> out;
  for (const WatchedBlock& block : blocks) {
    // A block that counts as a brick is none in the way.
    const bool counted = std::any_of(bricks.begin(), bricks.end(), [&](const BrickCheck& one) {
      return one.block == block.block;
    });
    const bool near = std::any_of(built.begin(), built.end(), [&](const Vec3& place) {
      return length(place - block.X_WB.p) < kInTheWay * site.pitch;
    });
    if (counted || !near) continue;
    const CellFit fit = fit_of(site, block.X_WB);
    const bool comes =
        fills(fit) && std::any_of(bricks.begin(), bricks.end(), [&](const auto& one) {
          return one.cell == fit.cell && !one.block;
        });
    if (comes) continue;
    out.push_back({block.block, fit.cell, block.led, fit.off, fit.yaw, fills(fit)});
  }
  return out;
}

}  // namespace

std::string_view to_string(BuildVerdict verdict) {
  constexpr std::string_view kNames[] = {"complete", "incomplete", "wrong"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::size_t Judgement::missing() const {
  return static_cast<std::size_t>(std::count_if(
      bricks.begin(), bricks.end(), [](const BrickCheck& brick) { return !brick.block; }));
}

std::string brick_text(const RuleSet& rules, Led led, Cell cell) {
  const Colour colour = colour_of(rules, led);
  const std::string what = colour != 0       ? rules.brick(colour).name + " brick"
                           : led == Led::off ? std::string("dark block")
                                             : fmt::format("{} block", to_string(led));
  return fmt::format("a {} at {}", what, cell_text(cell));
}

Judgement judge(const BuildTarget& target, std::size_t structure,
                const std::vector<WatchedBlock>& blocks, const std::vector<BrickEvent>& events,
                const Closeness& closeness) {
  assert(target.rules != nullptr && structure < target.sites.size());
  const BuildSite& site = target.sites[structure];
  std::vector<BrickEvent> own;
  std::copy_if(events.begin(), events.end(), std::back_inserter(own),
               [&](const BrickEvent& event) { return event.structure == structure; });
  const std::set<std::size_t> rested = bricks_of(own);
  std::map<Cell, Filled> filled;
  for (const WatchedBlock& block : blocks) {
    // What has not rested for long enough was not held against the rules, and is none yet.
    if (!block.fixed && rested.count(block.block) == 0) continue;
    const CellFit fit = fit_of(site, block.X_WB);
    // Two blocks cannot fill one cell without overlapping; if physics has let them, the first
    // counts and the other is found as stray.
    if (fills(fit)) filled.try_emplace(fit.cell, Filled{&block, fit});
  }
  Judgement out;
  out.bricks = wanted(target);
  std::vector<PlacedBlock> there;
  for (const BrickCheck& check : out.bricks) {
    const auto found = filled.find(check.cell);
    if (found != filled.end()) there.push_back({found->second.block->X_WB, 0});
  }
  // Fitted over the bricks that are there, wherever the others are.
  const BuildSite fitted = fitted_site(site, there);
  for (BrickCheck& check : out.bricks) {
    const auto found = filled.find(check.cell);
    if (found != filled.end()) measure(check, found->second, target, fitted, closeness);
  }
  measure_joints(out, closeness);
  out.extra = strays(site, blocks, out.bricks);
  const Replayed replayed = replay_events(target, own);
  out.placements = replayed.placements;
  out.allowed = replayed.allowed;
  out.against = replayed.against;
  // Missing bricks are no fault, only unfinished; everything else is.
  const bool right = out.extra.empty() && !out.against && out.loose.empty() &&
                     std::all_of(out.bricks.begin(), out.bricks.end(), [](const BrickCheck& brick) {
                       return !brick.block || (brick.close && brick.coloured);
                     });
  out.verdict = !right              ? BuildVerdict::wrong
                : out.missing() > 0 ? BuildVerdict::incomplete
                                    : BuildVerdict::complete;
  return out;
}

namespace {

bool is_right(const BuildTarget& target, const std::pair<const Cell, StandingBrick>& brick) {
  const State wanted = target.whole.at(brick.first);
  return is_brick(wanted) && led_of(*target.rules, wanted) == brick.second.led;
}

}  // namespace

bool stands(const BuildTarget& target, std::size_t structure, const Watch& watch) {
  // As many as wanted and none wrong: then none is missing.
  return watch.bricks(structure).size() == target.whole.size() && !spoilt(target, structure, watch);
}

bool spoilt(const BuildTarget& target, std::size_t structure, const Watch& watch) {
  assert(target.rules != nullptr);
  const auto& bricks = watch.bricks(structure);
  return !std::all_of(bricks.begin(), bricks.end(),
                      [&](const auto& brick) { return is_right(target, brick); });
}

}  // namespace stig::validate
