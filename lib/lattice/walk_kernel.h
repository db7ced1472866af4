// SPDX-License-Identifier: MIT
// The inner loop of the walk engine: one byte of flags a cell, moves drawn for all
// agents four steps ahead, and a loop without branches that makes them.
//
// Only the drawing is vectorised (sixteen agents at a time where the processor has
// AVX-512); the moves themselves are made one after another, as the model says. A
// loop that moved sixteen agents at once, where they could not meet, was slower: what
// costs is memory, not arithmetic.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lattice/uses.h"

namespace stig::lattice {

/// Flags of a cell of the padded box.
enum : std::uint8_t {
  kSolidCell = 1,    ///< a brick, floor, or a solid side
  kAgentCell = 2,    ///< an agent is here
  kEnabledCell = 4,  ///< some rule matches here
  kPortalCell = 8,   ///< padding of a periodic side; stands for a cell across
};

/// Index steps of the moves agents can make, and the number of them.
struct Moves {
  std::array<std::int32_t, 32> step{};
  std::uint32_t count = 0;
};

/// The order in which agents act within a step: agent (base + k·stride) mod count
/// for k = 0, 1, …; stride is coprime to count. Drawn anew for every step.
struct WalkOrder {
  std::uint32_t base = 0, stride = 1, count = 1;
  std::uint32_t next(std::uint32_t agent) const {
    const std::uint32_t sum = agent + stride;
    return sum >= count ? sum - count : sum;
  }
};

/// Index steps of agents 0 … size-1 in steps 4·block … 4·block + 3: out[w][agent].
/// Drawn from the words of Purpose::move at (agent, block): move (word · count) / 2^32,
/// uniform up to a bias of count / 2^32.
void draw_moves(std::uint64_t seed, std::uint32_t run, std::uint64_t block, const Moves& moves,
                bool vectorise, std::array<std::vector<std::int32_t>, 4>& out);

/// Is the vector path of draw_moves there on this processor?
bool vector_moves_available();
/// It, for the 16 agents from `agent` on.
void draw_moves_vector(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key,
                       std::size_t agent, const Moves& moves,
                       std::array<std::vector<std::int32_t>, 4>& out);

/// Moves up to `count` agents from `agent` on, one after another; stops before one that
/// is stimulated or steps through a portal. Returns how many acted; `agent` is then the
/// next in the order. `flags` and `position` as in the engine; `step` by agent.
std::uint32_t walk_some(std::uint8_t* flags, std::int32_t* position, const std::int32_t* step,
                        WalkOrder order, std::uint32_t& agent, std::uint32_t count);

// In large boxes what costs is memory. There two bits a cell take the place of its byte:
// kOccupiedBit for bricks, sides and agents alike, and kSpecialBit for cells where an agent's turn
// needs more than these: enabled ones, portals, and bricks with an agent in them.
inline constexpr std::uint64_t kOccupiedBit = 1, kSpecialBit = 2;

/// As walk_some, with such bits, 32 cells a word; stops where a special cell has a part in the
/// turn. Positions and steps are twice the cells' indices and their differences.
std::uint32_t walk_some_packed(std::uint64_t* bits, std::int32_t* position,
                               const std::int32_t* step, WalkOrder order, std::uint32_t& agent,
                               std::uint32_t count);

}  // namespace stig::lattice
