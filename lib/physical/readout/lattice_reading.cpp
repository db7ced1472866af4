// SPDX-License-Identifier: MIT
// In three stages: joins between pairs, clusters grown along the best joins first (as Prim's
// algorithm grows a minimal tree), and a fit of one lattice to each cluster (Horn 1987,
// "Closed-form solution of absolute orientation using unit quaternions"). Cells are whole numbers
// from the start: noise in poses can only break a join, never shift a cell by rounding.
#include "physical/readout/lattice_reading.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <tuple>

namespace stig::physics {

namespace {

/// A turn of the cube onto itself, as the image of its axes.
using CubeTurn = Mat3;

LatticeCell operator+(const LatticeCell& a, const LatticeCell& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
LatticeCell operator-(const LatticeCell& a, const LatticeCell& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec3 centre(const LatticeCell& c) {
  return {static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)};
}

double& at(Vec3& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }
double at(const Vec3& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

Vec3 axis(int i, double sign) {
  Vec3 out;
  at(out, i) = sign;
  return out;
}

Mat3 product(const Mat3& a, const Mat3& b) { return {a * b.x, a * b.y, a * b.z}; }
Mat3 product_transposed(const Mat3& a, const Mat3& b) {
  return {a.transposed(b.x), a.transposed(b.y), a.transposed(b.z)};
}
double trace(const Mat3& m) { return m.x.x + m.y.y + m.z.z; }
double turn_angle(const Mat3& r) { return std::acos(std::clamp((trace(r) - 1) / 2, -1.0, 1.0)); }

/// All 24 turns of a cube: six directions for x, four for y that are across it; z follows.
const std::vector<CubeTurn>& cube_turns() {
  static const std::vector<CubeTurn> turns = [] {
    std::vector<CubeTurn> out;
    for (int x = 0; x < 6; ++x) {
      for (int y = 0; y < 6; ++y) {
        if (x / 2 == y / 2) continue;
        const Vec3 first = axis(x / 2, x % 2 == 0 ? 1 : -1);
        const Vec3 second = axis(y / 2, y % 2 == 0 ? 1 : -1);
        out.push_back({first, second, cross(first, second)});
      }
    }
    return out;
  }();
  return turns;
}

/// The turn T of the cube that is nearest to a rotation R: the trace of TᵀR is 1 + 2 cos of the
/// angle between them, so the one with the largest trace is nearest.
const CubeTurn& nearest_turn(const Mat3& r) {
  const auto nearness = [&](const CubeTurn& turn) { return trace(product_transposed(turn, r)); };
  return *std::max_element(
      cube_turns().begin(), cube_turns().end(),
      [&](const CubeTurn& a, const CubeTurn& b) { return nearness(a) < nearness(b); });
}

/// How one block lies against another: in a's frame, b is a step along an axis away.
struct Join {
  std::size_t a = 0, b = 0;
  LatticeCell step;
  double offset = 0, turn = 0;
  double badness = 0;
};

std::optional<Join> joined(const std::vector<PlacedBlock>& blocks, const std::vector<Mat3>& axes,
                           std::size_t a, std::size_t b, double side, const Tolerance& tolerance) {
  // In a's own frame, in which a neighbour lies a step along one axis away.
  const Vec3 away = axes[a].transposed(blocks[b].X_WB.p - blocks[a].X_WB.p);
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(at(away, i)) > std::abs(at(away, longest))) longest = i;
  }
  const int sign = at(away, longest) > 0 ? 1 : -1;
  Join join{a, b, {}, 0, 0, 0};
  (longest == 0 ? join.step.x : longest == 1 ? join.step.y : join.step.z) = sign;
  join.offset = length(away - axis(longest, sign * side));
  // Written so that NaN fails.
  if (!(join.offset <= tolerance.offset)) return std::nullopt;
  const Mat3 relative = product_transposed(axes[a], axes[b]);
  join.turn = turn_angle(product_transposed(nearest_turn(relative), relative));
  if (!(join.turn <= tolerance.turn)) return std::nullopt;
  // Both parts in units of their tolerance.
  join.badness = join.offset / tolerance.offset + join.turn / tolerance.turn;
  return join;
}

using Joins = std::vector<std::vector<Join>>;

/// Joins of each block, in both directions. Candidates come from a grid of cells that are as wide
/// as a join can be long, so that 27 of them hold all candidates.
Joins find_joins(const std::vector<PlacedBlock>& blocks, const std::vector<Mat3>& axes, double side,
                 const Tolerance& tolerance) {
  const double reach = side + tolerance.offset;
  using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  const auto key = [&](const Vec3& p, int dx, int dy, int dz) {
    const auto number = [&](double v) { return static_cast<std::int64_t>(std::floor(v / reach)); };
    return Key{number(p.x) + dx, number(p.y) + dy, number(p.z) + dz};
  };
  std::map<Key, std::vector<std::size_t>> grid;
  for (std::size_t i = 0; i < blocks.size(); ++i) grid[key(blocks[i].X_WB.p, 0, 0, 0)].push_back(i);
  Joins out(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (int n = 0; n < 27; ++n) {
      const auto near = grid.find(key(blocks[i].X_WB.p, n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
      if (near == grid.end()) continue;
      for (const std::size_t k : near->second) {
        if (k == i) continue;
        if (const auto join = joined(blocks, axes, i, k, side, tolerance)) out[i].push_back(*join);
      }
    }
  }
  return out;
}

/// A block of a cluster, while it grows: its cell, and the turn of the cube by which its own
/// axes differ from the first block's.
struct Member {
  std::size_t block = 0;
  LatticeCell cell;
  CubeTurn turn;
};

// A turn of the cube maps whole steps to whole steps; rounding takes only noise away.
LatticeCell turned(const CubeTurn& turn, const LatticeCell& step) {
  const Vec3 v = turn * centre(step);
  return {static_cast<int>(std::lround(v.x)), static_cast<int>(std::lround(v.y)),
          static_cast<int>(std::lround(v.z))};
}

/// All that hangs together with `seed`, best joins first. A second block for a cell already
/// filled stays out.
std::vector<Member> grow(std::size_t seed, const std::vector<Mat3>& axes, const Joins& joins,
                         std::vector<bool>& taken) {
  struct Candidate {
    Join join;
    std::size_t from;  ///< place of join.a in the list of members
  };
  // Ties by numbers, so that the tree is the same whatever the queue does.
  const auto worse = [](const Candidate& a, const Candidate& b) {
    return std::tie(a.join.badness, a.join.a, a.join.b) >
           std::tie(b.join.badness, b.join.a, b.join.b);
  };
  std::priority_queue<Candidate, std::vector<Candidate>, decltype(worse)> open(worse);
  std::vector<Member> members;
  std::map<LatticeCell, std::size_t> filled;
  const auto add = [&](const Member& member) {
    taken[member.block] = true;
    filled.emplace(member.cell, member.block);
    members.push_back(member);
    for (const Join& join : joins[member.block]) open.push({join, members.size() - 1});
  };
  add({seed, {}, {}});
  while (!open.empty()) {
    const Candidate next = open.top();
    open.pop();
    // Its block may have been taken since it was pushed, by a better join.
    if (taken[next.join.b]) continue;
    const Member from = members[next.from];
    const LatticeCell cell = from.cell + turned(from.turn, next.join.step);
    if (filled.contains(cell)) continue;
    const Mat3 relative = product_transposed(axes[next.join.a], axes[next.join.b]);
    // Turns multiply along the way, so a cube upside down in the middle does not matter.
    add({next.join.b, cell, product(from.turn, nearest_turn(relative))});
  }
  return members;
}

/// The rotation R that makes tr(Rᵀ sum) largest: Horn's quaternion, the eigenvector of the
/// largest eigenvalue of a symmetric 4 × 4 matrix, by Jacobi's rotations.
Mat3 best_rotation(const Mat3& sum) {
  const Vec3 &x = sum.x, &y = sum.y, &z = sum.z;  // sum_ij = column j, row i
  std::array<std::array<double, 4>, 4> n{{{x.x + y.y + z.z, y.z - z.y, z.x - x.z, x.y - y.x},
                                          {0, x.x - y.y - z.z, x.y + y.x, z.x + x.z},
                                          {0, 0, -x.x + y.y - z.z, y.z + z.y},
                                          {0, 0, 0, -x.x - y.y + z.z}}};
  std::array<std::array<double, 4>, 4> v{};
  for (std::size_t i = 0; i < 4; ++i) {
    v[i][i] = 1;
    for (std::size_t k = 0; k < i; ++k) n[i][k] = n[k][i];
  }
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = p + 1; q < 4; ++q) {
        if (n[p][q] == 0) continue;
        // The angle that makes the element vanish, by the half-angle formula.
        const double angle = 0.5 * std::atan2(2 * n[p][q], n[q][q] - n[p][p]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (std::size_t k = 0; k < 4; ++k) {
          std::tie(n[k][p], n[k][q]) =
              std::pair(c * n[k][p] - s * n[k][q], s * n[k][p] + c * n[k][q]);
        }
        for (std::size_t k = 0; k < 4; ++k) {
          std::tie(n[p][k], n[q][k]) =
              std::pair(c * n[p][k] - s * n[q][k], s * n[p][k] + c * n[q][k]);
          std::tie(v[k][p], v[k][q]) =
              std::pair(c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]);
        }
      }
    }
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (n[i][i] > n[best][best]) best = i;
  }
  return matrix(normalised(Quat{v[0][best], v[1][best], v[2][best], v[3][best]}));
}

struct Fit {
  Mat3 r;
  Vec3 origin;  ///< centre of cell (0, 0, 0)
  double pitch = 0;
};

void add_outer(Mat3& sum, const Vec3& column, const Vec3& row, double weight) {
  sum.x += column * (row.x * weight);
  sum.y += column * (row.y * weight);
  sum.z += column * (row.z * weight);
}

/// Least squares over positions, and axes with the weight of a corner half a side away.
Fit fit(const std::vector<Member>& members, const std::vector<PlacedBlock>& blocks,
        const std::vector<Mat3>& axes, double side) {
  // Both sets about their means: then the rotation is the only unknown left (Horn).
  Vec3 mean_p, mean_c;
  for (const Member& member : members) {
    mean_p += blocks[member.block].X_WB.p;
    mean_c += centre(member.cell);
  }
  mean_p *= 1 / static_cast<double>(members.size());
  mean_c *= 1 / static_cast<double>(members.size());
  Mat3 sum{{}, {}, {}};
  for (const Member& member : members) {
    const Vec3 c = centre(member.cell) - mean_c;
    add_outer(sum, blocks[member.block].X_WB.p - mean_p, c * side, 1);
    // Axes count as points half a side away: 1/4 of a squared side each.
    for (int i = 0; i < 3; ++i) {
      add_outer(sum, axes[member.block].column(i), member.turn.column(i), side * side / 4);
    }
  }
  Fit out{best_rotation(sum), {}, side};
  // The pitch follows from the rotation, by least squares over the cells' places.
  double along = 0, extent = 0;
  for (const Member& member : members) {
    const Vec3 c = centre(member.cell) - mean_c;
    along += dot(blocks[member.block].X_WB.p - mean_p, out.r * c);
    extent += squared(c);
  }
  out.pitch = along / extent;
  out.origin = mean_p - out.r * mean_c * out.pitch;
  return out;
}

/// The turn of the cube after which a lattice's axes lie nearest the world's: z first.
CubeTurn upright(const Mat3& r) {
  const auto better = [&](const CubeTurn& a, const CubeTurn& b) {
    const Mat3 ra = product(r, a), rb = product(r, b);
    // Then x and y together; ties within rounding go to the first turn.
    if (std::abs(ra.z.z - rb.z.z) > 1e-9) return ra.z.z < rb.z.z;
    return ra.x.x + ra.y.y < rb.x.x + rb.y.y - 1e-9;
  };
  return *std::max_element(cube_turns().begin(), cube_turns().end(), better);
}

ReadLattice describe(std::vector<Member> members, const std::vector<PlacedBlock>& blocks,
                     const std::vector<Mat3>& axes, double side) {
  assert(members.size() >= 2);
  // Cells and turns as seen from the upright frame, the lowest cell at the origin.
  const CubeTurn up = upright(fit(members, blocks, axes, side).r);
  const CubeTurn down = product_transposed(up, {});
  LatticeCell low{1 << 30, 1 << 30, 1 << 30};
  for (Member& member : members) {
    member.cell = turned(down, member.cell);
    member.turn = product(down, member.turn);
    low = {std::min(low.x, member.cell.x), std::min(low.y, member.cell.y),
           std::min(low.z, member.cell.z)};
  }
  for (Member& member : members) member.cell = member.cell - low;
  std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
    return std::tie(a.cell.z, a.cell.y, a.cell.x) < std::tie(b.cell.z, b.cell.y, b.cell.x);
  });
  // Fitted again in the final frame, so that what is said is of that frame.
  const Fit fitted = fit(members, blocks, axes, side);
  ReadLattice out;
  out.X_WL = {fitted.origin, quaternion_of(fitted.r)};
  out.pitch = fitted.pitch;
  out.yaw = std::atan2(fitted.r.x.y, fitted.r.x.x);
  out.tilt = std::acos(std::clamp(fitted.r.z.z, -1.0, 1.0));
  for (const Member& member : members) {
    const PlacedBlock& block = blocks[member.block];
    const Vec3 expected = fitted.origin + fitted.r * centre(member.cell) * fitted.pitch;
    const Mat3 axes_L = product_transposed(fitted.r, axes[member.block]);
    // With how far it is from its place, and what is left of its axes' turn beyond that of the
    // cube.
    out.blocks.push_back({member.block, member.cell, block.colour, length(block.X_WB.p - expected),
                          turn_angle(product_transposed(member.turn, axes_L))});
  }
  return out;
}

