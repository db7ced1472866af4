// SPDX-License-Identifier: MIT
// Point dipoles (docs/physics.md has the equations; Jackson, Classical Electrodynamics, section
// 5.7). Who is near whom is asked twice: of owners (blocks) by a grid, then of their magnets one by
// one, since all magnets of a block lie within a known radius. Free magnets turn much faster than
// blocks move, so their directions relax towards the field at rest, sweep by sweep, in the order of
// their numbers (Gauss and Seidel's way): each sees what those before it have just done.
#include "physical/magnets/magnetism.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace stig::physics {

namespace {

constexpr std::size_t kGridCost = 30;  ///< of an entry, in comparisons of two owners

/// A pair as one of its magnets sees it.
struct Neighbour {
  std::uint32_t other;
  Vec3 r;        ///< from the other to this one, unit
  double scale;  ///< field of the other's unit direction at this distance
};

/// Neighbours of each magnet: those of magnet i are [start[i], start[i + 1]).
struct Neighbours {
  std::vector<std::uint32_t> start;
  std::vector<Neighbour> list;
};

// Compressed rows: counts, then sums, then places; two passes and no lists of lists.
Neighbours neighbours_of(const std::vector<Magnet>& magnets, const std::vector<MagnetPair>& pairs) {
  Neighbours out{std::vector<std::uint32_t>(magnets.size() + 1), {}};
  for (const MagnetPair& pair : pairs) {
    ++out.start[pair.i + 1];
    ++out.start[pair.j + 1];
  }
  for (std::size_t i = 0; i < magnets.size(); ++i) out.start[i + 1] += out.start[i];
  out.list.resize(2 * pairs.size());
  std::vector<std::uint32_t> next(out.start.begin(), out.start.end() - 1);
  for (const MagnetPair& pair : pairs) {
    const double d = length(pair.r);
    const double k = kDipoleConstant / (d * d * d);
    const Vec3 n = pair.r * (1 / d);
    out.list[next[pair.i]++] = {pair.j, n, k * magnets[pair.j].moment};
    out.list[next[pair.j]++] = {pair.i, n, k * magnets[pair.i].moment};
  }
  return out;
}

/// One step of the way from `u` to the unit vector `goal`.
Vec3 turned(Vec3 u, const Vec3& goal, double part) {
  // Straight against the field it would stay for ever: a nudge to the side, always the same.
  if (dot(u, goal) < -0.9999) u = normalised(u + perpendicular(u) * 1e-2);
  return normalised(u + (goal - u) * part);
}

struct OwnerCell {
  std::int64_t x, y, z;
  std::uint32_t owner;

