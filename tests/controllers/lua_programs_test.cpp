// SPDX-License-Identifier: MIT
// Two programs written for the real robot's interface, against readings made up for them.
#include <doctest/doctest.h>

#include <tuple>

#include "controllers/lua_fixture.h"
#include "support/uses.h"

namespace stig {
namespace {

std::string program(const std::string& name) {
  FileError error;
  const auto read = read_lua_program(STIG_TESTS_DIR "/controllers/" + name, error);
  REQUIRE(read);
  return read->text;
}

RobotModel ringed_robot() {
  RobotModel model = whole_robot();
  model.rangefinders.clear();
  for (int i = 1; i <= 12; ++i) {
    model.rangefinders.push_back({std::to_string(i), 0, {}, {1, 0, 0}, 0.2, {}, {}});
  }
  model.rangefinders.push_back({"underneath", 1, {}, {0, 0, -1}, 0.2, {}, {}});
  return model;
}

RobotReadings nothing_near() {
  RobotReadings readings = empty_readings();
  readings.rangefinders.assign(13, {0.05, 0});
  return readings;
}

TEST_CASE("the wall follower turns away, follows, and circles") {
  Running robot(program("wall_follower.lua"), settings_of(), ringed_robot());
  REQUIRE(robot.status.error == "");
  const auto wheels = [&](const RobotReadings& readings) {
    CHECK(robot.step(readings).error == "");
    REQUIRE(robot.commands.wheels);
    return *robot.commands.wheels;
  };
  RobotReadings readings = nothing_near();
  auto [left, right] = wheels(readings);
  CHECK(0 < left);
  CHECK(left < right);
  readings.rangefinders[3].proximity = 0.02;  // too near on the left
  std::tie(left, right) = wheels(readings);
  CHECK(left > right);
  readings.rangefinders[3].proximity = 0.04;  // too far
  std::tie(left, right) = wheels(readings);
  CHECK(left < right);
  readings.rangefinders[0].proximity = 0.02;  // ahead
  std::tie(left, right) = wheels(readings);
  CHECK(left == -right);
  CHECK(left > 0);
  CHECK(robot.commands.user.texts.at(0).second == "turn");
}

TEST_CASE("the block fetcher searches, approaches, pulls, lifts, marks and carries") {
  Running robot(program("block_fetcher.lua"), settings_of(), ringed_robot());
  REQUIRE(robot.status.error == "");
  CHECK(robot.commands.camera_enabled.at(0) == true);
  CHECK(robot.commands.lift.position == 0.135);
  RobotReadings readings = nothing_near();
  readings.cameras[0].enabled = true;
  const auto state = [&] {
    CHECK(robot.step(readings).error == "");
    readings.time += 0.2;
    return robot.commands.user.texts.at(0).second;
  };
  CHECK(state() == "search");
  CHECK(robot.commands.wheels->first == -robot.commands.wheels->second);
  TagReading tag;
  tag.p_CT = {0.01, 0, 0.2};
  tag.centre = {400, 200};
  readings.cameras[0].tags = {tag};
  CHECK(state() == "approach");
  CHECK(state() == "approach");
  CHECK(robot.commands.wheels->first > robot.commands.wheels->second);  // it is to the right
  readings.cameras[0].tags.clear();
  CHECK(state() == "reach");
  CHECK(state() == "reach");
  readings.rangefinders[12].proximity = 0.005;
  CHECK(state() == "pull");
  CHECK(state() == "pull");
  CHECK(robot.commands.discharge == Discharge::constructive);
  readings.time += 1;
  CHECK(state() == "lift");
  CHECK(state() == "lift");
  readings.time += 1;
  CHECK(state() == "carry");
  CHECK(robot.commands.sends.at(0) == std::vector<Message>{"4"});
}

TEST_CASE("the example of the documentation runs") {
  FileError error;
  const auto page = read_file(STIG_SOURCE_DIR "/docs/controllers.md", 1 << 20, error);
  REQUIRE(page);
  const std::size_t begin = page->find("```lua\n") + 7;
  Running robot(page->substr(begin, page->find("```", begin) - begin));
  REQUIRE(robot.status.error == "");
  RobotReadings readings = empty_readings();
  readings.cameras[0].tags.resize(1);
  readings.cameras[0].tags[0].p_CT = {0.1, 0, 0.3};
  CHECK(robot.step(readings).error == "");
  CHECK(robot.commands.wheels->first > robot.commands.wheels->second);
  CHECK(robot.commands.wheels->second > 0);
}

}  // namespace
}  // namespace stig
