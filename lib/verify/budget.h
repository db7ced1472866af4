// SPDX-License-Identifier: MIT
// What a proof may cost. What it decides by is counted work: steps, about a nanosecond each
// on a machine of 2020, that depend on the input alone, so that the same search ends alike
// whatever else the machine does. The clock is looked at where a user set a time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>

#include "verify/uses.h"

namespace stig::verify {

inline constexpr double kNoTimeLimit = 3.2e7;  ///< seconds: a year, which the clock can hold
inline constexpr std::uint64_t kNoWorkLimit = std::numeric_limits<std::uint64_t>::max();

/// What one of these takes, in steps.
inline constexpr std::uint64_t kStepsOfDeposit = 4000;
inline constexpr std::uint64_t kStepsOfLook = 1000;  ///< at a site, its rules aside
inline constexpr std::uint64_t kStepsOfState = 50;   ///< of what is around a site
inline constexpr std::uint64_t kStepsOfCell = 20;    ///< of a filling, or of a world that is copied

inline std::chrono::steady_clock::time_point time_after(double seconds) {
  const double some = seconds < 0 ? 0 : seconds > kNoTimeLimit ? kNoTimeLimit : seconds;
  return std::chrono::steady_clock::now() +
         std::chrono::duration_cast<std::chrono::steady_clock::duration>(
             std::chrono::duration<double>(some));
}

/// Copies count on the same counter.
struct Budget {
  std::chrono::steady_clock::time_point end;  ///< when to give up
  std::uint64_t states = 2'000'000;           ///< fillings of a window held at a time
  const std::atomic<bool>* stop = nullptr;    ///< set from outside: give up soon
  std::uint64_t work = kNoWorkLimit;          ///< steps that may be done
  std::uint64_t* done = nullptr;              ///< steps that were; none: not counted

  void spend(std::uint64_t steps) const {
    if (done != nullptr) *done += steps;
  }
  std::uint64_t work_left() const {
    if (done == nullptr) return work;
    return work > *done ? work - *done : 0;
  }
  double seconds_left() const {
    const std::chrono::duration<double> rest = end - std::chrono::steady_clock::now();
    return rest.count() > 0 ? rest.count() : 0;
  }
  bool spent() const {
    return work_left() == 0 || (stop && stop->load(std::memory_order_relaxed)) ||
           std::chrono::steady_clock::now() >= end;
  }
  /// For inner loops: the clock and the signal are looked at every 1024th time only.
  bool spent_at(std::uint64_t count) const {
    return work_left() == 0 || (count % 1024 == 0 && spent());
  }
};

}  // namespace stig::verify
