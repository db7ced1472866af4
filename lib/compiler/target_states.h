// SPDX-License-Identifier: MIT
// The structure that every order of events ends in, and the structures on the way to it.
//
// Once a rule set is proved, whatever can be built from the start is a part of the proved
// structure in its colours. So a structure on the way is a set of its bricks.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/target_bricks.h"
#include "compiler/uses.h"
#include "verify/stage_model.h"
#include "verify/verify.h"

namespace stig::compiler {

/// What the rules of one brick ask of its neighbours.
struct Demands {
  std::vector<std::uint32_t> always;  ///< each rule asks for it
  std::vector<std::uint32_t> never;   ///< each rule forbids it
};

/// Bricks: those of the start first, then in the order of the proof's run.
class TargetStates : public TargetBricks {
 public:
  /// The states of a proved rule set with a single stage. Both arguments must outlive them.
  TargetStates(const RuleSet& rules, const VerifyResult& proof);
  TargetStates(TargetStates&&) noexcept;
  ~TargetStates();

  /// The rule by which the brick may be placed now, or nothing.
  std::optional<std::uint32_t> rule_for(const BrickSet& state, std::size_t brick) const;
  /// May a missing brick be placed in every structure that has all of `least` and nothing beyond
  /// `most`? False too where several rules would have to be looked at together.
  bool due_between(const BrickSet& least, const BrickSet& most, std::size_t brick) const;
  /// Does the one stand whenever the other does? As far as it is known.
  using ComesBefore = std::function<bool(std::uint32_t first, std::uint32_t then)>;
  /// The demands on a brick that is not of the start; neighbours of the start are left out. A rule
  /// that asks for a brick and forbids one that comes before it, or asks for one that comes after
  /// the brick itself, never fires here, and is left out.
  Demands demands(std::size_t brick, const ComesBefore& comes_before) const;
  /// Bricks that may be placed now, rising.
  std::vector<std::uint32_t> open(const BrickSet& state) const;
  /// As cells with colours, for drawings.
  Structure structure(const BrickSet& state) const;

 private:
  struct Model;
  const RuleSet* rules_;
  std::unique_ptr<Model> model_;
};

}  // namespace stig::compiler
