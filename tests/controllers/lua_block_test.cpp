// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "controllers/lua_fixture.h"
#include "support/uses.h"

namespace stig {
namespace {

LuaBlockController block(const std::string& text) {
  LuaSettings settings = settings_of("b1");
  settings.limits = block_limits();
  return {{"block.lua", text}, settings};
}

LuaBlockController our_block() {
  FileError error;
  const auto program = read_lua_program(STIG_SOURCE_DIR "/blocks/stigmergic.lua", error);
  REQUIRE(program);
  return block(program->text);
}

BlockCommands step(LuaBlockController& controller, std::vector<std::vector<Message>> radios) {
  BlockCommands commands;
  BlockReadings readings;
  readings.radios = std::move(radios);
  const auto status = controller.step(readings, commands);
  CHECK(status.error == "");
  return commands;
}

TEST_CASE("the paper's program: a message's first byte sets all LEDs") {
  LuaBlockController controller = our_block();
  BlockCommands commands;
  REQUIRE(controller.init(commands).ok);
  CHECK(commands.all_leds == 0);
  CHECK(!step(controller, std::vector<std::vector<Message>>(6)).all_leds);
  for (std::size_t radio = 0; radio < 6; ++radio) {
    std::vector<std::vector<Message>> radios(6);
    radios[radio] = {"3"};
    CHECK(step(controller, radios).all_leds == 3);
  }
  CHECK(step(controller, {{}, {"4 and more"}, {}, {}, {}, {}}).all_leds == 4);
  CHECK(step(controller, {{"2"}, {}, {}, {}, {}, {}}).all_leds == 2);
  // A code word: the four LEDs of each face.
  const BlockCommands word = step(controller, {{"w1234"}, {}, {}, {}, {}, {}});
  REQUIRE(word.leds.size() == kBlockLeds);
  for (std::size_t i = 0; i < kBlockLeds; ++i) {
    CHECK(word.leds[i] == std::pair(i, static_cast<std::uint8_t>(i % 4 + 1)));
  }
  CHECK(step(controller, {{"5"}, {}, {}, {}, {}, {}}).all_leds == 0);
  CHECK(step(controller, {{""}, {}, {}, {}, {}, {}}).all_leds == 0);
}

TEST_CASE("our block answers what it is told on the same radio, and leaves answers alone") {
  LuaBlockController controller = our_block();
  BlockCommands commands;
  REQUIRE(controller.init(commands).ok);
  const BlockCommands told = step(controller, {{}, {}, {}, {}, {"3", "w1234"}, {}});
  REQUIRE(told.sends.size() == 6);
  CHECK(told.sends[4] == std::vector<Message>{"a3", "aw1234"});
  for (const std::size_t other : {0, 1, 2, 3, 5}) CHECK(told.sends[other].empty());
  // A neighbour's, which is not for it.
  const BlockCommands heard = step(controller, {{"a4"}, {}, {}, {}, {}, {}});
  CHECK(!heard.all_leds);
  for (const auto& sent : heard.sends) CHECK(sent.empty());
}

TEST_CASE("our block passes on by its lowest face what follows a p, and one answer back") {
  LuaBlockController controller = our_block();
  BlockCommands commands;
  REQUIRE(controller.init(commands).ok);
  for (const std::size_t asked : {0, 3, 4}) {
    // The last of these to be passed on once more.
    for (const std::string word : {"2", "w1234", "pw1234"}) {
      std::vector<std::vector<Message>> radios(6);
      radios[asked] = {"p" + word};
      const BlockCommands passed = step(controller, radios);
      CHECK(!passed.all_leds);
      for (std::size_t i = 0; i < 6; ++i) {
        CHECK(passed.sends[i] == (i == 5 ? std::vector<Message>{word} : std::vector<Message>{}));
      }
      // A neighbour's answer at another face is not the one that is awaited.
      for (const auto& sent : step(controller, {{}, {"a1"}, {}, {}, {}, {}}).sends) {
        CHECK(sent.empty());
      }
      const BlockCommands answered = step(controller, {{}, {}, {}, {}, {}, {"a" + word, "a1"}});
      CHECK(!answered.all_leds);
      for (std::size_t i = 0; i < 6; ++i) {
        CHECK(answered.sends[i] ==
              (i == asked ? std::vector<Message>{"a" + word} : std::vector<Message>{}));
      }
    }
  }
}

TEST_CASE("LEDs one by one, colours by number and name, radios of six faces") {
  LuaBlockController controller = block(R"(function step()
    local leds = robot.directional_leds
    leds.set_single_color(1, 'Q2')
    leds.set_all_colors('magenta')
    leds.set_single_color(24, 3)
    leds.set_single_color(24, 'blue')
    for name, radio in pairs(robot.simple_radios) do radio.send(name) end
    log(robot.id, ' ', robot.system.time)
  end)");
  BlockCommands commands;
  REQUIRE(controller.init(commands).ok);
  commands = step(controller, {});
  CHECK(commands.all_leds == 1);
  CHECK(commands.leds == std::vector<std::pair<std::size_t, std::uint8_t>>{{23, 4}});
  REQUIRE(commands.sends.size() == 6);
  const std::vector<std::string> names{"north", "east", "south", "west", "top", "bottom"};
  for (std::size_t i = 0; i < 6; ++i) CHECK(commands.sends[i] == std::vector<Message>{names[i]});
  CHECK(joined(commands.log) == "b1 0.0");
}

TEST_CASE("wrong colours and places are refused") {
  for (const char* call : {"set_all_colors(5)", "set_all_colors('red')", "set_all_colors()",
                           "set_single_color(0, 1)", "set_single_color(25, 1)"}) {
    CAPTURE(call);
    LuaBlockController controller = block("robot.directional_leds." + std::string(call));
    BlockCommands commands;
    const auto status = controller.init(commands);
    CHECK(status.error.find("directional_leds.set_") != std::string::npos);
    CHECK(status.error.starts_with("block.lua:1: "));
  }
}

}  // namespace
}  // namespace stig
