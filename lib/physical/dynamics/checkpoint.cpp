// SPDX-License-Identifier: MIT
// A checkpoint holds the numbers that a step depends on, bit by bit in this machine's byte order,
// so that a run which is resumed cannot be told from one that was not. What can be worked out again
// (matrices, bounds, caches) is left out. Each struct's members are listed once, for both
// directions. Bytes come from files: lengths are bounded by what is left, and values are checked
// before they are used.
#include <algorithm>
#include <cstring>
#include <optional>
#include <type_traits>

#include "base/hash.h"
#include "physical/dynamics/world_settings.h"
#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

// The last digits are the format: to be raised whenever the order of members changes.
constexpr std::uint64_t kMagic = 0x33303050'47495453;  // "STIGP003"

/// Appends numbers to a text.
class Writer {
 public:
  template <class T>
  void operator()(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      (*this)(static_cast<std::uint8_t>(value));
    } else {
      static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
      const std::size_t at = out_.size();
      out_.resize(at + sizeof value);
      std::memcpy(out_.data() + at, &value, sizeof value);
    }
  }
  void operator()(const Vec3& v) { (*this)(v.x), (*this)(v.y), (*this)(v.z); }
  void operator()(const Quat& q) { (*this)(q.w), (*this)(q.x), (*this)(q.y), (*this)(q.z); }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

/// Takes numbers from the front of a text; once it is too short, all are left alone, and good()
/// tells it at the end.
class Taker {
 public:
  explicit Taker(std::string_view in) : in_(in) {}
  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t byte = 0;
      (*this)(byte);
      // A bool that is neither 0 nor 1 would be undefined behaviour.
      good_ = good_ && byte <= 1;
      value = byte == 1;
    } else {
      good_ = good_ && in_.size() >= sizeof value;
      if (!good_) return;
      std::memcpy(&value, in_.data(), sizeof value);
      in_.remove_prefix(sizeof value);
    }
  }
  void operator()(Vec3& v) { (*this)(v.x), (*this)(v.y), (*this)(v.z); }
  void operator()(Quat& q) { (*this)(q.w), (*this)(q.x), (*this)(q.y), (*this)(q.z); }
  bool good() const { return good_; }
  void fail() { good_ = false; }
  std::size_t left() const { return in_.size(); }
  bool finished() const { return good_ && in_.empty(); }

 private:
  std::string_view in_;
  bool good_ = true;
};

template <class Each, class BodyType>
void visit_body(Each& each, BodyType& body) {
  each(body.p), each(body.q), each(body.v), each(body.w);
  each(body.force), each(body.torque), each(body.user_force), each(body.user_torque);
  each(body.awake), each(body.left), each(body.rest), each(body.rest_X_WB.p),
      each(body.rest_X_WB.q);
}

template <class Each, class MagnetType>
void visit_magnet(Each& each, MagnetType& magnet) {
  each(magnet.direction), each(magnet.p_W), each(magnet.spin);
}

template <class Each, class ContactType>
void visit_contact(Each& each, ContactType& contact) {
  each(contact.a), each(contact.b), each(contact.normal), each(contact.count);
  each(contact.friction), each(contact.axle), each(contact.axle_friction), each(contact.touching);
  for (auto& point : contact.points) {
    each(point.p_W), each(point.p_A), each(point.gap), each(point.push), each(point.friction);
  }
}

template <class Each, class Held>
void visit_held(Each& each, Held& held) {
  each(held.body), each(held.articulation), each(held.part), each(held.X_PB.p), each(held.X_PB.q);
}

template <class Each, class Def>
void visit_mass_and_place(Each& each, Def& def) {
  each(def.mass), each(def.inertia);
  each(def.X_WB.p), each(def.X_WB.q), each(def.material), each(def.fixed);
  each(def.axle), each(def.axle_friction);
}

template <class Each, class Magnet>
void visit_magnet_def(Each& each, Magnet& magnet) {
  each(magnet.p_B), each(magnet.moment), each(magnet.free), each(magnet.direction);
  each(magnet.active), each(magnet.inertia);
}

template <class Each, class Joint>
void visit_joint_frames(Each& each, Joint& joint) {
  each(joint.parent), each(joint.child), each(joint.X_PJ.p), each(joint.X_PJ.q);
  each(joint.X_CJ.p), each(joint.X_CJ.q);
}

template <class Each, class Dof>
void visit_dof(Each& each, Dof& dof) {
  each(dof.linear), each(dof.axis), each(dof.start), each(dof.start_speed), each(dof.lower);
  each(dof.upper), each(dof.actuator), each(dof.effort), each(dof.speed), each(dof.damping);
}

