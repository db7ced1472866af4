// SPDX-License-Identifier: MIT
#include "lattice/walk_kernel.h"

#include "base/random.h"

namespace stig {

void fill_move_words(std::uint64_t seed, std::uint32_t run, std::uint64_t block, bool vectorise,
                     std::array<std::vector<std::uint32_t>, 4>& out) {
  const auto counter = random_address(run, Purpose::move, 0, block);
  const auto key = random_key(seed);
  const std::size_t agents = out[0].size();
  std::size_t agent = 0;
  if (vectorise && walk_batch_available()) {
    for (; agent + 16 <= agents; agent += 16) fill_batch(counter, key, agent, out);
  }
  for (; agent < agents; ++agent) {
    const auto words =
        philox({counter[0], counter[1], static_cast<std::uint32_t>(agent), counter[3]}, key);
    for (std::size_t w = 0; w < 4; ++w) out[w][agent] = words[w];
  }
}

std::uint32_t walk_some(const WalkArrays& arrays, const Moves& moves_given,
                        const Order& order_given, std::uint32_t& agent, std::uint32_t count) {
  // Copies whose address stays here: stores to the flags cannot change them.
  const Moves moves = moves_given;
  const Order order = order_given;
  std::uint8_t* const flags = arrays.flags;
  std::uint32_t who = agent, done = 0;
  for (; done < count; ++done, who = order.next(who)) {
    const std::int32_t from = arrays.position[who];
    const std::int32_t to = from + chosen_step(moves, arrays.word[who]);
    const std::uint8_t there = flags[to];
    if ((flags[from] & kEnabledCell) != 0 || (there & kPortalCell) != 0) break;
    if ((there & (kSolidCell | kAgentCell)) != 0) continue;
    flags[from] = static_cast<std::uint8_t>(flags[from] & ~kAgentCell);
    flags[to] = static_cast<std::uint8_t>(there | kAgentCell);
    arrays.position[who] = to;
  }
  agent = who;
  return done;
}

std::array<std::uint32_t, 16> batch_lanes(const Order& order) {
  std::array<std::uint32_t, 16> lanes{};
  for (std::size_t i = 1; i < lanes.size(); ++i) lanes[i] = order.next(lanes[i - 1]);
  return lanes;
}

}  // namespace stig
