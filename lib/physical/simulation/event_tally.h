// SPDX-License-Identifier: MIT
// Events of a run, counted.
#pragma once

#include <cstdint>
#include <vector>

#include "physical/simulation/run_part.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

struct RunTally {
  std::uint64_t contacts = 0, slept = 0, woke = 0, snapped = 0, let_go = 0;
  std::vector<std::uint32_t> left;  ///< bodies, in order

  static void members(auto& each, auto& tally) {
    each(tally.contacts), each(tally.slept), each(tally.woke), each(tally.snapped);
    each(tally.let_go), each.list(tally.left);
  }
  friend bool operator==(const RunTally&, const RunTally&) = default;
};

class EventTally final : public SavedPart<EventTally> {
 public:
  const RunTally& tally() const { return tally_; }

  void after_step(RunState& run) override;
  static void members(auto& each, auto& part) { each_member(each, part.tally_); }
  bool accept(const RunState& run) const;

 private:
  void count(const WorldEvent& event);

  RunTally tally_;
};

}  // namespace stig::physics
