// SPDX-License-Identifier: MIT
// Who touches whom in this step. A grid gives candidates, bounds sort most of them out, and the
// narrow phase (collision/) gives points. Contacts are kept sorted by their two bodies (`key`), so
// that a new list and the last one are compared in one pass, and so that the order of contacts,
// which the solver's result depends on, is that of body numbers alone.
#include <algorithm>
#include <cassert>
#include <tuple>

#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

constexpr double kMargin = 0.2e-3;     ///< m: contacts are seen from here on
constexpr double kMostMargin = 50e-3;  ///< m: for fast bodies that are no boxes
constexpr double kMostWay = 0.5;       ///< m, of a step, that is looked along
constexpr double kSwept = 5e-3;        ///< m/s: faster boxes are followed along their way

/// How far turning may bring the surface in a step, at most: as for a point at the radius.
double turning_reach(const WorldState& world, const Body& body) {
  return length(body.w) * body.shape.radius() * world.config.step;
}

/// Gap below which two bodies may touch in this step.
double margin_of(const WorldState& world, const Body& a, const Body& b, double most) {
  const double way = length(a.v - b.v) * world.config.step;
  return std::min(most, kMargin + way + turning_reach(world, a) + turning_reach(world, b));
}

// Poses are kept in a list of their own, laid out for the narrow phase.
void place(WorldState& world, std::uint32_t i) {
  world.placed[i].p = world.bodies[i].p;
  world.placed[i].r = world.bodies[i].r;
}

/// The velocity before this step's forces, which come to nothing for what lies on something: with
/// them a box on a table would seem to fall in each step, which is no motion to follow.
Vec3 steady(const Body& body) { return body.fixed || !body.awake ? body.v : body.last_v; }

Touch touch_bodies(const WorldState& world, std::uint32_t number_a, std::uint32_t number_b) {
  const Body &a = world.bodies[number_a], &b = world.bodies[number_b];
  const Placed &placed_a = world.placed[number_a], &placed_b = world.placed[number_b];
  const bool boxes = a.shape.kind == ShapeKind::box && b.shape.kind == ShapeKind::box;
  const Vec3 velocity = steady(a) - steady(b);
  // Slow boxes cannot pass each other in a step.
  const bool swept = boxes && squared(velocity) > kSwept * kSwept;
  const double most = margin_of(world, a, b, swept ? kMostWay : kMostMargin);
  if (!swept) return touch(placed_a, placed_b, most);
  Passing motion;
  motion.way = velocity * world.config.step;
  motion.turning = turning_reach(world, a) + turning_reach(world, b);
  motion.margin = kMargin + motion.turning;
  motion.most = most;
  // Which body the points of a meeting go back with: the one that moves.
  motion.share = a.fixed || !a.awake ? 0 : b.fixed || !b.awake ? 1 : 0.5;
  return touch_moving_boxes(placed_a, placed_b, motion);
}

/// All that the body may reach in this step, and half the margin.
Bounds bounds_of(const WorldState& world, const Body& body) {
  Vec3 h = body.shape.half;
  if (body.shape.kind != ShapeKind::sphere) {
    const Vec3 x = body.r.x * h.x, y = body.r.y * h.y, z = body.r.z * h.z;
    // Half extents of the box about a turned box.
    h = {std::abs(x.x) + std::abs(y.x) + std::abs(z.x),
         std::abs(x.y) + std::abs(y.y) + std::abs(z.y),
         std::abs(x.z) + std::abs(y.z) + std::abs(z.z)};
  }
  const double reach = kMargin / 2 + std::min(kMostMargin, turning_reach(world, body));
  const auto way = [&world](double speed) {
    return std::clamp(speed * world.config.step, -kMostWay, kMostWay);
  };
  const Vec3 step{way(body.v.x), way(body.v.y), way(body.v.z)};
  const auto down = [reach](double x) { return std::min(x, 0.0) - reach; };
  const auto up = [reach](double x) { return std::max(x, 0.0) + reach; };
  return {body.p - h + Vec3{down(step.x), down(step.y), down(step.z)},
          body.p + h + Vec3{up(step.x), up(step.y), up(step.z)}};
}

