// SPDX-License-Identifier: MIT
// Two kinds of contacts are solved side by side: between free bodies here, in vectors of three;
// those that a mechanism has a part in as rows of generalised velocities (solver_rows.h). Points of
// free bodies are by far the most, so they have a form of their own.
#include "physical/solver/solver.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "physical/solver/grasp_rows.h"
#include "physical/solver/solver_rows.h"

namespace stig::physics {

namespace {

// How far a point may wander over a block in a step and still be the same.
constexpr double kMatchDistance = 3e-3;
// Overlaps are small, and what one step leaves the next undoes.
constexpr int kShiftSweeps = 6;
constexpr double kImpact = 1e-2;   ///< m/s: one that changes more is followed by others
constexpr int kMoreSweeps = 4;     ///< at most so many
constexpr double kSettled = 1e-8;  ///< m/s: a sweep that changes less is the last

/// A point between two free bodies, or one and the world. What four points of a contact
/// share is in their Patch.
struct Point {
  Vec3 arm_a, arm_b;  ///< from the centres of mass
  double gap = 0;
  double mass = 0, slide_mass = 0;  ///< impulse for a velocity change of 1 m/s, kg
  double push = 0;
  Vec3 slide;
  Vec3 bend;                           ///< see bend(); along the surface
  double shift_target = 0, shift = 0;  ///< m/s and N·s, for what undoes overlaps
};

struct Patch {
  std::uint32_t contact = 0;   ///< its place in the task
  std::uint32_t a = 0, b = 0;  ///< places of the bodies
  Vec3 normal;
  double friction = 0;
  std::uint32_t begin = 0, end = 0;  ///< its points
};

struct Patches {
  std::vector<Patch> patches;
  std::vector<Point> points;
};

/// The first body's velocity at the point, seen from the second, in m/s.
Vec3 velocity(const Point& point, const SolverBody& a, const SolverBody& b) {
  return a.v - b.v + cross(a.w, point.arm_a) - cross(b.w, point.arm_b);
}

// An impulse at a point; the other body takes the opposite.
void push(const Point& point, SolverBody& a, SolverBody& b, const Vec3& impulse) {
  a.v += impulse * a.inverse_mass;
  a.w += a.inverse_inertia * cross(point.arm_a, impulse);
  b.v -= impulse * b.inverse_mass;
  b.w -= b.inverse_inertia * cross(point.arm_b, impulse);
}

// 1 / (J M⁻¹ Jᵀ): by how much an impulse along d changes the velocity along d. Two bodies that
// nothing moves have none.
double effective_mass(const Point& point, const SolverBody& a, const SolverBody& b, const Vec3& d) {
  const Vec3 ca = cross(point.arm_a, d), cb = cross(point.arm_b, d);
  const double inverse = a.inverse_mass + b.inverse_mass + dot(ca, a.inverse_inertia * ca) +
                         dot(cb, b.inverse_inertia * cb);
  return inverse > 0 ? 1 / inverse : 0;
}

Point make_point(const SolverTask& task, std::uint32_t number, const ContactPoint& from) {
  const Contact& contact = task.contacts[number];
  const SolverBody &a = task.bodies[task.slots[number].first],
                   &b = task.bodies[task.slots[number].second];
  Point point;
  point.arm_a = from.p_W - a.p;
  point.arm_b = from.p_W - b.p;
  // From here on the gap follows the velocities to first order; the normal stays as it is.
  point.gap = from.gap;
  const Vec3 t = perpendicular(contact.normal), s = cross(contact.normal, t);
  point.mass = effective_mass(point, a, b, contact.normal);
  // The same for all directions, so that sliding does not depend on how the axes lie.
  point.slide_mass = std::min(effective_mass(point, a, b, t), effective_mass(point, a, b, s));
  point.push = from.push;
  point.slide = from.friction - contact.normal * dot(contact.normal, from.friction);
  point.shift_target = least_shift(from.gap, task.dt);
  point.bend = bend(task, number, from.p_W);
  point.bend -= contact.normal * dot(contact.normal, point.bend);
  return point;
}

/// Returns the change in velocity that was asked for.
double relax(const Patch& patch, Point& point, SolverBody& a, SolverBody& b, double inverse_dt) {
  const Vec3& n = patch.normal;
  const Vec3 v = velocity(point, a, b);
  // Complementarity: either the gap closes no faster than it is wide, or an impulse pushes. The
  // accumulated impulse is clamped, not the change, so a sweep can take back what another gave.
  const double along = dot(n, v);
  const double lacking = -std::max(0.0, point.gap) * inverse_dt - along;
  const double most = std::max(0.0, point.push + lacking * point.mass);
  // Most points of a pile that falls carry nothing.
  if (most == 0 && point.push == 0) return 0;
  // Coulomb's cone by projection: the tangential impulse that would stop the slide, cut to the
  // cone's radius. An ellipse, for wheels, is in the rows.
  Vec3 slide = point.slide - (v - n * along + point.bend) * point.slide_mass;
  const double limit = patch.friction * most, size = squared(slide);
  if (size > limit * limit) slide *= limit / std::sqrt(size);
  const double change = most - point.push;
  const Vec3 side = slide - point.slide;
  point.push = most;
  point.slide = slide;
  push(point, a, b, n * change + side);
  // Impulse times inverse mass: what the solver's end is decided by, in m/s.
  return std::max(std::abs(change),
                  std::max(std::abs(side.x), std::max(std::abs(side.y), std::abs(side.z)))) *
         (a.inverse_mass + b.inverse_mass);
}

// As relax, without friction, for velocities that move bodies and are then forgotten.
void relax_shift(const Patch& patch, Point& point, SolverBody& a, SolverBody& b) {
  const Vec3 v = a.way_v - b.way_v + cross(a.way_w, point.arm_a) - cross(b.way_w, point.arm_b);
  const double lacking = point.shift_target - dot(patch.normal, v);
  const double impulse = std::max(0.0, point.shift + lacking * point.mass);
  const Vec3 change = patch.normal * (impulse - point.shift);
  point.shift = impulse;
  a.way_v += change * a.inverse_mass;
  a.way_w += a.inverse_inertia * cross(point.arm_a, change);
  b.way_v -= change * b.inverse_mass;
  b.way_w -= b.inverse_inertia * cross(point.arm_b, change);
}

void make_patches(const SolverTask& task, double part, Patches& out) {
  out.patches.clear();
  out.points.clear();
  for (std::uint32_t c = 0; c < task.contacts.size(); ++c) {
    if (needs_rows(task, c)) continue;
    const Contact& contact = task.contacts[c];
    const auto [a, b] = task.slots[c];
    const auto begin = static_cast<std::uint32_t>(out.points.size());
    Patch patch{c, a, b, contact.normal, contact.friction, begin, 0};
    for (int i = 0; i < contact.count; ++i) {
      const ContactPoint& point = contact.points[static_cast<std::size_t>(i)];
      // Warm start: the last step's impulses, shared out to the small steps.
      out.points.push_back(make_point(task, c, point));
      out.points.back().push *= part;
      out.points.back().slide *= part;
    }
    patch.end = static_cast<std::uint32_t>(out.points.size());
    out.patches.push_back(patch);
  }
}

// Before the first sweep of each small step: the bodies have already been given forces.
void apply_last(Patches& all, std::vector<SolverBody>& bodies) {
  for (Patch& patch : all.patches) {
    SolverBody &a = bodies[patch.a], &b = bodies[patch.b];
    for (std::uint32_t i = patch.begin; i < patch.end; ++i) {
      const Point& point = all.points[i];
      if (point.push > 0) push(point, a, b, patch.normal * point.push + point.slide);
    }
  }
}

/// Backwards: blocks are mostly listed from the ground up, and loads pass downwards. (In
/// turn with forwards, one sweep of each, columns shake themselves to pieces.)
double sweep(Patches& all, std::vector<SolverBody>& bodies, double inverse_dt) {
  double change = 0;
  for (std::size_t k = all.patches.size(); k-- > 0;) {
    const Patch& patch = all.patches[k];
    SolverBody &a = bodies[patch.a], &b = bodies[patch.b];
    for (std::uint32_t i = patch.begin; i < patch.end; ++i) {
      change = std::max(change, relax(patch, all.points[i], a, b, inverse_dt));
    }
  }
  return change;
}

void follow_gaps(Patches& all, const std::vector<SolverBody>& bodies, double dt) {
  for (const Patch& patch : all.patches) {
    const SolverBody &a = bodies[patch.a], &b = bodies[patch.b];
    for (std::uint32_t i = patch.begin; i < patch.end; ++i) {
      all.points[i].gap += dot(patch.normal, velocity(all.points[i], a, b)) * dt;
    }
  }
}

/// Overlaps are undone by a shift that leaves velocities alone: as a part of them it feeds
/// the swaying of high columns, which then fall. `way` holds the shift alone here.
void undo_overlaps(Patches& all, Rows& rows, SolverTask& task) {
  const auto deep = [](const Point& point) { return point.shift_target > 0; };
  if (std::none_of(all.points.begin(), all.points.end(), deep) && !overlapping(rows)) return;
  for (int i = 0; i < kShiftSweeps; ++i) {
    shift_rows(rows);
    for (const Patch& patch : all.patches) {
      SolverBody &a = task.bodies[patch.a], &b = task.bodies[patch.b];
      for (std::uint32_t k = patch.begin; k < patch.end; ++k) {
        relax_shift(patch, all.points[k], a, b);
      }
    }
  }
}

/// Adds a part of what the step's forces change. Links are moved by their mechanism's generalised
/// velocities, not by themselves.
void kick(SolverTask& task, double part) {
  for (SolverBody& body : task.bodies) {
    if (body.link >= 0) continue;
    body.v += body.kick_v * part;
    body.w += body.kick_w * part;
  }
  for (SolverMechanism& mechanism : task.mechanisms) {
    for (std::size_t i = 0; i < mechanism.dofs; ++i) mechanism.v[i] += mechanism.kick[i] * part;
  }
}

/// Adds the way of a small step, in units of a whole one: poses are moved once, at the end.
void go(SolverTask& task, double part) {
  for (SolverBody& body : task.bodies) {
    if (body.link >= 0) continue;
    body.way_v += body.v * part;
    body.way_w += body.w * part;
  }
  for (SolverMechanism& mechanism : task.mechanisms) {
    for (std::size_t i = 0; i < mechanism.dofs; ++i) mechanism.way[i] += mechanism.v[i] * part;
  }
}

// In whole steps' impulses, as others read them: magnets that snap, the next step's start.
void keep_impulses(const Patches& all, SolverTask& task, double parts) {
  for (const Patch& patch : all.patches) {
    for (std::uint32_t i = patch.begin; i < patch.end; ++i) {
      ContactPoint& point = task.contacts[patch.contact].points[i - patch.begin];
      point.push = all.points[i].push * parts;
      point.friction = all.points[i].slide * parts;
    }
  }
}

}  // namespace

void warm_start(Contact& contact, const Contact& last) {
  assert(contact.count <= 4 && last.count <= 4);
  contact.touching = last.touching;
  // Turned by more than 18°: the old impulses would push elsewhere.
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

void solve(SolverTask& task) {
  assert(task.dt > 0 && task.small_steps > 0);
  assert(task.slots.size() == task.contacts.size());
  // Substepping: `parts` small steps of dt each.
  const double parts = task.small_steps, dt = task.dt / parts;
  // Kept from step to step for their memory alone: to take it anew costs more than to fill it.
  thread_local Patches patches;
  thread_local Rows rows;
  thread_local GraspRows grasps;
  make_patches(task, 1 / parts, patches);
  make_rows(task, rows);
  make_grasp_rows(task, grasps);
  // Before anything else, so that the shift knows no velocities.
  undo_overlaps(patches, rows, task);
  for (int step = 0; step < task.small_steps; ++step) {
    kick(task, 1 / parts);
    apply_last(patches, task.bodies);
    apply_last_rows(rows, task);
    apply_last_grasps(grasps);
    // Another sweep as long as something changes and the count allows; impacts get a few more.
    double change = 1;
    for (int i = 0; change > kSettled; ++i) {
      if (i >= task.sweeps + (change > kImpact ? kMoreSweeps : 0)) break;
      change = relax_grasps(grasps);
      change = std::max(change, sweep_rows(rows, task, 1 / dt));
      change = std::max(change, sweep(patches, task.bodies, 1 / dt));
    }
    add_up_grasps(grasps);
    go(task, 1 / parts);
    follow_gaps(patches, task.bodies, dt);
    follow_row_gaps(rows, task, dt);
  }
  keep_impulses(patches, task, parts);
  keep_row_impulses(rows, task);
  keep_grasp_impulses(grasps, task);
}

}  // namespace stig::physics
