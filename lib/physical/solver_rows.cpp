// SPDX-License-Identifier: MIT
#include "physical/solver_rows.h"

#include <algorithm>
#include <tuple>

namespace stig {

namespace {

constexpr double kCorrection = 0.1;     ///< part of an overlap undone in a step
constexpr double kSlop = 50e-6;         ///< overlap that is left alone, m
constexpr double kMostRecovery = 0.05;  ///< m/s

const SolverLink* link_of(const SolverTask& task, std::uint32_t body) {
  const std::int32_t link = task.bodies[body].link;
  return link < 0 ? nullptr : &task.links[static_cast<std::size_t>(link)];
}

/// In two sums, of which neither waits for the other.
double product(const double* a, const double* b, std::size_t n) {
  double even = 0, odd = 0;
  for (std::size_t i = 0; i + 1 < n; i += 2) {
    even += a[i] * b[i];
    odd += a[i + 1] * b[i + 1];
  }
  return n % 2 == 0 ? even + odd : even + odd + a[n - 1] * b[n - 1];
}

/// Appends J and W of a unit impulse along `d` at `p` (times `sign`); returns J·W.
double add_hold(const SolverTask& task, const SolverLink& link, const Vec3& p, const Vec3& d,
                double sign, Hold& hold, std::vector<double>& numbers) {
  const SolverMechanism& mechanism = task.mechanisms[link.mechanism];
  const std::size_t n = mechanism.dofs, at = numbers.size();
  hold = {static_cast<std::int32_t>(link.mechanism), static_cast<std::uint32_t>(at)};
  numbers.resize(at + 2 * n);
  const Vec3 arm = cross(p - link.p, d);
  for (std::size_t i = 0; i < n; ++i) {
    numbers[at + i] = sign * (dot(d, link.columns[i].v) + dot(arm, link.columns[i].w));
  }
  double* j = &numbers[at];
  double* w = j + n;
  for (std::size_t i = 0; i < n; ++i) w[i] = product(mechanism.inverse + i * n, j, n);
  return product(w, j, n);
}

Row make_row(const SolverTask& task, const RowPoint& point, const Vec3& p, const Vec3& d,
             std::vector<double>& numbers) {
  const SolverBody &a = task.bodies[point.a], &b = task.bodies[point.b];
  Row row;
  row.d = d;
  row.arm_a = cross(p - a.p, d);
  row.arm_b = cross(p - b.p, d);
  row.turn_a = a.inverse_inertia * row.arm_a;
  row.turn_b = b.inverse_inertia * row.arm_b;
  double inverse =
      a.inverse_mass + b.inverse_mass + dot(row.arm_a, row.turn_a) + dot(row.arm_b, row.turn_b);
  if (const SolverLink* link = link_of(task, point.a)) {
    inverse += add_hold(task, *link, p, d, 1, row.holds[0], numbers);
  }
  if (const SolverLink* link = link_of(task, point.b)) {
    inverse += add_hold(task, *link, p, d, -1, row.holds[1], numbers);
  }
  row.mass = inverse > 1e-12 ? 1 / inverse : 0;
  return row;
}

/// Whether its six numbers count: those of links and of the ground are zero.
bool is_loose(const SolverBody& body) {
  return body.inverse_mass > 0 || !(body.v == Vec3{}) || !(body.w == Vec3{});
}

/// The tangent that lies along the axle; some tangent when there is none, or it is upright.
Vec3 first_tangent(const Contact& contact) {
  const Vec3 flat = contact.axle - contact.normal * dot(contact.axle, contact.normal);
  return squared(flat) > 0.01 ? normalised(flat) : perpendicular(contact.normal);
}

RowPoint make_row_point(const SolverTask& task, std::size_t c, std::size_t number,
                        std::vector<double>& numbers) {
  const Contact& contact = task.contacts[c];
  const ContactPoint& from = contact.points[number];
  const double part = 1.0 / task.small_steps;
  RowPoint point;
  point.contact = static_cast<std::uint32_t>(c);
  point.point = static_cast<std::uint32_t>(number);
  std::tie(point.a, point.b) = task.slots[c];
  point.loose = is_loose(task.bodies[point.a]) || is_loose(task.bodies[point.b]);
  const Vec3 t = first_tangent(contact), s = cross(contact.normal, t);
  point.normal = make_row(task, point, from.p_W, contact.normal, numbers);
  point.first = make_row(task, point, from.p_W, t, numbers);
  point.second = make_row(task, point, from.p_W, s, numbers);
  point.gap = from.gap;
  point.push = from.push * part;
  point.slide_first = dot(from.friction, t) * part;
  point.slide_second = dot(from.friction, s) * part;
  point.friction = contact.friction;
  point.axle_friction = contact.axle_friction;
  const Vec3 way = bend(task, c, from.p_W);
  point.bend_first = dot(way, t);
  point.bend_second = dot(way, s);
  point.shift_target = least_shift(from.gap, task.dt);
  return point;
}

/// Which numbers rows are about: velocities, or the shift that undoes overlaps.
struct OfVelocities {
  static constexpr auto kLinear = &SolverBody::v, kAngular = &SolverBody::w;
  static double* speeds(const SolverMechanism& mechanism) { return mechanism.v; }
};
struct OfShifts {
  static constexpr auto kLinear = &SolverBody::way_v, kAngular = &SolverBody::way_w;
  static double* speeds(const SolverMechanism& mechanism) { return mechanism.way; }
};

template <class Of = OfVelocities>
double along(const Row& row, const Rows& rows, const SolverTask& task, const RowPoint& point) {
  double sum = 0;
  if (point.loose) {
    const SolverBody &a = task.bodies[point.a], &b = task.bodies[point.b];
    sum = dot(row.d, a.*Of::kLinear - b.*Of::kLinear) + dot(row.arm_a, a.*Of::kAngular) -
          dot(row.arm_b, b.*Of::kAngular);
  }
  for (const Hold& hold : row.holds) {
    if (hold.mechanism < 0) continue;
    const SolverMechanism& mechanism = task.mechanisms[static_cast<std::size_t>(hold.mechanism)];
    sum += product(&rows.numbers[hold.at], Of::speeds(mechanism), mechanism.dofs);
  }
  return sum;
}

template <class Of = OfVelocities>
void push(const Row& row, const Rows& rows, SolverTask& task, const RowPoint& point,
          double impulse) {
  if (impulse == 0) return;
  if (point.loose) {
    SolverBody &a = task.bodies[point.a], &b = task.bodies[point.b];
    a.*Of::kLinear += row.d * (impulse * a.inverse_mass);
    a.*Of::kAngular += row.turn_a * impulse;
    b.*Of::kLinear -= row.d * (impulse * b.inverse_mass);
    b.*Of::kAngular -= row.turn_b * impulse;
  }
  for (const Hold& hold : row.holds) {
    if (hold.mechanism < 0) continue;
    const SolverMechanism& mechanism = task.mechanisms[static_cast<std::size_t>(hold.mechanism)];
    const double* w = &rows.numbers[hold.at + mechanism.dofs];
    double* v = Of::speeds(mechanism);
    for (std::size_t i = 0; i < mechanism.dofs; ++i) v[i] += w[i] * impulse;
  }
}

/// Returns the change in velocity that was asked for.
double relax_normal(RowPoint& point, const Rows& rows, SolverTask& task, double inverse_dt) {
  const double lacking =
      -std::max(0.0, point.gap) * inverse_dt - along(point.normal, rows, task, point);
  const double impulse = std::max(0.0, point.push + lacking * point.normal.mass);
  const double change = impulse - point.push;
  point.push = impulse;
  push(point.normal, rows, task, point, change);
  return point.normal.mass > 0 ? std::abs(change) / point.normal.mass : 0;
}

/// Friction within an ellipse whose half axis along the axle is a part of the other. The
/// wheel slips so that friction takes the most power from it, as one with rollers on its rim
/// would: the step along the axle is shorter by the square of that part.
double relax_friction(RowPoint& point, const Rows& rows, SolverTask& task) {
  if (point.push == 0 && point.slide_first == 0 && point.slide_second == 0) return 0;
  const double part = point.axle_friction;
  // The same mass for both, so that sliding does not depend on how the tangents lie.
  const double mass = std::min(point.first.mass, point.second.mass);
  const double first = along(point.first, rows, task, point) + point.bend_first;
  const double second = along(point.second, rows, task, point) + point.bend_second;
  double x = point.slide_first - first * mass * part * part;
  double y = point.slide_second - second * mass;
  const double most = point.friction * point.push;
  if (part == 0) x = 0;
  const double across = part > 0 ? x / part : 0;
  const double size = across * across + y * y;
  if (size > most * most) {
    const double less = most / std::sqrt(size);
    x *= less;
    y *= less;
  }
  const double dx = x - point.slide_first, dy = y - point.slide_second;
  push(point.first, rows, task, point, dx);
  push(point.second, rows, task, point, dy);
  point.slide_first = x;
  point.slide_second = y;
  return mass > 0 ? std::max(std::abs(dx), std::abs(dy)) / mass : 0;
}

/// Of a point of a body, while its velocities stay the same.
Vec3 acceleration(const SolverTask& task, std::uint32_t body, const Vec3& p) {
  if (const SolverLink* link = link_of(task, body)) {
    const Vec3 arm = p - link->p;
    return link->change_v + cross(link->change_w, arm) + cross(link->w, cross(link->w, arm));
  }
  const SolverBody& one = task.bodies[body];
  return cross(one.w, cross(one.w, p - one.p));
}

void turn(const SolverAxis& axis, SolverTask& task, double impulse) {
  if (impulse == 0) return;  // most stops are far away
  SolverMechanism& mechanism = task.mechanisms[axis.mechanism];
  const std::size_t n = mechanism.dofs;
  for (std::size_t i = 0; i < n; ++i) {
    mechanism.v[i] += mechanism.inverse[i * n + axis.dof] * impulse;
  }
}

double relax_axis(SolverAxis& axis, SolverTask& task, double inverse_dt) {
  const SolverMechanism& mechanism = task.mechanisms[axis.mechanism];
  const double inverse = mechanism.inverse[axis.dof * mechanism.dofs + axis.dof];
  const double speed = mechanism.v[axis.dof];
  double impulse = 0;
  if (axis.side == 0) {
    impulse = axis.impulse + (axis.target - speed) / inverse;
    impulse = std::clamp(impulse, -axis.most, axis.most);
  } else {
    const double least = -axis.gap * inverse_dt * (axis.gap > 0 ? 1 : kCorrection);
    impulse = axis.impulse + (axis.side * least - speed) / inverse;
    impulse = axis.side > 0 ? std::max(0.0, impulse) : std::min(0.0, impulse);
  }
  const double change = impulse - axis.impulse;
  axis.impulse = impulse;
  turn(axis, task, change);
  return std::abs(change) * inverse;
}

}  // namespace

Vec3 bend(const SolverTask& task, std::size_t contact, const Vec3& p_W) {
  const auto [a, b] = task.slots[contact];
  if (a == 0 || b == 0 || task.contacts[contact].count < 3) return {};
  return (acceleration(task, a, p_W) - acceleration(task, b, p_W)) * (task.dt / 2);
}

double least_shift(double gap, double dt) {
  if (gap > -kSlop) return -(gap + kSlop) / dt;
  return std::min(kCorrection * (-gap - kSlop) / dt, kMostRecovery);
}

bool needs_rows(const SolverTask& task, std::size_t contact) {
  const auto [a, b] = task.slots[contact];
  return task.bodies[a].link >= 0 || task.bodies[b].link >= 0 ||
         !(task.contacts[contact].axle == Vec3{});
}

void make_rows(const SolverTask& task, Rows& rows) {
  rows.numbers.clear();
  rows.points.clear();
  for (std::size_t c = 0; c < task.contacts.size(); ++c) {
    if (!needs_rows(task, c)) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.contacts[c].count); ++i) {
      rows.points.push_back(make_row_point(task, c, i, rows.numbers));
    }
  }
  rows.axes = task.axes;
  for (SolverAxis& axis : rows.axes) {
    axis.impulse /= task.small_steps;
    axis.most /= task.small_steps;
  }
}

