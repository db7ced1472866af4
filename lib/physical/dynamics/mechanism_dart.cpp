// SPDX-License-Identifier: MIT
// The one file that knows DART's kinematics. Joints with several degrees of freedom become chains
// of single ones with bodies between them that weigh almost nothing, since DART's own compound
// joints have coordinates of their own. DART keeps global registries of what exists, so making and
// unmaking is under a lock; the use of one skeleton by one thread is not.
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>

#include "physical/dynamics/dart_lock.h"
#include "physical/dynamics/mechanism.h"

namespace stig::physics {

namespace {

using namespace dart::dynamics;

/// Mass and inertia of the bodies between the axes of one joint, which DART wants to weigh
/// something: kg, and kg·m².
constexpr double kAlmostNoMass = 1e-12, kAlmostNoInertia = 1e-18;

Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 vec3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Isometry3d eigen(const Pose& pose) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear() = Eigen::Quaterniond(pose.q.w, pose.q.x, pose.q.y, pose.q.z).toRotationMatrix();
  out.translation() = eigen(pose.p);
  return out;
}
Eigen::Matrix3d eigen(const Mat3& m) {
  Eigen::Matrix3d out;
  out << eigen(m.x), eigen(m.y), eigen(m.z);
  return out;
}

class DartMechanism final : public Mechanism {
 public:
  explicit DartMechanism(const std::vector<Part>& parts);

  std::size_t dofs() const override { return skeleton_->getNumDofs(); }
  void place(const Pose& X_WP, const Twist& motion, double* q, double* v) override;
  void set_positions(const double* q) override;
  Pose pose(std::size_t part) const override;
  void columns(std::size_t part, Twist* out) const override;
  void integrate(double* q, const double* v, double dt) override;

 private:
  using Six = Eigen::Map<const Eigen::Matrix<double, 6, 1>>;
  /// The number of the first degree of freedom of `singles_`: a floating base's come before.
  std::size_t first() const { return floating_ == nullptr ? 0 : 6; }
  BodyNode* add_joint(BodyNode* parent, const Part& part, const std::string& name);
  BodyNode* add_dof(BodyNode* parent, const DofDef& dof, const std::string& name,
                    const Eigen::Isometry3d& before, const Eigen::Isometry3d& after);

  SkeletonPtr skeleton_;
  FreeJoint* floating_ = nullptr;  ///< the first part's; it has the first six degrees of freedom
  std::vector<Joint*> singles_;    ///< of one degree of freedom each, in their order
  std::vector<BodyNode*> nodes_;   ///< of the parts
};

template <class JointType>
BodyNode* add_node(const SkeletonPtr& skeleton, BodyNode* parent, const std::string& name,
                   typename JointType::Properties joint, const Eigen::Isometry3d& before,
                   const Eigen::Isometry3d& after) {
  joint.mName = name;
  joint.mT_ParentBodyToJoint = before;
  joint.mT_ChildBodyToJoint = after;
  BodyNode::Properties node;
  node.mName = name;
  node.mInertia = Inertia(kAlmostNoMass, Eigen::Vector3d::Zero(),
                          kAlmostNoInertia * Eigen::Matrix3d::Identity());
  return skeleton->createJointAndBodyNodePair<JointType>(parent, joint, node).second;
}

BodyNode* DartMechanism::add_dof(BodyNode* parent, const DofDef& dof, const std::string& name,
                                 const Eigen::Isometry3d& before, const Eigen::Isometry3d& after) {
  if (dof.linear) {
    PrismaticJoint::Properties joint;
    joint.mAxis = eigen(dof.axis);
    return add_node<PrismaticJoint>(skeleton_, parent, name, joint, before, after);
  }
  RevoluteJoint::Properties joint;
  joint.mAxis = eigen(dof.axis);
  return add_node<RevoluteJoint>(skeleton_, parent, name, joint, before, after);
}

BodyNode* DartMechanism::add_joint(BodyNode* parent, const Part& part, const std::string& name) {
  const Eigen::Isometry3d none = Eigen::Isometry3d::Identity();
  if (part.floating) return add_node<FreeJoint>(skeleton_, parent, name, {}, none, none);
  const Eigen::Isometry3d before = eigen(part.X_PJ), after = eigen(part.X_CJ);
  const std::size_t count = part.dofs.size();
  if (count == 0) return add_node<WeldJoint>(skeleton_, parent, name, {}, before, after);
  BodyNode* node = parent;
  for (std::size_t i = 0; i < count; ++i) {
    // The first of a chain takes the joint's own frame, the last the child's.
    node = add_dof(node, part.dofs[i], name + "." + std::to_string(i), i == 0 ? before : none,
                   i + 1 == count ? after : none);
  }
  return node;
}

DartMechanism::DartMechanism(const std::vector<Part>& parts) : skeleton_(Skeleton::create()) {
  skeleton_->setGravity(Eigen::Vector3d::Zero());  // among the forces
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = parts[i];
    BodyNode* parent = part.parent < 0 ? nullptr : nodes_[static_cast<std::size_t>(part.parent)];
    BodyNode* node = add_joint(parent, part, std::to_string(i));
    node->setInertia(Inertia(part.mass, eigen(part.centre), eigen(part.inertia)));
    nodes_.push_back(node);
  }
  if (parts[0].floating) floating_ = static_cast<FreeJoint*>(nodes_[0]->getParentJoint());
  for (std::size_t i = floating_ == nullptr ? 0 : 6; i < skeleton_->getNumDofs(); ++i) {
    singles_.push_back(skeleton_->getDof(i)->getJoint());
  }
}

