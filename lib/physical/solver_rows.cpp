// SPDX-License-Identifier: MIT
#include "physical/solver_rows.h"

#include <algorithm>
#include <cstring>
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

/// Two numbers at once, as every processor of this width computes them.
using Two = double __attribute__((vector_size(16)));

Two two_at(const double* p) {
  Two out;
  std::memcpy(&out, p, sizeof out);
  return out;
}

/// J's numbers of one direction.
std::size_t width(const Reach& reach) { return 2 * std::size_t{reach.count} + 1; }

/// Of so many pairs, or of `count` where that is 0.
template <std::size_t kPairs>
double product_of(const double* j, const std::uint32_t* pair, std::size_t count, const double* v,
                  std::size_t n) {
  if (kPairs > 0) count = kPairs;
  Two sum{};
  for (std::size_t k = 0; k < count; ++k) {
    sum += two_at(j + 2 * k) * two_at(v + 2 * std::size_t{pair[k]});
  }
  const double both = sum[0] + sum[1];
  return n % 2 == 0 ? both : both + j[2 * count] * v[n - 1];
}

/// J times v. In two sums, of which neither waits for the other; what J leaves out is zero. A
/// robot's base has three pairs, what hangs on it mostly one more: these are written out.
double product(const double* j, const Rows& rows, const Reach& reach, const double* v,
               std::size_t n) {
  const std::uint32_t* pair = rows.pairs.data() + reach.begin;
  switch (reach.count) {
    case 3:
      return product_of<3>(j, pair, 3, v, n);
    case 4:
      return product_of<4>(j, pair, 4, v, n);
    default:
      return product_of<0>(j, pair, reach.count, v, n);
  }
}

/// Adds W times an impulse, for n / 2 pairs and one more.
template <std::size_t kPairs>
void add_to(double* v, const double* w, std::size_t n, double impulse) {
  const Two both{impulse, impulse};
  const std::size_t pairs = kPairs > 0 ? kPairs : n / 2;
  for (std::size_t k = 0; k < pairs; ++k) {
    const Two sum = two_at(v + 2 * k) + two_at(w + 2 * k) * both;
    std::memcpy(v + 2 * k, &sum, sizeof sum);
  }
  if (n % 2 != 0) v[n - 1] += w[n - 1] * impulse;
}

void add(double* v, const double* w, std::size_t n, double impulse) {
  if (n / 2 == 5) return add_to<5>(v, w, n, impulse);  // robots of four wheels and a lift
  add_to<0>(v, w, n, impulse);
}

void note_reach(const SolverTask& task, Rows& rows) {
  rows.pairs.clear();
  rows.reach.clear();
  for (const SolverLink& link : task.links) {
    Reach reach{static_cast<std::uint32_t>(rows.pairs.size()), 0};
    const auto moves = [&link](std::size_t i) {
      return !(link.columns[i].v == Vec3{}) || !(link.columns[i].w == Vec3{});
    };
    for (std::uint32_t k = 0; k < task.mechanisms[link.mechanism].dofs / 2; ++k) {
      if (moves(2 * std::size_t{k}) || moves(2 * std::size_t{k} + 1)) rows.pairs.push_back(k);
    }
    reach.count = static_cast<std::uint32_t>(rows.pairs.size()) - reach.begin;
    rows.reach.push_back(reach);
  }
}

/// J and W of a unit impulse along a direction `d` at `p` (times `sign`); returns J·W.
double fill_row(const SolverTask& task, const Hold& hold, const Vec3& p, const Vec3& d, double sign,
                std::size_t direction, Rows& rows) {
  const SolverLink& link = task.links[hold.link];
  const SolverMechanism& mechanism = task.mechanisms[link.mechanism];
  const Reach& reach = rows.reach[hold.link];
  const std::size_t n = hold.dofs, last = width(reach) - 1;
  double* j = &rows.numbers[hold.at + direction * width(reach)];
  double* w = &rows.numbers[hold.at + 3 * width(reach) + direction * n];
  const Vec3 arm = cross(p - link.p, d);
  const auto entry = [&](std::size_t i) {
    return sign * (dot(d, link.columns[i].v) + dot(arm, link.columns[i].w));
  };
  for (std::size_t k = 0; k < last; ++k) {
    j[k] = entry(2 * std::size_t{rows.pairs[reach.begin + k / 2]} + k % 2);
  }
  j[last] = n % 2 == 0 ? 0 : entry(n - 1);
  for (std::size_t i = 0; i < n; ++i) w[i] = product(j, rows, reach, mechanism.inverse + i * n, n);
  return product(j, rows, reach, w, n);
}

