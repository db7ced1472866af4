// SPDX-License-Identifier: MIT
// How much a search may do. What it decides by is counted work: steps, about a
// nanosecond each on a machine of 2020, that depend on the input alone. So the same
// search gives the same answer whatever else the machine does. The clock can only end
// it altogether, and then it is known that it did.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "synthesis/deadline.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// Steps of one unit of effort, that of `stigc synth --effort 1`.
inline constexpr double kStepsOfEffort = 20e9;
/// The clock is looked at once in so many sites.
inline constexpr std::size_t kSitesBetweenLooks = 1024;

class Effort {
 public:
  explicit Effort(const Deadline& deadline) : deadline_(deadline) {}

  void spend(std::uint64_t steps) { spent_ += steps; }
  std::uint64_t spent() const { return spent_; }
  /// Is the time over? Once asked and answered yes it stays so.
  bool out_of_time() {
    cut_short_ = cut_short_ || deadline_.passed();
    return cut_short_;
  }
  /// Was the answer to out_of_time() ever yes, so that the search may have missed something?
  bool cut_short() const { return cut_short_; }

 private:
  Deadline deadline_;
  std::uint64_t spent_ = 0;
  bool cut_short_ = false;
};

/// Work up to a mark. Without an Effort: as much as it takes.
struct Allowance {
  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

  Effort* effort = nullptr;
  std::uint64_t end = kUnlimited;

  void spend(std::uint64_t steps) const {
    if (effort != nullptr) effort->spend(steps);
  }
  /// Steps that are left, not regarding the time.
  std::uint64_t left() const {
    if (effort == nullptr) return kUnlimited;
    return end > effort->spent() ? end - effort->spent() : 0;
  }
  bool passed() const { return left() == 0 || out_of_time(); }
  bool out_of_time() const { return effort != nullptr && effort->out_of_time(); }
  /// The part of this that ends so many steps from now.
  Allowance within(std::uint64_t steps) const {
    return {effort, effort == nullptr ? end : effort->spent() + std::min(steps, left())};
  }
};

}  // namespace stig::synthesis
