// SPDX-License-Identifier: MIT
// A robot's program in Lua, run outside of any simulation: stig::robots and stig::lua. Readings go
// in, commands come out; a real robot's drivers, another simulator or a test can be at either end.
#include <cstdio>
#include <iostream>

#include "lua/lua_controller.h"
#include "robots/robot_reader.h"

namespace {

// Drives towards the nearest tag that the camera sees, and stops before it.
constexpr const char* kProgram = R"(
function init()
  robot.camera_system.enable()
end

function step()
  local nearest
  for _, tag in ipairs(robot.camera_system.tags) do
    local distance = tag.position:length()
    if not nearest or distance < nearest then nearest = distance end
  end
  local speed = nearest and math.min(0.05, 0.2 * (nearest - 0.1)) or 0
  robot.differential_drive.set_target_velocity(speed, -speed)
  robot.logger('nearest tag', nearest, 'speed', speed)
end
)";

}  // namespace

int main() {
  stig::Diagnostics diagnostics;
  const auto robot = stig::robots::read_robot_file(STIG_DATA "/robots/bebot.yaml", diagnostics);
  std::cerr << stig::to_text(diagnostics);
  if (!robot) return 1;

  // Programs are untrusted: instructions, memory and the depth of calls are bounded.
  stig::lua::LuaSettings settings;
  settings.id = "robot1";
  settings.limits.instructions = 100'000;
  stig::lua::LuaController controller({"approach.lua", kProgram}, *robot, settings);

  stig::robots::RobotCommands commands;
  if (const auto status = controller.init(commands); !status.ok) {
    std::cerr << status.error << '\n';
    return 1;
  }
  // Lists of readings have an entry for each device of the robot's file, in its order.
  stig::robots::RobotReadings readings;
  readings.cameras.resize(robot->cameras.size());
  readings.rangefinders.resize(robot->rangefinders.size());
  readings.radios.resize(robot->radios.size());
  readings.cameras[0].tags.resize(1);
  for (const double distance : {0.4, 0.2, 0.1}) {
    readings.cameras[0].tags[0].p_CT = {0, 0, distance};
    readings.time += robot->control_period;
    ++readings.tick;
    commands = {};  // what is not commanded stays as it was
    if (const auto status = controller.step(readings, commands); !status.ok) {
      std::cerr << status.error << '\n';
      return 1;
    }
    for (const std::string& line : commands.log) std::cout << line << '\n';
    std::printf("wheels %.3f, %.3f m/s\n", commands.wheels->first, commands.wheels->second);
  }
}
