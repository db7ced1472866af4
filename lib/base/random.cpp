// SPDX-License-Identifier: MIT
// Philox4x32-10 from the Random123 library, addressed by (seed, run, purpose, agent, step).
// Results are part of the program's interface: traces and golden files hold random numbers,
// so neither addresses nor the way in which words become numbers can change.
#include "base/random.h"

#include <Random123/philox.h>

#include <cassert>

namespace stig {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  const r123::Philox4x32::ctr_type c = {{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x32::key_type k = {{key[0], key[1]}};
  const auto words = r123::Philox4x32{}(c, k);
  return {words[0], words[1], words[2], words[3]};
}

/// The step's high half shares a word with the block's number, and the run with the purpose:
/// hence the limits.
std::array<std::uint32_t, 4> random_address(std::uint32_t run, Purpose purpose, std::uint32_t agent,
                                            std::uint64_t step) {
  assert(run < 1U << 24);
  assert(step < std::uint64_t{1} << 44);
  return {static_cast<std::uint32_t>(step >> 32), static_cast<std::uint32_t>(step), agent,
          run << 8 | static_cast<std::uint32_t>(purpose)};
}

std::array<std::uint32_t, 2> random_key(std::uint64_t seed) {
  return {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
}

Random::Random(std::uint64_t seed, std::uint32_t run, Purpose purpose, std::uint32_t agent,
               std::uint64_t step)
    : counter_(random_address(run, purpose, agent, step)), key_(random_key(seed)) {}

/// Four words per block; a stream moves on by incrementing the block's number within its
/// address.
std::uint32_t Random::next() {
  if (used_ == 4) {
    words_ = philox(counter_, key_);
    counter_[0] += kRandomBlock;
    used_ = 0;
  }
  return words_[static_cast<std::size_t>(used_++)];
}

std::uint64_t Random::below(std::uint64_t bound) {
  assert(bound >= 1);
  // Lemire 2019, "Fast random integer generation in an interval", in 64 bits.
  const auto draw = [this] {
    const std::uint64_t high = next();
    return high << 32 | next();
  };
  __extension__ using Wide = unsigned __int128;
  Wide product = static_cast<Wide>(draw()) * bound;
  if (static_cast<std::uint64_t>(product) < bound) {
    // The rejection is needed for few values; its threshold costs a division, so it is
    // computed only then.
    const std::uint64_t threshold = (0 - bound) % bound;
    while (static_cast<std::uint64_t>(product) < threshold) {
      product = static_cast<Wide>(draw()) * bound;
    }
  }
  return static_cast<std::uint64_t>(product >> 64);
}

double Random::unit() {
  // 53 bits are all that a double's fraction holds, so every value is equally likely.
  const std::uint64_t high = next();
  const std::uint64_t bits = (high << 32 | next()) >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

}  // namespace stig
