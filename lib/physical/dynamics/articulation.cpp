// SPDX-License-Identifier: MIT
// Kinematics (poses, and the velocity of each part for each degree of freedom: `columns`) are
// DART's; the dynamics are written out here, so that nothing of the result depends on how DART adds
// up. Names: `motion` is a part's twist about its own origin, `change` how that twist changes while
// generalised velocities stay (the convective acceleration), `momentum` is about the world's
// origin. With n degrees of freedom a step costs n³ for the inverse, which for robots of a dozen is
// nothing.
#include "physical/dynamics/articulation.h"

#include <algorithm>
#include <cassert>

#include "physical/dynamics/world_state.h"
#include "physical/solver/small_matrix.h"

namespace stig::physics {

namespace {

/// The part's inertia in the world's axes, about its centre of mass.
Mat3 turned(const Mat3& r, const Mat3& inertia) {
  const auto column = [&](const Vec3& e) { return r * (inertia * r.transposed(e)); };
  return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

PartWeight weight_of(const Articulation& it, std::size_t part) {
  const Mat3 r = matrix(it.poses[part].q);
  return {it.parts[part].mass, r * it.parts[part].centre, turned(r, it.parts[part].inertia)};
}

/// Adds a part's share of the mass matrix's lower half: m v·v + w·I w over its columns.
void add_mass(const Articulation& it, std::size_t part, std::vector<double>& out) {
  const PartWeight& weight = it.weights[part];
  const Twist* columns = it.columns_of(part);
  const std::size_t n = it.size();
  for (const std::uint32_t i : it.chains[part]) {
    // A column is a part's twist for a velocity of 1: velocity of its origin, and spin.
    const Vec3 p = (columns[i].v + cross(columns[i].w, weight.centre)) * weight.mass;
    // Momentum and angular momentum about the part's origin.
    const Vec3 l = weight.inertia * columns[i].w + cross(weight.centre, p);
    for (const std::uint32_t k : it.chains[part]) {
      // Chains rise, so the lower half is complete at k = i; invert_positive mirrors it.
      if (k > i) break;
      out[i * n + k] += dot(p, columns[k].v) + dot(l, columns[k].w);
    }
  }
}

Twist motion_of(const Articulation& it, std::size_t part) {
  Twist sum;
  const Twist* columns = it.columns_of(part);
  for (const std::uint32_t i : it.chains[part]) {
    sum.v += columns[i].v * it.v[i];
    sum.w += columns[i].w * it.v[i];
  }
  return sum;
}

Momentum momentum_of(const Articulation& it) {
  Momentum sum;
  for (std::size_t part = 0; part < it.parts.size(); ++part) {
    const PartWeight& weight = it.weights[part];
    const Twist& motion = it.motions[part];
    const Vec3 p = (motion.v + cross(motion.w, weight.centre)) * weight.mass;
    sum.linear += p;
    // Angular momentum about the world's origin: that of the centre of mass, and the part's own.
    sum.angular += weight.inertia * motion.w + cross(it.poses[part].p + weight.centre, p);
  }
  return sum;
}

/// The outer forces of the bodies as generalised ones, and their sum.
Momentum gather(const Articulation& it, const std::vector<Body>& bodies, std::vector<double>& out) {
  Momentum sum;
  for (const LinkBody& link : it.links) {
    const Body& body = bodies[link.body];
    // The outer force acts at the body's centre of mass; moved to the part's origin it brings a
    // torque.
    const Vec3 torque = body.torque + cross(body.p - it.poses[link.part].p, body.force);
    const Twist* columns = it.columns_of(link.part);
    for (const std::uint32_t i : it.chains[link.part]) {
      out[i] += dot(body.force, columns[i].v) + dot(torque, columns[i].w);
    }
    sum.linear += body.force;
    sum.angular += body.torque + cross(body.p, body.force);
  }
  return sum;
}

/// How columns that move with a body change: of s, which moves with m. It is the time derivative of
/// a twist that is carried along, Featherstone's cross product of motion vectors (Rigid Body
/// Dynamics Algorithms, section 2.9).
Twist carried(const Twist& m, const Twist& s) {
  return {cross(m.w, s.v) + cross(m.v, s.w), cross(m.w, s.w)};
}

/// Adds a part's share of the Coriolis and centrifugal forces: what its mass and inertia make of
/// the acceleration that it has while generalised velocities stay the same.
void add_coriolis(const Articulation& it, std::size_t part, const std::vector<double>& v,
                  std::vector<double>& out) {
  const auto [motion, change] = part_motion(it, part, v);
  const PartWeight& weight = it.weights[part];
  const Vec3 a =
      change.v + cross(change.w, weight.centre) + cross(motion.w, cross(motion.w, weight.centre));
  const Vec3 force = a * weight.mass;
  const Vec3 torque = weight.inertia * change.w + cross(motion.w, weight.inertia * motion.w) +
                      cross(weight.centre, force);
  const Twist* columns = it.columns_of(part);
  for (const std::uint32_t i : it.chains[part]) {
    out[i] += dot(force, columns[i].v) + dot(torque, columns[i].w);
  }
}

/// dt M⁻¹ (force - c(v)); `left` is of use to nobody else. Called twice a step, with velocities at
/// its beginning and at its middle.
void respond(const Articulation& it, const std::vector<double>& force, const std::vector<double>& v,
             double dt, std::vector<double>& left, std::vector<double>& out) {
  const std::size_t n = it.size();
  left.assign(n, 0);
  for (std::size_t part = 0; part < it.parts.size(); ++part) add_coriolis(it, part, v, left);
  for (std::size_t i = 0; i < n; ++i) left[i] = (force[i] - left[i]) * dt;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += it.inverse[i * n + k] * left[k];
    out[i] = sum;
  }
}

/// Changes the velocity of the floating first part so that the momentum is as given.
void put_right(Articulation& it, const Momentum& wanted) {
  // Integration errors of the coupling between joints and base would make a falling robot drift:
  // what its momentum must be is known exactly, so the six velocities of the base are solved for.
  const Momentum now = momentum_of(it);
  const Vec3 linear = wanted.linear - now.linear, angular = wanted.angular - now.angular;
  std::vector<double> matrix(36),
      change{linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
  for (std::size_t part = 0; part < it.parts.size(); ++part) {
    const PartWeight& weight = it.weights[part];
    const Twist* columns = it.columns_of(part);
    for (std::size_t k = 0; k < 6; ++k) {
      const Vec3 p = (columns[k].v + cross(columns[k].w, weight.centre)) * weight.mass;
      const Vec3 l = weight.inertia * columns[k].w + cross(it.poses[part].p + weight.centre, p);
      const double rows[6] = {p.x, p.y, p.z, l.x, l.y, l.z};
      for (std::size_t i = 0; i < 6; ++i) matrix[i * 6 + k] += rows[i];
    }
  }
  solve_linear(matrix, change);
  for (std::size_t i = 0; i < 6; ++i) it.v[i] += change[i];
  note_motions(it);
}

double motor_target(const Articulation& it, std::size_t i, double dt) {
  constexpr double kPart = 0.2;  ///< of a position's error, gone in a step
  const DofDef& dof = it.dofs[i];
  if (dof.actuator == Actuator::velocity) return it.axes[i].target;
  // A position motor is a velocity motor whose target leads there: it slows as it comes near, and
  // is never stiffer than a step can bear. No error is taken away faster than the axis may move.
  const double goal = std::clamp(it.axes[i].target, dof.lower, dof.upper);
  return std::clamp((goal - it.q[i]) * kPart / dt, -dof.speed, dof.speed);
}

bool has_motor(const DofDef& dof) {
  return dof.actuator == Actuator::velocity || dof.actuator == Actuator::position;
}

}  // namespace

// The columns of a floating first part turn with it, and so add nothing but that its velocity
// turns; every other stands still in the body that its joint begins at.
PartMotion part_motion(const Articulation& it, std::size_t part, const std::vector<double>& v) {
  const Twist* columns = it.columns_of(part);
  const std::size_t free = it.floating ? 6 : 0;
  PartMotion out;
  for (const std::uint32_t i : it.chains[part]) {
    const Twist own{columns[i].v * v[i], columns[i].w * v[i]};
    if (i >= free) {
      const Twist more = carried(out.motion, own);
      out.change.v += more.v;
      out.change.w += more.w;
    }
    out.motion.v += own.v;
    out.motion.w += own.w;
  }
  out.change.v += cross(out.motion.w, out.motion.v);
  return out;
}

void place_bodies(const Articulation& it, std::vector<Body>& bodies) {
  for (const LinkBody& link : it.links) {
    Body& body = bodies[link.body];
    const Pose X_WB = it.poses[link.part] * link.X_PB;
    body.p = X_WB.p;
    // Orientations are normalised again in each step, so that rounding does not add up.
    body.q = normalised(X_WB.q);
    body.r = matrix(body.q);
  }
  set_body_velocities(it, bodies);
}

void set_body_velocities(const Articulation& it, std::vector<Body>& bodies) {
  for (const LinkBody& link : it.links) {
    Body& body = bodies[link.body];
    const Twist& motion = it.motions[link.part];
    body.w = motion.w;
    body.v = motion.v + cross(motion.w, body.p - it.poses[link.part].p);
  }
}

void note_motions(Articulation& it) {
  it.motions.resize(it.parts.size());
  for (std::size_t part = 0; part < it.parts.size(); ++part) it.motions[part] = motion_of(it, part);
}

void refresh(Articulation& it) {
  // All of the kinematics is asked for once, here; everything else reads what this leaves.
  it.mechanism->set_positions(it.q.data());
  it.columns.resize(it.parts.size() * it.size());
  it.poses.resize(it.parts.size());
  it.weights.resize(it.parts.size());
  for (std::size_t part = 0; part < it.parts.size(); ++part) {
    it.poses[part] = it.mechanism->pose(part);
    it.mechanism->columns(part, &it.columns[part * it.size()]);
    it.weights[part] = weight_of(it, part);
  }
  note_motions(it);
}

void kick(Articulation& it, const std::vector<Body>& bodies, double dt) {
  assert(dt > 0);
  const std::size_t n = it.size();
  it.inverse.assign(n * n, 0);
  for (std::size_t part = 0; part < it.parts.size(); ++part) add_mass(it, part, it.inverse);
  std::vector<double> force(n), middle = it.v, scratch;
  const Momentum outer = gather(it, bodies, force);
  for (std::size_t i = 0; i < n; ++i) {
    const DofDef& dof = it.dofs[i];
    // Viscous friction is implicit: D dt is added to the mass matrix, so that no friction can make
    // the step unstable.
    it.inverse[i * n + i] += dof.damping * dt;
    force[i] -= dof.damping * it.v[i];
    // Motors of velocity and position are rows of the solver; a force is a force.
    if (dof.actuator == Actuator::force) {
      force[i] += std::clamp(it.axes[i].target, -dof.effort, dof.effort);
    }
  }
  invert_positive(it.inverse, n);
  it.momentum = momentum_of(it);
  it.momentum.linear += outer.linear * dt;
  it.momentum.angular += outer.angular * dt;
  it.kick.resize(n);
  respond(it, force, it.v, dt, scratch, it.kick);
  // The explicit midpoint method in the velocities: the response is that at their middle.
  for (std::size_t i = 0; i < n; ++i) middle[i] += it.kick[i] / 2;
  respond(it, force, middle, dt, scratch, it.kick);
  for (std::size_t i = 0; i < n; ++i) it.v[i] += it.kick[i];
  note_motions(it);
  it.held = false;
  if (it.floating) it.kicked = momentum_of(it);
}

void move(Articulation& it, double dt) {
  assert(dt > 0);
  if (it.floating && it.held) {
    // Impulses of contacts and motors are known as the difference that they made.
    const Momentum now = momentum_of(it);
    it.momentum.linear += now.linear - it.kicked.linear;
    it.momentum.angular += now.angular - it.kicked.angular;
  }
  if (!it.held) it.way = it.v;
  // Positions go with the mean of the velocities in free flight: falling is exact.
  if (!it.held && it.floating) {
    for (std::size_t i = 0; i < it.size(); ++i) it.way[i] -= it.kick[i] / 2;
  }
  it.mechanism->integrate(it.q.data(), it.way.data(), dt);
  refresh(it);
  if (it.floating) put_right(it, it.momentum);
}

void add_axes(const Articulation& it, std::uint32_t number, double dt,
              std::vector<SolverAxis>& out) {
  for (std::size_t i = 0; i < it.size(); ++i) {
    const DofDef& dof = it.dofs[i];
    SolverAxis axis;
    axis.mechanism = number;
    axis.dof = static_cast<std::uint32_t>(i);
    if (has_motor(dof)) {
      axis.target = motor_target(it, i, dt);
      axis.most = dof.effort * dt;
      axis.impulse = std::clamp(it.axes[i].motor, -axis.most, axis.most);
      out.push_back(axis);
    }
    for (const int side : {1, -1}) {
      const double gap = side > 0 ? it.q[i] - dof.lower : dof.upper - it.q[i];
      // A stop is a row of its own for each side, and only where there is one.
      if (!std::isfinite(gap)) continue;
      axis.side = side;
      axis.gap = gap;
      // An impulse of the wrong sign was the other stop's.
      axis.impulse = side > 0 ? std::max(0.0, it.axes[i].stop) : std::min(0.0, it.axes[i].stop);
      out.push_back(axis);
    }
  }
}

std::size_t keep_axes(Articulation& it, const std::vector<SolverAxis>& axes, std::size_t at) {
  assert(at <= axes.size());
  // In the order of add_axes, which this must follow step for step.
  for (std::size_t i = 0; i < it.size(); ++i) {
    AxisState& state = it.axes[i];
    state.stop = 0;
    if (has_motor(it.dofs[i])) state.motor = axes[at++].impulse;
    if (std::isfinite(it.dofs[i].lower)) state.stop += axes[at++].impulse;
    if (std::isfinite(it.dofs[i].upper)) state.stop += axes[at++].impulse;
  }
  return at;
}

double motor_force(const Articulation& it, std::size_t i, double dt) {
  const DofDef& dof = it.dofs[i];
  if (has_motor(dof)) return it.axes[i].motor / dt;
  return dof.actuator == Actuator::force ? std::clamp(it.axes[i].target, -dof.effort, dof.effort)
                                         : 0;
}

// Asleep although driven, a mechanism would never go: so it is kept awake.
bool driven(const Articulation& it) {
  constexpr double kThere = 1e-4;  ///< m or rad: a position reached
  for (std::size_t i = 0; i < it.size(); ++i) {
    const DofDef& dof = it.dofs[i];
    const double target = it.axes[i].target;
    if (dof.actuator == Actuator::none) continue;
    if (dof.actuator != Actuator::position && target != 0) return true;
    if (dof.actuator == Actuator::position &&
        std::abs(std::clamp(target, dof.lower, dof.upper) - it.q[i]) > kThere) {
      return true;
    }
  }
  return false;
}

}  // namespace stig::physics
