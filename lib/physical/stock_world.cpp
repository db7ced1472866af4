// SPDX-License-Identifier: MIT
#include "physical/stock_world.h"

#include <cassert>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include "physical/dart_lock.h"
#include "physical/world_state.h"

namespace stig {

namespace {

using namespace dart::dynamics;

constexpr double kFloorHalf = 50;  ///< m: the floor is a box, its upper face at z = 0

Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 vec3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Isometry3d eigen(const Pose& pose) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear() = Eigen::Quaterniond(pose.q.w, pose.q.x, pose.q.y, pose.q.z).toRotationMatrix();
  out.translation() = eigen(pose.p);
  return out;
}

ShapePtr shape_of(const Shape& shape) {
  if (shape.kind == ShapeKind::sphere) return std::make_shared<SphereShape>(shape.half.x);
  return std::make_shared<BoxShape>(eigen(shape.half * 2));
}

void add_shape(BodyNode& body, const ShapePtr& shape, double friction) {
  auto* node = body.createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape);
  node->getDynamicsAspect()->setFrictionCoeff(friction);
  node->getDynamicsAspect()->setRestitutionCoeff(0);
}

BodyNode* add_welded(dart::simulation::World& world, const std::string& name,
                     const Eigen::Isometry3d& place) {
  const SkeletonPtr skeleton = Skeleton::create(name);
  const auto [joint, body] = skeleton->createJointAndBodyNodePair<WeldJoint>();
  joint->setTransformFromParentBodyNode(place);
  world.addSkeleton(skeleton);
  return body;
}

BodyNode* add_free(dart::simulation::World& world, const std::string& name, const BodyDef& def) {
  const SkeletonPtr skeleton = Skeleton::create(name);
  const auto [joint, body] = skeleton->createJointAndBodyNodePair<FreeJoint>();
  const Vec3 i = inertia_of(def);
  body->setInertia(Inertia(def.mass, Eigen::Vector3d::Zero(), eigen(i).asDiagonal()));
  FreeJoint::setTransformOf(body, eigen(def.X_WB));
  joint->setLinearVelocity(eigen(def.velocity));
  joint->setAngularVelocity(eigen(def.spin));
  world.addSkeleton(skeleton);
  return body;
}

}  // namespace

struct StockWorld::Dart {
  dart::simulation::WorldPtr world;
  std::vector<BodyNode*> nodes;
  WorldState state;  ///< for forces alone; its poses follow DART's
};

StockWorld::StockWorld(const WorldConfig& config) {
  const std::lock_guard lock(dart_lock());
  dart_ = std::make_unique<Dart>();
  dart_->state = make_world_state(config);
  dart_->world = dart::simulation::World::create();
  dart::simulation::World& world = *dart_->world;
  world.setTimeStep(config.step);
  world.setGravity(Eigen::Vector3d::Zero());  // among the forces already
  auto* solver = world.getConstraintSolver();
  solver->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  solver->getCollisionOption().maxNumContacts = 100 * (config.bodies.size() + 1);
  for (std::size_t i = 0; i < config.bodies.size(); ++i) {
    const BodyDef& def = config.bodies[i];
    const std::string name = std::to_string(i);
    dart_->nodes.push_back(def.fixed ? add_welded(world, name, eigen(def.X_WB))
                                     : add_free(world, name, def));
    add_shape(*dart_->nodes.back(), shape_of(def.shape),
              friction_of(config, def.material, def.material));
  }
  if (!config.floor) return;
  BodyNode* floor = add_welded(world, "floor", eigen(Pose{{0, 0, -kFloorHalf}, {}}));
  add_shape(*floor, shape_of({ShapeKind::box, {kFloorHalf, kFloorHalf, kFloorHalf}}),
            friction_of(config, kFloorMaterial, kFloorMaterial));
}

StockWorld::~StockWorld() {
  const std::lock_guard lock(dart_lock());
  dart_.reset();
}

StepResult StockWorld::step() {
  WorldState& state = dart_->state;
  refresh_lists(state);
  gather_forces(state);
  for (std::size_t i = 0; i < dart_->nodes.size(); ++i) {
    Body& body = state.bodies[i];
    // DART's library aborts on what is not finite.
    if (!is_finite(body.force) || !is_finite(body.torque) || !is_finite(body.p)) {
      return {false, BodyId{static_cast<std::uint32_t>(i)}};
    }
    if (body.fixed) continue;
    dart_->nodes[i]->addExtForce(eigen(body.force), Eigen::Vector3d::Zero(), false, true);
    dart_->nodes[i]->addExtTorque(eigen(body.torque), false);
    body.user_force = body.user_torque = {};
  }
  dart_->world->step();
  for (std::size_t i = 0; i < dart_->nodes.size(); ++i) {
    Body& body = state.bodies[i];
    const Eigen::Isometry3d pose = dart_->nodes[i]->getWorldTransform();
    const Eigen::Quaterniond q(pose.linear());
    body.p = vec3(pose.translation());
    body.q = normalised(Quat{q.w(), q.x(), q.y(), q.z()});
    body.r = matrix(body.q);
    body.v = vec3(dart_->nodes[i]->getLinearVelocity());
    body.w = vec3(dart_->nodes[i]->getAngularVelocity());
  }
  ++state.tick;
  return {};
}

BodyState StockWorld::state(BodyId id) const {
  return state_of(dart_->state, static_cast<std::uint32_t>(id));
}

void StockWorld::push(BodyId id, const Vec3& force, const Vec3& torque) {
  Body& body = dart_->state.bodies.at(static_cast<std::size_t>(id));
  body.user_force += force;
  body.user_torque += torque;
}

}  // namespace stig