void DartMechanism::place(const Pose& X_WP, const Twist& motion, double* q, double* v) {
  // DART's free joint has coordinates of its own, spin first: read back as it has them.
  floating_->setRelativeTransform(eigen(X_WP));
  floating_->setLinearVelocity(eigen(motion.v));
  floating_->setAngularVelocity(eigen(motion.w));
  for (std::size_t i = 0; i < 6; ++i) {
    q[i] = floating_->getPosition(i);
    v[i] = floating_->getVelocity(i);
  }
}

// A joint at a time: a skeleton sets each degree of freedom alone, and each time tells all that
// hangs on it.
void DartMechanism::set_positions(const double* q) {
  if (floating_ != nullptr) floating_->setPositionsStatic(Six(q));
  for (std::size_t i = 0; i < singles_.size(); ++i) singles_[i]->setPosition(0, q[first() + i]);
}

Pose DartMechanism::pose(std::size_t part) const {
  const Eigen::Isometry3d& pose = nodes_[part]->getWorldTransform();
  const Eigen::Quaterniond q(pose.linear());
  return {vec3(pose.translation()), normalised(Quat{q.w(), q.x(), q.y(), q.z()})};
}

void DartMechanism::columns(std::size_t part, Twist* out) const {
  // Columns of joints that do not move the part stay zero.
  std::fill_n(out, dofs(), Twist{});
  const auto& jacobian = nodes_[part]->getWorldJacobian();  // spin above velocity
  const auto& depends = nodes_[part]->getDependentGenCoordIndices();
  for (std::size_t i = 0; i < depends.size(); ++i) {
    const auto column = jacobian.col(static_cast<Eigen::Index>(i));
    out[depends[i]] = {vec3(column.tail<3>()), vec3(column.head<3>())};
  }
}

void DartMechanism::integrate(double* q, const double* v, double dt) {
  for (std::size_t i = first(); i < dofs(); ++i) q[i] += v[i] * dt;
  if (floating_ == nullptr) return;
  // DART moves along the body's axes at the step's beginning: take those at its middle.
  // Second order in dt for the base's path; turns are DART's exponential map.
  const Vec3 way = matrix(rotation(Vec3{v[0], v[1], v[2]} * (dt / 2))) * Vec3{v[3], v[4], v[5]};
  Eigen::Matrix<double, 6, 1> motion;
  motion << v[0], v[1], v[2], way.x, way.y, way.z;
  const Eigen::Matrix<double, 6, 1> after = FreeJoint::convertToPositions(
      FreeJoint::convertToTransform(Six(q)) * FreeJoint::convertToTransform(motion * dt));
  std::copy_n(after.data(), 6, q);
}

}  // namespace

std::shared_ptr<Mechanism> make_mechanism(const std::vector<Part>& parts) {
  // Not make_shared: the deleter has to lock as well.
  const std::lock_guard lock(dart_lock());
  return {new DartMechanism(parts), [](const DartMechanism* mechanism) {
            const std::lock_guard unmake(dart_lock());
            delete mechanism;
          }};
}

}  // namespace stig::physics
