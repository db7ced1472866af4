// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <type_traits>

#include "base/hash.h"
#include "physical/world_state.h"

namespace stig {

namespace {

constexpr std::uint64_t kMagic = 0x32303050'47495453;  // "STIGP002"

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

/// Takes numbers from the front of a text; once it is too short, all are left alone.
class Taker {
 public:
  explicit Taker(std::string_view in) : in_(in) {}
  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t byte = 0;
      (*this)(byte);
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
  bool finished() const { return good_ && in_.empty(); }

 private:
  std::string_view in_;
  bool good_ = true;
};

template <class Each, class BodyType>
void visit_body(Each& each, BodyType& body) {
  each(body.p), each(body.q), each(body.v), each(body.w);
  each(body.force), each(body.torque), each(body.user_force), each(body.user_torque);
  each(body.awake), each(body.left), each(body.rest);
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

void write_joint(Writer& out, const JointDef& joint) {
  out(joint.parent), out(joint.child), out(joint.X_PJ.p), out(joint.X_PJ.q), out(joint.X_CJ.p);
  out(joint.X_CJ.q), out(joint.dofs.size());
  for (const DofDef& dof : joint.dofs) {
    out(dof.linear), out(dof.axis), out(dof.start), out(dof.lower), out(dof.upper);
    out(dof.actuator), out(dof.effort), out(dof.speed), out(dof.damping);
  }
}

/// Of everything in the configuration that a step depends on.
std::uint64_t hash_of(const WorldConfig& config) {
  Writer out;
  out(config.step), out(config.gravity), out(config.floor), out(config.arena);
  out(config.friction), out(config.frictions.size());
  for (const FrictionPair& pair : config.frictions) {
    out(pair.a), out(pair.b), out(pair.coefficient);
  }
  out(config.magnet_cutoff), out(config.magnet_contact), out(config.relaxation.time),
      out(config.relaxation.sweeps), out(config.magnets), out(config.bearing_damping),
      out(config.snap.force);
  const SleepRules& sleep = config.sleep;
  out(config.small_steps), out(config.sweeps), out(sleep.enabled), out(sleep.time),
      out(sleep.speed), out(sleep.spin);
  out(sleep.waking_speed), out(sleep.waking_spin), out(sleep.waking_force);
  for (const BodyDef& def : config.bodies) {
    out(def.shape.kind), out(def.shape.half), out(def.mass), out(def.inertia), out(def.X_WB.p);
    out(def.X_WB.q), out(def.material), out(def.fixed), out(def.axle), out(def.axle_friction);
    out(def.magnets.size());
    for (const MagnetDef& magnet : def.magnets) {
      out(magnet.p_B), out(magnet.moment), out(magnet.free), out(magnet.direction);
      out(magnet.active), out(magnet.inertia);
    }
  }
  for (const JointDef& joint : config.joints) write_joint(out, joint);
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
  for (std::size_t i = 0; i < it.q.size(); ++i) {
    const AxisState& axis = it.axes[i];
    if (!std::isfinite(it.q[i] + it.v[i] + axis.target + axis.motor + axis.stop)) return false;
  }
  return true;
}

bool sound(const Body& body) {
  const Quat& q = body.q;
  return is_finite(body.p) && is_finite(body.v) && is_finite(body.w) && std::isfinite(body.rest) &&
         is_finite(body.force) && is_finite(body.torque) &&
         std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) < 1e-6;
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
    magnet.moment = def.moment + world.currents[k] * def.active;
  }
  return true;
}

bool sound(const Contact& contact, std::size_t bodies) {
  return contact.a < bodies && (contact.b < bodies || contact.b == kFloorBody) &&
         contact.count >= 0 && contact.count <= 4;
}

}  // namespace

std::string write_checkpoint(const WorldState& world) {
  Writer out;
  out(kMagic), out(hash_of(world.config)), out(world.tick);
  for (const Body& body : world.bodies) visit_body(out, body);
  for (const Articulation& it : world.articulations.all) visit_articulation(out, it);
  for (const Magnet& magnet : world.magnets) visit_magnet(out, magnet);
  for (const double current : world.currents) out(current);
  out(static_cast<std::uint64_t>(world.snaps.size()));
  for (const BodyPair& snap : world.snaps) out(snap.first), out(snap.second);
  out(static_cast<std::uint64_t>(world.contacts.size()));
  for (const Contact& contact : world.contacts) visit_contact(out, contact);
  return out.take();
}

bool read_checkpoint(WorldState& world, std::string_view bytes) {
  Taker in(bytes);
  WorldState next = world;
  std::uint64_t magic = 0, config = 0, count = 0;
  in(magic), in(config), in(next.tick);
  if (!in.good() || magic != kMagic || config != hash_of(world.config)) return false;
  for (std::size_t i = 0; i < next.bodies.size(); ++i) {
    Body& body = next.bodies[i];
    visit_body(in, body);
    if (!sound(body)) return false;
    body.r = matrix(body.q);
    MagnetOwner& owner = next.owners[i];
    owner.centre = body.p;
    const auto magnets = world.config.bodies[i].magnets.size();
    owner.end = owner.begin + (body.left ? 0 : static_cast<std::uint32_t>(magnets));
  }
  for (Articulation& it : next.articulations.all) {
    visit_articulation(in, it);
    if (!in.good() || !sound(it)) return false;
    refresh(it);
  }
  if (!read_magnets(next, in)) return false;
  in(count);
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
  if (!in.finished()) return false;
  next.events.clear();
  next.changed = true;
  world = std::move(next);
  return true;
}

}  // namespace stig
