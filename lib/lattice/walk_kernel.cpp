// SPDX-License-Identifier: MIT
// The scalar kernel; walk_kernel.h says what it has to be equal to. Moves of one agent in
// four consecutive steps come from one Philox block, so drawing costs a quarter of a block
// for each move.
#include "lattice/walk_kernel.h"

#include <algorithm>
#include <cassert>

#include "base/random.h"

namespace stig::lattice {

void draw_moves(std::uint64_t seed, std::uint32_t run, std::uint64_t block, const Moves& moves,
                bool vectorise, std::array<std::vector<std::int32_t>, 4>& out) {
  assert(moves.count >= 1 && moves.count <= moves.step.size());
  const auto counter = random_address(run, Purpose::move, 0, block);
  const auto key = random_key(seed);
  const std::size_t agents = out[0].size();
  assert(std::all_of(out.begin(), out.end(),
                     [&](const auto& steps) { return steps.size() == agents; }));
  std::size_t agent = 0;
  if (vectorise && vector_moves_available()) {
    for (; agent + 16 <= agents; agent += 16) draw_moves_vector(counter, key, agent, moves, out);
  }
  for (; agent < agents; ++agent) {
    const auto words =
        philox({counter[0], counter[1], static_cast<std::uint32_t>(agent), counter[3]}, key);
    // Lemire's multiplication in place of a remainder: biased by at most count / 2^32.
    for (std::size_t w = 0; w < 4; ++w) {
      out[w][agent] = moves.step[(std::uint64_t{words[w]} * moves.count) >> 32];
    }
  }
}

std::uint32_t walk_some(std::uint8_t* flags, std::int32_t* position, const std::int32_t* step,
                        WalkOrder order, std::uint32_t& agent, std::uint32_t count) {
  std::uint32_t who = agent, done = 0;
  for (; done < count; ++done, who = order.next(who)) {
    const std::int32_t from = position[who];
    const std::int32_t to = from + step[who];
    const std::uint8_t here = flags[from], there = flags[to];
    if (((here & kEnabledCell) | (there & kPortalCell)) != 0) break;
    // A mask instead of a branch on whether the way is free: that would be mispredicted
    // too often, and compilers turn ?: into one.
    const std::int32_t free = ((there & (kSolidCell | kAgentCell)) - 1) >> 31;
    const std::int32_t end = from + (step[who] & free);
    const int at_end = here ^ ((here ^ there) & free);
    flags[from] = static_cast<std::uint8_t>(here & ~kAgentCell);
    flags[end] = static_cast<std::uint8_t>(at_end | kAgentCell);
    position[who] = end;
  }
  agent = who;
  return done;
}

}  // namespace stig::lattice
