// SPDX-License-Identifier: MIT
// When a grasp (grasp.h) begins and ends. It begins when contacts have held the body without a move
// for a tenth of a second; it ends when they could not bear what the joint gives, when anything
// else touches the body, and whenever somebody outside of the step takes a hand in it.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

constexpr double kSteadyTime = 0.1;   ///< s
constexpr double kSteadyWay = 20e-6;  ///< m, that counts as no move in that time
constexpr double kSteadyTurn = 5e-4;  ///< rad, likewise

bool is_link(const WorldState& world, std::uint32_t i) {
  return i != kFloorBody && world.bodies[i].articulation >= 0;
}

bool is_of_part(const WorldState& world, std::uint32_t i, std::int32_t articulation,
                std::uint32_t part) {
  return i != kFloorBody && world.bodies[i].articulation == articulation &&
         world.bodies[i].part == part;
}

const Pose& part_pose(const WorldState& world, std::int32_t articulation, std::uint32_t part) {
  return world.articulations.all[static_cast<std::size_t>(articulation)].poses[part];
}

/// The grasp of the body, if there is one.
const Grasp* grasp_of(const WorldState& world, std::uint32_t i) {
  if (i == kFloorBody || world.grasp_of[i] < 0) return nullptr;
  return &world.grasps[static_cast<std::size_t>(world.grasp_of[i])];
}

template <class Ends>
void end_grasps(WorldState& world, const Ends& ends) {
  if (std::erase_if(world.grasps, ends) > 0) number_grasps(world);
}

/// Its vectors and places turned by `r`, then moved by `p`.
Contact carried(Contact contact, const Mat3& r, const Vec3& p) {
  contact.normal = r * contact.normal;
  contact.axle = r * contact.axle;
  for (ContactPoint& point : contact.points) {
    point.p_W = p + r * point.p_W;
    point.friction = r * point.friction;
  }
  return contact;
}

Contact in_frame_of(const Body& body, Contact contact) {
  contact.normal = body.r.transposed(contact.normal);
  contact.axle = body.r.transposed(contact.axle);
  for (ContactPoint& point : contact.points) {
    point.p_W = body.r.transposed(point.p_W - body.p);
    point.friction = body.r.transposed(point.friction);
  }
  return contact;
}

/// Who alone touches a loose body in this step: a link, nobody, or others, too.
class Holders {
 public:
  explicit Holders(const WorldState& world) : holder_(world.bodies.size(), kNobody) {
    for (const Contact& contact : world.contacts) {
      note(world, contact.a, contact);
      note(world, contact.b, contact);
    }
  }
  bool held(std::uint32_t body) const { return holder_[body] != kNobody && holder_[body] != kMany; }
  /// One of the bodies of the part that holds it.
  std::uint32_t holder(std::uint32_t body) const { return holder_[body]; }

 private:
  static constexpr std::uint32_t kNobody = kFloorBody, kMany = kFloorBody - 1;

  void note(const WorldState& world, std::uint32_t one, const Contact& contact) {
    if (!takes_part(world, one) || is_link(world, one) || world.bodies[one].fixed) return;
    const std::uint32_t other = contact.a == one ? contact.b : contact.a;
    std::uint32_t& holder = holder_[one];
    if (holder == kMany) return;
    const bool wheel = !(contact.axle == Vec3{});
    if (!is_link(world, other) || wheel) {
      holder = kMany;
    } else if (holder == kNobody) {
      holder = other;
    } else if (!is_of_part(world, other, world.bodies[holder].articulation,
                           world.bodies[holder].part)) {
      holder = kMany;
    }
  }

  std::vector<std::uint32_t> holder_;
};

bool same_place(const Pose& a, const Pose& b) {
  return squared(a.p - b.p) < kSteadyWay * kSteadyWay &&
         angle_of(a.q * conjugate(b.q)) < kSteadyTurn;
}

/// Begins a grasp, if contacts hold the body so that this can be told.
void begin(WorldState& world, const Steady& steady, const Pose& X_PB) {
  Grasp grasp;
  grasp.body = steady.body;
  grasp.articulation = steady.articulation;
  grasp.part = steady.part;
  grasp.X_PB = X_PB;
  const Body& body = world.bodies[steady.body];
  for (const Contact& contact : world.contacts) {
    if (contact.a != steady.body && contact.b != steady.body) continue;
    grasp.contacts.push_back(in_frame_of(body, contact));
  }
  if (!complete(grasp)) return;
  const Twist wrench = wrench_of(grasp);
  grasp.impulse = {body.r * wrench.v, body.r * wrench.w};
  const auto at =
      std::lower_bound(world.grasps.begin(), world.grasps.end(), grasp.body,
                       [](const Grasp& one, std::uint32_t number) { return one.body < number; });
  world.grasps.insert(at, std::move(grasp));
}

