// SPDX-License-Identifier: MIT
// The step as a sequence, and what callers may ask and do in between. Everything that changes a
// world goes through a few functions that keep its lists valid: `changed` says that bodies woke,
// fell asleep, came or left, and lists of the awake and the resting are made again (refresh_lists).
// Wakings between steps wait in `early` for the next step's events.
#include "physical/dynamics/world.h"

#include <algorithm>
#include <cassert>

#include "base/hash.h"
#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

constexpr double kMostSpeed = 1e3;  ///< m/s, and rad/s times ten: beyond, it has diverged

Body make_body(const BodyDef& def) {
  Body body;
  body.shape = def.shape;
  body.inertia = inertia_of(def);
  body.mass = def.mass;
  body.round = body.inertia.x == body.inertia.y && body.inertia.y == body.inertia.z;
  body.fixed = def.fixed;
  body.material = def.material;
  body.p = def.X_WB.p;
  body.q = normalised(def.X_WB.q);
  body.r = matrix(body.q);
  body.v = def.velocity;
  body.w = def.spin;
  body.awake = !def.fixed || !(body.v == Vec3{}) || !(body.w == Vec3{});
  return body;
}

void add_magnets(WorldState& world, const BodyDef& def, std::uint32_t number) {
  const Body& body = world.bodies[number];
  MagnetOwner owner;
  owner.begin = static_cast<std::uint32_t>(world.magnets.size());
  owner.centre = body.p;
  for (const MagnetDef& magnet : def.magnets) {
    world.magnets.push_back({number, magnet.free, body.p + body.r * magnet.p_B,
                             body.r * magnet.direction, magnet.moment});
    world.magnet_places.push_back(magnet.p_B);
    world.currents.push_back(0);
    world.magnet_radius = std::max(world.magnet_radius, length(magnet.p_B));
  }
  owner.end = static_cast<std::uint32_t>(world.magnets.size());
  world.owners.push_back(owner);
}

/// Tells the bodies of an articulation that they are its links, and where they stand.
void number_links(WorldState& world, std::size_t number) {
  const Articulation& articulation = world.articulations.all[number];
  for (const LinkBody& link : articulation.links) {
    world.bodies[link.body].articulation = static_cast<std::int32_t>(number);
    world.bodies[link.body].part = static_cast<std::uint32_t>(link.part);
  }
  place_bodies(articulation, world.bodies);
}

/// Cells a little larger than most bodies: parts of mechanisms are small, and many.
double cell_size(const std::vector<BodyDef>& bodies) {
  if (bodies.empty()) return 1;
  std::vector<double> radii;
  for (const BodyDef& def : bodies) radii.push_back(def.shape.radius());
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() * 4 / 5);
  std::nth_element(radii.begin(), middle, radii.end());
  return 1.6 * *middle;
}

/// Free flight: the angular momentum stays as it is, to the last bit of rounding; the spin
/// at the middle of the step turns the body (second order).
void turn_freely(Body& body, double dt) {
  Vec3 spin = body.w;
  // Spin from the conserved momentum at the orientation of mid-step: energy stays bounded.
  if (!body.round) {
    const Vec3 momentum = body.r * scaled(body.inertia, body.r.transposed(body.w));
    const Vec3 inverse{1 / body.inertia.x, 1 / body.inertia.y, 1 / body.inertia.z};
    const auto spin_at = [&](const Quat& q) {
      const Mat3 r = matrix(q);
      return r * scaled(inverse, r.transposed(momentum));
    };
    spin = spin_at(rotation(body.w * (dt / 2)) * body.q);
    body.q = normalised(rotation(spin * dt) * body.q);
    body.w = spin_at(body.q);
  } else {
    body.q = normalised(rotation(spin * dt) * body.q);
  }
  body.r = matrix(body.q);
}

