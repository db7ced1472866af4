// SPDX-License-Identifier: MIT
#include "physical/solver.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace stig {

namespace {

constexpr double kMatchDistance = 3e-3;
constexpr double kCorrection = 0.1;     ///< part of an overlap undone in a step
constexpr double kSlop = 50e-6;         ///< overlap that is left alone, m
constexpr double kMostRecovery = 0.05;  ///< m/s
constexpr int kShiftSweeps = 6;
constexpr double kSettled = 1e-8;  ///< m/s: a sweep that changes less is the last

/// One direction at one point: unit impulses along d change velocities by these.
struct Row {
  Vec3 d, arm_a, arm_b, turn_a, turn_b;
  double mass = 0;  ///< impulse for a velocity change of 1 m/s, kg
};

struct PointRows {
  Row normal, first, second;
  double target = 0;  ///< least normal velocity, m/s
  double push = 0, slide_first = 0, slide_second = 0;
  double shift_target = 0, shift = 0;  ///< the same for what undoes overlaps
  double friction = 0;
  std::uint32_t a = 0, b = 0;
};

Row make_row(const SolverBody& a, const SolverBody& b, const Vec3& p, const Vec3& d) {
  Row row;
  row.d = d;
  row.arm_a = cross(p - a.p, d);
  row.arm_b = cross(p - b.p, d);
  row.turn_a = a.inverse_inertia * row.arm_a;
  row.turn_b = b.inverse_inertia * row.arm_b;
  const double inverse =
      a.inverse_mass + b.inverse_mass + dot(row.arm_a, row.turn_a) + dot(row.arm_b, row.turn_b);
  row.mass = inverse > 0 ? 1 / inverse : 0;
  return row;
}

double velocity(const Row& row, const SolverBody& a, const SolverBody& b) {
  return dot(row.d, a.v - b.v) + dot(row.arm_a, a.w) - dot(row.arm_b, b.w);
}

void push(const Row& row, SolverBody& a, SolverBody& b, double impulse) {
  a.v += row.d * (impulse * a.inverse_mass);
  a.w += row.turn_a * impulse;
  b.v -= row.d * (impulse * b.inverse_mass);
  b.w -= row.turn_b * impulse;
}

/// Least normal velocity of the shift that undoes overlaps.
double least_shift(double gap, double dt) {
  if (gap > -kSlop) return -(gap + kSlop) / dt;
  return std::min(kCorrection * (-gap - kSlop) / dt, kMostRecovery);
}

/// Rows of one point, with last step's impulses applied.
PointRows prepare(const Contact& contact, const ContactPoint& point, SolverBody& a, SolverBody& b,
                  double dt) {
  const Vec3 t = perpendicular(contact.normal), s = cross(contact.normal, t);
  PointRows rows;
  rows.normal = make_row(a, b, point.p_W, contact.normal);
  rows.first = make_row(a, b, point.p_W, t);
  rows.second = make_row(a, b, point.p_W, s);
  // The same for both directions, so that sliding does not depend on how they lie.
  rows.first.mass = rows.second.mass = std::min(rows.first.mass, rows.second.mass);
  rows.friction = contact.friction;
  rows.target = -std::max(0.0, point.gap) / dt;
  rows.shift_target = least_shift(point.gap, dt);
  rows.push = point.push;
  rows.slide_first = dot(point.friction, t);
  rows.slide_second = dot(point.friction, s);
  push(rows.normal, a, b, rows.push);
  push(rows.first, a, b, rows.slide_first);
  push(rows.second, a, b, rows.slide_second);
  return rows;
}

/// Returns the change in normal velocity that was asked for.
double relax_normal(PointRows& rows, SolverBody& a, SolverBody& b) {
  const double lacking = rows.target - velocity(rows.normal, a, b);
  const double impulse = std::max(0.0, rows.push + lacking * rows.normal.mass);
  const double change = impulse - rows.push;
  rows.push = impulse;
  push(rows.normal, a, b, change);
  return rows.normal.mass > 0 ? std::abs(change) / rows.normal.mass : 0;
}

void relax_shift(PointRows& rows, SolverBody& a, SolverBody& b) {
  const Row& row = rows.normal;
  const double velocity =
      dot(row.d, a.shift_v - b.shift_v) + dot(row.arm_a, a.shift_w) - dot(row.arm_b, b.shift_w);
  const double lacking = rows.shift_target - velocity;
  const double impulse = std::max(0.0, rows.shift + lacking * row.mass);
  const double change = impulse - rows.shift;
  rows.shift = impulse;
  a.shift_v += row.d * (change * a.inverse_mass);
  a.shift_w += row.turn_a * change;
  b.shift_v -= row.d * (change * b.inverse_mass);
  b.shift_w -= row.turn_b * change;
}

/// Overlaps are undone by a shift that leaves velocities alone: as a part of them it feeds
/// the swaying of high columns, which then fall.
void undo_overlaps(std::vector<PointRows>& rows, std::vector<SolverBody>& bodies) {
  const auto deep = [](const PointRows& row) { return row.shift_target > 0; };
  if (std::none_of(rows.begin(), rows.end(), deep)) return;
  for (int sweep = 0; sweep < kShiftSweeps; ++sweep) {
    for (PointRows& row : rows) relax_shift(row, bodies[row.a], bodies[row.b]);
  }
}

double relax_friction(PointRows& rows, SolverBody& a, SolverBody& b) {
  // Most points of a pile that falls carry nothing.
  if (rows.push == 0 && rows.slide_first == 0 && rows.slide_second == 0) return 0;
  double x = rows.slide_first - velocity(rows.first, a, b) * rows.first.mass;
  double y = rows.slide_second - velocity(rows.second, a, b) * rows.second.mass;
  const double most = rows.friction * rows.push, size = std::sqrt(x * x + y * y);
  if (size > most) {
    x *= most / size;
    y *= most / size;
  }
  const double dx = x - rows.slide_first, dy = y - rows.slide_second;
  push(rows.first, a, b, dx);
  push(rows.second, a, b, dy);
  rows.slide_first = x;
  rows.slide_second = y;
  return rows.first.mass > 0 ? std::max(std::abs(dx), std::abs(dy)) / rows.first.mass : 0;
}

}  // namespace

