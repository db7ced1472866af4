// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "compiler/block_figures.h"
#include "support.h"
#include "support/shipped_robot.h"
#include "support/uses.h"

namespace stig {
namespace {

TEST_CASE("the paper's robot, measured from its file, is the one of the published figures") {
  const Abilities robot = abilities_of(shipped_robot("bebot.yaml"), {});
  const Abilities paper = paper_robot();
  CHECK(robot.levels == 3);
  CHECK(robot.carried_x == doctest::Approx(paper.carried_x).epsilon(0.001));
  CHECK(robot.body_front == doctest::Approx(0.057755));
  CHECK(robot.body_back == doctest::Approx(paper.body_back).epsilon(0.001));
  CHECK(robot.body_half_width == doctest::Approx(0.04375));
  CHECK(robot.effector_front == doctest::Approx(0.129755));
  CHECK(robot.effector_half_width == doctest::Approx(0.033).epsilon(0.1));
  CHECK(robot.face_hold == doctest::Approx(9.5).epsilon(0.01));
  CHECK(robot.magnet_reach > 0.010);
  CHECK(robot.magnet_reach < 0.014);
  REQUIRE(robot.cameras.size() == 1);
  CHECK(robot.cameras[0].lifted);
  CHECK(length(robot.cameras[0].X_RC.p - paper.cameras[0].X_RC.p) < 1e-9);
  const Vec3 ahead = rotate(robot.cameras[0].X_RC.q, {0, 0, 1});
  CHECK(length(ahead - rotate(paper.cameras[0].X_RC.q, {0, 0, 1})) < 1e-9);
}

Abilities with_block(const std::string& name) {
  Diagnostics diagnostics;
  const auto block = read_block_file(STIG_SOURCE_DIR "/blocks/" + name + ".yaml", diagnostics);
  REQUIRE_MESSAGE(block, to_text(diagnostics));
  return abilities_of(shipped_robot("bebot.yaml"), figures_of(*block));
}

TEST_CASE("what is known of the block is what its file says") {
  constexpr double kDegree = M_PI / 180;
  const Abilities paper = with_block("stigmergic"), later = with_block("stigmergic-2021");
  CHECK(paper.block.tag_side == 0.024);
  CHECK(later.block.tag_side == 0.0235);
  CHECK(paper.block.proud == 0.001);
  CHECK(later.block.proud == 0.00055);
  CHECK(paper.block.led_place == 0.020);
  CHECK(paper.block.most_angle == doctest::Approx(75 * kDegree));
  CHECK(later.block.most_angle == doctest::Approx(60 * kDegree));
  CHECK(paper.friction == 0.5);
  CHECK(later.friction == 1.0);
  // Magnets 9 mm apart in place of 10 hold more; the later block's friction halves what moves.
  CHECK(later.face_hold == doctest::Approx(paper.face_hold * std::pow(10.0 / 9, 4)));
  CHECK(paper.magnet_reach == doctest::Approx(0.0105).epsilon(0.01));
  CHECK(later.magnet_reach == doctest::Approx(0.0082).epsilon(0.01));
}

TEST_CASE("a robot that cannot build says what it lacks") {
  CHECK(lacking(shipped_robot("bebot.yaml")).empty());
  CHECK(lacking(shipped_robot("builderbot.yaml")).empty());
  CHECK(lacking(RobotModel{}).size() == 5);
}

}  // namespace
}  // namespace stig
