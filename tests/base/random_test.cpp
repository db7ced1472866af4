// SPDX-License-Identifier: MIT
#include "base/random.h"

#include <doctest/doctest.h>

#include <set>
#include <vector>

#include "base/hash.h"
#include "support/uses.h"

using namespace stig;

TEST_CASE("philox gives the published known answers") {
  // Known-answer file of the Random123 distribution (Salmon et al. 2011), philox4x32 10.
  CHECK(philox({0, 0, 0, 0}, {0, 0}) ==
        std::array<std::uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
        std::array<std::uint32_t, 4>{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("streams of different address differ, of the same address agree") {
  std::set<std::uint64_t> seen;
  const auto first = [](std::uint64_t seed, std::uint32_t run, Purpose purpose, std::uint32_t agent,
                        std::uint64_t step) {
    Random r(seed, run, purpose, agent, step);
    const std::uint64_t high = r.next();
    return high << 32 | r.next();
  };
  for (std::uint64_t seed : {0ULL, 1ULL, 1ULL << 32}) {
    for (std::uint32_t run : {0U, 1U, (1U << 24) - 1}) {
      for (Purpose purpose : {Purpose::move, Purpose::event}) {
        for (std::uint32_t agent : {0U, 7U}) {
          for (std::uint64_t step : {0ULL, 1ULL, 1ULL << 32, (1ULL << 44) - 1}) {
            CHECK(seen.insert(first(seed, run, purpose, agent, step)).second);
            CHECK(first(seed, run, purpose, agent, step) == first(seed, run, purpose, agent, step));
          }
        }
      }
    }
  }
}

TEST_CASE("below is uniform and stays below") {
  for (std::uint64_t bound : {1ULL, 2ULL, 7ULL, 26ULL}) {
    std::vector<int> hits(bound);
    Random r(3, 0, Purpose::test, 0, bound);
    for (int i = 0; i < 26000; ++i) ++hits[r.below(bound)];
    const double expected = 26000.0 / static_cast<double>(bound);
    for (const int h : hits) CHECK(h == doctest::Approx(expected).epsilon(0.15));
  }
  Random r(3, 0, Purpose::test, 1, 0);
  for (int i = 0; i < 100; ++i) CHECK(r.below((1ULL << 63) + 1) <= 1ULL << 63);
}

TEST_CASE("unit lies in [0, 1) with mean one half") {
  Random r(5, 0, Purpose::test, 2, 0);
  double sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const double u = r.unit();
    REQUIRE(u >= 0);
    REQUIRE(u < 1);
    sum += u;
  }
  CHECK(sum / 10000 == doctest::Approx(0.5).epsilon(0.02));
}

TEST_CASE("hexadecimal is padded, text hashes are fixed") {
  CHECK(to_hex(0) == "0000000000000000");
  CHECK(to_hex(0xabcULL << 52) == "abc0000000000000");
  CHECK(hash_text("") != hash_text("a"));
  CHECK(to_hex(hash_text("stigmergy")) == to_hex(hash_text("stigmergy")));
}