Bounds joined(const Bounds& a, const Bounds& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

/// Stands for the floor, as far as motion goes.
const Body kAtRest{};

const Vec3& axle_of(const WorldState& world, std::uint32_t body) {
  return world.config.bodies[body].axle;
}

void add_contact(const WorldState& world, std::uint32_t a, std::uint32_t b, const Touch& touch,
                 std::vector<Contact>& out) {
  if (touch.count == 0) return;
  const Body& body = world.bodies[a];
  Contact contact;
  contact.a = a;
  contact.b = b;
  contact.normal = touch.normal;
  contact.count = touch.count;
  const Material other = b == kFloorBody ? kFloorMaterial : world.bodies[b].material;
  const double grip = b == kFloorBody ? body.grip : body.grip * world.bodies[b].grip;
  contact.friction = grip * friction_of(world.config, body.material, other);
  // The wheel's axle decides; two wheels that touch are taken as the first's.
  const std::uint32_t wheel = b == kFloorBody || !(axle_of(world, a) == Vec3{}) ? a : b;
  contact.axle = world.bodies[wheel].r * axle_of(world, wheel);
  if (!(contact.axle == Vec3{})) {
    contact.axle_friction = world.config.bodies[wheel].axle_friction;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(touch.count); ++i) {
    const TouchPoint& from = touch.points[i];
    contact.points[i].p_W = from.p;
    contact.points[i].p_A = body.r.transposed(from.p - body.p);
    contact.points[i].gap = from.gap;
  }
  out.push_back(contact);
}

/// The things of the grid that the bodies make, with their bounds. A mechanism is one thing in the
/// grid, by its first link, so its parts are not paired with each other.
std::vector<std::uint32_t> things_of(WorldState& world, const std::vector<std::uint32_t>& bodies) {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t i : bodies) {
    const Articulation* it = articulation_of(world, i);
    if (it != nullptr && it->links[0].body != i) continue;
    Bounds& all = world.thing_bounds[i] = world.bounds[i];
    if (it != nullptr) {
      for (const LinkBody& link : it->links) all = joined(all, world.bounds[link.body]);
    }
    out.push_back(i);
  }
  return out;
}

/// Calls with each body of a thing.
template <class Each>
void each_body(const WorldState& world, std::uint32_t thing, const Each& each) {
  const std::int32_t number = world.bodies[thing].articulation;
  if (number < 0) return each(thing);
  const Articulation& it = world.articulations.all[static_cast<std::size_t>(number)];
  for (const LinkBody& link : it.links) each(link.body);
}

/// Pairs a < b of bodies that may touch, one of them awake, in rising order.
std::vector<BodyPair> near_pairs(WorldState& world) {
  for (const std::uint32_t i : world.awake) {
    place(world, i);
    world.bounds[i] = bounds_of(world, world.bodies[i]);
  }
  const auto moving = cells_of(things_of(world, world.awake), world.thing_bounds, world.cell);
  std::vector<BodyPair> out;
  // Pairs of things, then of their bodies, each with bounds of its own.
  for (const auto& pair : candidate_pairs(moving, world.resting_cells, world.thing_bounds)) {
    each_body(world, pair.first, [&](std::uint32_t a) {
      each_body(world, pair.second, [&](std::uint32_t b) {
        const bool awake = world.bodies[a].awake || world.bodies[b].awake;
        if (awake && overlap(world.bounds[a], world.bounds[b])) out.push_back(std::minmax(a, b));
      });
    });
  }
  std::sort(out.begin(), out.end());
  return out;
}

void add_floor_contact(const WorldState& world, std::uint32_t i, std::vector<Contact>& out) {
  const Body& body = world.bodies[i];
  if (body.fixed) return;
  const double margin = margin_of(world, body, kAtRest, kMostWay);
  add_contact(world, i, kFloorBody, touch_floor(world.placed[i], margin), out);
}

/// Contacts in which somebody takes part, sorted: into world.found.
void find_contacts(WorldState& world) {
  const std::vector<BodyPair> pairs = near_pairs(world);
  std::vector<Contact>& out = world.found;
  out.clear();
  auto next = world.config.floor ? world.awake.begin() : world.awake.end();
  // Floor contacts come in between, in the order of body numbers, for the sort.
  for (const auto& [a, b] : pairs) {
    for (; next != world.awake.end() && *next < a; ++next) add_floor_contact(world, *next, out);
    if (world.bodies[a].fixed && world.bodies[b].fixed) continue;
    if (within_grasp(world, a, b)) {
      if (const auto contact = grasped_contact(world, a, b)) out.push_back(*contact);
      continue;
    }
    add_contact(world, a, b, touch_bodies(world, a, b), out);
  }
  for (; next != world.awake.end(); ++next) add_floor_contact(world, *next, out);
}

bool by_key(const Contact& a, const Contact& b) { return key(a) < key(b); }

