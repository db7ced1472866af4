// SPDX-License-Identifier: MIT
// The interface level of 2019: its names, its anchors, its modules, and that it leads nowhere.
#include <doctest/doctest.h>

#include "controllers/lua_fixture.h"
#include "lua/module_search.h"
#include "support/shipped_robot.h"
#include "support/uses.h"

namespace stig {
namespace {

LuaProgram of_2019(const std::string& text) {
  LuaProgram program{"part/test.lua", text, {}, true, InterfaceLevel::of_2019};
  program.modules = {{"part/Tools/one.lua", "return 'one of tools'"},
                     {"other/two.lua", "return ... .. '!'"}};
  return program;
}

RobotReadings readings_of(const RobotModel& model) {
  RobotReadings readings;
  readings.cameras.resize(model.cameras.size());
  readings.rangefinders.resize(model.rangefinders.size());
  readings.radios = {{Message("\x33x")}};
  return readings;
}

/// What a program says until the end of its first step that is called.
std::string told(const std::string& text) {
  const RobotModel model = shipped_robot("builderbot-2019.yaml");
  const RobotReadings readings = readings_of(model);
  LuaController controller(of_2019(text), model, settings_of());
  RobotCommands commands;
  ControllerStatus status = controller.init(commands);
  for (int i = 0; i < 2 && status.ok; ++i) status = controller.step(readings, commands);
  return status.ok ? joined(commands.log) : status.error;
}
bool has(const std::string& text, const std::string& words) {
  INFO(text);
  return text.find(words) != std::string::npos;
}

TEST_CASE("candidates of a name follow the templates, and none leads out") {
  using Files = std::vector<std::string>;
  CHECK(module_candidates("a.b", "./?.lua;Tools/?.lua", "dir/p.lua") ==
        Files{"a/b.lua", "dir/a/b.lua", "Tools/a/b.lua", "dir/Tools/a/b.lua"});
  CHECK(module_candidates("a", "?/?.lua", "p.lua") == Files{"a/a.lua"});
  for (const char* bad : {"/etc/?.lua", "../?.lua", "a/../../?.lua", "fixed.lua", "a//?.lua",
                          "\\?.lua", "./../?.lua", "..?.lua/../x"}) {
    CAPTURE(bad);
    CHECK(module_candidates("a", bad, "p.lua").empty());
  }
  for (const char* bad : {"", ".", "..", "a..b", "/a", "a/", "../a", "a b", "a\nb"}) {
    CAPTURE(bad);
    CHECK_FALSE(is_module_search_name(bad));
    CHECK(module_candidates(bad, "?.lua", "p.lua").empty());
  }
}

TEST_CASE("names and templates that a text writes are found in it") {
  WrittenModules written;
  written.add_text(
      "package.path = package.path .. ';Tools/?.lua;x/?.lua'\nrequire(\"a.b\")\n"
      "local its = nil -- 'c'\nlocal name = 'd' .. number\n'not closed\n");
  CHECK(written.templates == "./?.lua;./?/init.lua;Tools/?.lua;x/?.lua");
  CHECK(written.names == std::vector<std::string>{"a.b", "c", "d"});
}

TEST_CASE("require goes by package.path, and modules are run once") {
  CHECK(
      told("package.path = package.path .. ';Tools/?.lua;other/?.lua'\n"
           "function step() print(require('one'), require('t' .. 'wo'), package.loaded.two) end") ==
      "one of tools\ttwo!\ttwo!");
  CHECK(has(told("package.path = 7.5 require 'one'"), "package.path is no text"));
  CHECK(has(told("package.path = nil require 'one'"), "package.path is no text"));
  CHECK(has(told("require '../one'"), "a name of letters"));
}

TEST_CASE("debug and io are there, and do no harm") {
  CHECK(told("local info = debug.getinfo(1) function step()\n"
             "print(info.short_src, info.currentline, debug.getinfo(step).linedefined,\n"
             "debug.getinfo(99), io.open('x'), io.read()) end") ==
        "part/test.lua\t1\t1\tnil\tnil\tnil");
  CHECK(has(told("function step() print(debug.traceback('here')) end"), "here\nstack traceback"));
  CHECK(told("function step() io.write('a', 1) debug.sethook(print, 'lcr') end") == "a1");
  for (const char* name :
       {"debug.getlocal", "debug.getupvalue", "debug.setmetatable", "debug.getregistry",
        "debug.getinfo(1).func", "io.popen", "io.lines", "package.loadlib", "os", "dofile"}) {
    CHECK(told(std::string("function step() print(") + name + ") end") == "nil");
  }
}

TEST_CASE("radios and places are told as in 2019") {
  CHECK(told("function step() local m = robot.nfc.rx_data[1]\n"
             "print(#robot.nfc.rx_data, m[1], robot.radios.nfc.rx_data[1][2]) end") ==
        "1\t51\t120");
  CHECK(
      told("function step() print(robot.radios.nfc.tx_data == robot.simple_radios.nfc.send) end") ==
      "true");
  const std::string places = told(
      "function step()\nfor _, name in ipairs { '1', '12', 'underneath' } do\n"
      "local t = robot.rangefinders[name].transform\n"
      "print(t.anchor, string.format('%.4f %.4f %.4f', t.position.x, t.position.y, t.position.z))\n"
      "end\nlocal t = robot.camera_system.transform\n"
      "print(t.anchor, string.format('%.3f', t.position.z)) end");
  CHECK(places ==
        "origin\t0.0640 -0.0175 0.0515\norigin\t0.0640 0.0175 0.0515\n"
        "end_effector\t0.0000 0.0000 0.0000\nend_effector\t0.075");
}

TEST_CASE("robots and blocks of 2019 answer by the radio that something came by") {
  // Each byte one more, and a text after it.
  const std::string answer = R"(
function step()
   for name, radio in pairs(robot.radios) do
      for _, message in ipairs(radio.rx_data) do
         for i, byte in ipairs(message) do message[i] = byte + 1 end
         radio.tx_data(message)
         radio.tx_data('from ' .. name)
      end
   end
end)";
  const RobotModel model = shipped_robot("builderbot-2019.yaml");
  LuaController robot(of_2019(answer), model, settings_of());
  RobotCommands commands;
  REQUIRE(robot.init(commands).ok);
  for (int i = 0; i < 2; ++i) REQUIRE(robot.step(readings_of(model), commands).error == "");
  REQUIRE(commands.sends.size() == 1);
  CHECK(commands.sends[0] == std::vector<Message>{"4y", "from nfc"});