void move(const WorldState& world, Body& body) {
  const double dt = world.config.step;
  if (body.free || body.fixed) {
    // Between contacts force is constant over the step, and its parabola known.
    body.p += (body.v - (body.fixed ? Vec3{} : body.kick_v * 0.5)) * dt;
    turn_freely(body, dt);
    return;
  }
  const Vec3 momentum = body.r * scaled(body.inertia, body.r.transposed(body.w));
  body.p += body.way_v * dt;
  body.q = normalised(rotation(body.way_w * dt) * body.q);
  body.r = matrix(body.q);
  if (!body.round) body.w = body.inverse_inertia() * momentum;
}

/// The first body awake whose force or velocity is beyond measure; its number, or the size.
std::uint32_t diverged(const WorldState& world) {
  for (const std::uint32_t i : world.awake) {
    const Body& body = world.bodies[i];
    // Written so that NaN fails.
    const bool sound = squared(body.v) < kMostSpeed * kMostSpeed &&
                       squared(body.w) < 100 * kMostSpeed * kMostSpeed && is_finite(body.p) &&
                       is_finite(body.force) && is_finite(body.torque);
    if (!sound) return i;
  }
  return static_cast<std::uint32_t>(world.bodies.size());
}

void leave(WorldState& world, std::uint32_t i) {
  Body& body = world.bodies[i];
  end_grasps_of(world, i);
  body.left = true;
  body.awake = false;
  body.v = body.w = {};
  world.owners[i].end = world.owners[i].begin;
  world.changed = true;
  world.stock.reset();
  world.events.push_back({EventKind::left_arena, BodyId{i}, kFloorId});
}

/// Notes the bodies that left; all bodies of a mechanism leave when one does.
void note_leavers(WorldState& world) {
  const double most = world.config.arena;
  for (const std::uint32_t i : world.awake) {
    const Body& body = world.bodies[i];
    const double far = std::max({std::abs(body.p.x), std::abs(body.p.y), std::abs(body.p.z)});
    if (far <= most || body.left) continue;
    const Articulation* articulation = articulation_of(world, i);
    if (articulation == nullptr) {
      leave(world, i);
    } else {
      for (const LinkBody& link : articulation->links) leave(world, link.body);
    }
  }
}

/// Velocities of the step, with contacts. Stops before them when forces are beyond measure.
void update_velocities(WorldState& world) {
  const bool stock = world.config.solver == SolverKind::stock;
  for (const std::uint32_t i : world.awake) {
    if (!stock) integrate_velocity(world, i);
  }
  if (diverged(world) < world.bodies.size()) return;
  update_contacts(world);
  if (stock) {
    if (!world.stock) world.stock = std::make_shared<StockStep>(world);
    world.stock->solve(world);
  } else {
    solve_world(world);
    follow_grasps(world);
  }
}

void move_all(WorldState& world) {
  if (world.stock) {
    world.stock->move(world);
    return;
  }
  for (const std::uint32_t i : world.awake) {
    if (world.bodies[i].articulation < 0) move(world, world.bodies[i]);
  }
  for (Articulation& articulation : world.articulations.all) {
    if (!awake(world, articulation)) continue;
    move(articulation, world.config.step);
    place_bodies(articulation, world.bodies);
  }
  place_grasped(world);
}

void finish_step(WorldState& world) {
  move_all(world);
  report_contacts(world);
  report_snaps(world);
  if (!world.stock) put_to_sleep(world);
  for (const std::uint32_t i : world.awake) {
    world.bodies[i].user_force = world.bodies[i].user_torque = {};
  }
  note_leavers(world);
}

/// Wakes a body between steps; the next step reports it.
void wake_early(WorldState& world, BodyId id) {
  std::swap(world.events, world.early);
  wake(world, static_cast<std::uint32_t>(id));
  std::swap(world.events, world.early);
}

/// What a caller's number stands for; one that there is not is a bug of the caller.
template <class List>
auto& entry(List& list, std::size_t number) {
  assert(number < list.size());
  return list[number];
}
template <class List>
auto& entry(List& list, BodyId id) {
  return entry(list, static_cast<std::size_t>(id));
}

}  // namespace