/// Follows the bodies that parts hold, and begins the grasps of those that have not moved.
void follow_steady(WorldState& world) {
  const Holders holders(world);
  const auto ticks = static_cast<std::uint32_t>(std::ceil(kSteadyTime / world.config.step));
  std::vector<Steady> now;
  auto before = world.steady.begin();
  for (const std::uint32_t i : world.awake) {
    if (!holders.held(i) || world.grasp_of[i] >= 0) continue;
    const Body& body = world.bodies[i];
    const Body& link = world.bodies[holders.holder(i)];
    const Pose X_PB =
        inverse(part_pose(world, link.articulation, link.part)) * Pose{body.p, body.q};
    Steady steady{i, link.articulation, link.part, X_PB, 0};
    while (before != world.steady.end() && before->body < i) ++before;
    const bool was = before != world.steady.end() && before->body == i &&
                     before->articulation == steady.articulation && before->part == steady.part;
    if (was && same_place(before->X_PB, X_PB)) {
      steady = *before;
      ++steady.ticks;
    }
    if (steady.ticks < ticks) {
      now.push_back(steady);
    } else {
      begin(world, steady, X_PB);
    }
  }
  world.steady = std::move(now);
}

}  // namespace

void number_grasps(WorldState& world) {
  world.grasp_of.assign(world.bodies.size(), -1);
  for (std::size_t k = 0; k < world.grasps.size(); ++k) {
    world.grasp_of[world.grasps[k].body] = static_cast<std::int32_t>(k);
  }
}

bool within_grasp(const WorldState& world, std::uint32_t a, std::uint32_t b) {
  const Grasp* grasp = grasp_of(world, a);
  std::uint32_t other = b;
  if (grasp == nullptr) {
    grasp = grasp_of(world, b);
    other = a;
  }
  return grasp != nullptr && is_of_part(world, other, grasp->articulation, grasp->part);
}

std::optional<Contact> grasped_contact(const WorldState& world, std::uint32_t a, std::uint32_t b) {
  const Grasp* grasp = grasp_of(world, a) != nullptr ? grasp_of(world, a) : grasp_of(world, b);
  assert(grasp != nullptr);
  for (const Contact& contact : grasp->contacts) {
    if (contact.a != a || contact.b != b) continue;
    const Body& body = world.bodies[grasp->body];
    return carried(contact, body.r, body.p);
  }
  return std::nullopt;
}

void end_touched_grasps(WorldState& world) {
  if (world.grasps.empty()) return;
  std::vector<std::uint32_t> touched;
  for (const Contact& contact : world.found) {
    if (within_grasp(world, contact.a, contact.b)) continue;
    for (const std::uint32_t i : {contact.a, contact.b}) {
      if (grasp_of(world, i) != nullptr) touched.push_back(i);
    }
  }
  end_grasps(world, [&](const Grasp& grasp) {
    return std::find(touched.begin(), touched.end(), grasp.body) != touched.end();
  });
}

bool holds(const WorldState& world, const Grasp& grasp) { return world.grasp_of[grasp.body] >= 0; }

bool bears(WorldState& world, std::size_t number, const Twist& impulse) {
  Grasp& grasp = world.grasps[number];
  const Body& body = world.bodies[grasp.body];
  if (!bear(grasp, {body.r.transposed(impulse.v), body.r.transposed(impulse.w)})) {
    world.grasp_of[grasp.body] = -1;
    return false;
  }
  grasp.impulse = impulse;
  for (const Contact& from : grasp.contacts) {
    const auto at =
        std::lower_bound(world.contacts.begin(), world.contacts.end(), from,
                         [](const Contact& a, const Contact& b) { return key(a) < key(b); });
    // One that began with a gap may be out of reach by now.
    if (at == world.contacts.end() || key(*at) != key(from)) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(from.count); ++i) {
      at->points[i].push = from.points[i].push;
      at->points[i].friction = body.r * from.points[i].friction;
    }
  }
  return true;
}

void end_grasps_of(WorldState& world, std::uint32_t body) {
  const std::int32_t articulation = world.bodies[body].articulation;
  end_grasps(world, [&](const Grasp& grasp) {
    return grasp.body == body || (articulation >= 0 && grasp.articulation == articulation);
  });
}

void follow_grasps(WorldState& world) {
  if (!world.config.grasps || world.articulations.all.empty()) return;
  end_grasps(world, [&](const Grasp& grasp) { return !holds(world, grasp); });
  const std::size_t before = world.grasps.size();
  follow_steady(world);
  if (world.grasps.size() != before) number_grasps(world);
}

void place_grasped(WorldState& world) {
  for (const Grasp& grasp : world.grasps) {
    if (!takes_part(world, grasp.body)) continue;
    Body& body = world.bodies[grasp.body];
    const Pose X_WB = part_pose(world, grasp.articulation, grasp.part) * grasp.X_PB;
    body.p = X_WB.p;
    body.q = normalised(X_WB.q);
    body.r = matrix(body.q);
  }
}

}  // namespace stig::physics
