// SPDX-License-Identifier: MIT
// What sensors get wrong, all of it off by default. Every error is a function of its address
// (seed, robot, device, tick), so neither threads nor what else is simulated change it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

#include "base/random.h"
#include "physical/sensors/uses.h"

namespace stig::physics {

struct CameraNoise {
  double pixel = 0;        ///< px, standard deviation of each coordinate of a corner or an LED
  double missed_tags = 0;  ///< probability that a tag in view is not reported
  double missed_leds = 0;
  double false_tags = 0;  ///< probability that an image has a tag that is not there
  double false_leds = 0;
  double colour = 0;  ///< standard deviation of each of an LED's Y, U and V, which are 0 to 255
  int latency = 0;    ///< control ticks that an image is late
};

struct RangeNoise {
  double distance = 0;  ///< m, standard deviation, before calibration
  int latency = 0;      ///< control ticks
};

/// A wheel encoder whose counts are read once in a short window.
struct EncoderNoise {
  double count = 0;  ///< m/s, of a rim that moves on by one count in a window; 0: exact
};

/// Where a device's errors are drawn. The caller numbers the devices of a robot across kinds, below
/// 2^24.
struct NoiseAddress {
  std::uint64_t seed = 0;
  std::uint32_t robot = 0;
  std::uint32_t device = 0;
  std::uint64_t tick = 0;
};
Random noise_stream(const NoiseAddress& address);

/// The device number of a robot's drive, after all others.
inline constexpr std::uint32_t kDriveDevice = (1U << 24) - 1;

/// A speed as an encoder tells it, m/s: whole counts in a window that begins anywhere between two
/// of them, so that the mean over many windows is right.
double counted(double speed, const EncoderNoise& noise, Random& random);

/// Readings that arrive late. Until the first has arrived there are empty ones.
template <class Reading>
struct Late {
  std::deque<Reading> on_the_way;

  /// Takes what is sensed now, gives what arrives now.
  Reading pass(Reading now, int latency) {
    on_the_way.push_back(std::move(now));
    if (on_the_way.size() <= static_cast<std::size_t>(latency)) return Reading{};
    Reading out = std::move(on_the_way.front());
    on_the_way.pop_front();
    return out;
  }
};

}  // namespace stig::physics
