// SPDX-License-Identifier: MIT
// The kernel for large boxes. In a box of 100³ cells it needs 260 kB in place of a megabyte, which
// stay near the processor; where all is near anyhow the bytes are faster, since they need no
// shifts.
#include "lattice/walk_kernel.h"

#if defined(__x86_64__)
#define STIG_BMI2 __attribute__((target("bmi,bmi2")))
#endif

namespace stig::lattice {
namespace {

__attribute__((always_inline)) inline std::uint32_t walk_words(
    std::uint64_t* bits, std::int32_t* position, const std::int32_t* step, WalkOrder order,
    std::uint32_t& agent, std::uint32_t count) {
  std::uint32_t who = agent, done = 0;
  for (; done < count; ++done, who = order.next(who)) {
    const auto from = static_cast<std::uint32_t>(position[who]);
    const auto by = static_cast<std::uint32_t>(step[who]);  // sums wrap
    const std::uint32_t to = from + by;
    const std::uint64_t here = bits[from / 64] >> (from % 64), there = bits[to / 64] >> (to % 64);
    if (((here | there) & kSpecialBit) != 0) break;
    // A mask instead of a branch, as in walk_some.
    const std::uint32_t free = static_cast<std::uint32_t>(there & kOccupiedBit) - 1;
    const std::uint32_t end = from + (by & free);
    bits[from / 64] &= ~(kOccupiedBit << (from % 64));
    bits[end / 64] |= kOccupiedBit << (end % 64);
    position[who] = static_cast<std::int32_t>(end);
  }
  agent = who;
  return done;
}

#if defined(__x86_64__)
/// Shifts by a variable are one instruction there.
STIG_BMI2 std::uint32_t walk_words_bmi2(std::uint64_t* bits, std::int32_t* position,
                                        const std::int32_t* step, WalkOrder order,
                                        std::uint32_t& agent, std::uint32_t count) {
  return walk_words(bits, position, step, order, agent, count);
}
#endif

}  // namespace

std::uint32_t walk_some_packed(std::uint64_t* bits, std::int32_t* position,
                               const std::int32_t* step, WalkOrder order, std::uint32_t& agent,
                               std::uint32_t count) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("bmi2")) {
    return walk_words_bmi2(bits, position, step, order, agent, count);
  }
#endif
  return walk_words(bits, position, step, order, agent, count);
}

}  // namespace stig::lattice
