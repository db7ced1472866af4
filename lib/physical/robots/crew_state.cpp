// SPDX-License-Identifier: MIT
// A crew as bytes, and back.
#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "physical/robots/crew.h"
#include "physical/robots/crew_bytes.h"
#include "physical/robots/crew_history.h"

namespace stig::physics {

namespace {

/// A reading for each device that has one.
bool one_for_each(const RobotReadings& readings, const RobotModel& robot) {
  bool out = true;
  DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (ReadKind<Kind>) {
      out = out && Kind::readings(readings).size() == Kind::devices(robot).size();
    }
  });
  return out;
}

}  // namespace

// Histories and checkpoints take these bytes; their order is a format (base/byte_members.h).
std::string bytes_of(const RobotReadings& readings, const RobotModel& robot) {
  BytesOut out;
  reading_members(out, readings, robot);
  return out.take();
}

// The lowest bit says whether a list follows: idle blocks take a byte or two a step.
std::string bytes_of(const std::vector<std::vector<Message>>& inbox, std::uint64_t since) {
  BytesOut out;
  const bool any =
      std::any_of(inbox.begin(), inbox.end(), [](const auto& heard) { return !heard.empty(); });
  out(since * 2 + (any ? 1 : 0));
  if (any) out.list(inbox);
  return out.take();
}

RobotReadings take_readings(ByteReader& in, const RobotModel& robot) {
  RobotReadings out;
  BytesIn each(in);
  reading_members(each, out, robot);
  // Bytes of a checkpoint are untrusted: sizes must be those of the robot.
  if (!one_for_each(out, robot)) in.fail();
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

// One list of members for both directions, so what is written can be read. Numbers of robots and
// blocks are known from the scene and only compared.
void Crew::crew_members(auto& each, auto& crew) {
  CrewSignals::common_members(each, crew.signals_);
  each.known(crew.robots_.size());
  for (std::size_t i = 0; i < crew.robots_.size(); ++i) {
    auto& robot = crew.robots_[i];
    each(robot.begun), each(robot.failed), each(robot.halted), each_member(each, robot.devices);
    CrewSenses::robot_members(each, crew.senses_, i);
    CrewSignals::robot_members(each, crew.signals_, i);
  }
  each.known(crew.blocks_.size());
  for (std::size_t i = 0; i < crew.blocks_.size(); ++i) {
    auto& block = crew.blocks_[i];
    auto& signals = CrewSignals::block(crew.signals_, i);
    each(block.begun), each(block.failed), each(signals.quiet), each(block.last);
    for (auto& led : signals.leds) each.choice(led, Led::q4);
    each_member(each, signals.mail);
  }
}

// Behind the other members, and only where something is broken: a crew in which nothing is keeps
// the bytes, and the hash, that it had before there were faults.
void Crew::faults(auto& each, auto& crew) {
  for (std::size_t i = 0; i < crew.robots_.size(); ++i) {
    each(CrewSenses::dark(crew.senses_, i)), each(CrewSignals::mail(crew.signals_, i).dead);
  }
  for (std::size_t i = 0; i < crew.blocks_.size(); ++i) {
    auto& signals = CrewSignals::block(crew.signals_, i);
    each(signals.mail.dead), each(signals.dead_leds);
  }
}

std::vector<std::string> Crew::broken() const {
  const auto deaf = [](const std::string& name) {
    return "the radios of " + name + " neither send nor receive";
  };
  std::vector<std::string> out;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const std::string& name = robot_name(i);
    if (CrewSenses::dark(senses_, i)) out.push_back("the cameras of " + name + " see nothing");
    if (CrewSignals::mail(signals_, i).dead) out.push_back(deaf(name));
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const BlockSignals& block = CrewSignals::block(signals_, i);
    const std::string& name = config_.blocks[i].name;
    if (block.mail.dead) out.push_back(deaf(name));
    const int dead = std::popcount(block.dead_leds);
    if (dead == 0) continue;
    out.push_back(std::to_string(dead) + " of " + std::to_string(kBlockLeds) + " LEDs of " + name +
                  " are dead");
  }
  return out;
}

bool Crew::leds_dead(BodyId body) const {
  const std::size_t block = block_of(body);
  return block < blocks_.size() && CrewSignals::block(signals_, block).dead_leds == kAllLeds;
}

bool Crew::faulty() const {
  bool out = false;
  const auto broken = [&out](auto value) { out = out || value != 0; };
  faults(broken, *this);
  return out;
}

void Crew::histories(auto& each, auto& crew) {
  for (auto& robot : crew.robots_) each_member(each, robot.history);
  for (auto& block : crew.blocks_) each_member(each, block.history);
}

// Compared in traces and hashed: no histories, which say nothing of what comes.
std::string Crew::state() const {
  BytesOut out;
  crew_members(out, *this);
  if (faulty()) faults(out, *this);
  return out.take();
}

std::string Crew::checkpoint() const {
  // Without histories nothing could be brought back.
  assert(config_.resumable);
  BytesOut out;
  out(state());
  histories(out, *this);
  return out.take();
}

/// Whether lists are as long as there are devices.
bool Crew::fits() const {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const auto& targets = robots_[i].devices.joints;
    if (!targets.empty() && targets.size() != model(i).actuators.size()) return false;
  }
  return senses_.fits(config_) && signals_.fits(config_);
}

/// Feeds its program what it has read. A controller's state cannot be saved, so it is made again
/// and fed what the last one read; what it commands on the way is thrown away, but for the last
/// step's.
bool Crew::bring_back_robot(std::size_t number) {
  Robot& robot = robots_[number];
  // The history sets it again if there was a step.
  const bool begun = std::exchange(robot.begun, false);
  const bool good = robot.history.each([&](ByteReader& in) {
    robot.readings = take_readings(in, model(number));
    if (!in.good() || !config_.robots[number].controller) return false;
    robot.commands = {};
    call_robot(number, robot.commands);
    return true;
  });
  if (robot.failed) robot.commands = {};
  robot.commands.log.clear();
  return good && robot.begun == begun;
}

bool Crew::bring_back_block(std::size_t number) {
  Block& block = blocks_[number];
  const bool begun = std::exchange(block.begun, false);
  std::uint64_t tick = 0;
  const bool good = block.history.each([&](ByteReader& in) {
    std::uint64_t since = 0;
    std::vector<std::vector<Message>> heard(kBlockRadios);
    take_inbox(in, heard, since);
    if (!in.good() || !config_.blocks[number].controller) return false;
    tick += since;
    BlockCommands ignored;
    call_block(number, block_readings(tick, std::move(heard)), ignored);
    return true;
  });
  return good && block.begun == begun && block.last == tick;
}

// Members first, all of them, then the histories.
bool Crew::resume(std::string_view checkpoint) {
  ByteReader whole(checkpoint);
  ByteReader in(whole.block());
  BytesIn each(in);
  crew_members(each, *this);
  if (in.good() && in.left() > 0) faults(each, *this);
  if (!in.good() || in.left() > 0 || !fits()) return false;
  BytesIn rest(whole);
  histories(rest, *this);
  if (!whole.good() || whole.left() > 0) return false;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (!bring_back_robot(i)) return false;
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (!bring_back_block(i)) return false;
  }
  return true;
}

}  // namespace stig::physics
