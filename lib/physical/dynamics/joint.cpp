// SPDX-License-Identifier: MIT
// Everything that can be wrong with a mechanism is found before a world is made from it: the
// dynamics below asserts and does not ask. A mechanism is a tree whose bodies stand where its
// joints say.
#include "physical/dynamics/joint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/islands.h"
#include "physical/dynamics/number_checks.h"
#include "physical/dynamics/world_config.h"
#include "physical/solver/solver.h"

namespace stig::physics {

namespace {

// With the limit on degrees of freedom it keeps a step's work within bounds.
constexpr std::size_t kMostJoined = 256;  ///< bodies of a mechanism

bool is_pose(const Pose& pose) { return is_finite(pose.p) && is_unit(pose.q); }

/// Written so that NaN is refused too.
const char* problem_of(const DofDef& dof) {
  if (!is_unit(dof.axis)) return "has an axis that is no unit vector";
  if (!(dof.lower <= dof.upper)) return "has limits in the wrong order";
  if (!std::isfinite(dof.start) || !(dof.lower <= dof.start && dof.start <= dof.upper)) {
    return "starts outside of its limits";
  }
  if (!(std::abs(dof.start_speed) <= 1000)) return "starts too fast";
  if (!not_negative(dof.effort)) return "has an effort that is negative or none";
  if (!not_negative(dof.speed)) return "has a speed that is negative or none";
  if (!not_negative(dof.damping)) return "has a damping that is negative or none";
  return nullptr;
}

// The first problem of a joint is enough: others may only follow from it.
std::string problem_of(const JointDef& joint, const WorldConfig& config) {
  const std::size_t count = config.bodies.size();
  if (joint.child >= count) return "has a child that is no body";
  if (joint.parent != kWorldBody && joint.parent >= count) return "has a parent that is no body";
  if (joint.parent == joint.child) return "joins a body to itself";
  if (config.bodies[joint.child].fixed) return "has a child that is fixed";
  if (joint.parent == kWorldBody && joint.dofs.empty()) {
    return "has no degree of freedom and hangs in the world: say that its body is fixed";
  }
  // A fixed body has no velocity that a joint could be relative to.
  if (joint.parent != kWorldBody && config.bodies[joint.parent].fixed) {
    return "has a parent that is fixed: hang it in the world";
  }
  if (!is_pose(joint.X_PJ) || !is_pose(joint.X_CJ)) return "has a pose that is none";
  for (const DofDef& dof : joint.dofs) {
    if (const char* problem = problem_of(dof)) return problem;
  }
  return {};
}

/// The joint of which each body is the child; the number of joints: none.
std::vector<std::size_t> joints_above(const WorldConfig& config, std::vector<std::string>& out) {
  const std::size_t none = config.joints.size();
  std::vector<std::size_t> above(config.bodies.size(), none);
  for (std::size_t i = 0; i < none; ++i) {
    std::size_t& slot = above[config.joints[i].child];
    if (slot != none) {
      out.push_back(fmt::format("body {} is the child of joints {} and {}: a mechanism is a tree",
                                config.joints[i].child, slot, i));
    }
    slot = i;
  }
  return above;
}

/// The body at the top of the tree, counting degrees of freedom on the way; kWorldBody when
/// the way does not end.
std::uint32_t root_of(const WorldConfig& config, const std::vector<std::size_t>& above,
                      std::uint32_t body) {
  // Going up more often than there are joints means going in a circle.
  for (std::size_t steps = 0; steps <= config.joints.size(); ++steps) {
    if (above[body] == config.joints.size()) return body;
    const std::uint32_t parent = config.joints[above[body]].parent;
    if (parent == kWorldBody) return body;
    body = parent;
  }
  return kWorldBody;
}

/// Whether the poses of the two bodies are those that the joint puts them in.
bool fits(const WorldConfig& config, const JointDef& joint) {
  const Pose& child = config.bodies[joint.child].X_WB;
  Pose wanted = start_pose(joint);
  if (joint.parent != kWorldBody) wanted = config.bodies[joint.parent].X_WB * wanted;
  // Both poses come from the same file, with six digits or more.
  const Pose apart = inverse(wanted) * child;
  // For small turns the vector part is half the angle: 2 µrad.
  return length(apart.p) < 1e-6 && length({apart.q.x, apart.q.y, apart.q.z}) < 1e-6;
}

void check_trees(const WorldConfig& config, std::vector<std::string>& out) {
  const auto above = joints_above(config, out);
  if (!out.empty()) return;
  std::vector<std::size_t> dofs(config.bodies.size(), 6), bodies(config.bodies.size(), 1);
  for (std::size_t i = 0; i < config.joints.size(); ++i) {
    const JointDef& joint = config.joints[i];
    const std::uint32_t root = root_of(config, above, joint.child);
    if (root == kWorldBody) {
      out.push_back(fmt::format("joint {} is part of a circle: a mechanism is a tree", i));
    } else if ((dofs[root] += joint.dofs.size()) > kMostMechanismDofs) {
      out.push_back(fmt::format("the mechanism of body {} has more than {} degrees of freedom",
                                root, kMostMechanismDofs));
    } else if (++bodies[root] > kMostJoined) {
      out.push_back(
          fmt::format("the mechanism of body {} has more than {} bodies", root, kMostJoined));
    } else if (!fits(config, joint)) {
      out.push_back(fmt::format("joint {} does not fit the poses of its bodies", i));
    }
    if (!out.empty()) return;
  }
}

}  // namespace

Pose start_pose(const JointDef& joint) {
  // Degrees of freedom follow each other, each in the frame that the one before leaves.
  Pose pose = joint.X_PJ;
  for (const DofDef& dof : joint.dofs) {
    const Vec3 way = dof.axis * dof.start;
    pose = pose * (dof.linear ? Pose{way, {}} : Pose{{}, rotation(way)});
  }
  return pose * inverse(joint.X_CJ);
}

void place_links(WorldConfig& config) {
  // As often as the deepest tree needs; a circle ends it too.
  for (std::size_t round = 0; round < config.joints.size(); ++round) {
    bool changed = false;
    for (const JointDef& joint : config.joints) {
      Pose pose = start_pose(joint);
      assert(joint.parent == kWorldBody || joint.parent < config.bodies.size());
      assert(joint.child < config.bodies.size());
      if (joint.parent != kWorldBody) pose = config.bodies[joint.parent].X_WB * pose;
      pose.q = normalised(pose.q);
      Pose& own = config.bodies[joint.child].X_WB;
      changed = changed || !(own.p == pose.p) || !(own.q == pose.q);
      own = pose;
    }
    if (!changed) return;
  }
}

std::vector<std::uint32_t> mechanisms_of(const WorldConfig& config) {
  Islands islands(config.bodies.size());
  for (const JointDef& joint : config.joints) {
    if (joint.parent != kWorldBody) islands.join(joint.parent, joint.child);
  }
  std::vector<std::uint32_t> out(config.bodies.size());
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = islands.root(i);
  return out;
}

std::vector<std::string> problems_of_joints(const WorldConfig& config) {
  std::vector<std::string> out;
  if (config.joints.empty()) return out;
  for (std::size_t i = 0; i < config.joints.size(); ++i) {
    const std::string problem = problem_of(config.joints[i], config);
    if (!problem.empty()) out.push_back(fmt::format("joint {} {}", i, problem));
  }
  if (out.empty()) check_trees(config, out);
  return out;
}

}  // namespace stig::physics
