// SPDX-License-Identifier: MIT
// Does every order of events mend the loss of a brick?
//
// A *loss* takes one brick away from a structure that some order of events reaches: none of the
// start, one with none above it, and without which the others still hang together with the start,
// face to face. What is knocked off by accident is such a brick. It is restored if every order of
// events from there on ends in the structure that was proved.
//
// All structures are looked at, one by one: those that orders reach, and those that they reach
// after one loss. The answer is a theorem, and certify/loss_check.h re-checks it.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lattice/box.h"
#include "lattice/structure.h"
#include "verify/budget.h"
#include "verify/uses.h"
#include "verify/verify.h"

namespace stig::verify {

enum class LossVerdict : std::uint8_t {
  restored,  ///< every loss, in every order
  lasting,   ///< some loss is not, in some order
  unknown,   ///< not all structures were looked at
};
std::string_view to_string(LossVerdict verdict);  ///< "restored"

struct LossOptions {
  std::optional<Box> box;            ///< none: unbounded space
  std::uint64_t states = 200'000;    ///< structures at most
  std::uint64_t work = kVerifyWork;  ///< steps (budget.h)
  double seconds = kNoTimeLimit;
  const std::atomic<bool>* stop = nullptr;
  /// Now and then: the number of structures so far.
  std::function<void(std::uint64_t structures)> progress;
};

/// How a brick fares, of all structures that can lose it.
struct LostBrick {
  PlacedBrick brick;
  std::uint64_t losses = 0;
  std::uint64_t restored = 0;
};

/// The smallest structure with a loss that lasts, and an end of an order of events after it.
struct LastingLoss {
  std::vector<PlacedBrick> before;  ///< by cell, with the brick that is lost
  PlacedBrick lost;
  std::vector<PlacedBrick> end;
};

struct LossResult {
  LossVerdict verdict = LossVerdict::unknown;
  std::vector<std::vector<PlacedBrick>> reached;  ///< without a loss, the start first
  std::vector<std::vector<PlacedBrick>> after;    ///< after one alone
  std::vector<LostBrick> bricks;                  ///< by cell
  std::optional<LastingLoss> lasting;
  std::string open;          ///< unknown: why
  bool interrupted = false;  ///< by options.stop

  std::uint64_t losses() const;
  std::uint64_t restored() const;
};

/// `end` is the structure in which every order ends, as verify() has proved.
LossResult find_losses(const RuleSet& rules, const Structure& end, const LossOptions& options);

}  // namespace stig::verify
