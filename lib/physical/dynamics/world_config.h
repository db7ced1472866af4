// SPDX-License-Identifier: MIT
// What a World is made from: plain data, checked by one function.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"
#include "physical/collision/contact.h"
#include "physical/dynamics/joint.h"
#include "physical/dynamics/uses.h"
#include "physical/magnets/magnetism.h"
#include "robots/block.h"

namespace stig::physics {

/// Number of a kind of surface; pairs of them have a friction coefficient.
using Material = std::uint8_t;
inline constexpr Material kBlockMaterial = 0, kFloorMaterial = 1;

inline constexpr std::size_t kMostBodies = 20'000;  ///< of a world
inline constexpr double kMostSizeRatio = 200;       ///< of its largest body to its smallest

/// A permanent magnet; with `active`, an electromagnet, and with both, a semi-permanent one:
/// its moment is moment + current · active.
struct MagnetDef {
  Vec3 p_B;                 ///< place in the body's frame
  double moment = 0.2;      ///< A·m², without current
  bool free = true;         ///< turns towards the field; otherwise fixed in the body
  Vec3 direction{0, 0, 1};  ///< unit, body frame; of a free one: at the start
  double active = 0;        ///< A·m² for a current of 1, in the unit of World::set_current
  double inertia = 3.6e-9;  ///< kg m², of a free sphere about its centre
};

/// How free magnets turn, see magnetism.h.
enum class MagnetModel : std::uint8_t {
  quasi_static,
  integrated  ///< the reference: steps of at most 1 ms, better 0.2 ms
};

struct BodyDef {
  Shape shape;
  double mass = 1;      ///< kg
  Vec3 inertia;         ///< principal moments about the body's axes, kg·m²; all 0: solid
  Pose X_WB;            ///< of the centre of mass, which is the shape's centre
  Vec3 velocity, spin;  ///< m/s and rad/s, world frame
  Material material = kBlockMaterial;
  bool fixed = false;  ///< moved by nothing but its own velocity
  /// The axle of a wheel: unit, body frame; along it the wheel grips less. Zero: no wheel.
  Vec3 axle;
  double axle_friction = 0.3;  ///< times the friction elsewhere, along the axle
  std::vector<MagnetDef> magnets;
};

/// A solid at rest.
BodyDef solid_body(const Shape& shape, double mass, const Vec3& place = {});
/// A solid hull of points that enclose something, in their frame P: about its centre of mass
/// and along its principal axes, so that it moves exactly.
BodyDef hull_body(const std::vector<Vec3>& points, double mass, const Pose& X_WP);
/// The block of a data file as a body.
BodyDef block_body(const BlockModel& block, const Pose& X_WB);
/// A solid's moments when the definition leaves them open.
Vec3 inertia_of(const BodyDef& def);

struct FrictionPair {
  Material a = 0, b = 0;
  double coefficient = 0.5;
};

struct SleepRules {
  bool enabled = true;
  double time = 0.25;          ///< s, that a whole island must be at rest
  double speed = 0.002;        ///< m/s, below which a body is
  double spin = 0.05;          ///< rad/s
  double waking_speed = 0.01;  ///< m/s, of a body that touches a sleeper and wakes it
  double waking_spin = 0.3;    ///< rad/s
  double waking_force = 0.15;  ///< N, of the magnets of a body that moves
};

/// When bodies count as snapped together: they touch, and their magnets press them upon
/// each other with this force or more. They have let go when they part, or are pressed with
/// less than half of it.
struct SnapRule {
  double force = 1;  ///< N; a block weighs 1.08 N, a face of its magnets holds 9.5 N
};

/// What turns forces into motion: this library's solver, or DART's
/// (physical/dynamics/stock_step.h).
enum class SolverKind : std::uint8_t { fast, stock };

struct WorldConfig {
  double step = 0.005;  ///< s
  SolverKind solver = SolverKind::fast;
  double gravity = 9.8;
  bool floor = true;      ///< z = 0, of kFloorMaterial
  double arena = 100;     ///< m: bodies farther from the origin along x, y or z have left
  double friction = 0.5;  ///< of pairs that are not listed
  std::vector<FrictionPair> frictions;
  double damping = 0;          ///< 1/s: free motion decays as exp(-damping · t)
  double angular_damping = 0;  ///< 1/s, likewise of spins
  double magnet_cutoff = 0.04;
  double magnet_contact = 0.006;  ///< m: magnets nearer than this pull as at this distance
  MagnetModel magnets = MagnetModel::quasi_static;
  Relaxation relaxation;       ///< of the quasi-static ones
  double bearing_damping = 0;  ///< N·m·s, of the integrated ones, see Bearing
  SnapRule snap;
  int small_steps = 16;  ///< of the contact solver, in each step
  int sweeps = 1;        ///< in each of those
  bool grasps = true;    ///< what a mechanism holds is one joint, see grasp.h
  SleepRules sleep;
  std::vector<BodyDef> bodies;
  std::vector<JointDef> joints;
};

/// What makes a configuration unusable: `what` is said of the bodies, "overlap" or "has no
/// extent", or is a sentence about the settings when there are none.
struct ConfigProblem {
  std::vector<std::uint32_t> bodies;  ///< at most two
  std::string what;
};
/// Empty: nothing is wrong. Spawns may overlap by at most 1 mm.
std::vector<ConfigProblem> find_problems(const WorldConfig& config);
/// The same but for bodies that overlap, each other or the floor.
std::vector<ConfigProblem> find_problems_apart(const WorldConfig& config);
/// Whether two bodies, where they are defined to be, overlap by more than spawns may.
bool spawns_overlap(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);
/// Whether a body would be as far in the floor.
bool spawns_in_floor(const Shape& shape, const Pose& X_WB);
bool inside_arena(const Vec3& p, double arena);
/// What find_problems says, each a sentence that names the bodies by their numbers.
std::vector<std::string> problems_of(const WorldConfig& config);

}  // namespace stig::physics