/// Among neighbours of one lattice.
void note_worst(ReadLattice& lattice, const Joins& joins) {
  std::map<std::size_t, LatticeCell> cells;
  for (const ReadBlock& block : lattice.blocks) cells.emplace(block.block, block.cell);
  for (const ReadBlock& block : lattice.blocks) {
    for (const Join& join : joins[block.block]) {
      if (!cells.contains(join.b)) continue;
      lattice.worst_offset = std::max(lattice.worst_offset, join.offset);
      lattice.worst_turn = std::max(lattice.worst_turn, join.turn);
    }
  }
}

}  // namespace

// r = beyond · turn, so beyond = r · turnᵀ.
Mat3 beyond_cube_turn(const Mat3& r) {
  const CubeTurn& turn = nearest_turn(r);
  const Mat3 back{turn.transposed({1, 0, 0}), turn.transposed({0, 1, 0}),
                  turn.transposed({0, 0, 1})};
  return product(r, back);
}

StructureReading read_lattices(const std::vector<PlacedBlock>& blocks, double side,
                               const Tolerance& tolerance) {
  // Wider, and one block could be joined to two neighbours at one face.
  assert(side > 0 && tolerance.offset < side / 2);
  std::vector<Mat3> axes;
  for (const PlacedBlock& block : blocks) axes.push_back(matrix(block.X_WB.q));
  const Joins joins = find_joins(blocks, axes, side, tolerance);
  StructureReading out;
  std::vector<bool> taken(blocks.size(), false);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (taken[i]) continue;
    const std::vector<Member> members = grow(i, axes, joins, taken);
    if (members.size() < 2) {
      out.loose.push_back(i);
      continue;
    }
    out.lattices.push_back(describe(members, blocks, axes, side));
    note_worst(out.lattices.back(), joins);
  }
  std::stable_sort(
      out.lattices.begin(), out.lattices.end(),
      [](const ReadLattice& a, const ReadLattice& b) { return a.blocks.size() > b.blocks.size(); });
  return out;
}

}  // namespace stig::physics