WorldState make_world_state(const WorldConfig& config) {
  assert(problems_of(config).empty());
  WorldState world;
  world.config = config;
  world.config.bodies.clear();
  world.config.joints.clear();
  world.cell = cell_size(config.bodies);
  append(world, config.bodies, config.joints);
  world.first_bodies = config.bodies.size();
  world.first_joints = config.joints.size();
  return world;
}

void append(WorldState& world, const std::vector<BodyDef>& bodies,
            const std::vector<JointDef>& joints) {
  const std::size_t first_joint = world.config.joints.size();
  for (const BodyDef& def : bodies) {
    world.config.bodies.push_back(def);
    world.bodies.push_back(make_body(def));
    add_magnets(world, def, static_cast<std::uint32_t>(world.bodies.size() - 1));
  }
  world.config.joints.insert(world.config.joints.end(), joints.begin(), joints.end());
  std::size_t next = world.articulations.all.size();
  add_articulations(world.config, first_joint, world.articulations);
  while (next < world.articulations.all.size()) number_links(world, next++);
  number_grasps(world);
  world.changed = true;
  world.stock.reset();
}

Articulation* articulation_of(WorldState& world, std::uint32_t body) {
  const std::int32_t number = world.bodies[body].articulation;
  return number < 0 ? nullptr : &world.articulations.all[static_cast<std::size_t>(number)];
}

bool awake(const WorldState& world, const Articulation& articulation) {
  const Body& first = world.bodies[articulation.links[0].body];
  return first.awake && !first.left;
}

BodyState state_of(const WorldState& world, std::uint32_t number) {
  const Body& body = entry(world.bodies, number);
  return {{body.p, body.q}, body.v, body.w, body.awake, body.left};
}

World::World(const WorldConfig& config)
    : state_(std::make_unique<WorldState>(make_world_state(config))) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

StepResult World::step() {
  WorldState& world = *state_;
  world.events = std::move(world.early);
  world.early.clear();
  refresh_lists(world);
  if (!world.awake.empty()) {
    gather_forces(world);
    refresh_lists(world);
    add_user_forces();
    update_velocities(world);
    const std::uint32_t bad = diverged(world);
    // Bodies stand where they stood, but have the velocities of the step that failed: the caller
    // must not go on with this world.
    if (bad < world.bodies.size()) return {false, BodyId{bad}};
    finish_step(world);
  }
  ++world.tick;
  return {};
}

std::uint64_t World::tick() const { return state_->tick; }
double World::time() const { return static_cast<double>(state_->tick) * state_->config.step; }
std::size_t World::size() const { return state_->bodies.size(); }

std::size_t World::awake_count() const {
  return static_cast<std::size_t>(std::count_if(state_->bodies.begin(), state_->bodies.end(),
                                                [](const Body& body) { return body.awake; }));
}

std::size_t World::grasp_count() const { return state_->grasps.size(); }

BodyState World::state(BodyId id) const {
  return state_of(*state_, static_cast<std::uint32_t>(id));
}

Vec3 World::magnet_direction(BodyId id, std::size_t magnet) const {
  const MagnetOwner& owner = entry(state_->owners, id);
  assert(magnet < owner.end - owner.begin);
  return state_->magnets[owner.begin + magnet].direction;
}

const std::vector<WorldEvent>& World::events() const { return state_->events; }

double World::energy() const {
  double energy = magnet_energy(*state_);
  for (const Body& body : state_->bodies) {
    if (body.fixed || body.left) continue;
    const Vec3 spin = body.r.transposed(body.w);
    energy += body.mass * (squared(body.v) / 2 + state_->config.gravity * body.p.z);
    energy += dot(spin, scaled(body.inertia, spin)) / 2;
  }
  return energy;
}

void World::add_force(ForceFunction function) { functions_.push_back(std::move(function)); }

void World::add_user_forces() {
  Forces forces(*state_);
  for (const ForceFunction& function : functions_) function(*this, forces);
}