void add_hold(const SolverTask& task, std::uint32_t body, RowPoint& point, Rows& rows) {
  const std::int32_t number = task.bodies[body].link;
  if (number < 0) return;
  Hold& hold = point.holds[point.held++];
  hold.link = static_cast<std::uint32_t>(number);
  const SolverMechanism& mechanism = task.mechanisms[task.links[hold.link].mechanism];
  hold.v = mechanism.v;
  hold.way = mechanism.way;
  hold.dofs = static_cast<std::uint32_t>(mechanism.dofs);
  hold.at = static_cast<std::uint32_t>(rows.numbers.size());
  rows.numbers.resize(rows.numbers.size() + 3 * (width(rows.reach[hold.link]) + mechanism.dofs));
}

Row make_row(const SolverTask& task, const RowPoint& point, const Vec3& p, const Vec3& d,
             std::size_t direction, Rows& rows) {
  const SolverBody &a = task.bodies[point.a], &b = task.bodies[point.b];
  Row row;
  row.d = d;
  double inverse = 0;
  if (point.loose_a) {
    row.arm_a = cross(p - a.p, d);
    row.turn_a = a.inverse_inertia * row.arm_a;
    inverse += a.inverse_mass;
  }
  if (point.loose_b) {
    row.arm_b = cross(p - b.p, d);
    row.turn_b = b.inverse_inertia * row.arm_b;
    inverse += b.inverse_mass;
  }
  inverse += dot(row.arm_a, row.turn_a);
  inverse += dot(row.arm_b, row.turn_b);
  for (std::size_t i = 0; i < point.held; ++i) {
    const double sign = i == 0 && a.link >= 0 ? 1 : -1;
    inverse += fill_row(task, point.holds[i], p, d, sign, direction, rows);
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

RowPoint make_row_point(const SolverTask& task, std::size_t c, std::size_t number, Rows& rows) {
  const Contact& contact = task.contacts[c];
  const ContactPoint& from = contact.points[number];
  const double part = 1.0 / task.small_steps;
  RowPoint point;
  point.contact = static_cast<std::uint32_t>(c);
  point.point = static_cast<std::uint32_t>(number);
  std::tie(point.a, point.b) = task.slots[c];
  point.loose_a = is_loose(task.bodies[point.a]);
  point.loose_b = is_loose(task.bodies[point.b]);
  add_hold(task, point.a, point, rows);
  add_hold(task, point.b, point, rows);
  const Vec3 t = first_tangent(contact), s = cross(contact.normal, t);
  point.rows = {make_row(task, point, from.p_W, contact.normal, 0, rows),
                make_row(task, point, from.p_W, t, 1, rows),
                make_row(task, point, from.p_W, s, 2, rows)};
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
  static constexpr auto kSpeeds = &Hold::v;
};
struct OfShifts {
  static constexpr auto kLinear = &SolverBody::way_v, kAngular = &SolverBody::way_w;
  static constexpr auto kSpeeds = &Hold::way;
};

constexpr std::size_t kNormal = 0, kFirst = 1, kSecond = 2;

template <class Of = OfVelocities>
double along(std::size_t direction, const Rows& rows, const SolverTask& task,
             const RowPoint& point) {
  const Row& row = point.rows[direction];
  Vec3 v;
  double sum = 0;
  if (point.loose_a) v = task.bodies[point.a].*Of::kLinear;
  if (point.loose_b) v -= task.bodies[point.b].*Of::kLinear;
  if (point.loose_a || point.loose_b) sum = dot(row.d, v);
  if (point.loose_a) sum += dot(row.arm_a, task.bodies[point.a].*Of::kAngular);
  if (point.loose_b) sum -= dot(row.arm_b, task.bodies[point.b].*Of::kAngular);
  for (std::size_t i = 0; i < point.held; ++i) {
    const Hold& hold = point.holds[i];
    const Reach& reach = rows.reach[hold.link];
    const double* j = &rows.numbers[hold.at + direction * width(reach)];
    sum += product(j, rows, reach, hold.*Of::kSpeeds, hold.dofs);
  }
  return sum;
}

template <class Of = OfVelocities>
void push(std::size_t direction, const Rows& rows, SolverTask& task, const RowPoint& point,
          double impulse) {
  if (impulse == 0) return;
  const Row& row = point.rows[direction];
  if (point.loose_a) {
    SolverBody& a = task.bodies[point.a];
    a.*Of::kLinear += row.d * (impulse * a.inverse_mass);
    a.*Of::kAngular += row.turn_a * impulse;
  }
  if (point.loose_b) {
    SolverBody& b = task.bodies[point.b];
    b.*Of::kLinear -= row.d * (impulse * b.inverse_mass);
    b.*Of::kAngular -= row.turn_b * impulse;
  }
  for (std::size_t i = 0; i < point.held; ++i) {
    const Hold& hold = point.holds[i];
    const std::size_t w = hold.at + 3 * width(rows.reach[hold.link]) + direction * hold.dofs;
    add(hold.*Of::kSpeeds, &rows.numbers[w], hold.dofs, impulse);
  }
}

/// Returns the change in velocity that was asked for.
double relax_normal(RowPoint& point, const Rows& rows, SolverTask& task, double inverse_dt) {
  const double mass = point.rows[kNormal].mass;
  const double lacking = -std::max(0.0, point.gap) * inverse_dt - along(kNormal, rows, task, point);
  const double impulse = std::max(0.0, point.push + lacking * mass);
  const double change = impulse - point.push;
  point.push = impulse;
  push(kNormal, rows, task, point, change);
  return mass > 0 ? std::abs(change) / mass : 0;
}

/// Friction within an ellipse whose half axis along the axle is a part of the other. The
/// wheel slips so that friction takes the most power from it, as one with rollers on its rim
/// would: the step along the axle is shorter by the square of that part.
double relax_friction(RowPoint& point, const Rows& rows, SolverTask& task) {
  if (point.push == 0 && point.slide_first == 0 && point.slide_second == 0) return 0;
  const double part = point.axle_friction;
  // The same mass for both, so that sliding does not depend on how the tangents lie.
  const double mass = std::min(point.rows[kFirst].mass, point.rows[kSecond].mass);
  const double first = along(kFirst, rows, task, point) + point.bend_first;
  const double second = along(kSecond, rows, task, point) + point.bend_second;
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
  push(kFirst, rows, task, point, dx);
  push(kSecond, rows, task, point, dy);
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
  note_reach(task, rows);
  rows.numbers.clear();
  rows.points.clear();
  for (std::size_t c = 0; c < task.contacts.size(); ++c) {
    if (!needs_rows(task, c)) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.contacts[c].count); ++i) {
      rows.points.push_back(make_row_point(task, c, i, rows));
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
    push(kNormal, rows, task, point, point.push);
    push(kFirst, rows, task, point, point.slide_first);
    push(kSecond, rows, task, point, point.slide_second);
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
    point.gap += along(kNormal, rows, task, point) * dt;
  }
}

bool overlapping(const Rows& rows) {
  return std::any_of(rows.points.begin(), rows.points.end(),
                     [](const RowPoint& point) { return point.shift_target > 0; });
}

void shift_rows(Rows& rows, SolverTask& task) {
  for (RowPoint& point : rows.points) {
    const double mass = point.rows[kNormal].mass;
    const double speed = along<OfShifts>(kNormal, rows, task, point);
    const double impulse = std::max(0.0, point.shift + (point.shift_target - speed) * mass);
    push<OfShifts>(kNormal, rows, task, point, impulse - point.shift);
    point.shift = impulse;
  }
}

void keep_row_impulses(const Rows& rows, SolverTask& task) {
  const double parts = task.small_steps;
  for (const RowPoint& from : rows.points) {
    ContactPoint& point = task.contacts[from.contact].points[from.point];
    point.push = from.push * parts;
    point.friction =
        (from.rows[kFirst].d * from.slide_first + from.rows[kSecond].d * from.slide_second) * parts;
  }
  for (std::size_t i = 0; i < rows.axes.size(); ++i) {
    task.axes[i].impulse = rows.axes[i].impulse * parts;
  }
}

}  // namespace stig
