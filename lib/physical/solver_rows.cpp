// SPDX-License-Identifier: MIT
#include "physical/solver_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>
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
void put(double* p, const Two& two) { std::memcpy(p, &two, sizeof two); }
Two both(double x) { return Two{x, x}; }

// ---- Mechanisms ----

/// How many pairs there are: `kBegin` and `kPairs` where they are known, as of robots with four
/// wheels and a lift, for which loops are written out.
template <std::size_t kBegin, std::size_t kPairs>
struct Sizes {
  static std::size_t begin(const Reach& reach) { return kBegin > 0 ? kBegin : reach.begin; }
  static std::size_t pairs(const Hold& hold) { return kPairs > 0 ? kPairs : hold.dofs / 2; }
};
using AnySizes = Sizes<0, 0>;
using RobotSizes = Sizes<3, 5>;

bool is_robot(const Hold& hold) { return hold.reach.begin == 3 && hold.dofs / 2 == 5; }
bool is_robot(const RowPoint& point) { return point.held == 1 && is_robot(point.holds[0]); }

/// J times v. In two sums, of which neither waits for the other.
template <class Size = AnySizes>
double product(const double* j, const Hold& hold, const double* v) {
  const std::size_t begin = Size::begin(hold.reach), pairs = Size::pairs(hold);
  Two sum{};
  for (std::size_t k = 0; k < begin; ++k) sum += two_at(j + 2 * k) * two_at(v + 2 * k);
  if (hold.reach.extra > 0) {
    sum += two_at(j + 2 * begin) * two_at(v + 2 * std::size_t{hold.reach.extra});
  }
  const double most = sum[0] + sum[1];
  return hold.dofs % 2 == 0 ? most : most + j[2 * begin + 2] * v[2 * pairs];
}

/// Adds W times an impulse in each of `kCount` directions, one after the other.
template <class Size, std::size_t kCount>
void add(const double* w, const Hold& hold, const std::array<double, kCount>& impulse, double* v) {
  const std::size_t n = hold.dofs, pairs = Size::pairs(hold);
  for (std::size_t k = 0; k < pairs; ++k) {
    Two sum = two_at(v + 2 * k);
    for (std::size_t i = 0; i < kCount; ++i) sum += two_at(w + i * n + 2 * k) * both(impulse[i]);
    put(v + 2 * k, sum);
  }
  if (n % 2 == 0) return;
  for (std::size_t i = 0; i < kCount; ++i) v[n - 1] += w[i * n + n - 1] * impulse[i];
}

const double* rows_j(const Rows& rows, const Hold& hold, std::size_t direction) {
  return &rows.numbers[hold.at + direction * hold.reach.width()];
}
const double* rows_w(const Rows& rows, const Hold& hold, std::size_t direction) {
  return &rows.numbers[hold.at + 3 * hold.reach.width() + direction * hold.dofs];
}

Reach reach_of(const SolverTask& task, const SolverLink& link) {
  const auto moves = [&link](std::size_t i) {
    return !(link.columns[i].v == Vec3{}) || !(link.columns[i].w == Vec3{});
  };
  const auto pair_moves = [&](std::size_t k) { return moves(2 * k) || moves(2 * k + 1); };
  const auto pairs = static_cast<std::uint32_t>(task.mechanisms[link.mechanism].dofs / 2);
  Reach out;
  while (out.begin < pairs && pair_moves(out.begin)) ++out.begin;
  for (std::uint32_t k = out.begin; k < pairs; ++k) {
    if (!pair_moves(k)) continue;
    if (out.extra > 0 || k == 0) return {pairs, 0};
    out.extra = k;
  }
  return out;
}

