// SPDX-License-Identifier: MIT
// Radios and LEDs. Messages lie in outboxes until the next control tick, are carried all at once,
// and lie in inboxes until their reader's next step. Most blocks say and hear nothing for most of a
// run: `quiet` and `sends_` keep them from costing anything.
#include "physical/robots/crew_signals.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "physical/sensors/radio_medium.h"

namespace stig::physics {

namespace {

/// Middles of a cube's faces, as its radios are numbered: north, east, south, west, top and bottom,
/// in the block's frame; see cube_marks.
constexpr std::array<Vec3, kBlockRadios> kFaceNormals = {
    Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}};

Mailbox mailbox(std::size_t radios) {
  Mailbox out;
  out.inbox.resize(radios);
  out.outbox.resize(radios);
  return out;
}

bool has_radios(const Mailbox& mail, std::size_t radios) {
  return mail.inbox.size() == radios && mail.outbox.size() == radios;
}

/// The radios of robots, then those of blocks: the order in which outboxes are emptied.
std::vector<Radio> radios_of(const CrewConfig& config, const World& world) {
  std::vector<Radio> out;
  for (const CrewRobot& robot : config.robots) {
    for (const RadioDevice& device : robot.model->radios) {
      out.push_back({pose_of(world, robot.body, device.body) * device.p_B, device.range});
    }
  }
  for (const CrewBlock& block : config.blocks) {
    const Pose X_WB = world.state(block.body).X_WB;
    const BlockModel& model = config.models[block.model];
    // A radio sits behind its face, not on it.
    const double reach = model.side / 2 - model.radios.depth;
    for (const Vec3& normal : kFaceNormals) {
      out.push_back({X_WB * (normal * reach), model.radios.range});
    }
  }
  return out;
}

}  // namespace

CrewSignals::CrewSignals(const CrewConfig& config) {
  for (const CrewRobot& robot : config.robots) {
    robots_.push_back(mailbox(robot.model->radios.size()));
  }
  for (const CrewBlock& block : config.blocks) add_block(block, false);
}

void CrewSignals::add_block(const CrewBlock& block, bool changed) {
  BlockSignals& one = blocks_.emplace_back();
  one.leds = leds_showing(block.led);
  one.mail = mailbox(kBlockRadios);
  changed_.push_back(changed);
}

Led CrewSignals::colour(std::size_t block) const {
  assert(block < blocks_.size());
  return shown_by(blocks_[block].leds);
}

void CrewSignals::set_colour(std::size_t number, Led colour) {
  assert(number < blocks_.size());
  light(number, leds_showing(colour));
}

void CrewSignals::set_leds(std::size_t number, LedSet which, bool alive) {
  assert(number < blocks_.size());
  BlockSignals& block = blocks_[number];
  block.dead_leds = alive ? block.dead_leds & ~which : block.dead_leds | which;
  light(number, block.leds);
}

/// Lets LEDs shine as they are told, but for dead ones.
void CrewSignals::light(std::size_t number, BlockLeds leds) {
  BlockSignals& block = blocks_[number];
  for (std::size_t i = 0; i < leds.size(); ++i) {
    if ((block.dead_leds >> i & 1) != 0) leds[i] = Led::off;
  }
  if (std::exchange(block.leds, leds) != leds) changed_[number] = true;
}

std::vector<std::size_t> CrewSignals::take_changed() {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    if (changed_[i]) out.push_back(i);
  }
  changed_.assign(blocks_.size(), false);
  return out;
}

bool CrewSignals::carry(const CrewConfig& config, const World& world) {
  if (!sends_) return false;
  // Emptied even where nobody hears: a message not heard at once is lost, as in air.
  std::vector<std::vector<Message>> sends;
  const auto send_all = [&sends](Mailbox& mail) {
    for (auto& messages : mail.outbox) {
      sends.push_back(std::exchange(messages, {}));
      // A dead radio does not even keep others silent.
      if (mail.dead) sends.back().clear();
    }
  };
  for (Mailbox& robot : robots_) send_all(robot);
  for (BlockSignals& block : blocks_) send_all(block.mail);
  const auto heard = physics::carry(radios_of(config, world), sends);
  auto next = heard.begin();
  const auto take_all = [&next](Mailbox& mail) {
    bool any = false;
    for (auto& messages : mail.inbox) {
      const std::vector<Message>& arrived = *next++;
      if (mail.dead) continue;
      any = any || !arrived.empty();
      messages.insert(messages.end(), arrived.begin(), arrived.end());
    }
    return any;
  };
  for (Mailbox& robot : robots_) take_all(robot);
  for (BlockSignals& block : blocks_) {
    if (take_all(block.mail)) block.quiet = false;
  }
  sends_ = false;
  return true;
}

std::vector<std::vector<Message>> CrewSignals::take_heard(std::size_t robot) {
  // A list for each radio stays, empty.
  auto& inbox = robots_[robot].inbox;
  return std::exchange(inbox, std::vector<std::vector<Message>>(inbox.size()));
}

// Quiet: nothing came and nothing was sent since, so the inbox is still empty.
std::vector<std::vector<Message>> CrewSignals::take_heard_by_block(std::size_t number) {
  BlockSignals& block = blocks_[number];
  if (block.quiet) return block.mail.inbox;
  block.quiet = true;
  Mailbox empty = mailbox(kBlockRadios);
  empty.dead = block.mail.dead;
  return std::exchange(block.mail, std::move(empty)).inbox;
}

void CrewSignals::forget_heard(std::size_t robot) {
  for (auto& messages : robots_[robot].inbox) messages.clear();
}

void CrewSignals::limit_heard_by_block(std::size_t block) {
  for (auto& messages : blocks_[block].mail.inbox) {
    if (messages.size() > kMostUnread) messages.resize(kMostUnread);
  }
}

void CrewSignals::send(std::size_t robot, const std::vector<std::vector<Message>>& messages) {
  assert(robot < robots_.size());
  Mailbox& mail = robots_[robot];
  mail.outbox = messages;
  mail.outbox.resize(mail.inbox.size());
  for (const auto& some : mail.outbox) sends_ = sends_ || !some.empty();
}

// Colours that do not exist, and LEDs that a block does not have, are passed over: commands of a
// program may say anything.
void CrewSignals::apply(std::size_t number, const BlockCommands& commands) {
  BlockSignals& block = blocks_[number];
  BlockLeds leds = block.leds;
  if (commands.all_leds && *commands.all_leds < kLedStates) {
    leds.fill(static_cast<Led>(*commands.all_leds));
  }
  for (const auto& [led, colour] : commands.leds) {
    if (led < leds.size() && colour < kLedStates) leds[led] = static_cast<Led>(colour);
  }
  light(number, leds);
  for (std::size_t i = 0; i < std::min(commands.sends.size(), kBlockRadios); ++i) {
    if (commands.sends[i].empty()) continue;
    block.mail.outbox[i] = commands.sends[i];
    block.quiet = false;
    sends_ = true;
  }
}

bool CrewSignals::fits(const CrewConfig& config) const {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (!has_radios(robots_[i], config.robots[i].model->radios.size())) return false;
  }
  return std::all_of(blocks_.begin(), blocks_.end(), [](const BlockSignals& block) {
    return has_radios(block.mail, kBlockRadios) && block.dead_leds <= kAllLeds;
  });
}

}  // namespace stig::physics
