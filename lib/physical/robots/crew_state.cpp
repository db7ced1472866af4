// SPDX-License-Identifier: MIT
// A crew as bytes, and back.
#include <algorithm>
#include <cassert>

#include "physical/robots/crew.h"
#include "physical/robots/crew_bytes.h"
#include "physical/robots/crew_history.h"

namespace stig {

std::string bytes_of(const RobotReadings& readings) {
  BytesOut out;
  each_member(out, readings);
  return out.take();
}

std::string bytes_of(const std::vector<std::vector<Message>>& inbox, std::uint64_t since) {
  BytesOut out;
  const bool any =
      std::any_of(inbox.begin(), inbox.end(), [](const auto& heard) { return !heard.empty(); });
  out(since * 2 + (any ? 1 : 0));
  if (any) out.list(inbox);
  return out.take();
}

RobotReadings take_readings(ByteReader& in) {
  RobotReadings out;
  BytesIn each(in);
  each_member(each, out);
  return out;
}

void take_inbox(ByteReader& in, std::vector<std::vector<Message>>& inbox, std::uint64_t& since) {
  const std::uint64_t head = in.varint();
  since = head / 2;
  if (head % 2 == 0) return;
  const std::size_t radios = inbox.size();
  BytesIn(in).list(inbox);
  if (inbox.size() != radios) in.fail();
}

template <class Each>
void Crew::robot_members(Each& each, auto& robot) {
  each(robot.begun), each(robot.failed), each(robot.halted), each_member(each, robot.devices);
  each.list(robot.enabled);
  for (auto& late : robot.late_cameras) each.list(late.on_the_way);
  for (auto& late : robot.late_ranges) each.list(late.on_the_way);
  each.list(robot.inbox), each.list(robot.outbox);
}

template <class Each>
void Crew::block_members(Each& each, auto& block) {
  each(block.begun), each(block.failed), each(block.quiet), each(block.last);
  for (auto& led : block.leds) each.choice(led, Led::q4);
  each.list(block.inbox), each.list(block.outbox);
}

template <class Each>
void Crew::crew_members(Each& each, auto& crew) {
  each(crew.sends_);
  each.known(crew.robots_.size());
  for (auto& robot : crew.robots_) robot_members(each, robot);
  each.known(crew.blocks_.size());
  for (auto& block : crew.blocks_) block_members(each, block);
}

template <class Each>
void Crew::histories(Each& each, auto& crew) {
  for (auto& robot : crew.robots_) each_member(each, robot.history);
  for (auto& block : crew.blocks_) each_member(each, block.history);
}

std::string Crew::state() const {
  BytesOut out;
  crew_members(out, *this);
  return out.take();
}

std::string Crew::checkpoint() const {
  assert(config_.resumable);
  BytesOut out;
  out(state());
  histories(out, *this);
  return out.take();
}

/// Lists as long as the robot's devices are many.
bool Crew::fits(const Robot& robot) const {
  const RobotModel& model = *robot.config.model;
  const auto late = [](const auto& queues, int latency) {
    return std::all_of(queues.begin(), queues.end(), [latency](const auto& queue) {
      return queue.on_the_way.size() <= static_cast<std::size_t>(latency);
    });
  };
  return (robot.devices.joints.empty() || robot.devices.joints.size() == model.actuators.size()) &&
         robot.enabled.size() == model.cameras.size() &&
         robot.inbox.size() == model.radios.size() && robot.outbox.size() == model.radios.size() &&
         late(robot.late_cameras, robot.config.camera_noise.latency) &&
         late(robot.late_ranges, robot.config.range_noise.latency);
}

/// Feeds its program what it has read.
bool Crew::bring_back(Robot& robot) const {
  const RobotModel& model = *robot.config.model;
  const bool begun = robot.begun;
  robot.begun = false;
  const bool good = robot.history.each([&](ByteReader& in) {
    robot.readings = take_readings(in);
    if (!in.good() || !robot.config.controller) return false;
    const RobotReadings& r = robot.readings;
    if (r.cameras.size() != model.cameras.size() || r.radios.size() != model.radios.size() ||
        r.rangefinders.size() != model.rangefinders.size() ||
        r.joints.size() != model.actuators.size()) {
      return false;
    }
    robot.commands = {};
    call(robot, robot.commands);
    return true;
  });
  if (robot.failed) robot.commands = {};
  robot.commands.log.clear();
  return good && robot.begun == begun;
}

bool Crew::bring_back(Block& block) const {
  const bool begun = block.begun, quiet = block.quiet;
  auto inbox = block.inbox, outbox = block.outbox;
  block.begun = false;
  std::uint64_t tick = 0;
  const bool good = block.history.each([&](ByteReader& in) {
    std::uint64_t since = 0;
    block.inbox.assign(kBlockRadios, {});
    take_inbox(in, block.inbox, since);
    if (!in.good() || !block.config.controller) return false;
    tick += since;
    BlockCommands ignored;
    call(block, tick, ignored);
    return true;
  });
  block.inbox = std::move(inbox);
  block.outbox = std::move(outbox);
  block.quiet = quiet;
  return good && block.begun == begun && block.last == tick;
}

bool Crew::resume(std::string_view checkpoint) {
  ByteReader whole(checkpoint);
  ByteReader in(whole.block());
  BytesIn each(in);
  crew_members(each, *this);
  if (!in.good() || in.left() > 0) return false;
  if (!std::all_of(robots_.begin(), robots_.end(), [this](const Robot& r) { return fits(r); }) ||
      !std::all_of(blocks_.begin(), blocks_.end(), [](const Block& block) {
        return block.inbox.size() == kBlockRadios && block.outbox.size() == kBlockRadios;
      })) {
    return false;
  }
  BytesIn rest(whole);
  histories(rest, *this);
  if (!whole.good() || whole.left() > 0) return false;
  return std::all_of(robots_.begin(), robots_.end(), [this](Robot& r) { return bring_back(r); }) &&
         std::all_of(blocks_.begin(), blocks_.end(), [this](Block& b) { return bring_back(b); });
}

}  // namespace stig
