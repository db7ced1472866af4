// SPDX-License-Identifier: MIT
#include "sensing/led_code.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/led_name.h"
#include "support/uses.h"

namespace stig::sensing {
namespace {

int apart(const LedWord& a, const LedWord& b) {
  int out = 0;
  for (std::size_t i = 0; i < a.size(); ++i) out += a[i] != b[i];
  return out;
}

TEST_CASE("code words are as far apart as their code says, and no farther") {
  for (const int kinds : {4, 16, kMostKinds}) {
    int least = 4;
    for (int one = 1; one <= kinds; ++one) {
      for (int other = 1; other < one; ++other) {
        least = std::min(least, apart(word_of(one), word_of(other)));
      }
    }
    CHECK(code_size(kinds) == kinds);
    CHECK(code_distance(kinds) == least);
  }
  CHECK(code_size(5) == 16);
  CHECK(code_size(17) == kMostKinds);
}

TEST_CASE("the first four kinds show one colour all round") {
  for (std::uint8_t kind = 1; kind <= 4; ++kind) {
    CHECK(word_of(kind) == LedWord{kind, kind, kind, kind});
  }
  CHECK(word_of(5) == LedWord{1, 2, 3, 4});
}

TEST_CASE("a word is of its kind, and what is no word of none") {
  for (int kind = 1; kind <= kMostKinds; ++kind) CHECK(kind_of(word_of(kind)) == kind);
  CHECK_FALSE(kind_of({0, 0, 0, 0}));
  CHECK_FALSE(kind_of({1, 1, 1, 2}));
}

TEST_CASE("as many LEDs as have to be seen tell kinds apart with one of them missed") {
  for (const int kinds : {5, 16, 17, kMostKinds}) {
    CHECK(leds_needed(kinds) - 1 == 4 - code_distance(kinds) + 1);
  }
}

TEST_CASE("kinds have names") {
  CHECK(kind_named("off") == 0);
  CHECK(kind_named("Q4") == 4);
  CHECK(kind_named("Q62") == 62);
  for (const char* other : {"", "Q", "Q0", "Q63", "q1", "Q04"}) CHECK_FALSE(kind_named(other));
}

}  // namespace
}  // namespace stig::sensing
