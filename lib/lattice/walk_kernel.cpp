// SPDX-License-Identifier: MIT
#include "lattice/walk_kernel.h"

#include "base/random.h"

namespace stig {
namespace {

// Philox4x32-10 with the loops arranged so that compilers vectorise over agents.
// Tests hold it to base/random.h.
constexpr std::uint32_t kMultiplier0 = 0xD2511F53, kMultiplier1 = 0xCD9E8D57;
constexpr std::uint32_t kWeyl0 = 0x9E3779B9, kWeyl1 = 0xBB67AE85;
constexpr std::size_t kLanes = 16;

struct Lanes {
  std::uint32_t c0[kLanes], c1[kLanes], c2[kLanes], c3[kLanes];
};

inline void philox_lanes(Lanes& x, std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      const std::uint64_t p0 = std::uint64_t{kMultiplier0} * x.c0[i];
      const std::uint64_t p1 = std::uint64_t{kMultiplier1} * x.c2[i];
      const std::uint32_t next0 = static_cast<std::uint32_t>(p1 >> 32) ^ x.c1[i] ^ key[0];
      const std::uint32_t next2 = static_cast<std::uint32_t>(p0 >> 32) ^ x.c3[i] ^ key[1];
      x.c1[i] = static_cast<std::uint32_t>(p1);
      x.c3[i] = static_cast<std::uint32_t>(p0);
      x.c0[i] = next0;
      x.c2[i] = next2;
    }
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
}

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define STIG_CLONES __attribute__((optimize("O3"), target_clones("default", "avx2", "avx512f")))
#else
#define STIG_CLONES
#endif

STIG_CLONES void fill_words(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key,
                            std::array<std::uint32_t*, 4> out, std::size_t agents) {
  for (std::size_t first = 0; first < agents; first += kLanes) {
    Lanes x;
    for (std::size_t i = 0; i < kLanes; ++i) {
      x.c0[i] = counter[0];
      x.c1[i] = counter[1];
      x.c2[i] = static_cast<std::uint32_t>(first + i);
      x.c3[i] = counter[3];
    }
    philox_lanes(x, key);
    for (std::size_t i = 0; i < kLanes; ++i) {  // rows are padded to whole batches
      out[0][first + i] = x.c0[i];
      out[1][first + i] = x.c1[i];
      out[2][first + i] = x.c2[i];
      out[3][first + i] = x.c3[i];
    }
  }
}

}  // namespace

void fill_move_words(std::uint64_t seed, std::uint32_t run, std::uint64_t block,
                     std::array<std::vector<std::uint32_t>, 4>& out) {
  fill_words(random_address(run, Purpose::move, 0, block), random_key(seed),
             {out[0].data(), out[1].data(), out[2].data(), out[3].data()}, out[0].size());
}

std::array<std::uint32_t, 16> batch_lanes(const Order& order) {
  std::array<std::uint32_t, 16> lanes{};
  for (std::size_t i = 1; i < lanes.size(); ++i) lanes[i] = order.next(lanes[i - 1]);
  return lanes;
}

}  // namespace stig
