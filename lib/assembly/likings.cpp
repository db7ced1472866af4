// SPDX-License-Identifier: MIT
#include "assembly/likings.h"

#include <algorithm>

#include "assembly/counted.h"
#include "assembly/path.h"
#include "assembly/span.h"
#include "base/hash.h"

namespace stig::assembly {

namespace {

using Spine = Liking::Spine;

/// Weights by which a row goes brick by brick, level by level there or, as steps, each level behind
/// the one below.
constexpr int kAlongRow = 100, kLevels = 1, kSteps = 150;
/// Places where a closed chain may begin, at most.
constexpr std::size_t kMostRings = 16;
/// A longer spine is seldom coloured by the conflicts there are for it.
constexpr int kLongSpine = 64;

/// How many bricks a target is wide along x, or y.
int width_of(const TargetBricks& target, bool along_x) {
  return span_of(target, along_x ? &Cell::x : &Cell::y).width();
}

/// Can a spine of so many bricks across count this far to both ends? What comes next follows from
/// the colours across, so none may come twice on the way to an end.
bool can_count(int across, int length, int colours) {
  std::int64_t ways = 1;
  for (int i = 0; i < across && ways < length; ++i) ways *= colours;
  return length < 2 * ways;
}

Liking swept_liking(bool along_x, bool from_ends) {
  Liking out;
  out.spine = along_x ? Spine::along_x : Spine::along_y;
  (along_x ? out.x : out.y) = kAlongRow;
  // Towards both ends from the middle, so that each half counts by itself.
  (along_x ? out.middle_x : out.middle_y) = true;
  out.swept = true;
  if (!from_ends) return out;
  // The row in the middle leads: robots at the ends get to it and then to those beside it.
  out.from_ends = true;
  out.spine_rows = 3;
  (along_x ? out.y : out.x) = 1;
  (along_x ? out.middle_y : out.middle_x) = true;
  return out;
}

/// The two columns beside this one where it is a bend about an empty corner, a cell of each, on
/// the floor. At the corner of a plate there is a brick, and nothing to go round.
std::vector<Cell> about_bend(const TargetBricks& target, Cell column) {
  std::vector<Cell> out;
  for (const Offset step : {Offset{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}) {
    if (target.brick_at(column + step) != TargetBricks::kNone) out.push_back(column + step);
  }
  const bool bends = out.size() == 2 && out[0].x != out[1].x && out[0].y != out[1].y;
  if (!bends) return {};
  const Cell corner = out[0] + (out[1] - column);
  return target.brick_at(corner) == TargetBricks::kNone ? out : std::vector<Cell>{};
}

/// Does a path lead from one to the other, but for the one through that column?
bool closes(const TargetBricks& target, const Liking::Round& round, Cell other) {
  const std::vector<int> steps = steps_from(target, round.first, round.last);
  return steps[target.brick_at(other)] < steps[target.brick_at(round.last)];
}

}  // namespace

std::vector<Liking> round_likings(const TargetBricks& target) {
  std::vector<Liking::Round> rounds;
  for (std::size_t i = 0; i < target.bricks() && rounds.size() < kMostRings; ++i) {
    const Cell last = target.cell(i);
    if (last.z != target.floor_level()) continue;
    const std::vector<Cell> beside = about_bend(target, last);
    for (std::size_t k = 0; k < beside.size(); ++k) {
      const Liking::Round round{beside[k], last};
      if (closes(target, round, beside[1 - k])) rounds.push_back(round);
    }
  }
  std::vector<Liking> out;
  for (const int z : {kLevels, kSteps}) {
    for (const Liking::Round& round : rounds) {
      Liking one;
      one.round = round;
      one.z = z;
      out.push_back(one);
    }
    if (target.levels() == 1) break;
  }
  return out;
}

std::vector<Liking> swept_likings(const TargetBricks& target, int colours) {
  std::vector<Liking> out;
  const bool x_is_shorter = width_of(target, true) <= width_of(target, false);
  // Two rows count as far as some 15 bricks to each end and are built from two sides, three rows
  // count farther. A shorter spine has less to count.
  for (const bool from_ends : {false, true}) {
    for (const bool along_x : {x_is_shorter, !x_is_shorter}) {
      Liking one = swept_liking(along_x, from_ends);
      const int length = width_of(target, along_x), across = width_of(target, !along_x);
      const int rows_beside = (across - one.spine_rows + 1) / 2;
      if (rows_beside >= length) continue;
      const int bricks_across = std::min(across, one.spine_rows) * target.levels();
      if (!can_count(bricks_across, length, colours)) continue;
      one.z = kLevels;
      out.push_back(one);
      if (target.levels() == 1) continue;
      one.z = kSteps;
      out.push_back(one);
    }
  }
  return out;
}

std::vector<Liking> large_likings(const TargetBricks& target, int colours) {
  std::vector<Liking> out = swept_likings(target, colours);
  const auto rows = colours < kCountedColours ? std::nullopt : rows_to_count(target);
  if (!rows) return out;
  Liking counted;
  counted.counting_rows = *rows;
  const auto is_long = [&](const Liking& one) {
    return width_of(target, one.spine == Spine::along_x) > kLongSpine;
  };
  out.insert(std::find_if(out.begin(), out.end(), is_long), counted);
  return out;
}

std::vector<Liking> regular_likings() {
  std::vector<Liking> out;
  for (const bool along_x : {true, false}) {
    for (const bool middle : {true, false}) {
      // A spine only makes sense along the axis that the rows run.
      for (const Spine spine : {Spine::none, along_x ? Spine::along_x : Spine::along_y}) {
        Liking one;
        (along_x ? one.x : one.y) = kAlongRow;
        (along_x ? one.middle_x : one.middle_y) = middle;
        one.z = kLevels;
        one.spine = spine;
        out.push_back(one);
        one.z = kSteps;
        out.push_back(one);
      }
    }
  }
  return out;
}

Liking liking_of(std::uint64_t seed) {
  // Weights of very different sizes, so that often one coordinate decides and the others break
  // ties.
  constexpr int kWeights[] = {-9, -3, -1, 0, 1, 3, 9};
  const auto weight = [&](std::uint64_t which) {
    return kWeights[combine(seed, which) % std::size(kWeights)];
  };
  constexpr int kChances[] = {0, 2, 6, 20};
  Liking out;
  out.x = weight(1);
  out.y = weight(2);
  out.z = weight(3);
  out.chance = kChances[combine(seed, 4) % std::size(kChances)];
  out.seed = seed;
  out.in_chains = combine(seed, 5) % 2 == 0;
  // Half of them about the middle.
  if (combine(seed, 7) % 2 == 0) return out;
  out.middle_x = combine(seed, 8) % 2 == 0;
  out.middle_y = combine(seed, 9) % 2 == 0;
  const std::uint64_t spine = combine(seed, 10) % 4;
  if (spine < 2) out.spine = spine == 0 ? Spine::along_x : Spine::along_y;
  return out;
}

bool suits(const TargetBricks& target, const Liking& liking,
           const std::vector<ApproachSide>& sides) {
  if (liking.counting_rows > 0) {
    return std::is_permutation(sides.begin(), sides.end(), kCountedSides.begin(),
                               kCountedSides.end());
  }
  if (liking.round) return sides.size() == kAllSides.size();
  const auto both = [&](bool along_x) {
    const auto has = [&](ApproachSide side) {
      return std::find(sides.begin(), sides.end(), side) != sides.end();
    };
    return along_x ? has(ApproachSide::plus_x) && has(ApproachSide::minus_x)
                   : has(ApproachSide::plus_y) && has(ApproachSide::minus_y);
  };
  if (liking.spine == Spine::none) return true;
  const bool along_x = liking.spine == Spine::along_x;
  // More sides than it takes make more cases for its colours to tell apart.
  if (!liking.from_ends) {
    return both(!along_x) && !(liking.swept && sides.size() == kAllSides.size());
  }
  const bool rows_beside = width_of(target, !along_x) > liking.spine_rows;
  return both(along_x) && (!rows_beside || both(!along_x));
}

}  // namespace stig::assembly
