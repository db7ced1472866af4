// SPDX-License-Identifier: MIT
// Rows are made anew each step, since links move. The memory is kept (solver.cpp): `numbers` holds
// J and W of all points in one list, in the order in which sweeps read them.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "physical/solver/robot_rows.h"
#include "physical/solver/row_numbers.h"

namespace stig::physics {

namespace {

// So much stays, so that contacts at rest do not come and go.
constexpr double kSlop = 50e-6;         ///< overlap that is left alone, m
constexpr double kMostRecovery = 0.05;  ///< m/s

const SolverLink* link_of(const SolverTask& task, std::uint32_t body) {
  const std::int32_t link = task.bodies[body].link;
  return link < 0 ? nullptr : &task.links[static_cast<std::size_t>(link)];
}

// ---- Mechanisms ----

// Joints beyond a link do not move it. Wheels and lifts are mostly leaves of a mechanism's tree, so
// J is zero but for the body and one of them: that is what `begin` and `extra` say. A link that
// needs more than one extra pair gets all.
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

/// How many numbers there are: any, or a robot's, so that loops are written out.
struct AnySize {
  static std::size_t begin(const Hold& hold) { return hold.reach.begin; }
  static std::size_t dofs(const Hold& hold) { return hold.dofs; }
};
template <std::size_t kBegin>
struct RobotSize {
  static std::size_t begin(const Hold&) { return kBegin; }
  static std::size_t dofs(const Hold&) { return kRobotDofs; }
};

/// W = M⁻¹Jᵀ, two of its numbers at once; M⁻¹ is the same by rows and by columns, to the bit. Sums
/// are those of product().
template <class Size>
void fill_w(const double* inverse, const Hold& hold, const double* j, double* w) {
  const std::size_t begin = Size::begin(hold), n = Size::dofs(hold);
  const double* extra = inverse + 2 * std::size_t{hold.reach.extra} * n;
  const double* last = inverse + (n - 1) * n;
  for (std::size_t i = 0; i + 1 < n; i += 2) {
    Two even{}, odd{};
    for (std::size_t k = 0; k < begin; ++k) {
      even += both(j[2 * k]) * two_at(inverse + 2 * k * n + i);
      odd += both(j[2 * k + 1]) * two_at(inverse + (2 * k + 1) * n + i);
    }
    if (hold.reach.extra > 0) {
      even += both(j[2 * begin]) * two_at(extra + i);
      odd += both(j[2 * begin + 1]) * two_at(extra + n + i);
    }
    Two sum = even + odd;
    if (n % 2 != 0) sum += both(j[2 * begin + 2]) * two_at(last + i);
    put(w + i, sum);
  }
  if (n % 2 != 0) w[n - 1] = product(j, hold, last);
}

/// J and W of a unit impulse along a direction `d` at `p` (times `sign`); returns J·W. J holds
/// dot(d, v) of the velocity v that each degree of freedom alone would give the link at p.
template <class Size>
double fill_row(const SolverTask& task, const SolverLink& link, const Hold& hold, const Vec3& p,
                const Vec3& d, double sign, double* j, double* w) {
  const std::size_t begin = Size::begin(hold), n = Size::dofs(hold);
  const Vec3 arm = cross(p - link.p, d);
  const auto entry = [&](std::size_t i) {
    return sign * (dot(d, link.columns[i].v) + dot(arm, link.columns[i].w));
  };
  for (std::size_t i = 0; i < 2 * begin; ++i) j[i] = entry(i);
  for (std::size_t i = 0; i < 2 && hold.reach.extra > 0; ++i) {
    j[2 * begin + i] = entry(2 * std::size_t{hold.reach.extra} + i);
  }
  if (n % 2 != 0) j[2 * begin + 2] = entry(n - 1);
  fill_w<Size>(task.mechanisms[link.mechanism].inverse, hold, j, w);
  return product(j, hold, w);
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
  rows.numbers.resize(rows.numbers.size() + 3 * (hold.reach.width() + hold.height()));
  const auto fill = [&](auto size) {
    double* j = &rows.numbers[hold.at];
    double* w = j + 3 * hold.reach.width();
    for (std::size_t i = 0; i < 3; ++i) {
      change[i] += fill_row<decltype(size)>(task, *link, hold, p, point.directions[i], sign, j, w);
      j += hold.reach.width();
      w += hold.height();
    }
  };
  const std::size_t begin = hold.dofs == kRobotDofs ? hold.reach.begin : 0;
  // A robot's sizes are known when compiling.
  begin == 3 ? fill(RobotSize<3>{}) : begin == 4 ? fill(RobotSize<4>{}) : fill(AnySize{});
}

// ---- Free bodies ----

// Rows reach a body's six numbers by one pointer.
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
    side.j[i] = {jv.x, jw.x, jv.y, jw.y, jv.z, jw.z};
    side.w[i] = {d.x, ww.x, d.y, ww.y, d.z, ww.z};
  }
}

