// SPDX-License-Identifier: MIT
// Integrated magnets against what they stand for: blocks of nine bodies, spheres on ball
// joints, on DART's dynamics.

#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/simulation/World.hpp>

#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

using dart::dynamics::BallJoint, dart::dynamics::BodyNode, dart::dynamics::FreeJoint;
using dart::dynamics::Inertia, dart::dynamics::Skeleton, dart::dynamics::SkeletonPtr;

Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 vec3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Nothing but dynamics: no contacts, no weight.
class NineBodies {
 public:
  NineBodies(const WorldConfig& config, const BlockModel& block)
      : config_(config), block_(block), world_(dart::simulation::World::create()) {
    world_->setTimeStep(config.step);
    world_->setGravity(Eigen::Vector3d::Zero());
    for (const BodyDef& def : config.bodies) add_block(def);
  }

  void step() {
    const std::size_t half = spheres_.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
      for (std::size_t j = half; j < spheres_.size(); ++j) pull(*spheres_[i], *spheres_[j]);
    }
    world_->step();
  }

  Pose pose(std::size_t block) const {
    const Eigen::Isometry3d place = blocks_[block]->getWorldTransform();
    const Eigen::Quaterniond q(place.linear());
    return {vec3(place.translation()), normalised(Quat{q.w(), q.x(), q.y(), q.z()})};
  }
  /// The direction of a sphere's magnet.
  Vec3 direction(std::size_t sphere) const {
    return vec3(spheres_[sphere]->getWorldTransform().linear() * eigen(start_[sphere]));
  }

 private:
  void add_block(const BodyDef& def) {
    const SkeletonPtr skeleton = Skeleton::create(std::to_string(blocks_.size()));
    auto* body = skeleton->createJointAndBodyNodePair<FreeJoint>().second;
    const double moment = block_.body_mass * block_.side * block_.side / 6;
    body->setInertia(
        Inertia(block_.body_mass, Eigen::Vector3d::Zero(), moment * Eigen::Matrix3d::Identity()));
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    const Quat& q = def.X_WB.q;
    place.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
    place.translation() = eigen(def.X_WB.p);
    FreeJoint::setTransformOf(body, place);
    for (const MagnetDef& magnet : def.magnets) {
      BallJoint::Properties properties;
      properties.mName = "joint " + std::to_string(spheres_.size());
      const auto [joint, sphere] = body->createChildJointAndBodyNodePair<BallJoint>(
          properties, BodyNode::AspectProperties("sphere " + std::to_string(spheres_.size())));
      Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
      at.translation() = eigen(magnet.p_B);
      joint->setTransformFromParentBodyNode(at);
      sphere->setInertia(Inertia(block_.magnet_mass, Eigen::Vector3d::Zero(),
                                 block_.magnet_inertia() * Eigen::Matrix3d::Identity()));
      spheres_.push_back(sphere);
      start_.push_back(magnet.direction);
    }
    blocks_.push_back(body);
    world_->addSkeleton(skeleton);
  }

  void pull(BodyNode& a, BodyNode& b) const {
    const Vec3 r = vec3(a.getWorldTransform().translation() - b.getWorldTransform().translation());
    if (length(r) >= config_.magnet_cutoff) return;
    const auto moment = [this](const BodyNode& sphere) {
      const auto at = std::find(spheres_.begin(), spheres_.end(), &sphere) - spheres_.begin();
      return direction(static_cast<std::size_t>(at)) * block_.magnet_moment();
    };
    const DipoleWrench wrench = dipole_wrench(moment(a), moment(b), r);
    a.addExtForce(eigen(wrench.force), Eigen::Vector3d::Zero(), false, true);
    b.addExtForce(eigen(-wrench.force), Eigen::Vector3d::Zero(), false, true);
    a.addExtTorque(eigen(wrench.torque), false);
    b.addExtTorque(eigen(wrench.torque_on_other), false);
  }

  const WorldConfig config_;
  const BlockModel block_;
  dart::simulation::WorldPtr world_;
  std::vector<BodyNode*> blocks_, spheres_;
  std::vector<Vec3> start_;  ///< directions in the spheres' frames
};

}  // namespace

TEST_CASE("integrated magnets move blocks as spheres on ball joints do") {
  const BlockModel block = paper_block();
  WorldConfig config = settled_pair(block, 0.012, 0, 7 * kDegree, 2);
  config.floor = false;
  config.gravity = 0;
  config.magnets = MagnetModel::integrated;
  config.step = 0.00005;
  // Swinging, not settled.
  for (std::size_t k = 0; k < 8; ++k) {
    Vec3& direction = config.bodies[1].magnets[k].direction;
    direction = normalised(direction + Vec3{0.3, 0.1, -0.4});
  }
  World world(config);
  NineBodies nine(config, block);
  for (int i = 0; i < 300; ++i) {
    REQUIRE(world.step().ok);
    nine.step();
  }
  const Misfit own = misfit(state(world, 0).X_WB, state(world, 1).X_WB);
  const Misfit other = misfit(nine.pose(0), nine.pose(1));
  const Misfit start = misfit(config.bodies[0].X_WB, config.bodies[1].X_WB);
  CHECK(length(own.p - start.p) > 1e-4);
  CHECK(length(own.p - other.p) < 0.01 * length(own.p - start.p));
  CHECK(std::abs(own.yaw - other.yaw) < 0.01 * std::abs(own.yaw - start.yaw));
  for (std::uint32_t k = 0; k < 8; ++k) {
    const Vec3 before = matrix(config.bodies[1].X_WB.q) * config.bodies[1].magnets[k].direction;
    const Vec3 now = world.magnet_direction(BodyId{1}, k);
    CAPTURE(length(now - before));
    CHECK(length(now - nine.direction(8 + k)) < 0.05);
  }
}
