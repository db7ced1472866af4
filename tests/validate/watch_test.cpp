// SPDX-License-Identifier: MIT
#include "validate/watch.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include "support.h"

namespace stig {
namespace {

const WatchedHand kFarHand{{0, 0, 10}};

/// A hand that holds the block.
WatchedHand hand_on(const WatchedBlock& block) {
  return {block.X_WB.p + Vec3{0, 0, 0.0275 + 0.001}};
}

/// A staircase that grows, five looks a second.
struct Growing : Staircase {
  Watch watch{target};
  double time = 0;
  std::vector<WatchedBlock> there{blocks[0]};
  std::vector<WatchedHand> hands{kFarHand};

  void look(double seconds) {
    for (int i = 0; i < seconds * 5 - 1e-9; ++i) {
      watch.look(time, there, hands);
      time += 0.2;
    }
  }
  /// Puts a block on its way, a metre off, and then to its cell.
  void bring(std::size_t number) {
    there.push_back(blocks[number]);
    there.back().X_WB.p += Vec3{1, 0, 0};
    hands[0] = hand_on(there.back());
    look(1);
    there.back() = blocks[number];
    hands[0] = hand_on(there.back());
    look(3);
    hands[0] = kFarHand;
    look(2);
  }
};

TEST_CASE("a block is a brick once it has been let go for a second") {
  Growing g;
  g.look(1);
  CHECK(g.watch.bricks(0).size() == 1);
  g.there.push_back(g.blocks[1]);
  g.hands[0] = hand_on(g.there.back());
  g.look(5);
  CHECK(g.watch.events().empty());
  CHECK(g.watch.holding(0));
  CHECK(g.watch.held(1));
  const double let_go = g.time;
  g.hands[0] = kFarHand;
  g.look(0.8);
  CHECK(g.watch.events().empty());
  g.look(0.6);
  REQUIRE(g.watch.events().size() == 1);
  const BrickEvent& event = g.watch.events()[0];
  CHECK(event.kind == BrickEvent::Kind::placed);
  CHECK(event.block == 1);
  CHECK(event.cell == g.order[0].at);
  CHECK(event.led == led_of(g.set.rules, g.order[0].brick));
  CHECK(event.robot == 0);
  CHECK(event.time <= let_go + 1e-9);
  CHECK(event.time > let_go - 0.3);
}

TEST_CASE("a fixed block between cells is no brick, and never left") {
  Growing g;
  g.there.push_back(g.blocks[0]);
  g.there.back().block = 9;
  g.there.back().X_WB.p += Vec3{0.3, 0, 0.02};
  g.look(5);
  CHECK(g.watch.bricks(0).size() == 1);
  CHECK(g.watch.events().empty());
}

TEST_CASE("a whole staircase stands, its placements in order, each an attempt that succeeded") {
  Growing g;
  for (std::size_t i = 1; i < g.blocks.size(); ++i) {
    CHECK_FALSE(stands(g.target, 0, g.watch));
    g.bring(i);
  }
  CHECK(stands(g.target, 0, g.watch));
  REQUIRE(g.watch.events().size() == 5);
  for (std::size_t i = 0; i < 5; ++i) CHECK(g.watch.events()[i].cell == g.order[i].at);
  const std::vector<Haul> hauls = g.watch.hauls();
  REQUIRE(hauls.size() == 5);
  CHECK(hauls[4].placed == g.order[4].at);
  CHECK(hauls[4].ended);
  CHECK(hauls[4].way == doctest::Approx(1));
  CHECK(judge(g.target, 0, g.there, g.watch.events()).verdict == BuildVerdict::complete);
}

TEST_CASE("a colour that is not the brick's does not stand") {
  Growing g;
  for (std::size_t i = 1; i < g.blocks.size(); ++i) g.bring(i);
  CHECK_FALSE(spoilt(g.target, 0, g.watch));
  g.there[3].led = Led::off;
  g.look(0.2);
  CHECK_FALSE(stands(g.target, 0, g.watch));
  CHECK(spoilt(g.target, 0, g.watch));
}

TEST_CASE("what moves, floats alone or lies askew is no brick") {
  Growing g;
  g.there.push_back(g.blocks[1]);
  for (int i = 0; i < 20; ++i) {
    g.there.back().X_WB.p.z += i % 2 == 0 ? 0.0008 : -0.0008;
    g.look(0.2);
  }
  CHECK(g.watch.events().empty());
  g.there.back() = g.block(1, {4, 0, 0}, Led::q2);
  g.look(3);
  CHECK(g.watch.events().empty());
  g.there.back() = g.blocks[1];
  g.there.back().X_WB.p += Vec3{0.013, 0, 0};
  g.look(3);
  CHECK(g.watch.events().empty());
}

TEST_CASE("a brick that leaves is told, and that which comes again") {
  Growing g;
  g.bring(1);
  REQUIRE(g.watch.events().size() == 1);
  g.there.back().X_WB.p += Vec3{0.05, 0.05, 0};
  g.look(0.2);
  REQUIRE(g.watch.events().size() == 2);
  CHECK(g.watch.events()[1].kind == BrickEvent::Kind::left);
  CHECK(g.watch.events()[1].cell == g.order[0].at);
  CHECK(g.watch.bricks(0).size() == 1);
  g.there.back() = g.blocks[1];
  g.look(2);
  REQUIRE(g.watch.events().size() == 3);
  CHECK(g.watch.events()[2].kind == BrickEvent::Kind::placed);
  g.there.pop_back();  // out of the arena
  g.look(0.2);
  REQUIRE(g.watch.events().size() == 4);
  CHECK(g.watch.events()[3].kind == BrickEvent::Kind::left);
}

TEST_CASE("an attempt that comes to nothing") {
  Growing g;
  g.there.push_back(g.block(7, {9, 0, 0}, Led::off));
  g.hands[0] = hand_on(g.there.back());
  g.look(1);
  g.there.back() = g.block(7, {5, 0, 0}, Led::off);
  g.hands[0] = hand_on(g.there.back());
  g.look(1);
  REQUIRE(g.watch.hauls().size() == 1);
  CHECK_FALSE(g.watch.hauls()[0].ended);
  g.hands[0] = kFarHand;
  g.look(3);
  REQUIRE(g.watch.hauls().size() == 1);
  CHECK(g.watch.hauls()[0].ended);
  CHECK_FALSE(g.watch.hauls()[0].placed);
  CHECK(g.watch.hauls()[0].way == doctest::Approx(4 * 0.055));
  CHECK_FALSE(g.watch.holding(0));
}

}  // namespace
}  // namespace stig
