// SPDX-License-Identifier: MIT
// A block in hand is one joint: with the same break loads and poses as by its points of contact.
#include <cmath>

#include "physical/robots/stage.h"
#include "physical/support.h"

using namespace stig;

namespace {

constexpr double kSamePose = 0.1e-3;  ///< m

/// The robot of 2017 with a block in hand, lifted.
struct Carrier {
  Stage stage{"bebot.yaml"};
  std::uint32_t block = 0;

  explicit Carrier(bool grasps) {
    stage.config.grasps = grasps;
    block = static_cast<std::uint32_t>(stage.config.bodies.size());
    stage.config.bodies.push_back(
        block_body(paper_block(), {{0.093755, 0.001, 0.0275 - 1e-5}, {}}));
    stage.begin();
    stage.run(6);  // charges
    stage.discharge(Discharge::constructive);
    stage.run(1);
    stage.discharge(Discharge::disable);
    stage.lift_to(0.06);
    stage.run(2);
  }
  Pose in_robot() const { return inverse(stage.place()) * stage.world->state(BodyId{block}).X_WB; }
  bool held_by_joint() const { return stage.world->grasp_count() > 0; }
};

/// What a pull that grows by 1 N/s (or 0.02 N·m/s) does.
struct Pulled {
  double load = 0;  ///< s until the block was off by 1 mm
  Pose before;      ///< of the block in the robot, at nine tenths of the way to `until`
};

Pulled pulled(Carrier& carrier, const Vec3& force, const Vec3& torque, double until) {
  Pulled out;
  World& world = *carrier.stage.world;
  const Pose start = carrier.in_robot();
  const double step = carrier.stage.config.step;
  for (int i = 1; out.load < 12; ++i) {
    out.load = i * step;
    world.push(BodyId{carrier.block}, force * out.load, torque * (0.02 * out.load));
    carrier.stage.run(step);
    const Pose now = carrier.in_robot();
    if (out.load <= 0.9 * until) out.before = now;
    const double turn = angle_of(now.q * conjugate(start.q));
    if (length(now.p - start.p) > 1e-3 || turn > 0.03) return out;
  }
  return out;
}

}  // namespace

TEST_CASE("a block in hand is one joint, and breaks off under the loads that contacts bear") {
  const struct {
    const char* name;
    Vec3 force, torque;
  } pulls[] = {{"down", {0, 0, -1}, {}},          {"forward", {1, 0, 0}, {}},
               {"sideways", {0, 1, 0}, {}},       {"turned about z", {}, {0, 0, 1}},
               {"turned about y", {}, {0, 1, 0}}, {"askew", {0.5, 0.5, -0.5}, {0.3, 0, 0.3}}};
  for (const auto& pull : pulls) {
    CAPTURE(std::string(pull.name));
    Carrier by_contacts(false), by_joint(true);
    CHECK(!by_contacts.held_by_joint());
    REQUIRE(by_joint.held_by_joint());
    CHECK(length(by_joint.in_robot().p - by_contacts.in_robot().p) < kSamePose);
    const Pulled contacts = pulled(by_contacts, pull.force, pull.torque, 0);
    const Pulled joint = pulled(by_joint, pull.force, pull.torque, contacts.load);
    CHECK(!by_joint.held_by_joint());
    CHECK(joint.load == doctest::Approx(contacts.load).epsilon(0.02));
    Carrier again(false);
    const Pulled shorter = pulled(again, pull.force, pull.torque, contacts.load);
    CHECK(length(joint.before.p - shorter.before.p) < kSamePose);
  }
}

TEST_CASE("a block that is driven about, turned and lifted stays where contacts would have it") {
  Carrier by_contacts(false), by_joint(true);
  const auto both = [&](const auto& act) { act(by_contacts.stage), act(by_joint.stage); };
  int looks = 0, held = 0;
  const auto drive = [&](double left, double right, double seconds) {
    for (double t = 0; t < seconds; t += 0.1) {
      both([&](Stage& stage) {
        stage.wheels(left, right);
        stage.run(0.1);
      });
      const Pose one = by_contacts.in_robot(), other = by_joint.in_robot();
      CHECK(length(one.p - other.p) < kSamePose);
      CHECK(angle_of(one.q * conjugate(other.q)) < 0.002);
      ++looks;
      held += by_joint.held_by_joint() ? 1 : 0;
    }
  };
  drive(0.15, 0.15, 1);
  drive(0, 0, 0.5);
  drive(-0.08, 0.08, 1);
  drive(0.05, 0.12, 1.5);
  both([](Stage& stage) { stage.lift_to(0.1); });
  drive(-0.1, -0.1, 1.5);
  both([](Stage& stage) { stage.lift_to(0.03); });
  drive(0, 0, 1.5);
  CHECK(by_joint.held_by_joint());
  // A start or a stop at once is more than contacts bear without a slip.
  CHECK(held > looks * 9 / 10);
}

TEST_CASE("what touches the block in hand ends the joint, and what takes it away, too") {
  Carrier carrier(true);
  REQUIRE(carrier.held_by_joint());
  SUBCASE("another block comes from the side") {
    const Pose X_WB = carrier.stage.world->state(BodyId{carrier.block}).X_WB;
    Addition other;
    other.bodies.push_back(block_body(without_magnets(paper_block()), X_WB));
    other.bodies[0].X_WB.p.y += 0.058;
    other.bodies[0].fixed = true;
    const AddResult added = carrier.stage.world->add(other);
    REQUIRE(added.problem.empty());
    carrier.stage.world->set_velocity(added.body, {0, -0.02, 0}, {});
    bool ended = false;
    for (int i = 0; i < 100 && !ended; ++i) {
      carrier.stage.run(carrier.stage.config.step);
      ended = !carrier.held_by_joint();
    }
    CHECK(ended);
  }
  SUBCASE("by hand") {
    REQUIRE(carrier.stage.world->place(BodyId{carrier.block}, {{0.5, 0.5, 0.0275}, {}})
                .problem.empty());
    CHECK(!carrier.held_by_joint());
  }
  SUBCASE("the magnets turn") {
    carrier.stage.discharge(Discharge::destructive);
    carrier.stage.run(0.5);
    CHECK(!carrier.held_by_joint());
  }
}

TEST_CASE("joints of blocks in hand are part of checkpoints, and damaged ones bring nothing back") {
  Carrier carrier(true);
  World& world = *carrier.stage.world;
  const std::string bytes = world.checkpoint();
  World resumed(carrier.stage.config);
  REQUIRE(resumed.resume(bytes));
  CHECK(resumed.grasp_count() == 1);
  CHECK(resumed.checkpoint() == bytes);
  run(world, 0.5), run(resumed, 0.5);
  CHECK(resumed.checkpoint() == world.checkpoint());
  // The last part of the bytes is about the grasp: whatever becomes of it, no crash.
  World other(carrier.stage.config);
  for (std::size_t from_end = 1; from_end <= 800 && from_end < bytes.size(); from_end += 3) {
    for (const char change : {'\x01', '\x80', '\xff'}) {
      std::string damaged = bytes;
      damaged[bytes.size() - from_end] ^= change;
      if (!other.resume(damaged)) continue;
      for (int i = 0; i < 3 && other.step().ok; ++i) continue;
    }
    CHECK(!other.resume(bytes.substr(0, bytes.size() - from_end)));
  }
}
