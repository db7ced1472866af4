// SPDX-License-Identifier: MIT
// Records of a crew's histories: what one program read before one step.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "physical/robots/uses.h"
#include "robots/robot_io.h"
#include "robots/robot_model.h"

namespace stig::physics {

std::string bytes_of(const RobotReadings& readings, const RobotModel& robot);
/// `since`: ticks of the world since the block's step before.
std::string bytes_of(const std::vector<std::vector<Message>>& inbox, std::uint64_t since);

/// The reader is bad after bytes that are none; lists are as long as the robot has devices.
RobotReadings take_readings(ByteReader& in, const RobotModel& robot);
void take_inbox(ByteReader& in, std::vector<std::vector<Message>>& inbox, std::uint64_t& since);

}  // namespace stig::physics
