// SPDX-License-Identifier: MIT
// Who is in a crew: robots and blocks with their controllers.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "physical/dynamics/world.h"
#include "physical/robots/led.h"
#include "physical/robots/robot_body.h"
#include "physical/robots/uses.h"
#include "physical/sensors/sensor_noise.h"
#include "robots/block.h"
#include "robots/controller.h"

namespace stig::physics {

struct CrewRobot {
  std::string name;
  const RobotModel* model = nullptr;  ///< must outlive the crew
  RobotBody body;
  std::unique_ptr<RobotController> controller;
  CameraNoise camera_noise;
  RangeNoise range_noise;
  EncoderNoise encoder_noise;
};

struct CrewBlock {
  std::string name;
  BodyId body{};
  std::size_t model = 0;                        ///< in CrewConfig::models
  Led led = Led::off;                           ///< of all its LEDs at the start
  std::unique_ptr<BlockController> controller;  ///< none: its LEDs stay as they are
};

struct CrewConfig {
  std::uint64_t seed = 1;
  double block_period = 0.2;  ///< s between steps of blocks' programs
  bool lights = true;         ///< false: no LED shines
  bool resumable = true;      ///< keep what programs read, so that the crew can be brought back
  std::vector<BlockModel> models;  ///< of the blocks
  std::vector<CrewRobot> robots;
  std::vector<CrewBlock> blocks;
};

}  // namespace stig::physics
