// SPDX-License-Identifier: MIT
// The same world with DART's own step in place of this library's solver: slow, and for comparison
// alone (docs/physics.md). Forces, magnets, sleep and events stay ours; DART gets bodies, contacts
// and friction.
#include <Eigen/Geometry>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/config.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include "physical/dynamics/dart_lock.h"
#include "physical/dynamics/stock_step.h"
#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

using namespace dart::dynamics;

// DART's collision detector knows no half space.
constexpr double kFloorHalf = 50;  ///< m: the floor is a box, its upper face at z = 0

Eigen::Vector3d to_dart(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 from_dart(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Isometry3d to_dart(const Pose& pose) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear() = Eigen::Quaterniond(pose.q.w, pose.q.x, pose.q.y, pose.q.z).toRotationMatrix();
  out.translation() = to_dart(pose.p);
  return out;
}

ShapePtr shape_of(const Shape& shape) {
  if (shape.kind == ShapeKind::sphere) return std::make_shared<SphereShape>(shape.half.x);
  return std::make_shared<BoxShape>(to_dart(shape.half * 2));
}

// Friction between two is what DART makes of both coefficients, so pairs are not the same as ours.
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

/// A fixed body moves as it is told, whatever is in its way.
BodyNode* add_body(dart::simulation::World& world, const std::string& name, const Body& body) {
  const SkeletonPtr skeleton = Skeleton::create(name);
  const auto [joint, node] = skeleton->createJointAndBodyNodePair<FreeJoint>();
  node->setInertia(Inertia(body.mass, Eigen::Vector3d::Zero(), to_dart(body.inertia).asDiagonal()));
  if (body.fixed) joint->setActuatorType(Joint::VELOCITY);
  world.addSkeleton(skeleton);
  return node;
}

FreeJoint& joint_of(BodyNode& node) { return static_cast<FreeJoint&>(*node.getParentJoint()); }

/// Before a step.
void set_state(BodyNode& node, const Body& body) {
  FreeJoint& joint = joint_of(node);
  FreeJoint::setTransformOf(&node, to_dart(Pose{body.p, body.q}));
  joint.setLinearVelocity(to_dart(body.v));
  joint.setAngularVelocity(to_dart(body.w));
  // A fixed body keeps the velocity that it is commanded, whatever pushes.
  if (body.fixed) {
    joint.setCommands(joint.getVelocities());
    return;
  }
  node.addExtForce(to_dart(body.force), Eigen::Vector3d::Zero(), false, true);
  node.addExtTorque(to_dart(body.torque), false);
}

}  // namespace

std::string dart_version() { return DART_VERSION; }

struct StockStep::Dart {
  dart::simulation::WorldPtr world;
  std::vector<BodyNode*> nodes;  ///< null: has left
};

StockStep::StockStep(const WorldState& state) {
  const std::lock_guard lock(dart_lock());
  const WorldConfig& config = state.config;
  dart_ = std::make_unique<Dart>();
  dart_->world = dart::simulation::World::create();
  dart::simulation::World& world = *dart_->world;
  world.setTimeStep(config.step);
  world.setGravity(Eigen::Vector3d::Zero());  // among the forces already
  auto* solver = world.getConstraintSolver();
  solver->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  // The default is too few for a heap.
  solver->getCollisionOption().maxNumContacts = 100 * (state.bodies.size() + 1);
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    const Body& body = state.bodies[i];
    dart_->nodes.push_back(body.left ? nullptr : add_body(world, std::to_string(i), body));
    if (body.left) continue;
    add_shape(*dart_->nodes.back(), shape_of(body.shape),
              body.grip * friction_of(config, body.material, body.material));
  }
  if (!config.floor) return;
  BodyNode* floor = add_welded(world, "floor", to_dart(Pose{{0, 0, -kFloorHalf}, {}}));
  add_shape(*floor, shape_of(Shape::box(Vec3{2, 2, 2} * kFloorHalf)),
            friction_of(config, kFloorMaterial, kFloorMaterial));
}

StockStep::~StockStep() {
  const std::lock_guard lock(dart_lock());
  dart_.reset();
}

void StockStep::solve(WorldState& world) {
  for (std::size_t i = 0; i < dart_->nodes.size(); ++i) {
    if (dart_->nodes[i] != nullptr) set_state(*dart_->nodes[i], world.bodies[i]);
  }
  dart_->world->step();
  for (const std::uint32_t i : world.awake) {
    Body& body = world.bodies[i];
    // Contacts that DART found are not ours: none is in free flight, for our purposes.
    body.free = false;
    if (body.fixed) continue;
    body.v = from_dart(dart_->nodes[i]->getLinearVelocity());
    body.w = from_dart(dart_->nodes[i]->getAngularVelocity());
  }
}

void StockStep::move(WorldState& world) const {
  for (const std::uint32_t i : world.awake) {
    Body& body = world.bodies[i];
    const Eigen::Isometry3d pose = dart_->nodes[i]->getWorldTransform();
    const Eigen::Quaterniond q(pose.linear());
    body.p = from_dart(pose.translation());
    body.q = normalised(Quat{q.w(), q.x(), q.y(), q.z()});
    body.r = matrix(body.q);
  }
}

}  // namespace stig::physics
