// SPDX-License-Identifier: MIT
// A deterministic world of free rigid bodies with magnets.
//
//     WorldConfig config;
//     config.bodies.push_back(block_body(block, {{0, 0, 0.0275}, {}}));
//     if (!problems_of(config).empty()) …       // say so
//     World world(config);
//     while (world.time() < 1 && world.step().ok) …  // read world.state(id), world.events()
//
// A step: forces (gravity, magnets, the user's) → velocities → contacts → who wakes →
// solver → positions → who sleeps. Same configuration and calls, same bytes: nothing
// depends on threads, addresses or time. Different worlds may step in different threads.
//
// Mechanisms (physical/dynamics/joint.h) need DART: problems_of says so where it is missing.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "physical/dynamics/uses.h"
#include "physical/dynamics/world_config.h"

namespace stig::physics {

/// The body's place in WorldConfig::bodies.
enum class BodyId : std::uint32_t {};
/// The other body of a contact with the floor.
inline constexpr BodyId kFloorId{0xffffffff};

struct BodyState {
  Pose X_WB;
  Vec3 velocity, spin;
  bool awake = true;
  bool left = false;  ///< the arena; no longer simulated
};

/// The joint's place in WorldConfig::joints.
enum class JointId : std::uint32_t {};

struct DofState {
  double position = 0;  ///< m or rad; turns are not wrapped
  double velocity = 0;
  double force = 0;  ///< that the actuator applied in the last step, N or N·m
};

/// Snaps and their ends: see SnapRule.
enum class EventKind : std::uint8_t { contact_began, slept, woke, left_arena, snapped, let_go };

struct WorldEvent {
  EventKind kind = EventKind::contact_began;
  BodyId body{};
  BodyId other = kFloorId;  ///< of a contact or a snap; otherwise without meaning

  friend bool operator==(const WorldEvent&, const WorldEvent&) = default;
};

/// Not ok: forces or speeds grew beyond measure; `body` is the first such. All poses are
/// still those before the step, but the world cannot go on.
struct StepResult {
  bool ok = true;
  BodyId body{};
};

/// What one body does to another where they touch.
struct ContactForce {
  BodyId a{}, b = kFloorId;
  Vec3 force;  ///< on a, N, mean of a step; friction included. On b acts the opposite
  Vec3 p_W;    ///< m: middle of the points, weighed by how hard they push
};

/// Bodies that come into a world that runs, with the joints among them: numbers in `joints`
/// are places in `bodies`.
struct Addition {
  std::vector<BodyDef> bodies;
  std::vector<JointDef> joints;
};

/// Where they went: the first of them, the others follow. With a problem: nowhere.
struct AddResult {
  std::string problem;  ///< a sentence, bodies and joints by their places in the addition
  BodyId body{};
  JointId joint{};
  bool overlaps = false;  ///< that is the problem
  BodyId other{};         ///< with which body of the world
};

/// With a problem, the world is as before. Where it is an overlap: of which bodies.
struct PlaceResult {
  std::string problem;  ///< a sentence about what was to be placed
  bool overlaps = false;
  BodyId body{}, other{};
};

struct WorldState;
class World;

/// Takes up what a force function adds.
class Forces {
 public:
  explicit Forces(WorldState& world) : world_(world) {}
  /// Acts on the body during this step, the force at its centre of mass; adds to what others
  /// do. Without effect on bodies that are fixed, asleep or have left.
  void add(BodyId id, const Vec3& force, const Vec3& torque);
  /// The force at a place of the world.
  void add_at(BodyId id, const Vec3& force, const Vec3& p_W);

 private:
  WorldState& world_;
};

/// Reads the world as it was at the beginning of the step and adds forces. For runs that can be
/// repeated it must depend on nothing else.
using ForceFunction = std::function<void(const World& world, Forces& forces)>;

class World {
 public:
  /// Asserts that problems_of(config) is empty.
  explicit World(const WorldConfig& config);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  StepResult step();

  std::uint64_t tick() const;
  double time() const;  ///< s
  std::size_t size() const;
  std::size_t awake_count() const;
  /// Bodies that a mechanism holds by one joint now (grasp.h).
  std::size_t grasp_count() const;
  BodyState state(BodyId id) const;
  /// Direction of a body's magnet, world frame.
  Vec3 magnet_direction(BodyId id, std::size_t magnet) const;
  /// The events of the last step, in a fixed order: wakings, contacts by body, snaps by
  /// body, sleepers, leavers.
  const std::vector<WorldEvent>& events() const;
  /// Contacts that push, sorted by bodies: those of the last step, and those among sleepers as they
  /// were when they fell asleep. With SolverKind::stock, which keeps none: nothing.
  std::vector<ContactForce> contact_forces() const;
  /// What magnets do to each body as all stand now, N, by number: costs a good part of a step.
  std::vector<Vec3> magnet_forces() const;
  /// Kinetic (with that of integrated spheres), of gravity and of magnets, J. For tests and
  /// measures: costs a step.
  double energy() const;

  /// Refused, with the world as before, where the definitions are no bodies, or overlap others
  /// by more than 1 mm. Checkpoints from now on hold the definitions too.
  AddResult add(const Addition& addition);

  /// Puts a body elsewhere, as a hand would: with the whole mechanism, when it is a link of one,
  /// which turns and moves as one piece. It is at rest there; motors keep their targets. Wakes
  /// what it touched and touches, and whose magnets it pulled or pulls at. Refused where it would
  /// overlap something by more than 1 mm, or be in the floor or outside of the arena.
  PlaceResult place(BodyId id, const Pose& X_WB);

  /// Called in each step from now on in which something is awake, after gravity, damping and
  /// magnets, in the order in which they were added. No part of checkpoints: a world that
  /// resumes one must have been given the same functions.
  void add_force(ForceFunction function);
  /// Acts during the next step alone, at the centre of mass; wakes the body.
  void push(BodyId id, const Vec3& force, const Vec3& torque);
  /// What touches the body rubs it with so many times the friction of their materials from now on;
  /// finite, not negative, 1 at the start. A change wakes the body and what it touches.
  void set_grip(BodyId id, double factor);
  double grip(BodyId id) const;
  /// Not of a link. Of a fixed body: it moves so from now on, whatever is in its way. Wakes the
  /// body.
  void set_velocity(BodyId id, const Vec3& velocity, const Vec3& spin);

  /// Positions, velocities and motors of a joint's degrees of freedom.
  std::vector<DofState> joint(JointId id) const;
  /// What the actuator shall do from now on: m/s or rad/s, m or rad, N or N·m, as its kind
  /// says; finite. A change wakes the mechanism.
  void drive(JointId id, std::size_t dof, double target);
  /// Sets an electromagnet's current from now on; finite, 0 at the start. Wakes the body and those
  /// with magnets within the cut-off.
  void set_current(BodyId id, std::size_t magnet, double current);
  double current(BodyId id, std::size_t magnet) const;

  /// All that a step depends on besides the configuration, in this machine's byte order.
  std::string checkpoint() const;
  /// False, and nothing changed, when the bytes are no checkpoint of this configuration.
  bool resume(std::string_view checkpoint);
  /// The hash of the checkpoint's bytes.
  std::uint64_t hash() const;

 private:
  void add_user_forces();

  std::unique_ptr<WorldState> state_;
  std::vector<ForceFunction> functions_;
};

}  // namespace stig::physics
