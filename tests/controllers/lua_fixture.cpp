// SPDX-License-Identifier: MIT
#include "controllers/lua_fixture.h"
#include "support/uses.h"

namespace stig {

RobotModel whole_robot() {
  RobotModel model;
  model.bodies.resize(2);
  model.bodies[0].name = "chassis";
  model.bodies[1].name = "end_effector";
  model.drive.emplace();
  model.lift.emplace();
  model.magnets.emplace();
  CameraDevice camera;
  camera.name = "front";
  camera.body = 1;
  camera.X_BC.p = {0, 0, 0.075};
  camera.intrinsics = {640, 360, 883.961, 883.961, 319.5, 179.5};
  model.cameras = {camera};
  model.rangefinders = {{"1", 0, {0.04, 0, 0.045}, {1, 0, 0}, 0.2, {}, {}},
                        {"left", 1, {0, 0.03, 0}, {0, 0, -1}, 0.2, {}, {}}};
  model.radios = {{"nfc", 1, {}, 0.02}};
  model.leds = {{"a", 0, {}}, {"b", 0, {}}};
  model.actuators = {{"arm", {}}};
  return model;
}

RobotReadings empty_readings() {
  RobotReadings readings;
  readings.cameras.resize(1);
  readings.rangefinders.resize(2);
  readings.radios.resize(1);
  readings.joints.resize(1);
  return readings;
}

LuaSettings settings_of(const std::string& id) {
  LuaSettings settings;
  settings.id = id;
  settings.seed = 7;
  return settings;
}

Running::Running(const std::string& text, LuaSettings settings, RobotModel model)
    : controller({"test.lua", text}, std::move(model), std::move(settings)) {
  status = controller.init(commands);
}

ControllerStatus Running::step(const RobotReadings& readings) {
  commands = {};
  return status = controller.step(readings, commands);
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

std::string said(const std::string& text) {
  Running running(text);
  return running.status.ok ? joined(running.commands.log) : running.status.error;
}

}  // namespace stig
