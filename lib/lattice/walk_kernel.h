// SPDX-License-Identifier: MIT
// The inner loop of the walk engine: one byte of flags a cell, and moves of
// sixteen agents at a time where the processor has AVX-512.
//
// The vector path does what the agents would do one after another, or nothing: it
// steps aside (returns false) whenever an agent of the batch could affect another,
// so that its results equal the scalar path's bit for bit.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace stig {

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

/// The move a random word chooses: uniform up to a bias of count / 2^32.
inline std::int32_t chosen_step(const Moves& moves, std::uint32_t word) {
  return moves.step[static_cast<std::size_t>((std::uint64_t{word} * moves.count) >> 32)];
}

/// The order in which agents act within a step: agent (base + k·stride) mod count
/// for k = 0, 1, …; stride is coprime to count. Drawn anew for every step.
struct Order {
  std::uint32_t base = 0, stride = 1, count = 1;
  std::uint32_t next(std::uint32_t agent) const {
    const std::uint32_t sum = agent + stride;
    return sum >= count ? sum - count : sum;
  }
};

/// What a batch works on.
struct WalkArrays {
  std::uint8_t* flags = nullptr;        ///< by cell index; 4 readable bytes past the end
  std::int32_t* position = nullptr;     ///< by agent: cell index
  const std::uint32_t* word = nullptr;  ///< by agent: random word of this step
};

/// Words of Purpose::move at step `block` for agents 0 … size-1: out[w][agent].
void fill_move_words(std::uint64_t seed, std::uint32_t run, std::uint64_t block, bool vectorise,
                     std::array<std::vector<std::uint32_t>, 4>& out);
/// The vector path of it, for the 16 agents from `agent` on.
void fill_batch(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key,
                std::size_t agent, std::array<std::vector<std::uint32_t>, 4>& out);

/// Moves up to `count` agents from `agent` on, one after another; stops before one that
/// is stimulated or steps through a portal. Returns how many acted; `agent` is then the
/// next in the order.
std::uint32_t walk_some(const WalkArrays& arrays, const Moves& moves, const Order& order,
                        std::uint32_t& agent, std::uint32_t count);

/// Is the vector path there on this processor?
bool walk_batch_available();
/// lane[i] = i·stride mod count, for walk_batch.
std::array<std::uint32_t, 16> batch_lanes(const Order& order);
/// Moves the 16 agents from `agent` on in the order, all at once. False, with nothing
/// changed, if one of them is stimulated or they could get in each other's way.
bool walk_batch(const WalkArrays& arrays, const Moves& moves, const Order& order,
                const std::array<std::uint32_t, 16>& lanes, std::uint32_t agent);

}  // namespace stig