/// J and W of a unit impulse along a direction `d` at `p` (times `sign`); returns J·W.
template <class Size>
double fill_row(const SolverTask& task, const SolverLink& link, const Hold& hold, const Vec3& p,
                const Vec3& d, double sign, std::size_t direction, Rows& rows) {
  const Reach& reach = hold.reach;
  const double* inverse = task.mechanisms[link.mechanism].inverse;
  const std::size_t n = hold.dofs;
  double* j = &rows.numbers[hold.at + direction * reach.width()];
  double* w = &rows.numbers[hold.at + 3 * reach.width() + direction * n];
  const Vec3 arm = cross(p - link.p, d);
  const auto entry = [&](std::size_t i) {
    return sign * (dot(d, link.columns[i].v) + dot(arm, link.columns[i].w));
  };
  for (std::size_t i = 0; i < 2 * std::size_t{reach.begin}; ++i) j[i] = entry(i);
  for (std::size_t i = 0; i < 2 && reach.extra > 0; ++i) {
    j[2 * reach.begin + i] = entry(2 * std::size_t{reach.extra} + i);
  }
  if (n % 2 != 0) j[2 * std::size_t{reach.begin} + 2] = entry(n - 1);
  for (std::size_t i = 0; i < n; ++i) w[i] = product<Size>(j, hold, inverse + i * n);
  return product<Size>(j, hold, w);
}

/// All three directions; adds to what an impulse changes in each.
void add_hold(const SolverTask& task, std::uint32_t body, const Vec3& p, double sign,
              RowPoint& point, std::array<double, 3>& change, Rows& rows) {
  const SolverLink* link = link_of(task, body);
  if (link == nullptr) return;
  const SolverMechanism& mechanism = task.mechanisms[link->mechanism];
  Hold& hold = point.holds[point.held++];
  hold.v = mechanism.v;
  hold.way = mechanism.way;
  hold.dofs = static_cast<std::uint32_t>(mechanism.dofs);
  hold.reach = rows.reach[static_cast<std::size_t>(task.bodies[body].link)];
  hold.at = static_cast<std::uint32_t>(rows.numbers.size());
  rows.numbers.resize(rows.numbers.size() + 3 * (hold.reach.width() + hold.dofs));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& d = point.directions[i];
    change[i] += is_robot(hold) ? fill_row<RobotSizes>(task, *link, hold, p, d, sign, i, rows)
                                : fill_row<AnySizes>(task, *link, hold, p, d, sign, i, rows);
  }
}

// ---- Free bodies ----

static_assert(offsetof(SolverBody, w) == offsetof(SolverBody, v) + sizeof(Vec3) &&
                  offsetof(SolverBody, way_w) == offsetof(SolverBody, way_v) + sizeof(Vec3),
              "six numbers that stand together");

void add_loose(SolverBody& body, const Vec3& p, double sign, RowPoint& point,
               std::array<double, 3>& change) {
  // The numbers of links and of the ground are zero, and stay so.
  if (!(body.inverse_mass > 0) && body.v == Vec3{} && body.w == Vec3{}) return;
  LooseSide& side = point.loose[point.looses++];
  side.v = &body.v.x;
  side.way = &body.way_v.x;
  side.inverse_mass = sign * body.inverse_mass;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 d = point.directions[i], arm = cross(p - body.p, d);
    const Vec3 turn = body.inverse_inertia * arm;
    change[i] += body.inverse_mass + dot(arm, turn);
    const Vec3 jv = d * sign, jw = arm * sign, ww = turn * sign;
    side.j[i] = {jv.x, jv.y, jv.z, jw.x, jw.y, jw.z};
    side.w[i] = {d.x, d.y, d.z, ww.x, ww.y, ww.z};
  }
}

double product(const std::array<double, 6>& j, const double* v) {
  const Two a = two_at(&j[0]) * two_at(v), b = two_at(&j[2]) * two_at(v + 2),
            c = two_at(&j[4]) * two_at(v + 4);
  const double linear = a[0] + a[1] + b[0], angular = b[1] + c[0] + c[1];
  return linear + angular;
}

template <std::size_t kCount>
void add(const LooseSide& side, std::size_t direction, const std::array<double, kCount>& impulse,
         double* v) {
  Two a = two_at(v), b = two_at(v + 2), c = two_at(v + 4);
  for (std::size_t i = 0; i < kCount; ++i) {
    const double* w = side.w[direction + i].data();
    const double push = impulse[i] * side.inverse_mass;
    a += two_at(w) * both(push);
    b += two_at(w + 2) * Two{push, impulse[i]};
    c += two_at(w + 4) * both(impulse[i]);
  }
  put(v, a);
  put(v + 2, b);
  put(v + 4, c);
}