// ---- Points ----

/// The tangent that lies along the axle; some tangent when there is none, or it is upright.
Vec3 first_tangent(const Contact& contact) {
  const Vec3 flat = contact.axle - contact.normal * dot(contact.axle, contact.normal);
  // An axle nearly along the normal leaves no direction along the surface.
  return squared(flat) > 0.01 ? normalised(flat) : perpendicular(contact.normal);
}

void add_point(SolverTask& task, std::size_t c, std::size_t number, Rows& rows) {
  const Contact& contact = task.contacts[c];
  const ContactPoint& from = contact.points[number];
  const auto [a, b] = task.slots[c];
  const double part = 1.0 / task.small_steps;
  RowPoint& point = rows.points.emplace_back();
  point.contact = static_cast<std::uint32_t>(c);
  point.point = static_cast<std::uint32_t>(number);
  const Vec3 t = first_tangent(contact), s = cross(contact.normal, t);
  point.directions = {contact.normal, t, s};
  std::array<double, 3> change{};  // of velocity, by an impulse of 1
  add_loose(task.bodies[a], from.p_W, 1, point, change);
  add_loose(task.bodies[b], from.p_W, -1, point, change);
  add_hold(task, a, from.p_W, 1, point, change, rows);
  add_hold(task, b, from.p_W, -1, point, change, rows);
  point.kind = kind_of(point);
  // Zero where nothing gives way: the point then takes no impulse.
  for (std::size_t i = 0; i < 3; ++i) point.mass[i] = change[i] > 1e-12 ? 1 / change[i] : 0;
  point.gap = from.gap;
  point.push = from.push * part;
  point.slide = {dot(from.friction, t) * part, dot(from.friction, s) * part};
  point.friction = contact.friction;
  point.axle_friction = contact.axle_friction;
  const Vec3 way = bend(task, c, from.p_W);
  point.bend = {dot(way, t), dot(way, s)};
  point.shift_target = least_shift(from.gap, task.dt);
}

// Runs are of the same velocities, so that they can be kept in registers.
bool same_run(const RowPoint& a, const RowPoint& b) {
  return a.kind == b.kind && a.kind != RowKind::any && a.holds[0].v == b.holds[0].v &&
         a.loose[0].v == b.loose[0].v;
}

void note_runs(Rows& rows) {
  rows.runs.clear();
  for (std::uint32_t i = 0; i < rows.points.size(); ++i) {
    if (i == 0 || !same_run(rows.points[i - 1], rows.points[i])) rows.runs.push_back({i, i});
    rows.runs.back().end = i + 1;
  }
}

/// The acceleration of a point of a body, while its velocities stay the same.
Vec3 acceleration(const SolverTask& task, std::uint32_t body, const Vec3& p) {
  if (const SolverLink* link = link_of(task, body)) {
    const Vec3 arm = p - link->p;
    return link->change_v + cross(link->change_w, arm) + cross(link->w, cross(link->w, arm));
  }
  const SolverBody& one = task.bodies[body];
  return cross(one.w, cross(one.w, p - one.p));
}

}  // namespace

Vec3 bend(const SolverTask& task, std::size_t contact, const Vec3& p_W) {
  const auto [a, b] = task.slots[contact];
  // Fewer than three points are an edge or a wheel, which rolls: see the header.
  if (a == 0 || b == 0 || task.contacts[contact].count < 3) return {};
  return (acceleration(task, a, p_W) - acceleration(task, b, p_W)) * (task.dt / 2);
}

double least_shift(double gap, double dt) {
  assert(dt > 0);
  // Apart, or overlapping by less than the slop: the shift may close what is left, and no more.
  if (gap > -kSlop) return -(gap + kSlop) / dt;
  return std::min(kOverlapCorrection * (-gap - kSlop) / dt, kMostRecovery);
}

bool needs_rows(const SolverTask& task, std::size_t contact) {
  assert(contact < task.slots.size());
  const auto [a, b] = task.slots[contact];
  return task.bodies[a].link >= 0 || task.bodies[b].link >= 0 ||
         !(task.contacts[contact].axle == Vec3{});
}

void make_rows(SolverTask& task, Rows& rows) {
  assert(task.slots.size() == task.contacts.size());
  rows.reach.clear();
  for (const SolverLink& link : task.links) rows.reach.push_back(reach_of(task, link));
  rows.numbers.clear();
  rows.points.clear();
  for (std::size_t c = 0; c < task.contacts.size(); ++c) {
    if (!needs_rows(task, c)) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.contacts[c].count); ++i) {
      add_point(task, c, i, rows);
    }
  }
  note_runs(rows);
  rows.axes = task.axes;
  for (SolverAxis& axis : rows.axes) {
    axis.impulse /= task.small_steps;
    axis.most /= task.small_steps;
  }
}

}  // namespace stig::physics
