// SPDX-License-Identifier: MIT
// The robot's interface, call by call.
#include <doctest/doctest.h>

#include "controllers/lua_fixture.h"
#include "sensing/led_colour.h"
#include "support/uses.h"

namespace stig {
namespace {

TEST_CASE("wheels: ahead is (+v, -v), for commands and encoders") {
  Running robot(R"(function step()
    local e = robot.differential_drive.encoders
    print(e.left, e.right)
    robot.differential_drive.set_target_velocity(0.1, -0.2)
  end)");
  RobotReadings readings = empty_readings();
  readings.left_encoder = 0.03;
  readings.right_encoder = 0.04;
  REQUIRE(robot.step(readings).ok);
  CHECK(joined(robot.commands.log) == "0.03\t-0.04");
  REQUIRE(robot.commands.wheels);
  CHECK(robot.commands.wheels->first == 0.1);
  CHECK(robot.commands.wheels->second == 0.2);
}

TEST_CASE("lift: readings, and each of its commands") {
  Running robot(R"(n = 0
  function step()
    local lift = robot.lift_system
    print(lift.state, lift.position, lift.limit_switches.top, lift.limit_switches.bottom)
    n = n + 1
    if n == 1 then lift.set_position(0.06) elseif n == 2 then lift.stop() else lift.calibrate() end
  end)");
  RobotReadings readings = empty_readings();
  readings.lift = {true, false, 0.05, false, true};
  robot.step(readings);
  CHECK(joined(robot.commands.log) == "position_control\t0.05\tfalse\ttrue");
  CHECK(robot.commands.lift.kind == LiftCommand::Kind::position);
  CHECK(robot.commands.lift.position == 0.06);
  readings.lift = {false, true, 0, true, false};
  robot.step(readings);
  CHECK(joined(robot.commands.log) == "calibration_search_bottom\t0.0\ttrue\tfalse");
  CHECK(robot.commands.lift.kind == LiftCommand::Kind::stop);
  robot.step();
  CHECK(joined(robot.commands.log) == "inactive\t0.0\tfalse\tfalse");
  CHECK(robot.commands.lift.kind == LiftCommand::Kind::calibrate);
}

TEST_CASE("electromagnets: voltage and the three modes") {
  for (const auto& [word, mode] : {std::pair{"constructive", Discharge::constructive},
                                   {"destructive", Discharge::destructive},
                                   {"disable", Discharge::disable},
                                   {"disabled", Discharge::disable}}) {
    Running robot(
        "function step() print(robot.electromagnet_system.voltage) "
        "robot.electromagnet_system.set_discharge_mode('" +
        std::string(word) + "') end");
    RobotReadings readings = empty_readings();
    readings.magnet_voltage = 22.5;
    REQUIRE(robot.step(readings).ok);
    CHECK(robot.commands.log[0] == "22.5");
    CHECK(robot.commands.discharge == mode);
  }
  CHECK(said("robot.electromagnet_system.set_discharge_mode('on')") ==
        "test.lua:1: electromagnet_system.set_discharge_mode: argument 1 (mode) must be "
        "'constructive', 'destructive' or 'disable', and is 'on' (r1)");
}

TEST_CASE("camera: enabled and disabled, tags with places, turns, pixels") {
  Running robot(R"(function init()
      print(robot.camera_system.resolution, robot.camera_system.transform.anchor,
            robot.camera_system.transform.position, #robot.camera_system.tags,
            robot.cameras.front == robot.camera_system)
      robot.camera_system.enable()
    end
    function step()
      print(robot.camera_system.timestamp, #robot.camera_system.tags)
      for i, tag in ipairs(robot.camera_system.tags) do
        print(tag.id, tag.position, tag.orientation, tag.center, tag.corners[1], tag.corners[4])
      end
      robot.camera_system.disable()
    end)");
  CHECK(joined(robot.commands.log) == "640.0,360.0\tend_effector\t0.0,0.0,0.075\t0\ttrue");
  REQUIRE(robot.commands.camera_enabled.size() == 1);
  CHECK(robot.commands.camera_enabled[0] == true);
  RobotReadings readings = empty_readings();
  readings.cameras[0].enabled = true;
  readings.cameras[0].timestamp = 1.5;
  readings.cameras[0].tags = {
      {3, {0, 0.1, 0.2}, {1, 0, 0, 0}, {10, 20}, {{{1, 2}, {3, 4}, {5, 6}, {7, 8}}}}};
  robot.step(readings);
  CHECK(joined(robot.commands.log) ==
        "1.5\t1\n3\t0.0,0.1,0.2\t1.0,0.0,0.0,0.0\t10.0,20.0\t1.0,2.0\t7.0,8.0");
  CHECK(robot.commands.camera_enabled[0] == false);
  robot.step();
  CHECK(joined(robot.commands.log) == "0.0\t0");
}

TEST_CASE("detect_led sees the colour that appears where the vector points") {
  Running robot(R"(function step()
    local see = robot.camera_system.detect_led
    print(see(vector3(0, 0, 0.2)), see(vector3(0.02, 0, 0.2)), see(vector3(0, 0, -1)))
  end)");
  RobotReadings readings = empty_readings();
  CameraReading& camera = readings.cameras[0];
  const Yuv light = to_yuv(led_rgb(3));
  camera.leds = {{{320, 180}, light.y, light.u, light.v}};
  robot.step(readings);
  CHECK(joined(robot.commands.log) == "0\t0\t0");  // not enabled
  camera.enabled = true;
  robot.step(readings);
  CHECK(joined(robot.commands.log) == "3\t0\t0");
}

TEST_CASE("rangefinders by name, with their places") {
  Running robot(R"(function step()
    for name, r in pairs(robot.rangefinders) do
      print(name, r.proximity, r.illuminance, r.transform.anchor, r.transform.position,
            vector3(0, 0, 1):rotate(r.transform.orientation))
    end
  end)");
  RobotReadings readings = empty_readings();
  readings.rangefinders = {{0.04, 5}, {2500, 0}};
  robot.step(readings);
  REQUIRE(robot.commands.log.size() == 2);
  CHECK(robot.commands.log[0].starts_with("1\t0.04\t5.0\tchassis\t0.04,0.0,0.045\t1.0,0.0,"));
  CHECK(robot.commands.log[1].starts_with("left\t2500.0\t0.0\tend_effector\t0.0,0.03,0.0\t"));
}

TEST_CASE("radios: bytes in, lists or texts of bytes out") {
  Running robot(R"(function step()
    for i, message in ipairs(robot.simple_radios.nfc.recv) do
      print(i, #message, table.concat(message, ' '))
    end
    print(#robot.simple_radios.nfc.recv)
    robot.simple_radios.nfc.send({49, 0, 255})
    robot.simple_radios.nfc.send('4')
  end)");
  RobotReadings readings = empty_readings();
  readings.radios[0] = {std::string("1\0\xff", 3), ""};
  robot.step(readings);
  CHECK(joined(robot.commands.log) == "1\t3\t49 0 255\n2\t0\t\n2");
  REQUIRE(robot.commands.sends.size() == 1);
  CHECK(robot.commands.sends[0] == std::vector<Message>{std::string("1\0\xff", 3), "4"});
  robot.step();
  CHECK(joined(robot.commands.log) == "0");
}

TEST_CASE("LEDs by name, number and three parts; joints; the clock") {
  Running robot(R"(function step()
    print(robot.system.time, robot.system.temperature, robot.joints.arm.position,
          robot.joints.arm.velocity)
    robot.leds.set_leds('black')
    robot.leds.set_led_index(2, 1, 2, 3)
    robot.leds.set_led_index(1, '#0a0b0c')
    robot.joints.arm.set_target(0.25)
  end)");
  RobotReadings readings = empty_readings();
  readings.time = 0.4;
  readings.joints[0] = {0.5, -1};
  robot.step(readings);
  CHECK(joined(robot.commands.log) == "0.4\t25.0\t0.5\t-1.0");
  REQUIRE(robot.commands.leds.size() == 2);
  CHECK(robot.commands.leds[0].second == Rgb{10, 11, 12});
  CHECK(robot.commands.leds[1].second == Rgb{1, 2, 3});
  CHECK(robot.commands.joints.at(0) == 0.25);
}

TEST_CASE("what a robot shows of its mind") {
  Running robot(R"(function step()
    robot.show.number('gap', 0.5)
    robot.show.number('gap', 0.25)
    robot.show.text('state', 'search')
    robot.show.arrow(vector3(), vector3(1, 0, 0), 'red')
  end)");
  REQUIRE(robot.step().ok);
  const UserData& user = robot.commands.user;
  CHECK(user.numbers == std::vector<std::pair<std::string, double>>{{"gap", 0.25}});
  CHECK(user.texts == std::vector<std::pair<std::string, std::string>>{{"state", "search"}});
  REQUIRE(user.arrows.size() == 1);
  CHECK(user.arrows[0].to == Vec3{1, 0, 0});
  CHECK(user.arrows[0].rgb == Rgb{255, 0, 0});
}

TEST_CASE("id, params, and every way to log") {
  LuaSettings settings = settings_of("robot3");
  settings.params = {{"speed", 0.25}, {"goal", "tower"}, {"left", true}};
  Running robot(R"(print(robot.id, robot.params.speed, robot.params.goal, robot.params.left)
    log('a', 1, nil)
    logerr('b')
    robot.logger('INFO', 'c')
    robot.logger:log_info('d', 2)
    robot.logger.warn('e')
    robot.logger:error('f')
    robot.logger:register_module('g'))",
                settings);
  CHECK(joined(robot.commands.log) ==
        "robot3\t0.25\ttower\ttrue\na1nil\nerror: b\nINFO c\ninfo: d 2\nwarning: e\nerror: f");
}

TEST_CASE("devices that the robot lacks are absent") {
  RobotModel bare;
  Running robot(
      "for _, k in ipairs{'camera_system', 'cameras', 'differential_drive', 'lift_system',"
      "'electromagnet_system', 'rangefinders', 'simple_radios', 'leds', 'joints'} do "
      "assert(robot[k] == nil, k) end function step() end",
      settings_of(), bare);
  CHECK(robot.status.error == "");
  CHECK(robot.step(RobotReadings{}).ok);
}

TEST_CASE("wrong arguments name the function and the argument") {
  const auto complains = [](const std::string& call, const std::string& of) {
    CAPTURE(call);
    CHECK(said(call).find(of) != std::string::npos);
  };
  complains("robot.differential_drive.set_target_velocity(1)",
            "differential_drive.set_target_velocity: argument 2 (right) must be a finite number, "
            "and is missing");
  complains("robot.differential_drive.set_target_velocity(0/0, 1)", "argument 1 (left)");
  complains("robot.differential_drive.set_target_velocity('1', 1)", "and is '1'");
  complains("robot.differential_drive:set_target_velocity(1, 1)", "and is table");
  complains("robot.lift_system.set_position(1/0)", "lift_system.set_position: argument 1");
  complains("robot.camera_system.detect_led(1)", "camera_system.detect_led: argument 1 (position)");
  complains("robot.camera_system.detect_led(vector3(1, 2, 3) / 0)", "a finite vector3");
  complains("robot.simple_radios.nfc.send(5)", "send: argument 1 (message)");
  complains("robot.simple_radios.nfc.send({1, 256})",
            "send: byte 2 of the message must be a whole number from 0 to 255, and is 256");
  complains("robot.simple_radios.nfc.send({1, 'x'})", "and is 'x'");
  complains("robot.simple_radios.nfc.send({1.5})", "a whole number");
  complains("robot.simple_radios.nfc.send(('x'):rep(1025))", "at most 1024 bytes");
  complains("for i = 1, 65 do robot.simple_radios.nfc.send('x') end", "at most 64 messages");
  complains("robot.leds.set_led_index(3, 'red')", "from 1 to 2");
  complains("robot.leds.set_leds('reddish')", "leds.set_leds: argument 1 (color)");
  complains("robot.leds.set_leds('reddish')", "and is 'reddish'");
  complains("robot.leds.set_leds(('x'):rep(1000))", "and is '" + std::string(40, 'x') + "…'");
  complains("robot.joints.arm.set_target()", "joint.set_target: argument 1");
  complains("robot.show.number('x', 'y')", "show.number: argument 2 (value)");
  complains("for i = 1, 300 do robot.show.number('x' .. i, i) end", "too much in one step");
}

TEST_CASE("readings come whatever a program did to the tables") {
  Running robot(R"(local system = robot.system
    setmetatable(system, {__newindex = error, __index = error})
    system.time = nil
    robot.simple_radios.nfc.recv = 7
    local keep = robot
    robot = nil
    function step() print(system.time, #keep.simple_radios.nfc.recv) end)");
  RobotReadings readings = empty_readings();
  readings.time = 3;
  CHECK(robot.step(readings).ok);
  CHECK(joined(robot.commands.log) == "3.0\t0");
}

TEST_CASE("a function that is near to step is named, wherever tables have it") {
  const auto meant = [](const std::string& program) {
    const std::string error = Running(program).step().error;
    const std::size_t at = error.find(": is '");
    return at == std::string::npos ? "" : error.substr(at + 6, error.find('\'', at + 6) - at - 6);
  };
  CHECK(meant("function on_step() end") == "on_step");
  CHECK(meant("function Step() end") == "Step");
  CHECK(meant("function controlStep() end function Step() end") == "Step");
  CHECK(meant("function stpe() end function on_step() end") == "on_step");
  CHECK(meant("function setp() end") == "setp");
  CHECK(meant("function drive() end").empty());
  CHECK(meant("steps = 3 _ = drive function e() end").empty());
  CHECK(Running("\n\nfunction on_step() end").step().error.starts_with("test.lua:3: "));
}

TEST_CASE("reset and destroy are called; all callbacks but step may be absent") {
  Running robot(
      "function reset() print('again') end function destroy() print(1) robot.x.y = 1 end");
  RobotCommands commands;
  CHECK(robot.controller.reset(commands).ok);
  CHECK(joined(commands.log) == "again");
  robot.controller.destroy();
  CHECK(Running("function step() end").step().ok);
  CHECK(Running("").step().error ==
        "test.lua: there is no function 'step', which each step calls (r1)");
  Running once("function step() step = nil end");
  CHECK(once.step().ok);
  CHECK_FALSE(once.step().ok);
  CHECK(Running("step = 5").step().error.starts_with("'step' must be a function, and is a number"));
}

}  // namespace
}  // namespace stig
