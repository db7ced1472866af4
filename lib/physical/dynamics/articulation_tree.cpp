// SPDX-License-Identifier: MIT
// From bodies and joints to articulations: who is one rigid part, who hangs on whom.
#include <algorithm>
#include <cassert>

#include "physical/dynamics/articulation.h"

namespace stig::physics {

namespace {

/// A body's inertia about its centre, in the axes of a frame in which it is turned by q.
Mat3 inertia_in(const Quat& q, const Vec3& moments) { return rotated_diagonal(matrix(q), moments); }

Mat3 sum(const Mat3& a, const Mat3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// The inertia of a point mass at d.
Mat3 point_inertia(double mass, const Vec3& d) {
  const auto column = [&](const Vec3& e) { return (e * squared(d) - d * dot(d, e)) * mass; };
  return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

/// Joins a body to a part: masses add, moments about the common centre (Steiner).
void add_body(Part& part, const BodyDef& def, const Pose& X_PB) {
  const double mass = part.mass + def.mass;
  // Both inertias about the new common centre, by the parallel-axis theorem.
  const Vec3 centre = (part.centre * part.mass + X_PB.p * def.mass) * (1 / mass);
  const Mat3 own = sum(part.inertia, point_inertia(part.mass, part.centre - centre));
  const Mat3 other =
      sum(inertia_in(X_PB.q, inertia_of(def)), point_inertia(def.mass, X_PB.p - centre));
  part.inertia = sum(own, other);
  part.centre = centre;
  part.mass = mass;
}

/// Whether the parts of two mechanisms move in the same way; what they weigh does not matter.
bool move_alike(const std::vector<Part>& a, const std::vector<Part>& b) {
  const auto same_dof = [](const DofDef& x, const DofDef& y) {
    return x.linear == y.linear && x.axis == y.axis;
  };
  const auto same_part = [&](const Part& x, const Part& y) {
    return x.parent == y.parent && x.floating == y.floating && x.X_PJ == y.X_PJ &&
           x.X_CJ == y.X_CJ &&
           std::equal(x.dofs.begin(), x.dofs.end(), y.dofs.begin(), y.dofs.end(), same_dof);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_part);
}

/// Robots of one model share a mechanism: those of a crowd would not fit into the processor's
/// cache.
std::shared_ptr<Mechanism> mechanism_for(const std::vector<Part>& parts,
                                         const std::vector<Articulation>& others) {
  const auto alike = [&](const Articulation& other) { return move_alike(other.parts, parts); };
  const auto found = std::find_if(others.begin(), others.end(), alike);
  return found != others.end() ? found->mechanism : make_mechanism(parts);
}

/// Makes one articulation from a root body on.
class Builder {
 public:
  Builder(const WorldConfig& config, Articulations& out)
      : config_(config), out_(out), number_(static_cast<std::uint32_t>(out.all.size())) {}

  // A root that floats has six degrees of freedom before all others, without limits and motors.
  void add_root(std::uint32_t body) {
    it_.floating = true;
    Part part;
    part.floating = true;
    start(part, body);
    it_.dofs.resize(6);
    it_.q.resize(6);
    it_.v.resize(6);
    add_children(body, 0, {});
  }

  /// A body on a joint; parent: its part, or -1 for the world.
  void add_joint(std::size_t number, int parent, const Pose& X_PB) {
    const JointDef& joint = config_.joints[number];
    // Where a joint's degrees of freedom begin, for World::joint and drive.
    out_.joints[number] = {number_, static_cast<std::uint32_t>(it_.dofs.size())};
    // A joint without degrees of freedom welds: the child becomes part of its parent.
    if (joint.dofs.empty() && parent >= 0) {
      const Pose X_PC = X_PB * joint.X_PJ * inverse(joint.X_CJ);
      const auto part = static_cast<std::size_t>(parent);
      add_body(it_.parts[part], config_.bodies[joint.child], X_PC);
      it_.links.push_back({joint.child, part, X_PC});
      add_children(joint.child, parent, X_PC);
      return;
    }
    Part part;
    part.parent = parent;
    part.X_PJ = X_PB * joint.X_PJ;
    part.X_CJ = joint.X_CJ;
    part.dofs = joint.dofs;
    const int own = start(part, joint.child);
    for (const DofDef& dof : joint.dofs) {
      it_.dofs.push_back(dof);
      it_.q.push_back(dof.start);
      it_.v.push_back(dof.start_speed);
    }
    add_children(joint.child, own, {});
  }

  void finish() {
    it_.axes.resize(it_.q.size());
    for (std::size_t i = 0; i < it_.q.size(); ++i) {
      // A position motor begins with where it is as its goal, so that nothing jerks at the start.
      if (it_.dofs[i].actuator == Actuator::position) it_.axes[i].target = it_.q[i];
    }
    it_.mechanism = mechanism_for(it_.parts, out_.all);
    assert(it_.mechanism && it_.mechanism->dofs() == it_.q.size());
    note_chains();
    // The base's velocity, too: what is spawned in flight flies.
    if (it_.floating) {
      const BodyDef& def = config_.bodies[it_.links[0].body];
      it_.mechanism->place({def.X_WB.p, normalised(def.X_WB.q)}, {def.velocity, def.spin},
                           it_.q.data(), it_.v.data());
    }
    refresh(it_);
    out_.all.push_back(std::move(it_));
  }

 private:
  /// A part moves with the degrees of freedom of its parent and its own, which follow them.
  void note_chains() {
    std::uint32_t next = 0;
    for (const Part& part : it_.parts) {
      std::vector<std::uint32_t> chain;
      if (part.parent >= 0) chain = it_.chains[static_cast<std::size_t>(part.parent)];
      const std::size_t own = part.floating ? 6 : part.dofs.size();
      for (std::size_t i = 0; i < own; ++i) chain.push_back(next++);
      it_.chains.push_back(std::move(chain));
    }
    assert(next == it_.q.size());
  }

  int start(Part& part, std::uint32_t body) {
    const BodyDef& def = config_.bodies[body];
    part.mass = def.mass;
    part.inertia = inertia_in({}, inertia_of(def));
    it_.links.push_back({body, it_.parts.size(), {}});
    it_.parts.push_back(part);
    return static_cast<int>(it_.parts.size()) - 1;
  }

  // Depth first; joints are few, so looking through all of them costs nothing.
  void add_children(std::uint32_t body, int part, const Pose& X_PB) {
    for (std::size_t i = 0; i < config_.joints.size(); ++i) {
      if (config_.joints[i].parent == body) add_joint(i, part, X_PB);
    }
  }

  const WorldConfig& config_;
  Articulations& out_;
  std::uint32_t number_;
  Articulation it_;
};

}  // namespace

void add_articulations(const WorldConfig& config, std::size_t first, Articulations& out) {
  assert(first <= config.joints.size());
  const auto begin = config.joints.begin() + static_cast<std::ptrdiff_t>(first);
  const auto is_child = [&](std::uint32_t body) {
    return std::any_of(begin, config.joints.end(),
                       [body](const JointDef& joint) { return joint.child == body; });
  };
  out.joints.resize(config.joints.size());
  std::vector<std::uint32_t> done;
  for (std::size_t i = first; i < config.joints.size(); ++i) {
    const std::uint32_t parent = config.joints[i].parent;
    // Not a root itself: it comes when its tree does.
    if (parent != kWorldBody && is_child(parent)) continue;
    if (std::find(done.begin(), done.end(), parent) != done.end()) continue;
    Builder builder(config, out);
    if (parent == kWorldBody) {
      builder.add_joint(i, -1, {});
    } else {
      builder.add_root(parent);
      done.push_back(parent);
    }
    builder.finish();
  }
}

}  // namespace stig::physics