// ---- Points ----

/// The tangent that lies along the axle; some tangent when there is none, or it is upright.
Vec3 first_tangent(const Contact& contact) {
  const Vec3 flat = contact.axle - contact.normal * dot(contact.axle, contact.normal);
  return squared(flat) > 0.01 ? normalised(flat) : perpendicular(contact.normal);
}

RowPoint make_row_point(SolverTask& task, std::size_t c, std::size_t number, Rows& rows) {
  const Contact& contact = task.contacts[c];
  const ContactPoint& from = contact.points[number];
  const auto [a, b] = task.slots[c];
  const double part = 1.0 / task.small_steps;
  RowPoint point;
  point.contact = static_cast<std::uint32_t>(c);
  point.point = static_cast<std::uint32_t>(number);
  const Vec3 t = first_tangent(contact), s = cross(contact.normal, t);
  point.directions = {contact.normal, t, s};
  std::array<double, 3> change{};  // of velocity, by an impulse of 1
  add_loose(task.bodies[a], from.p_W, 1, point, change);
  add_loose(task.bodies[b], from.p_W, -1, point, change);
  add_hold(task, a, from.p_W, 1, point, change, rows);
  add_hold(task, b, from.p_W, -1, point, change, rows);
  for (std::size_t i = 0; i < 3; ++i) point.mass[i] = change[i] > 1e-12 ? 1 / change[i] : 0;
  point.gap = from.gap;
  point.push = from.push * part;
  point.slide = {dot(from.friction, t) * part, dot(from.friction, s) * part};
  point.friction = contact.friction;
  point.axle_friction = contact.axle_friction;
  const Vec3 way = bend(task, c, from.p_W);
  point.bend = {dot(way, t), dot(way, s)};
  point.shift_target = least_shift(from.gap, task.dt);
  return point;
}

/// Which numbers rows are about: velocities, or the shift that undoes overlaps.
struct OfVelocities {
  template <class Side>
  static double* of(const Side& side) {
    return side.v;
  }
};
struct OfShifts {
  template <class Side>
  static double* of(const Side& side) {
    return side.way;
  }
};

template <class Size, class Of = OfVelocities>
double along(std::size_t direction, const Rows& rows, const RowPoint& point) {
  double sum = 0;
  for (std::size_t i = 0; i < point.looses; ++i) {
    sum += product(point.loose[i].j[direction], Of::of(point.loose[i]));
  }
  for (std::size_t i = 0; i < point.held; ++i) {
    const Hold& hold = point.holds[i];
    sum += product<Size>(rows_j(rows, hold, direction), hold, Of::of(hold));
  }
  return sum;
}

/// In `kCount` directions from one on.
template <class Size, class Of = OfVelocities, std::size_t kCount>
void push(std::size_t direction, const Rows& rows, const RowPoint& point,
          const std::array<double, kCount>& impulse) {
  if (std::all_of(impulse.begin(), impulse.end(), [](double x) { return x == 0; })) return;
  for (std::size_t i = 0; i < point.looses; ++i) {
    add(point.loose[i], direction, impulse, Of::of(point.loose[i]));
  }
  for (std::size_t i = 0; i < point.held; ++i) {
    const Hold& hold = point.holds[i];
    add<Size>(rows_w(rows, hold, direction), hold, impulse, Of::of(hold));
  }
}

/// Returns the change in velocity that was asked for.
template <class Size>
double relax_normal(RowPoint& point, const Rows& rows, double inverse_dt) {
  const double mass = point.mass[kNormal];
  const double lacking = -std::max(0.0, point.gap) * inverse_dt - along<Size>(kNormal, rows, point);
  const double impulse = std::max(0.0, point.push + lacking * mass);
  const double change = impulse - point.push;
  point.push = impulse;
  push<Size>(kNormal, rows, point, std::array{change});
  return mass > 0 ? std::abs(change) / mass : 0;
}