// A cylinder is its half extents; its prism is made again.
void write_shape(Writer& out, const Shape& shape) {
  out(shape.kind), out(shape.half);
  if (shape.kind != ShapeKind::hull) return;
  out(static_cast<std::uint64_t>(shape.convex->points.size()));
  for (const Vec3& p : shape.convex->points) out(p);
}

/// The bodies and joints from some number on.
void write_definitions(Writer& out, const WorldConfig& config, std::size_t body,
                       std::size_t body_end, std::size_t joint, std::size_t joint_end) {
  out(static_cast<std::uint64_t>(body_end - body));
  for (; body < body_end; ++body) {
    const BodyDef& def = config.bodies[body];
    write_shape(out, def.shape);
    visit_mass_and_place(out, def);
    out(static_cast<std::uint64_t>(def.magnets.size()));
    for (const MagnetDef& magnet : def.magnets) visit_magnet_def(out, magnet);
  }
  out(static_cast<std::uint64_t>(joint_end - joint));
  for (; joint < joint_end; ++joint) {
    const JointDef& def = config.joints[joint];
    visit_joint_frames(out, def);
    out(static_cast<std::uint64_t>(def.dofs.size()));
    for (const DofDef& dof : def.dofs) visit_dof(out, dof);
  }
}

/// A list's length, and room for it: 0 when what is left could not hold it, at so many bytes
/// each.
template <class T>
void take_count(Taker& in, std::vector<T>& list, std::size_t bytes) {
  std::uint64_t count = 0;
  in(count);
  // A division, since a product of untrusted numbers may overflow.
  if (count > in.left() / bytes) in.fail();
  list.resize(in.good() ? count : 0);
}

/// False: no shape.
bool read_shape(Taker& in, Shape& shape) {
  in(shape.kind), in(shape.half);
  if (!in.good() || shape.kind > ShapeKind::hull || !is_finite(shape.half)) return false;
  if (shape.kind == ShapeKind::cylinder) {
    shape = Shape::cylinder(shape.half.x, shape.half.z * 2);
  } else if (shape.kind == ShapeKind::hull) {
    std::vector<Vec3> points;
    take_count(in, points, 24);
    for (Vec3& p : points) in(p);
    shape = Shape::hull(points);
  }
  return in.good();
}

bool known(const DofDef& dof) { return dof.actuator <= Actuator::force; }

// The numbers are the least bytes that an entry takes, so that no count asks for much more memory
// than the file itself has.
bool read_definitions(Taker& in, WorldConfig& out) {
  take_count(in, out.bodies, 150);
  for (BodyDef& def : out.bodies) {
    if (!read_shape(in, def.shape)) return false;
    visit_mass_and_place(in, def);
    take_count(in, def.magnets, 60);
    for (MagnetDef& magnet : def.magnets) visit_magnet_def(in, magnet);
    if (!in.good()) return false;
  }
  take_count(in, out.joints, 120);
  for (JointDef& def : out.joints) {
    visit_joint_frames(in, def);
    take_count(in, def.dofs, 60);
    for (DofDef& dof : def.dofs) {
      visit_dof(in, dof);
      if (!known(dof)) return false;
    }
  }
  return in.good();
}

void write_setting(Writer& out, const auto& value) { out(value); }
void write_setting(Writer& out, const std::vector<FrictionPair>& pairs) {
  out(pairs.size());
  for (const FrictionPair& pair : pairs) out(pair.a), out(pair.b), out(pair.coefficient);
}

/// A hash of everything in the first configuration that a step depends on. Without it a checkpoint
/// of another configuration would be read without complaint.
std::uint64_t hash_of(const WorldState& world) {
  const WorldConfig& config = world.config;
  Writer out;
  visit_settings(
      [&out](const Setting& /*setting*/, const auto& value) { write_setting(out, value); }, config);
  // Additions are in the checkpoint itself and so no part of the hash.
  write_definitions(out, config, 0, world.first_bodies, 0, world.first_joints);
  return hash_text(out.take());
}

template <class Each, class ArticulationType>
void visit_articulation(Each& each, ArticulationType& it) {
  for (std::size_t i = 0; i < it.q.size(); ++i) {
    each(it.q[i]), each(it.v[i]);
    each(it.axes[i].target), each(it.axes[i].motor), each(it.axes[i].stop);
  }
}

bool sound(const Articulation& it) {
  // A sum is finite only if all of its terms are.
  for (std::size_t i = 0; i < it.q.size(); ++i) {
    const AxisState& axis = it.axes[i];
    if (!std::isfinite(it.q[i] + it.v[i] + axis.target + axis.motor + axis.stop)) return false;
  }
  return true;
}

bool is_turn(const Quat& q) {
  return std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) < 1e-6;
}

bool sound(const Body& body) {
  return is_finite(body.p) && is_finite(body.v) && is_finite(body.w) && std::isfinite(body.rest) &&
         is_finite(body.force) && is_finite(body.torque) && is_turn(body.q);
}

