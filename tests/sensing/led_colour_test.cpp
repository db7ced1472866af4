// SPDX-License-Identifier: MIT
#include "sensing/led_colour.h"
#include "support/uses.h"

#include <doctest/doctest.h>

namespace stig {
namespace {

TEST_CASE("a block's colours are told apart as the real camera does, dark is off") {
  for (std::uint8_t colour = 1; colour <= 4; ++colour) {
    const Yuv light = to_yuv(led_rgb(colour));
    CHECK(classify_led(light.u, light.v) == colour);
  }
  CHECK(classify_led(128, 128) == 0);
  CHECK(classify_led(120, 141) == 0);  // between Q1 and Q2
  CHECK(classify_led(141, 141) == 1);
  CHECK(classify_led(140, 141) == 0);
  CHECK(classify_led(138, 99) == 0);  // between Q3 and Q4
}

TEST_CASE("a window weighs its light with luminance, and sees six pixels each way") {
  LedWindow window({100, 50});
  CHECK(window.colour() == 0);
  window.add({104, 50}, to_yuv(led_rgb(2)));  // outside
  CHECK(window.colour() == 0);
  window.add({103, 47}, to_yuv(led_rgb(2)));
  CHECK(window.colour() == 2);
  window.add({100, 50}, {1, 40, 40});  // dim: hardly counts
  CHECK(window.colour() == 2);
  window.add({100, 50}, {2000, 200, 200});
  CHECK(window.colour() == 1);
}

}  // namespace
}  // namespace stig