void apply_last_rows(const Rows& rows, SolverTask& task) {
  for (const SolverAxis& axis : rows.axes) turn(axis, task, axis.impulse);
  for (const RowPoint& point : rows.points) {
    push(point.normal, rows, task, point, point.push);
    push(point.first, rows, task, point, point.slide_first);
    push(point.second, rows, task, point, point.slide_second);
  }
}

double sweep_rows(Rows& rows, SolverTask& task, double inverse_dt) {
  double change = 0;
  for (SolverAxis& axis : rows.axes) {
    change = std::max(change, relax_axis(axis, task, inverse_dt));
  }
  for (RowPoint& point : rows.points) {
    change = std::max(change, relax_normal(point, rows, task, inverse_dt));
    change = std::max(change, relax_friction(point, rows, task));
  }
  return change;
}

void follow_row_gaps(Rows& rows, const SolverTask& task, double dt) {
  for (SolverAxis& axis : rows.axes) {
    axis.gap += axis.side * task.mechanisms[axis.mechanism].v[axis.dof] * dt;
  }
  for (RowPoint& point : rows.points) {
    point.gap += along(point.normal, rows, task, point) * dt;
  }
}

bool overlapping(const Rows& rows) {
  return std::any_of(rows.points.begin(), rows.points.end(),
                     [](const RowPoint& point) { return point.shift_target > 0; });
}

void shift_rows(Rows& rows, SolverTask& task) {
  for (RowPoint& point : rows.points) {
    const Row& row = point.normal;
    const double speed = along<OfShifts>(row, rows, task, point);
    const double impulse = std::max(0.0, point.shift + (point.shift_target - speed) * row.mass);
    push<OfShifts>(row, rows, task, point, impulse - point.shift);
    point.shift = impulse;
  }
}

void keep_row_impulses(const Rows& rows, SolverTask& task) {
  const double parts = task.small_steps;
  for (const RowPoint& from : rows.points) {
    ContactPoint& point = task.contacts[from.contact].points[from.point];
    point.push = from.push * parts;
    point.friction = (from.first.d * from.slide_first + from.second.d * from.slide_second) * parts;
  }
  for (std::size_t i = 0; i < rows.axes.size(); ++i) {
    task.axes[i].impulse = rows.axes[i].impulse * parts;
  }
}

}  // namespace stig
