// SPDX-License-Identifier: MIT
// What a World is inside, for the files that make its step: world.cpp, world_forces.cpp,
// world_magnets.cpp, world_snaps.cpp, world_contacts.cpp, world_grasps.cpp, world_solve.cpp,
// world_sleep.cpp, checkpoint.cpp and stock_dart.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physical/collision/broad_phase.h"
#include "physical/dynamics/articulation.h"
#include "physical/dynamics/grasp.h"
#include "physical/dynamics/stock_step.h"
#include "physical/dynamics/uses.h"
#include "physical/dynamics/world.h"
#include "physical/solver/solver.h"

namespace stig::physics {

struct Body {
  Shape shape;
  Vec3 inertia;
  double mass = 0;
  bool round = false;  ///< equal moments about all axes
  bool fixed = false;
  Material material = 0;
  double grip = 1;  ///< times the friction of its material

  Vec3 p;
  Quat q;
  Mat3 r;  ///< of q
  Vec3 v, w;
  Vec3 last_v, last_w;           ///< before this step's forces
  Vec3 kick_v, kick_w;           ///< what the forces of this step add
  Vec3 way_v, way_w;             ///< of a body in contact: the step's way by its length
  Vec3 force, torque;            ///< of this step
  Vec3 user_force, user_torque;  ///< for the next
  bool awake = true;             ///< of fixed ones: whether they move
  bool left = false;
  bool free = false;               ///< without contact in this step
  double rest = 0;                 ///< s, for which it has stayed where it is
  Pose rest_X_WB;                  ///< where that is
  std::int32_t articulation = -1;  ///< that it is a link of
  std::uint32_t part = 0;          ///< of that

  Mat3 inverse_inertia() const {
    return rotated_diagonal(r, {1 / inertia.x, 1 / inertia.y, 1 / inertia.z});
  }
};

/// Two bodies a < b, by number.
using BodyPair = std::pair<std::uint32_t, std::uint32_t>;

/// What the magnets of one body do to another.
struct Pull {
  BodyPair bodies;
  Vec3 force;  ///< on the first, N
};

struct WorldState {
  WorldConfig config;            ///< with what was added since
  std::size_t first_bodies = 0;  ///< of the configuration that the world was made from
  std::size_t first_joints = 0;
  std::uint64_t tick = 0;
  std::vector<Body> bodies;
  std::vector<Magnet> magnets;
  std::vector<Vec3> magnet_places;  ///< in their bodies' frames
  std::vector<double> currents;     ///< one a magnet
  std::vector<MagnetOwner> owners;  ///< one a body
  double magnet_radius = 0;         ///< largest distance of a magnet from its body's centre
  Articulations articulations;
  std::vector<Contact> contacts;       ///< sorted by (a, b), the floor last
  std::vector<Grasp> grasps;           ///< sorted by their bodies
  std::vector<std::int32_t> grasp_of;  ///< place in `grasps`, of each body; -1: none
  std::vector<Steady> steady;          ///< sorted by their bodies
  /// Buffers of the search for contacts, kept for their memory alone: contacts are many and large.
  std::vector<Contact> found, merged;
  std::vector<Pull> pulls;      ///< of this step, sorted by (a, b)
  std::vector<BodyPair> snaps;  ///< bodies snapped together, sorted
  std::vector<WorldEvent> events;
  std::vector<WorldEvent> early;  ///< since the last step, from calls of the user
  double cell = 0.1;
  std::shared_ptr<StockStep> stock;  ///< made when it is needed, keeps nothing between steps

  // Made anew when someone wakes or sleeps.
  bool changed = true;
  std::vector<std::uint32_t> awake, resting;
  std::vector<Bounds> bounds;  ///< of each body
  /// Each body's shape where it is. Kept, since to copy a shape is to count its owners.
  std::vector<Placed> placed;
  /// Bounds of each thing of the grid: a loose body, or a mechanism by its first link's number.
  std::vector<Bounds> thing_bounds;
  std::vector<CellEntry> resting_cells;
};

WorldState make_world_state(const WorldConfig& config);
/// Appends bodies and joints whose numbers are already those of the world.
void append(WorldState& world, const std::vector<BodyDef>& bodies,
            const std::vector<JointDef>& joints);
BodyState state_of(const WorldState& world, std::uint32_t body);

/// Its articulation, or null.
Articulation* articulation_of(WorldState& world, std::uint32_t body);
bool awake(const WorldState& world, const Articulation& articulation);

/// Lists of who is awake, when that changed.
void refresh_lists(WorldState& world);
/// The body and all sleepers joined to it by contacts; writes events.
void wake(WorldState& world, std::uint32_t body);

/// Gravity, magnets and the user's forces of the bodies awake; wakes those that a moving
/// magnet pulls at. A sleeper keeps the forces under which it fell asleep: should it wake in
/// the middle of a step, they are what it begins with.
void gather_forces(WorldState& world);
/// Turns the free magnets and adds what all of them do to bodies awake.
void add_magnet_forces(WorldState& world);
/// Those with magnets within the cut-off of the body's.
void wake_magnet_partners(WorldState& world, std::uint32_t body);
/// For a link: integrates its whole mechanism, when its first link is named.
void integrate_velocity(WorldState& world, std::uint32_t body);
/// Finds the contacts, keeps those among sleepers; wakes those that something fast touches.
void update_contacts(WorldState& world);
/// Whether the body is one, and awake.
bool takes_part(const WorldState& world, std::uint32_t body);
inline std::pair<std::uint32_t, std::uint32_t> key(const Contact& contact) {
  return {contact.a, contact.b};
}
void solve_world(WorldState& world);

/// Finds the grasp of each body: after the list was taken from elsewhere, or bodies were added.
void number_grasps(WorldState& world);
/// Whether one holds the other by a grasp, so that no point between them is to be solved.
bool within_grasp(const WorldState& world, std::uint32_t a, std::uint32_t b);
/// A contact within a grasp where the bodies are now; nothing where the two do not touch.
std::optional<Contact> grasped_contact(const WorldState& world, std::uint32_t a, std::uint32_t b);
/// Those of bodies that something else touches in this step.
void end_touched_grasps(WorldState& world);
/// Whether it has not been given up in this step.
bool holds(const WorldState& world, const Grasp& grasp);
/// Keeps the impulse that the solver found for a grasp, and gives its contacts the forces that bear
/// it. False: there are none, and the grasp is given up.
bool bears(WorldState& world, std::size_t grasp, const Twist& impulse);
/// Of what the body is, or its mechanism holds.
void end_grasps_of(WorldState& world, std::uint32_t body);
/// After the solver, before anything moves: ends those that were given up, begins others.
void follow_grasps(WorldState& world);
/// Puts what is held to its place in what holds it.
void place_grasped(WorldState& world);
void report_contacts(WorldState& world);
void report_snaps(WorldState& world);
void put_to_sleep(WorldState& world);

/// The energy of the fields and of integrated spheres that spin, J.
double magnet_energy(const WorldState& world);
/// See World.
std::vector<Vec3> magnet_forces(const WorldState& world);
double friction_of(const WorldConfig& config, Material a, Material b);

std::string write_checkpoint(const WorldState& world);
bool read_checkpoint(WorldState& world, std::string_view bytes);

}  // namespace stig::physics
