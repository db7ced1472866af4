// SPDX-License-Identifier: MIT
#include "assembly/candidate.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace stig::assembly {

namespace {

/// Neighbours are the 26 cells about one, which is what a rule of the cubic lattice sees.
bool neighbours(Cell a, Cell b) {
  return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1 && std::abs(a.z - b.z) <= 1;
}
bool share_a_face(Cell a, Cell b) {
  return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z) == 1;
}

/// Could brick k come after brick i as well, which the sequence has later?
bool either_first(const CandidateOrder& candidate, const Builders& builders, std::size_t k,
                  std::size_t i) {
  const TargetBricks& target = *candidate.target;
  // The structure with everything before i but k: the least in which i could come first. As in the
  // sequence's own order, more of it would only take room.
  BrickSet others(target.bricks());
  for (std::size_t b = 0; b < i; ++b) {
    if (b != k) others.add(b);
  }
  if (!side_for(target, others, static_cast<std::uint32_t>(i), builders)) return false;
  others.add(i);
  return side_for(target, others, static_cast<std::uint32_t>(k), builders).has_value();
}

void set_waits(const Builders& builders, Waiting waiting, CandidateOrder& out) {
  const TargetBricks& target = *out.target;
  const std::size_t count = target.bricks();
  out.before.assign(count, BrickSet(count));
  out.free.assign(count, BrickSet(count));
  for (std::size_t i = 0; i < count; ++i) {
    // Quadratic in bricks, but with a cheap test first.
    for (std::size_t k = 0; k < i; ++k) {
      if (!neighbours(target.cell(i), target.cell(k))) continue;
      // The start is always there, so nothing is free of it.
      if (waiting == Waiting::needed && k > 0 && !share_a_face(target.cell(i), target.cell(k)) &&
          either_first(out, builders, k, i)) {
        out.free[i].add(k);
        out.free[k].add(i);
      } else {
        out.before[i].add(k);
      }
    }
  }
}

/// What a robot that knows everything could put: each brick whose neighbours before it stand. Brick
/// 0 is the start, which nobody puts.
std::vector<std::uint32_t> open_bricks(const CandidateOrder& candidate, const BrickSet& state) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 1; i < candidate.before.size(); ++i) {
    if (!state.has(i) && state.contains(candidate.before[i])) out.push_back(i);
  }
  return out;
}

}  // namespace

CandidateOrder make_candidate(const TargetBricks& target, const Sequence& sequence,
                              const Builders& builders, Waiting waiting) {
  assert(sequence.bricks.size() == target.bricks());
  CandidateOrder out;
  out.sequence = sequence;
  // Colours stand for "which brick": i + 1 for brick i, as far as colours go. Larger targets are
  // never walked, so what theirs say is not read.
  std::vector<PlacedBrick> bricks;
  for (const std::uint32_t brick : sequence.bricks) {
    bricks.push_back(
        {target.cell(brick), static_cast<Colour>(std::min(bricks.size(), kMostWalkedBricks) + 1)});
  }
  out.target = std::make_unique<TargetBricks>(bricks, 1);
  set_waits(builders, waiting, out);
  return out;
}

void walk(const Builders& builders, const std::shared_ptr<Visibility>& visibility,
          const PolicyLimits& limits, CandidateOrder& candidate) {
  assert(candidate.target->bricks() <= kMostWalkedBricks);
  Sight sight(*candidate.target, visibility);
  const OpenBricks open = [&](const BrickSet& state) { return open_bricks(candidate, state); };
  candidate.policy = explore(*candidate.target, open, sight, builders.robot, builders.sides,
                             {PlacementKinds::all, true}, limits);
  if (candidate.policy.too_large) return;
  // Only what leads to the whole structure stays: a structure from which robots could get stuck is
  // none that the colours may allow.
  prune(*candidate.target, candidate.policy);
  candidate.walked = candidate.policy.complete;
}

}  // namespace stig::assembly
