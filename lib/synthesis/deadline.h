// SPDX-License-Identifier: MIT
// Time that may be spent, and whether it is.
#pragma once

#include <atomic>
#include <chrono>

#include "synthesis/uses.h"

namespace stig::synthesis {

struct Deadline {
  std::chrono::steady_clock::time_point end = std::chrono::steady_clock::time_point::max();
  const std::atomic<bool>* stop = nullptr;  ///< set: as if the time were over

  static Deadline after(double seconds, const std::atomic<bool>* stop = nullptr) {
    return {std::chrono::steady_clock::now() +
                std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                    std::chrono::duration<double>(seconds)),
            stop};
  }
  bool passed() const {
    return (stop != nullptr && stop->load(std::memory_order_relaxed)) ||
           std::chrono::steady_clock::now() >= end;
  }
};

}  // namespace stig::synthesis