bool sound(const Magnet& magnet) {
  return is_finite(magnet.p_W) && is_finite(magnet.spin) &&
         std::abs(squared(magnet.direction) - 1) < 1e-6;
}

bool read_magnets(WorldState& world, Taker& in) {
  for (Magnet& magnet : world.magnets) {
    visit_magnet(in, magnet);
    if (!in.good() || !sound(magnet)) return false;
  }
  for (double& current : world.currents) in(current);
  for (std::size_t k = 0; k < world.magnets.size(); ++k) {
    Magnet& magnet = world.magnets[k];
    const MagnetDef& def =
        world.config.bodies[magnet.owner].magnets[k - world.owners[magnet.owner].begin];
    // The moment follows from the current and is not trusted to the file.
    magnet.moment = def.moment + world.currents[k] * def.active;
  }
  return true;
}

// Last, and only of bodies whose grip somebody has changed: a world in which nobody has keeps the
// bytes, and the hash, that it had before there were grips.
void write_grips(Writer& out, const WorldState& world) {
  const auto changed = [](const Body& body) { return body.grip != 1; };
  const auto count = std::count_if(world.bodies.begin(), world.bodies.end(), changed);
  if (count == 0) return;
  out(static_cast<std::uint64_t>(count));
  for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
    if (changed(world.bodies[i])) out(i), out(world.bodies[i].grip);
  }
}

bool read_grips(WorldState& world, Taker& in) {
  for (Body& body : world.bodies) body.grip = 1;
  if (in.left() == 0) return in.good();
  std::uint64_t count = 0;
  in(count);
  for (std::uint64_t i = 0; i < count && in.good(); ++i) {
    std::uint32_t body = 0;
    double grip = 0;
    in(body), in(grip);
    if (body >= world.bodies.size() || !std::isfinite(grip) || grip < 0) return false;
    world.bodies[body].grip = grip;
  }
  return in.finished();
}

bool sound(const Contact& contact, std::size_t bodies) {
  return contact.a < bodies && (contact.b < bodies || contact.b == kFloorBody) &&
         contact.count >= 0 && contact.count <= 4;
}

// Without them a resumed world would solve contacts where the first had a joint.
void write_grasps(Writer& out, const WorldState& world) {
  out(static_cast<std::uint64_t>(world.grasps.size()));
  for (const Grasp& grasp : world.grasps) {
    visit_held(out, grasp);
    out(grasp.impulse.v), out(grasp.impulse.w);
    out(static_cast<std::uint64_t>(grasp.contacts.size()));
    for (const Contact& contact : grasp.contacts) visit_contact(out, contact);
  }
  out(static_cast<std::uint64_t>(world.steady.size()));
  for (const Steady& steady : world.steady) visit_held(out, steady), out(steady.ticks);
}

/// That the body is loose, and the part one of the world's.
template <class Held>
bool sound_held(const WorldState& world, const Held& held) {
  if (held.body >= world.bodies.size() || held.articulation < 0) return false;
  const auto number = static_cast<std::size_t>(held.articulation);
  const Body& body = world.bodies[held.body];
  return body.articulation < 0 && !body.fixed && number < world.articulations.all.size() &&
         held.part < world.articulations.all[number].parts.size() && is_finite(held.X_PB.p) &&
         is_turn(held.X_PB.q);
}

/// That the contact is one of the body with the part that holds it.
bool sound_within(const WorldState& world, const Grasp& grasp, const Contact& contact) {
  if (!sound(contact, world.bodies.size()) || contact.b == kFloorBody) return false;
  if (contact.a != grasp.body && contact.b != grasp.body) return false;
  const Body& link = world.bodies[contact.a == grasp.body ? contact.b : contact.a];
  return link.articulation == grasp.articulation && link.part == grasp.part;
}

/// Sorted, each body once.
template <class List>
bool rising(const List& list) {
  return std::adjacent_find(list.begin(), list.end(), [](const auto& a, const auto& b) {
           return a.body >= b.body;
         }) == list.end();
}

bool read_grasps(WorldState& world, Taker& in) {
  take_count(in, world.grasps, 80);
  for (Grasp& grasp : world.grasps) {
    visit_held(in, grasp);
    in(grasp.impulse.v), in(grasp.impulse.w);
    take_count(in, grasp.contacts, 80);
    if (!in.good() || grasp.contacts.empty() || !sound_held(world, grasp)) return false;
    for (Contact& contact : grasp.contacts) {
      visit_contact(in, contact);
      if (!in.good() || !sound_within(world, grasp, contact)) return false;
    }
    if (!is_finite(grasp.impulse.v) || !is_finite(grasp.impulse.w) || !complete(grasp)) {
      return false;
    }
  }
  take_count(in, world.steady, 60);
  for (Steady& steady : world.steady) {
    visit_held(in, steady), in(steady.ticks);
    if (!in.good() || !sound_held(world, steady)) return false;
  }
  if (!rising(world.grasps) || !rising(world.steady)) return false;
  number_grasps(world);
  return in.good();
}

}  // namespace

