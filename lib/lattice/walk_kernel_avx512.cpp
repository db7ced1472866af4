// SPDX-License-Identifier: MIT
// The vector path of draw_moves (see walk_kernel.h): Philox4x32-10 in sixteen lanes.
// Tests compare it with base/random.h.
#include "lattice/walk_kernel.h"

#if defined(__x86_64__)
#include <immintrin.h>
#if defined(__GNUC__) && !defined(__clang__)
// GCC 12's intrinsics headers leave a register undefined on purpose and then warn of it.
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#define STIG_AVX512 __attribute__((target("avx512f")))
#endif

namespace stig::lattice {

#if defined(__x86_64__)
namespace {

STIG_AVX512 __m512i all(std::uint32_t word) { return _mm512_set1_epi32(static_cast<int>(word)); }

/// Low and high halves of the lanes' products with a constant. There is no instruction for
/// 32-bit high products: even and odd lanes are multiplied to 64 bits and woven together
/// again.
struct Product {
  __m512i low, high;
};
STIG_AVX512 Product product(__m512i x, std::uint32_t factor) {
  const __m512i even = _mm512_mul_epu32(x, all(factor));
  const __m512i odd = _mm512_mul_epu32(_mm512_srli_epi64(x, 32), all(factor));
  return {_mm512_mask_blend_epi32(0xAAAA, even, _mm512_slli_epi64(odd, 32)),
          _mm512_mask_blend_epi32(0xAAAA, _mm512_srli_epi64(even, 32), odd)};
}

STIG_AVX512 __m512i exclusive_or(__m512i a, __m512i b, std::uint32_t key) {
  return _mm512_xor_si512(_mm512_xor_si512(a, b), all(key));
}

STIG_AVX512 void store_steps(__m512i words, const Moves& moves, std::int32_t* out) {
  const __m512i steps = _mm512_permutex2var_epi32(_mm512_loadu_si512(moves.step.data()),
                                                  product(words, moves.count).high,
                                                  _mm512_loadu_si512(moves.step.data() + 16));
  _mm512_storeu_si512(out, steps);
}

}  // namespace

bool vector_moves_available() { return __builtin_cpu_supports("avx512f"); }

STIG_AVX512 void draw_moves_vector(std::array<std::uint32_t, 4> counter,
                                   std::array<std::uint32_t, 2> key, std::size_t agent,
                                   const Moves& moves,
                                   std::array<std::vector<std::int32_t>, 4>& out) {
  const __m512i lane = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  __m512i c0 = all(counter[0]), c1 = all(counter[1]), c3 = all(counter[3]);
  __m512i c2 = _mm512_add_epi32(all(static_cast<std::uint32_t>(agent)), lane);
  // Ten rounds, with the constants of J. Salmon et al., "Parallel random numbers: as easy
  // as 1, 2, 3" (SC 2011).
  for (int round = 0; round < 10; ++round) {
    const Product p0 = product(c0, 0xD2511F53), p1 = product(c2, 0xCD9E8D57);
    c0 = exclusive_or(p1.high, c1, key[0]);
    c2 = exclusive_or(p0.high, c3, key[1]);
    c1 = p1.low;
    c3 = p0.low;
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  store_steps(c0, moves, &out[0][agent]);
  store_steps(c1, moves, &out[1][agent]);
  store_steps(c2, moves, &out[2][agent]);
  store_steps(c3, moves, &out[3][agent]);
}

#else

bool vector_moves_available() { return false; }
void draw_moves_vector(std::array<std::uint32_t, 4>, std::array<std::uint32_t, 2>, std::size_t,
                       const Moves&, std::array<std::vector<std::int32_t>, 4>&) {}

#endif

}  // namespace stig::lattice