  LuaBlockController block(of_2019(answer), settings_of());
  BlockCommands told_to;
  BlockReadings heard;
  heard.radios.resize(kBlockRadios);
  heard.radios[2] = {Message("ab")};
  REQUIRE(block.init(told_to).ok);
  REQUIRE(block.step(heard, told_to).error == "");
  CHECK(told_to.sends.at(2) == std::vector<Message>{"bc", "from south"});
}

TEST_CASE("arrows of robot.debug are those of robot.show") {
  LuaController controller(
      of_2019("function step() robot.debug.draw('arrow(red)(0,0,0)(' .. vector3(1, 2, "
              "3):__tostring() .. ')')\n"
              "robot.debug.draw('ring(red)(0,0,0)(0.1)') robot.debug.log('said') end"),
      shipped_robot("builderbot-2019.yaml"), settings_of());
  RobotCommands commands;
  const RobotReadings readings = readings_of(shipped_robot("builderbot-2019.yaml"));
  CHECK(controller.init(commands).ok);
  CHECK(controller.step(readings, commands).ok);
  CHECK(commands.user.arrows.empty());  // the first tick is init's alone
  CHECK(controller.step(readings, commands).error == "");
  REQUIRE(commands.user.arrows.size() == 1);
  CHECK(commands.user.arrows[0].to.y == 2);
  CHECK(commands.user.arrows[0].rgb == Rgb{255, 0, 0});
  CHECK(commands.log == std::vector<std::string>{"said"});
}

}  // namespace
}  // namespace stig
