// SPDX-License-Identifier: MIT
// The messages of a crew on their way.
#include <algorithm>
#include <utility>

#include "physical/robots/crew.h"
#include "physical/sensors/radio_medium.h"

namespace stig {

namespace {

/// Middles of a cube's faces, as its radios are numbered: see cube_marks.
constexpr std::array<Vec3, kBlockRadios> kFaceNormals = {
    Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}};

}  // namespace

/// Messages reach radios where they are now, at the end of the tick in which they were sent.
void Crew::carry_messages(const World& world) {
  std::vector<Radio> radios;
  std::vector<std::vector<Message>> sends;
  for (Robot& robot : robots_) {
    const RobotModel& model = *robot.config.model;
    for (std::size_t i = 0; i < model.radios.size(); ++i) {
      const RadioDevice& device = model.radios[i];
      radios.push_back({pose_of(world, robot.config.body, device.body) * device.p_B, device.range});
      sends.push_back(std::exchange(robot.outbox[i], {}));
    }
  }

  for (Block& block : blocks_) {
    const Pose X_WB = world.state(block.config.body).X_WB;
    const BlockModel& model = config_.models[block.config.model];
    const double reach = model.side / 2 - model.radios.depth;
    for (std::size_t i = 0; i < kBlockRadios; ++i) {
      radios.push_back({X_WB * (kFaceNormals[i] * reach), model.radios.range});
      sends.push_back(std::exchange(block.outbox[i], {}));
    }
  }
  const auto heard = carry(radios, sends);
  auto next = heard.begin();
  const auto take = [&next](std::vector<std::vector<Message>>& inbox) {
    bool any = false;
    for (auto& messages : inbox) {
      any = any || !next->empty();
      messages.insert(messages.end(), next->begin(), next->end());
      ++next;
    }
    return any;
  };
  for (Robot& robot : robots_) {
    take(robot.inbox);
    // Nobody reads them there.
    if (robot.failed || !robot.config.controller) {
      for (auto& messages : robot.inbox) messages.clear();
    }
  }
  for (Block& block : blocks_) {
    if (take(block.inbox)) block.quiet = false;
  }
  sends_ = false;
}

}  // namespace stig
