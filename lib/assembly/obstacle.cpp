// SPDX-License-Identifier: MIT
// Proofs that nothing can be done, which are cheap and hold for every order: a structure in parts
// (bricks are put next to bricks), a remainder that cannot be taken apart (remainder.h), or
// stretches and runs that are too long for the colours (stretch.h, run.h).
#include "assembly/obstacle.h"

#include <array>
#include <cassert>

#include "assembly/faces.h"

namespace stig::assembly {

namespace {

/// The bricks that hang together with one, face to face.
BrickSet part_of(const TargetBricks& target, std::uint32_t first) {
  BrickSet out(target.bricks());
  out.add(first);
  std::vector<std::uint32_t> edge = {first};
  while (!edge.empty()) {
    const Cell cell = target.cell(edge.back());
    edge.pop_back();
    for (const Offset step : kFaces) {
      const std::uint32_t brick = target.brick_at(cell + step);
      if (brick == TargetBricks::kNone || out.has(brick)) continue;
      out.add(brick);
      edge.push_back(brick);
    }
  }
  return out;
}

}  // namespace

std::optional<AssemblyObstacle> find_obstacle(const TargetBricks& target, const Builders& builders,
                                              std::optional<std::uint32_t> start, int colours) {
  assert(colours > 0 && (!start || *start < target.bricks()));
  AssemblyObstacle out;
  out.part = part_of(target, start.value_or(0));
  if (!target.complete(out.part)) {
    out.kind = AssemblyObstacle::Kind::apart;
    return out;
  }
  out.colours = colours;
  // Where a stretch is that long, taking the structure apart would take long too.
  if (const auto stretch = stretch_too_long(target, start, colours)) {
    out.kind = AssemblyObstacle::Kind::stretch;
    out.stretch = *stretch;
    return out;
  }
  out.remainder = find_remainder(target, builders, start);
  if (!out.remainder.barred.empty()) {
    out.kind = AssemblyObstacle::Kind::remainder;
    return out;
  }
  out.runs = runs_too_long(target, start, colours);
  if (out.runs.empty()) return std::nullopt;
  out.kind = AssemblyObstacle::Kind::runs;
  return out;
}

}  // namespace stig::assembly
