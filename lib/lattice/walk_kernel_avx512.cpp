// SPDX-License-Identifier: MIT
// The vector path of the walk engine (see walk_kernel.h).
#include "lattice/walk_kernel.h"

#if defined(__x86_64__)
#include <immintrin.h>
#if defined(__GNUC__) && !defined(__clang__)
// GCC 12's intrinsics headers leave a register undefined on purpose and then warn of it.
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#endif

namespace stig {

#if defined(__x86_64__)

bool walk_batch_available() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd");
}

#define STIG_AVX512 __attribute__((target("avx512f,avx512cd")))

namespace {

/// Does a lane want to go where an earlier lane stands? (That one may leave first.)
STIG_AVX512 bool waits_for_earlier(__m512i target, __m512i position, __mmask16 waiting) {
  alignas(64) std::int32_t targets[16];
  _mm512_store_si512(targets, target);
  for (unsigned rest = waiting; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<unsigned>(__builtin_ctz(rest));
    const __mmask16 earlier = static_cast<__mmask16>((1U << lane) - 1U);
    if (_mm512_mask_cmpeq_epi32_mask(earlier, position, _mm512_set1_epi32(targets[lane])) != 0) {
      return true;
    }
  }
  return false;
}

/// (word · count) >> 32 in each lane.
STIG_AVX512 __m512i high_product(__m512i word, __m512i count) {
  const __m512i even = _mm512_srli_epi64(_mm512_mul_epu32(word, count), 32);
  const __m512i odd = _mm512_mul_epu32(_mm512_srli_epi64(word, 32), count);
  return _mm512_mask_blend_epi32(0xAAAA, even, odd);
}

/// Low and high halves of the lanes' products with a constant.
STIG_AVX512 void full_product(__m512i x, std::uint32_t factor, __m512i& low, __m512i& high) {
  const __m512i f = _mm512_set1_epi32(static_cast<int>(factor));
  const __m512i even = _mm512_mul_epu32(x, f);
  const __m512i odd = _mm512_mul_epu32(_mm512_srli_epi64(x, 32), f);
  low = _mm512_mask_blend_epi32(0xAAAA, even, _mm512_slli_epi64(odd, 32));
  high = _mm512_mask_blend_epi32(0xAAAA, _mm512_srli_epi64(even, 32), odd);
}

STIG_AVX512 __m512i exclusive_or(__m512i a, __m512i b, std::uint32_t key) {
  return _mm512_xor_si512(_mm512_xor_si512(a, b), _mm512_set1_epi32(static_cast<int>(key)));
}

}  // namespace

/// Philox4x32-10 in sixteen lanes that differ in word 2, the agent. Tests hold it to
/// base/random.h.
STIG_AVX512 void fill_batch(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key,
                            std::size_t agent, std::array<std::vector<std::uint32_t>, 4>& out) {
  const auto all = [](std::uint32_t word)
                       STIG_AVX512 { return _mm512_set1_epi32(static_cast<int>(word)); };
  __m512i c0 = all(counter[0]), c1 = all(counter[1]), c3 = all(counter[3]);
  const __m512i lane = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  __m512i c2 = _mm512_add_epi32(all(static_cast<std::uint32_t>(agent)), lane);
  for (int round = 0; round < 10; ++round) {
    __m512i low0, high0, low1, high1;
    full_product(c0, 0xD2511F53, low0, high0);
    full_product(c2, 0xCD9E8D57, low1, high1);
    c0 = exclusive_or(high1, c1, key[0]);
    c2 = exclusive_or(high0, c3, key[1]);
    c1 = low1;
    c3 = low0;
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  _mm512_storeu_si512(&out[0][agent], c0);
  _mm512_storeu_si512(&out[1][agent], c1);
  _mm512_storeu_si512(&out[2][agent], c2);
  _mm512_storeu_si512(&out[3][agent], c3);
}

STIG_AVX512 bool walk_batch(const WalkArrays& arrays, const Moves& moves, const Order& order,
                            const std::array<std::uint32_t, 16>& lanes, std::uint32_t agent) {
  const __m512i count = _mm512_set1_epi32(static_cast<int>(order.count));
  __m512i who = _mm512_add_epi32(_mm512_loadu_si512(lanes.data()),
                                 _mm512_set1_epi32(static_cast<int>(agent)));
  who = _mm512_min_epu32(who, _mm512_sub_epi32(who, count));

  const __m512i from = _mm512_i32gather_epi32(who, arrays.position, 4);
  const __m512i word = _mm512_i32gather_epi32(who, arrays.word, 4);
  const __m512i pick = high_product(word, _mm512_set1_epi32(static_cast<int>(moves.count)));
  const __m512i step = _mm512_permutex2var_epi32(_mm512_loadu_si512(moves.step.data()), pick,
                                                 _mm512_loadu_si512(moves.step.data() + 16));
  const __m512i to = _mm512_add_epi32(from, step);
  const __m512i at_from = _mm512_i32gather_epi32(from, arrays.flags, 1);
  const __m512i at_to = _mm512_i32gather_epi32(to, arrays.flags, 1);

  const auto any = [](__m512i flags, int bits) STIG_AVX512 {
    return _mm512_test_epi32_mask(flags, _mm512_set1_epi32(bits));
  };
  if ((any(at_from, kEnabledCell) | any(at_to, kPortalCell)) != 0) return false;
  const __mmask16 waiting = any(at_to, kAgentCell);
  const __mmask16 moving = static_cast<__mmask16>(~(waiting | any(at_to, kSolidCell)));
  const __m512i clash = _mm512_maskz_conflict_epi32(moving, to);
  if (_mm512_test_epi32_mask(clash, clash) != 0) return false;
  if (waiting != 0 && waits_for_earlier(to, from, waiting)) return false;

  _mm512_mask_i32scatter_epi32(arrays.position, moving, who, to, 4);
  alignas(64) std::int32_t left[16], entered[16];
  _mm512_store_si512(left, _mm512_maskz_compress_epi32(moving, from));
  _mm512_store_si512(entered, _mm512_maskz_compress_epi32(moving, to));
  const int number = __builtin_popcount(moving);
  for (int i = 0; i < number; ++i) {
    arrays.flags[left[i]] = static_cast<std::uint8_t>(arrays.flags[left[i]] & ~kAgentCell);
    arrays.flags[entered[i]] = static_cast<std::uint8_t>(arrays.flags[entered[i]] | kAgentCell);
  }
  return true;
}

#else

bool walk_batch_available() { return false; }
void fill_batch(std::array<std::uint32_t, 4>, std::array<std::uint32_t, 2>, std::size_t,
                std::array<std::vector<std::uint32_t>, 4>&) {}
bool walk_batch(const WalkArrays&, const Moves&, const Order&, const std::array<std::uint32_t, 16>&,
                std::uint32_t) {
  return false;
}

#endif

}  // namespace stig