  friend auto operator<=>(const OwnerCell&, const OwnerCell&) = default;
};

std::vector<OwnerCell> owner_cells(const std::vector<MagnetOwner>& owners, double size) {
  std::vector<OwnerCell> cells;
  cells.reserve(owners.size());
  const auto cell = [size](double x) { return static_cast<std::int64_t>(std::floor(x / size)); };
  for (std::uint32_t i = 0; i < owners.size(); ++i) {
    if (owners[i].begin == owners[i].end) continue;
    const Vec3& p = owners[i].centre;
    cells.push_back({cell(p.x), cell(p.y), cell(p.z), i});
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// Magnets of `owner` that may be within the cut-off of one about `centre`.
void find_near(const std::vector<Magnet>& magnets, const MagnetOwner& owner, const Vec3& centre,
               double reach, std::vector<std::uint32_t>& out) {
  out.clear();
  for (std::uint32_t i = owner.begin; i < owner.end; ++i) {
    if (squared(magnets[i].p_W - centre) < reach * reach) out.push_back(i);
  }
}

/// Lists of magnets, kept to save their making for each pair of owners.
struct NearLists {
  std::vector<std::uint32_t> a, b;
};

void add_pairs(const std::vector<Magnet>& magnets, const MagnetOwner& a, const MagnetOwner& b,
               double radius, double cutoff, NearLists& near, std::vector<MagnetPair>& out) {
  find_near(magnets, a, b.centre, cutoff + radius, near.a);
  find_near(magnets, b, a.centre, cutoff + radius, near.b);
  for (const std::uint32_t i : near.a) {
    for (const std::uint32_t j : near.b) {
      const Vec3 r = magnets[i].p_W - magnets[j].p_W;
      const double d2 = squared(r);
      if (d2 < cutoff * cutoff && d2 > 0) out.push_back({i, j, r});
    }
  }
}

using Couple = std::pair<std::uint32_t, std::uint32_t>;

bool has_magnets(const MagnetOwner& owner) { return owner.begin < owner.end; }

void add_couple(const std::vector<MagnetOwner>& owners, std::uint32_t i, std::uint32_t k,
                double reach, std::vector<Couple>& out) {
  // Two that are awake come up twice, each once as i: the pair is noted when i has the lower
  // number.
  if (i == k || (owners[k].awake && k < i)) return;
  if (squared(owners[i].centre - owners[k].centre) < reach * reach) {
    out.emplace_back(std::minmax(i, k));
  }
}

/// Partners of awake owners in the cells about their own, which are as wide as the reach. Rows of
/// three cells along z stand together in the sorted list; where each of the nine begins moves
/// forward with the owner.
void add_neighbours(const std::vector<MagnetOwner>& owners, const std::vector<OwnerCell>& cells,
                    double reach, std::vector<Couple>& out) {
  std::array<std::size_t, 9> begins{};
  for (const OwnerCell& cell : cells) {
    if (!owners[cell.owner].awake) continue;
    for (std::size_t row = 0; row < begins.size(); ++row) {
      const auto dx = static_cast<std::int64_t>(row / 3) - 1;
      const auto dy = static_cast<std::int64_t>(row % 3) - 1;
      const OwnerCell first{cell.x + dx, cell.y + dy, cell.z - 1, 0};
      std::size_t& begin = begins[row];
      while (begin < cells.size() && cells[begin] < first) ++begin;
      for (std::size_t at = begin; at < cells.size(); ++at) {
        const OwnerCell& other = cells[at];
        if (other.x != first.x || other.y != first.y || other.z > cell.z + 1) break;
        add_couple(owners, cell.owner, other.owner, reach, out);
      }
    }
  }
}

/// Owners nearer than `reach`, at least one of them awake, in rising order.
std::vector<Couple> couples_of(const std::vector<MagnetOwner>& owners, double reach) {
  std::vector<std::uint32_t> awake;
  for (std::uint32_t i = 0; i < owners.size(); ++i) {
    if (owners[i].awake && has_magnets(owners[i])) awake.push_back(i);
  }
  std::vector<Couple> couples;
  // A grid is not worth its making for a few among many sleepers.
  const bool few = awake.size() * kGridCost < owners.size();
  for (const std::uint32_t i : few ? awake : std::vector<std::uint32_t>()) {
    for (std::uint32_t k = 0; k < owners.size(); ++k) {
      if (has_magnets(owners[k])) add_couple(owners, i, k, reach, couples);
    }
  }
  if (!few) add_neighbours(owners, owner_cells(owners, reach), reach, couples);
  std::sort(couples.begin(), couples.end());
  return couples;
}

}  // namespace

DipoleWrench dipole_wrench(const Vec3& m0, const Vec3& m1, const Vec3& r) {
  const double d2 = squared(r);
  assert(d2 > 0);
  const double d = std::sqrt(d2);
  // Unit vector n and both moments' components along it; docs/physics.md, "Magnets".
  const Vec3 n = r * (1 / d);
  const double a = dot(m0, n), b = dot(m1, n);
  const Vec3 force =
      (n * (3 * dot(m0, m1) - 15 * a * b) + (m0 * b + m1 * a) * 3) * (kDipoleConstant / (d2 * d2));
  const double k = kDipoleConstant / (d2 * d);
  const Vec3 across = cross(m0, m1);
  // The torques do not cancel: the forces' couple makes up for the difference.
  return {force, (cross(m0, n) * (3 * b) - across) * k, (cross(m1, n) * (3 * a) + across) * k};
}

Vec3 dipole_field(const Vec3& m1, const Vec3& r) {
  const double d = length(r);
  assert(d > 0);
  const Vec3 n = r * (1 / d);
  return (n * (3 * dot(m1, n)) - m1) * (kDipoleConstant / (d * d * d));
}

double dipole_energy(const Vec3& m0, const Vec3& m1, const Vec3& r) {
  return -dot(m0, dipole_field(m1, r));
}

std::vector<MagnetPair> magnet_pairs(const std::vector<Magnet>& magnets,
                                     const std::vector<MagnetOwner>& owners, double radius,
                                     double cutoff) {
  std::vector<MagnetPair> out;
  NearLists near;
  // Rounding, of owners' centres too, must not leave out a magnet that lies at the radius itself.
  const double ball = radius * (1 + 1e-9);
  for (const auto& [a, b] : couples_of(owners, cutoff + 2 * radius)) {
    add_pairs(magnets, owners[a], owners[b], ball, cutoff, near, out);
  }
  return out;
}

void relax_magnets(std::vector<Magnet>& magnets, const std::vector<MagnetPair>& pairs,
                   const std::vector<MagnetOwner>& owners, double dt,
                   const Relaxation& relaxation) {
  if (pairs.empty()) return;
  const Neighbours neighbours = neighbours_of(magnets, pairs);
  // All sweeps together let a fraction exp(-dt / time) of the angle remain.
  const double part = 1 - std::exp(-dt / (relaxation.time * relaxation.sweeps));
  for (int sweep = 0; sweep < relaxation.sweeps; ++sweep) {
    for (std::uint32_t i = 0; i < magnets.size(); ++i) {
      Magnet& magnet = magnets[i];
      if (neighbours.start[i] == neighbours.start[i + 1]) continue;
      // Sleepers keep their directions, as their neighbours have seen them fall asleep.
      if (!magnet.free || !owners[magnet.owner].awake) continue;
      Vec3 field;
      for (std::uint32_t k = neighbours.start[i]; k < neighbours.start[i + 1]; ++k) {
        const Neighbour& near = neighbours.list[k];
        const Vec3& u = magnets[near.other].direction;
        field += (near.r * (3 * dot(u, near.r)) - u) * near.scale;
      }
      const double strength = length(field);
      if (strength == 0 || magnet.moment == 0) continue;
      // A negative moment wants to point against the field.
      const double sign = magnet.moment > 0 ? 1 : -1;
      magnet.direction = turned(magnet.direction, field * (sign / strength), part);
    }
  }
}

Vec3 spin_magnet(Magnet& magnet, const Vec3& torque, const Vec3& body_spin, const Bearing& bearing,
                 double dt) {
  const double damping = bearing.damping;
  // Damping implicitly, so that any damping is stable at any step.
  magnet.spin = (magnet.spin + (torque + body_spin * damping) * (dt / bearing.inertia)) *
                (1 / (1 + damping * dt / bearing.inertia));
  magnet.direction = normalised(matrix(rotation(magnet.spin * dt)) * magnet.direction);
  return (magnet.spin - body_spin) * damping;
}

}  // namespace stig::physics