/// Friction within an ellipse whose half axis along the axle is a part of the other. The
/// wheel slips so that friction takes the most power from it, as one with rollers on its rim
/// would: the step along the axle is shorter by the square of that part.
template <class Size>
double relax_friction(RowPoint& point, const Rows& rows) {
  if (point.push == 0 && point.slide[0] == 0 && point.slide[1] == 0) return 0;
  const double part = point.axle_friction;
  // The same mass for both, so that sliding does not depend on how the tangents lie.
  const double mass = std::min(point.mass[kFirst], point.mass[kSecond]);
  const double first = along<Size>(kFirst, rows, point) + point.bend[0];
  const double second = along<Size>(kSecond, rows, point) + point.bend[1];
  double x = point.slide[0] - first * mass * part * part;
  double y = point.slide[1] - second * mass;
  const double most = point.friction * point.push;
  if (part == 0) x = 0;
  const double across = part == 1 ? x : part > 0 ? x / part : 0;
  const double size = across * across + y * y;
  if (size > most * most) {
    const double less = most / std::sqrt(size);
    x *= less;
    y *= less;
  }
  const double dx = x - point.slide[0], dy = y - point.slide[1];
  push<Size>(kFirst, rows, point, std::array{dx, dy});
  point.slide = {x, y};
  return mass > 0 ? std::max(std::abs(dx), std::abs(dy)) / mass : 0;
}

template <class Size>
double relax(RowPoint& point, const Rows& rows, double inverse_dt) {
  const double change = relax_normal<Size>(point, rows, inverse_dt);
  return std::max(change, relax_friction<Size>(point, rows));
}

template <class Size>
void apply_last(const RowPoint& point, const Rows& rows) {
  push<Size>(kNormal, rows, point, std::array{point.push, point.slide[0], point.slide[1]});
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

void make_rows(SolverTask& task, Rows& rows) {
  rows.reach.clear();
  for (const SolverLink& link : task.links) rows.reach.push_back(reach_of(task, link));
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
    is_robot(point) ? apply_last<RobotSizes>(point, rows) : apply_last<AnySizes>(point, rows);
  }
}

double sweep_rows(Rows& rows, SolverTask& task, double inverse_dt) {
  double change = 0;
  for (SolverAxis& axis : rows.axes) {
    change = std::max(change, relax_axis(axis, task, inverse_dt));
  }
  for (RowPoint& point : rows.points) {
    change = std::max(change, is_robot(point) ? relax<RobotSizes>(point, rows, inverse_dt)
                                              : relax<AnySizes>(point, rows, inverse_dt));
  }
  return change;
}

void follow_row_gaps(Rows& rows, const SolverTask& task, double dt) {
  for (SolverAxis& axis : rows.axes) {
    axis.gap += axis.side * task.mechanisms[axis.mechanism].v[axis.dof] * dt;
  }
  for (RowPoint& point : rows.points) {
    const double speed = is_robot(point) ? along<RobotSizes>(kNormal, rows, point)
                                         : along<AnySizes>(kNormal, rows, point);
    point.gap += speed * dt;
  }
}

bool overlapping(const Rows& rows) {
  return std::any_of(rows.points.begin(), rows.points.end(),
                     [](const RowPoint& point) { return point.shift_target > 0; });
}

void shift_rows(Rows& rows) {
  for (RowPoint& point : rows.points) {
    const double speed = along<AnySizes, OfShifts>(kNormal, rows, point);
    const double impulse =
        std::max(0.0, point.shift + (point.shift_target - speed) * point.mass[kNormal]);
    push<AnySizes, OfShifts>(kNormal, rows, point, std::array{impulse - point.shift});
    point.shift = impulse;
  }
}

void keep_row_impulses(const Rows& rows, SolverTask& task) {
  const double parts = task.small_steps;
  for (const RowPoint& from : rows.points) {
    ContactPoint& point = task.contacts[from.contact].points[from.point];
    point.push = from.push * parts;
    point.friction =
        (from.directions[kFirst] * from.slide[0] + from.directions[kSecond] * from.slide[1]) *
        parts;
  }
  for (std::size_t i = 0; i < rows.axes.size(); ++i) {
    task.axes[i].impulse = rows.axes[i].impulse * parts;
  }
}

}  // namespace stig
