// SPDX-License-Identifier: MIT
// What a proof may cost. Time only ever ends a search: it never decides what a search
// looks at, so a verdict reached within the budget does not depend on the clock.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace stig {

struct Budget {
  std::chrono::steady_clock::time_point end;  ///< when to give up
  std::uint64_t states = 2'000'000;           ///< fillings of a window held at a time
  const std::atomic<bool>* stop = nullptr;    ///< set from outside: give up soon

  bool spent() const {
    return (stop && stop->load(std::memory_order_relaxed)) ||
           std::chrono::steady_clock::now() >= end;
  }
};

}  // namespace stig
