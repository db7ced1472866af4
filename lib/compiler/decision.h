// SPDX-License-Identifier: MIT
// The policy as a decision tree over as few observations as tell its cases apart.
//
//     top colour?
//     ├─ Q3: top level?  0, 1: raise with Q3;  2: extend with Q2
//     ├─ Q2: top level?  0: raise with Q2;     1: extend with Q1
//     └─ Q1: nothing
//
// Every observation that can arise under the policy ends in a leaf that the policy allows
// there. Where a question's answer is not seen, nothing is done.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/policy.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// What is asked: the column's top, what is known of a cell of the window, or from which side.
struct Question {
  enum class Kind : std::uint8_t { top_colour, top_level, cell, side } kind = Kind::top_colour;
  WindowCell cell;
  auto operator<=>(const Question&) const = default;
};

/// The answer: a colour, a level, kSeenEmpty / kSeenBrick + colour, or an ApproachSide; nothing
/// where it is not known.
std::optional<int> answer(const Question& question, const Observation& seen);

struct DecisionNode {
  std::optional<Question> question;  ///< none: a leaf
  /// By answer, rising; answers that lead on alike share a branch.
  std::vector<std::pair<std::vector<int>, std::unique_ptr<DecisionNode>>> branches;
  std::optional<Placement> placement;       ///< of a leaf; none: nothing is to be done here
  std::vector<std::uint32_t> observations;  ///< of the policy that end here
};

struct Decision {
  std::unique_ptr<DecisionNode> root;  ///< null: there are cases that nothing tells apart
  /// Those cases: what is allowed in some of them and not in others, with a situation of each.
  std::vector<Withdrawal> unasked;
};

/// The tree of a complete policy.
Decision make_decision(const Policy& policy);

/// Prunes the policy and makes its tree; where cases cannot be told apart, what only some of
/// them allow is withdrawn, and it begins again. Null when the policy is not complete then.
std::unique_ptr<DecisionNode> settle(const TargetBricks& target, Policy& policy,
                                     Pruning pruning = Pruning::search);

/// Looks for a smaller tree: where columns with one top take several questions, nothing is to
/// be done but where one cell shows one thing, if work completes all the same. Policies of
/// more than `most` structures are left as they are.
std::unique_ptr<DecisionNode> simplify(const TargetBricks& target, Policy& policy,
                                       std::unique_ptr<DecisionNode> root, std::size_t most = 2000);

/// The leaf's placement that an observation leads to; nothing too where a question's answer is
/// not seen or has no branch.
std::optional<Placement> decide(const DecisionNode& root, const Observation& seen);

}  // namespace stig::compiler