std::string write_checkpoint(const WorldState& world) {
  Writer out;
  out(kMagic), out(hash_of(world)), out(world.tick);
  write_definitions(out, world.config, world.first_bodies, world.config.bodies.size(),
                    world.first_joints, world.config.joints.size());
  for (const Body& body : world.bodies) visit_body(out, body);
  for (const Articulation& it : world.articulations.all) visit_articulation(out, it);
  for (const Magnet& magnet : world.magnets) visit_magnet(out, magnet);
  for (const double current : world.currents) out(current);
  // Pairs of blocks that are snapped together, so that none snaps again after a resumption.
  out(static_cast<std::uint64_t>(world.snaps.size()));
  for (const BodyPair& snap : world.snaps) out(snap.first), out(snap.second);
  // Contacts carry the impulses that the next step begins with: without them it would end
  // elsewhere.
  out(static_cast<std::uint64_t>(world.contacts.size()));
  for (const Contact& contact : world.contacts) visit_contact(out, contact);
  write_grasps(out, world);
  write_grips(out, world);
  return out.take();
}

namespace {

/// The world as it was made, with the additions of a checkpoint: untrusted, so they are
/// checked as new ones are (but for overlaps: they came at different times). Their bodies get their
/// numbers by where they stand in the list.
std::optional<WorldState> with_additions(const WorldState& world, Taker& in) {
  WorldConfig added = world.config;
  if (!read_definitions(in, added)) return std::nullopt;
  WorldConfig all = world.config;
  // The first configuration's bodies, and the additions behind them.
  all.bodies.resize(world.first_bodies);
  all.joints.resize(world.first_joints);
  all.bodies.insert(all.bodies.end(), added.bodies.begin(), added.bodies.end());
  all.joints.insert(all.joints.end(), added.joints.begin(), added.joints.end());
  if (!find_problems_apart(all).empty()) return std::nullopt;
  WorldState out = world;
  // Mostly nothing was added, and the world is as it was made.
  if (world.config.bodies.size() == world.first_bodies && added.bodies.empty()) return out;
  WorldConfig first = world.config;
  first.bodies.resize(world.first_bodies);
  first.joints.resize(world.first_joints);
  out = make_world_state(first);
  append(out, added.bodies, added.joints);
  return out;
}

}  // namespace

bool read_checkpoint(WorldState& world, std::string_view bytes) {
  Taker in(bytes);
  std::uint64_t magic = 0, config = 0, tick = 0, count = 0;
  in(magic), in(config), in(tick);
  if (!in.good() || magic != kMagic || config != hash_of(world)) return false;
  std::optional<WorldState> made = with_additions(world, in);
  if (!made) return false;
  WorldState& next = *made;
  next.tick = tick;
  for (std::size_t i = 0; i < next.bodies.size(); ++i) {
    Body& body = next.bodies[i];
    visit_body(in, body);
    if (!sound(body)) return false;
    body.r = matrix(body.q);
    // Owners follow their bodies: they are not in the bytes.
    MagnetOwner& owner = next.owners[i];
    owner.centre = body.p;
    const auto magnets = next.config.bodies[i].magnets.size();
    owner.end = owner.begin + (body.left ? 0 : static_cast<std::uint32_t>(magnets));
  }
  for (Articulation& it : next.articulations.all) {
    visit_articulation(in, it);
    if (!in.good() || !sound(it)) return false;
    // Velocities and poses of all parts follow from the generalised ones.
    refresh(it);
  }
  if (!read_magnets(next, in)) return false;
  in(count);
  // An entry takes more than a byte.
  if (!in.good() || count > bytes.size()) return false;
  next.snaps.assign(count, {});
  for (BodyPair& snap : next.snaps) {
    in(snap.first), in(snap.second);
    if (std::max(snap.first, snap.second) >= next.bodies.size()) return false;
  }
  in(count);
  if (!in.good() || count > bytes.size()) return false;
  next.contacts.assign(count, {});
  for (Contact& contact : next.contacts) {
    visit_contact(in, contact);
    if (!in.good() || !sound(contact, next.bodies.size())) return false;
  }
  if (!read_grasps(next, in) || !read_grips(next, in)) return false;
  next.events.clear();
  // Lists are made again in the next step.
  next.changed = true;
  next.stock.reset();
  world = std::move(next);
  return true;
}

}  // namespace stig::physics
