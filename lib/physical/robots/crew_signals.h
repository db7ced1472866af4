// SPDX-License-Identifier: MIT
// What a crew's robots and blocks tell each other: messages by radio, and blocks' LEDs.
//
// A message that is sent in one control tick reaches the radios near its sender at the beginning
// of the next, wherever they are by then.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "physical/robots/crew_config.h"
#include "physical/robots/uses.h"

namespace stig::physics {

/// Messages of one robot or block: a list for each of its radios.
struct Mailbox {
  std::vector<std::vector<Message>> inbox, outbox;
  bool dead = false;  ///< its radios neither send nor receive

  static void members(auto& each, auto& mail) { each.list(mail.inbox), each.list(mail.outbox); }
};

/// Messages that a radio of a block keeps which no program reads. They are part of the state that
/// checkpoints and hashes have, and so not dropped altogether.
inline constexpr std::size_t kMostUnread = 100;

/// A bit for each LED of a block, in their order.
using LedSet = std::uint32_t;
static_assert(kBlockLeds < 32);
inline constexpr LedSet kAllLeds = (LedSet{1} << kBlockLeds) - 1;

struct BlockSignals {
  BlockLeds leds{};  ///< as they shine
  Mailbox mail;
  bool quiet = true;     ///< nothing in the mailbox
  LedSet dead_leds = 0;  ///< those that are dead: dark, whatever is set
};

class CrewSignals {
 public:
  explicit CrewSignals(const CrewConfig& config);
  /// `changed`: its LEDs are news.
  void add_block(const CrewBlock& block, bool changed);

  const BlockLeds& leds(std::size_t block) const { return blocks_[block].leds; }
  /// What its LEDs show.
  Led colour(std::size_t block) const;
  /// All LEDs of a block.
  void set_colour(std::size_t block, Led colour);
  /// LEDs that die are dark from now on, whatever is set; others obey, or do again when next set.
  void set_leds(std::size_t block, LedSet which, bool alive);
  /// All radios of a robot, or of a block.
  void set_radio(std::size_t robot, bool alive) { robots_[robot].dead = !alive; }
  void set_radio_of_block(std::size_t block, bool alive) { blocks_[block].mail.dead = !alive; }
  /// Blocks whose LEDs have changed since the last call, rising.
  std::vector<std::size_t> take_changed();

  /// Hands over what was sent since the last call; false when nothing was.
  bool carry(const CrewConfig& config, const World& world);
  /// What has reached a robot, or a block, since the last call.
  std::vector<std::vector<Message>> take_heard(std::size_t robot);
  std::vector<std::vector<Message>> take_heard_by_block(std::size_t block);
  /// Drops what has reached a robot on which nobody listens.
  void forget_heard(std::size_t robot);
  /// Keeps the first kMostUnread messages of each radio of a block on which nobody listens.
  void limit_heard_by_block(std::size_t block);
  void send(std::size_t robot, const std::vector<std::vector<Message>>& messages);
  /// LEDs and messages.
  void apply(std::size_t block, const BlockCommands& commands);

  // Members, for a crew's list of them.
  static void common_members(auto& each, auto& signals) { each(signals.sends_); }
  static void robot_members(auto& each, auto& signals, std::size_t robot) {
    each_member(each, signals.robots_[robot]);
  }
  static auto& mail(auto& signals, std::size_t robot) { return signals.robots_[robot]; }
  static auto& block(auto& signals, std::size_t number) { return signals.blocks_[number]; }
  /// A list for each radio, as after bytes from outside it might not be.
  bool fits(const CrewConfig& config) const;

 private:
  void light(std::size_t block, BlockLeds leds);

  std::vector<Mailbox> robots_;
  std::vector<BlockSignals> blocks_;
  std::vector<bool> changed_;
  bool sends_ = false;  ///< somebody has sent since messages were carried
};

}  // namespace stig::physics