/// Takes over the contacts found, with impulses of the last; those among sleepers stay as they
/// were.
void merge_contacts(WorldState& world) {
  std::vector<Contact>& out = world.merged;
  out.clear();
  auto next = world.found.begin();
  const auto end = world.found.end();
  for (const Contact& old : world.contacts) {
    for (; next != end && by_key(*next, old); ++next) out.push_back(*next);
    // Old contacts of bodies awake that were not found again are dropped here.
    if (!takes_part(world, old.a) && !takes_part(world, old.b)) {
      out.push_back(old);
    } else if (next != end && key(*next) == key(old)) {
      warm_start(*next, old);
    }
  }
  out.insert(out.end(), next, end);
  std::swap(out, world.contacts);
}

/// By its speed before this step's forces: with them, everything at rest seems to fall, since
/// gravity alone gives it 5 cm/s in a step of 5 ms.
bool wakes_others(const Body& body, const SleepRules& rules) {
  return body.awake &&
         (body.fixed || squared(body.last_v) > rules.waking_speed * rules.waking_speed ||
          squared(body.last_w) > rules.waking_spin * rules.waking_spin);
}

bool sleeps(const WorldState& world, std::uint32_t i) {
  return i != kFloorBody && !world.bodies[i].awake && !world.bodies[i].fixed &&
         !world.bodies[i].left;
}

/// Sleepers that something fast touches, and those whose contact with a body that is awake
/// has gone: it may have held them.
std::vector<std::uint32_t> disturbed(const WorldState& world) {
  std::vector<std::uint32_t> out;
  const auto consider = [&](std::uint32_t one, std::uint32_t other, bool gone) {
    if (!sleeps(world, one) || other == kFloorBody || !world.bodies[other].awake) return;
    if (gone || wakes_others(world.bodies[other], world.config.sleep)) out.push_back(one);
  };
  for (const Contact& contact : world.found) {
    consider(contact.a, contact.b, false);
    consider(contact.b, contact.a, false);
  }
  // A support that is gone must wake what it held.
  for (const Contact& old : world.contacts) {
    if (!takes_part(world, old.a) && !takes_part(world, old.b)) continue;
    if (!sleeps(world, old.a) && !sleeps(world, old.b)) continue;
    if (std::binary_search(world.found.begin(), world.found.end(), old, by_key)) continue;
    consider(old.a, old.b, true);
    consider(old.b, old.a, true);
  }
  return out;
}

}  // namespace

bool takes_part(const WorldState& world, std::uint32_t i) {
  assert(i == kFloorBody || i < world.bodies.size());
  return i != kFloorBody && world.bodies[i].awake && !world.bodies[i].left;
}

double friction_of(const WorldConfig& config, Material a, Material b) {
  for (const FrictionPair& pair : config.frictions) {
    if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a)) return pair.coefficient;
  }
  return config.friction;
}

void refresh_lists(WorldState& world) {
  if (!world.changed) return;
  world.changed = false;
  world.awake.clear();
  world.resting.clear();
  world.bounds.resize(world.bodies.size());
  world.thing_bounds.resize(world.bodies.size());
  // Places are only added: a body that has left keeps its own.
  for (std::size_t i = world.placed.size(); i < world.bodies.size(); ++i) {
    world.placed.push_back({world.bodies[i].shape, {}, {}});
  }
  for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    if (body.left) continue;
    (body.awake ? world.awake : world.resting).push_back(i);
    if (body.awake) continue;
    place(world, i);
    world.bounds[i] = bounds_of(world, body);
  }
  world.resting_cells = cells_of(things_of(world, world.resting), world.thing_bounds, world.cell);
}

void update_contacts(WorldState& world) {
  find_contacts(world);
  // Who wakes touches others, whom it may wake in turn: until nobody does.
  for (auto woken = disturbed(world); !woken.empty(); woken = disturbed(world)) {
    const std::vector<std::uint32_t> before = world.awake;
    for (const std::uint32_t i : woken) wake(world, i);
    refresh_lists(world);
    for (const std::uint32_t i : world.awake) {
      // Those who have just woken lack this step's forces.
      if (!std::binary_search(before.begin(), before.end(), i)) {
        integrate_velocity(world, i);
      }
    }
    find_contacts(world);
  }
  end_touched_grasps(world);
  merge_contacts(world);
}

// Reported once, when it first is nearer than the margin of touching.
void report_contacts(WorldState& world) {
  for (Contact& contact : world.contacts) {
    if (contact.touching) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.count); ++i) {
      contact.touching = contact.touching || contact.points[i].gap < kTouching;
    }
    if (!contact.touching) continue;
    world.events.push_back({EventKind::contact_began, BodyId{contact.a}, BodyId{contact.b}});
  }
}

}  // namespace stig::physics