void Forces::add(BodyId id, const Vec3& force, const Vec3& torque) {
  Body& body = entry(world_.bodies, id);
  if (body.fixed || body.left || !body.awake) return;
  body.force += force;
  body.torque += torque;
}

void Forces::add_at(BodyId id, const Vec3& force, const Vec3& p_W) {
  add(id, force, cross(p_W - entry(world_.bodies, id).p, force));
}

void World::push(BodyId id, const Vec3& force, const Vec3& torque) {
  Body& body = entry(state_->bodies, id);
  if (body.fixed || body.left) return;
  body.user_force += force;
  body.user_torque += torque;
  wake_early(*state_, id);
}

void World::set_velocity(BodyId id, const Vec3& velocity, const Vec3& spin) {
  Body& body = entry(state_->bodies, id);
  assert(body.articulation < 0);
  if (body.left) return;
  end_grasps_of(*state_, static_cast<std::uint32_t>(id));
  body.v = velocity;
  body.w = spin;
  if (body.fixed) {
    body.awake = !(velocity == Vec3{}) || !(spin == Vec3{});
    state_->changed = true;
  } else {
    wake_early(*state_, id);
  }
}

void World::set_grip(BodyId id, double factor) {
  assert(std::isfinite(factor) && factor >= 0);
  WorldState& world = *state_;
  const auto number = static_cast<std::uint32_t>(id);
  double& now = entry(world.bodies, number).grip;
  if (now == factor) return;
  now = factor;
  end_grasps_of(world, number);
  // DART has the coefficients from the beginning on.
  world.stock.reset();
  wake_early(world, id);
  // What is fixed does not wake, and so wakes nobody, but what lies on it may begin to slide.
  for (const Contact& contact : world.contacts) {
    if (contact.a == number && contact.b != kFloorBody) wake_early(world, BodyId{contact.b});
    if (contact.b == number) wake_early(world, BodyId{contact.a});
  }
}

double World::grip(BodyId id) const { return entry(state_->bodies, id).grip; }

std::vector<DofState> World::joint(JointId id) const {
  const auto number = static_cast<std::size_t>(id);
  const JointPlace& place = entry(state_->articulations.joints, number);
  const Articulation& it = state_->articulations.all[place.articulation];
  std::vector<DofState> out;
  for (std::size_t i = 0; i < state_->config.joints[number].dofs.size(); ++i) {
    const std::size_t at = place.first + i;
    out.push_back({it.q[at], it.v[at], motor_force(it, at, state_->config.step)});
  }
  return out;
}

void World::drive(JointId id, std::size_t dof, double target) {
  const auto number = static_cast<std::size_t>(id);
  assert(std::isfinite(target));
  assert(dof < entry(state_->config.joints, number).dofs.size());
  const JointPlace& place = state_->articulations.joints[number];
  Articulation& it = state_->articulations.all[place.articulation];
  double& now = it.axes[place.first + dof].target;
  if (now == target) return;
  now = target;
  wake_early(*state_, BodyId{it.links[0].body});
}

void World::set_current(BodyId id, std::size_t magnet, double current) {
  assert(std::isfinite(current));
  const auto number = static_cast<std::uint32_t>(id);
  const MagnetDef& def = entry(entry(state_->config.bodies, number).magnets, magnet);
  const std::size_t at = state_->owners[number].begin + magnet;
  if (state_->currents[at] == current || state_->bodies[number].left) return;
  state_->currents[at] = current;
  state_->magnets[at].moment = def.moment + current * def.active;
  wake_early(*state_, id);
  std::swap(state_->events, state_->early);
  wake_magnet_partners(*state_, number);
  std::swap(state_->events, state_->early);
}

double World::current(BodyId id, std::size_t magnet) const {
  const MagnetOwner& owner = entry(state_->owners, id);
  return entry(state_->currents, owner.begin + magnet);
}

std::string World::checkpoint() const { return write_checkpoint(*state_); }
bool World::resume(std::string_view bytes) { return read_checkpoint(*state_, bytes); }
std::uint64_t World::hash() const { return hash_text(checkpoint()); }

}  // namespace stig::physics
