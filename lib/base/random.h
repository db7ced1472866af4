// SPDX-License-Identifier: MIT
// Counter-based random numbers: Philox4x32-10 (Salmon et al. 2011, "Parallel
// random numbers: as easy as 1, 2, 3"). A number is a function of its address,
// so streams need no state, never overlap, and are the same on every machine and
// any number of threads.
#pragma once

#include <array>
#include <cstdint>

namespace stig {

/// What a stream is for; streams of different purposes are independent.
enum class Purpose : std::uint32_t { move = 1, deposit, order, start, event, test, user, sense };

/// Four random words at an address.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

/// The address of a stream's first block. Word 0 holds the high half of the step
/// and, above kRandomBlock, the number of the block within the stream.
std::array<std::uint32_t, 4> random_address(std::uint32_t run, Purpose purpose, std::uint32_t agent,
                                            std::uint64_t step);
std::array<std::uint32_t, 2> random_key(std::uint64_t seed);
/// Added to word 0 from one block of a stream to the next: 2^20 blocks a stream, and
/// steps below 2^44.
inline constexpr std::uint32_t kRandomBlock = 1U << 12;

/// A stream of words at (seed, run, purpose, agent, step).
class Random {
 public:
  /// run < 2^24.
  Random(std::uint64_t seed, std::uint32_t run, Purpose purpose, std::uint32_t agent,
         std::uint64_t step);
  std::uint32_t next();
  /// Uniform in [0, bound), exactly (by rejection); bound >= 1.
  std::uint64_t below(std::uint64_t bound);
  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit();

 private:
  std::array<std::uint32_t, 4> counter_;
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> words_{};
  int used_ = 4;
};

}  // namespace stig
