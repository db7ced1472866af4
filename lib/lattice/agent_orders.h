// SPDX-License-Identifier: MIT
// The order in which agents act in a step: (base + k·stride) mod n for k = 0, 1, …, n - 1, with
// base and stride drawn for each step. It is a function of the step alone, so an engine may ask for
// any step without those before it.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "lattice/uses.h"
#include "lattice/walk_kernel.h"

namespace stig::lattice {

class AgentOrders {
 public:
  /// agents >= 1.
  AgentOrders(std::uint64_t seed, std::uint32_t run, std::uint32_t agents);
  WalkOrder of_step(std::uint64_t step);

 private:
  std::uint64_t seed_;
  std::uint32_t run_, agents_;
  std::vector<std::uint32_t> strides_;
  std::uint64_t block_ = ~std::uint64_t{0};  ///< whose words these are
  std::array<std::uint32_t, 4> words_{};
};

/// k, of the agent that acts k-th; the inverse of agent_at.
std::uint32_t place_in(const WalkOrder& order, std::uint32_t agent);
std::uint32_t agent_at(const WalkOrder& order, std::uint32_t place);

}  // namespace stig::lattice
