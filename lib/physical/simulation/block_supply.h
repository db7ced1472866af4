// SPDX-License-Identifier: MIT
// Blocks that come while a scene runs: from its caches, and from the stock of its script.
#pragma once

#include <string>
#include <vector>

#include "physical/simulation/run_part.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

struct CacheSpawn;
struct Scene;

class BlockSupply final : public SavedPart<BlockSupply> {
 public:
  explicit BlockSupply(const Scene& scene);

  /// A block of the script's stock; `used_up`: there is none.
  AddResult drop(RunState& run, const Pose& X_WB, bool& used_up);

  /// Refills the caches.
  void before_step(RunState& run, const RunHooks& hooks) override;
  static void members(auto& each, auto& supply) {
    for (auto& blocks : supply.dropped_) each(blocks);
  }
  bool accept(const RunState& run) const;

 private:
  std::vector<std::size_t> dropped_;  ///< by each cache, and by the script
};

}  // namespace stig::physics