void warm_start(Contact& contact, const Contact& last) {
  contact.touching = last.touching;
  if (dot(contact.normal, last.normal) < 0.95) return;
  std::array<bool, 4> used{};
  for (int i = 0; i < contact.count; ++i) {
    ContactPoint& point = contact.points[static_cast<std::size_t>(i)];
    double nearest = kMatchDistance * kMatchDistance;
    int found = -1;
    for (int k = 0; k < last.count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double d = squared(last.points[at].p_A - point.p_A);
      if (!used[at] && d < nearest) std::tie(nearest, found) = std::pair(d, k);
    }
    if (found < 0) continue;
    const ContactPoint& old = last.points[static_cast<std::size_t>(found)];
    used[static_cast<std::size_t>(found)] = true;
    point.push = old.push;
    point.friction = old.friction;
  }
}

void solve_contacts(std::vector<SolverBody>& bodies, std::vector<Contact>& contacts,
                    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& slots, double dt,
                    int sweeps) {
  assert(slots.size() == contacts.size());
  std::vector<PointRows> rows;
  rows.reserve(contacts.size() * 4);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    SolverBody &a = bodies[slots[c].first], &b = bodies[slots[c].second];
    for (int i = 0; i < contacts[c].count; ++i) {
      const ContactPoint& point = contacts[c].points[static_cast<std::size_t>(i)];
      rows.push_back(prepare(contacts[c], point, a, b, dt));
      rows.back().a = slots[c].first;
      rows.back().b = slots[c].second;
    }
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double change = 0;
    // Backwards: blocks are mostly listed from the ground up, and loads pass downwards.
    for (std::size_t k = rows.size(); k-- > 0;) {
      PointRows& row = rows[k];
      SolverBody &a = bodies[row.a], &b = bodies[row.b];
      change = std::max(change, relax_normal(row, a, b));
      change = std::max(change, relax_friction(row, a, b));
    }
    if (change < kSettled) break;
  }
  undo_overlaps(rows, bodies);
  auto row = rows.begin();
  for (Contact& contact : contacts) {
    for (int i = 0; i < contact.count; ++i, ++row) {
      ContactPoint& point = contact.points[static_cast<std::size_t>(i)];
      point.push = row->push;
      point.friction = row->first.d * row->slide_first + row->second.d * row->slide_second;
    }
  }
}

}  // namespace stig
