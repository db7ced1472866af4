// SPDX-License-Identifier: MIT
// Forces that a script wants to act for a while.
#pragma once

#include <cstdint>
#include <vector>

#include "physical/simulation/run_part.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

class ForcePushes final : public SavedPart<ForcePushes> {
 public:
  /// At the body's centre of mass, N, from now on for so many ticks. False: there are too many
  /// such.
  bool add(const RunState& run, BodyId body, const Vec3& force, std::uint64_t ticks);

  void before_step(RunState& run, const RunHooks& hooks) override;
  static void members(auto& each, auto& part) { each.list(part.pushes_); }
  bool accept(const RunState& run) const;

 private:
  struct Push {
    std::uint32_t body = 0;
    std::uint64_t until = 0;  ///< the first tick without it
    Vec3 force;

    static void members(auto& each, auto& push) {
      each(push.body), each(push.until), each_member(each, push.force);
    }
  };

  std::vector<Push> pushes_;
};

}  // namespace stig::physics
