// SPDX-License-Identifier: MIT
// The structure that every order of events ends in, and the structures on the way to it.
//
// Once a rule set is proved, whatever can be built from the start is a part of the proved
// structure in its colours. So a structure on the way is a set of its bricks.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/target_bricks.h"
#include "verify/stage_model.h"
#include "verify/verify.h"

namespace stig {

/// Bricks: those of the start first, then in the order of the proof's run.
class TargetStates : public TargetBricks {
 public:
  /// The states of a proved rule set with a single stage. Both arguments must outlive them.
  TargetStates(const RuleSet& rules, const VerifyResult& proof);
  TargetStates(TargetStates&&) noexcept;
  ~TargetStates();

  /// The rule by which the brick may be placed now, or nothing.
  std::optional<std::uint32_t> rule_for(const BrickSet& state, std::size_t brick) const;
  /// Bricks that may be placed now, rising.
  std::vector<std::uint32_t> open(const BrickSet& state) const;
  /// As cells with colours, for drawings.
  Structure structure(const BrickSet& state) const;

 private:
  struct Model;
  const RuleSet* rules_;
  std::unique_ptr<Model> model_;
};

}  // namespace stig
