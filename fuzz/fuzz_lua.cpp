// SPDX-License-Identifier: MIT
// Any text as a robot's program of either interface under small limits: it ends in a status, within
// its memory, and the same way twice.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lua/lua_controller.h"
#include "support/uses.h"

namespace {

constexpr std::size_t kMemory = std::size_t{256} << 10;

std::string run(const std::string& text, stig::InterfaceLevel interface) {
  using namespace stig;
  LuaSettings settings;
  settings.id = "r";
  settings.limits.instructions = 20'000;
  settings.limits.memory = kMemory;
  settings.limits.object = std::size_t{64} << 10;
  settings.limits.string = std::size_t{8} << 10;
  settings.limits.depth = 500;
  RobotModel model;
  model.bodies.resize(1);
  model.drive.emplace();
  model.lift.emplace();
  model.cameras = {{"eye", 0, {}, {640, 360, 800, 800, 320, 180}}};
  model.radios = {{"nfc", 0, {}, 0.02}};
  LuaController controller({"/nowhere/fuzz.lua", text, {}, true, interface}, model, settings);
  RobotReadings readings;
  readings.cameras.resize(1);
  readings.cameras[0].enabled = true;
  readings.cameras[0].tags.resize(1);
  readings.radios = {{"1", ""}};
  std::string account;
  for (int i = 0; i < 3; ++i) {
    RobotCommands commands;
    const auto status = i == 0 ? controller.init(commands) : controller.step(readings, commands);
    account += status.error + "\n";
    for (const std::string& line : commands.log) account += line + "\n";
    if (controller.memory() > kMemory + (std::size_t{64} << 10)) std::abort();
  }
  controller.destroy();
  return account;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const auto interface : {stig::InterfaceLevel::of_2021, stig::InterfaceLevel::of_2019}) {
    const std::string account = run(text, interface);
    // At the edge of its memory a program may end at another instruction: how tables grow depends
    // on hashes, and those on addresses.
    if (account.find("memory") == std::string::npos && run(text, interface) != account)
      std::abort();
  }
  return 0;
}
