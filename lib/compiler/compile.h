// SPDX-License-Identifier: MIT
// From a rule set to the decisions of a robot that builds its structure, or the reason why this
// robot cannot.
//
//     verify      every order of events ends in one structure
//     shape       cubic, one stage, four colours, low enough: what can be said at once
//     sides       from where robots work, and so what they know of the lattice's directions
//     policy      what to do where, so that every order of work completes (policy.h): found column
//     by
//                 column in large structures (local_policy.h), else by a walk over all structures
//     decision    the same as questions about what the camera sees (decision.h)
//     concurrent  whether several robots may work at once (concurrent.h)
//
// A robot has no compass. It knows directions relative to the side it works from: where rules
// hold in all four turns, that is enough. Otherwise the sides are declared (in the file, the
// scene or on the command line), and a robot that begins on a side it was told keeps count of its
// own turns; or the structure shows them at every decision; or the rule set is refused.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "compiler/concurrent.h"
#include "compiler/decision.h"
#include "compiler/policy.h"
#include "compiler/uses.h"
#include "verify/verify.h"

namespace stig::compiler {

enum class KnownDirections : std::uint8_t {
  symmetric,  ///< the rules hold in every turn
  declared,   ///< robots work from the declared sides alone
  shown,      ///< the structure shows it at every decision
};
std::string_view to_string(KnownDirections directions);

struct CompileOptions {
  std::vector<ApproachSide> sides;  ///< empty: the file's, or all
  std::optional<int> robots;        ///< that will work at once; otherwise the file's
  bool own_sides = true;            ///< each has sides of its own, as far as there are as many
  VerifyOptions verify;
  PolicyLimits limits;
};

/// Kinds of brick that are tried where nobody asks for more: published blocks show so many. More
/// are code words (sensing/led_code.h), up to kMostKinds.
inline constexpr int kBlockColours = 4;
/// The robot as it sees blocks that may show so many kinds: code words take more LEDs.
Abilities seeing(int kinds, Abilities robot);

/// Structures of more bricks are looked at column by column first.
inline constexpr std::size_t kMostWalkedFirst = 24;

/// A cell that a refusal is about, and what there is to say of it.
struct RefusalMark {
  enum class Kind : std::uint8_t { wanted, in_the_way } kind = Kind::wanted;
  Cell at;
  std::string text;
};

/// A picture that goes with a refusal or a warning: as text, and as bricks with marks.
struct RefusalDrawing {
  std::string title, drawing;
  std::vector<PlacedBrick> bricks{};
  std::vector<RefusalMark> marks{};
};

class Precedence;

/// A brick of a proof column by column, and the column where something is done as long as it is
/// the first that is missing: from the brick's own, towards the robot and to its left.
struct WayOn {
  std::uint32_t brick = 0;
  ApproachSide side{};
  int du = 0, dv = 0;
};

struct CompiledRules {
  VerifyResult proof;
  std::unique_ptr<TargetStates> target;
  std::vector<ApproachSide> sides;
  std::optional<int> robots;  ///< that will work at once; none: nobody said
  bool own_sides = true;      ///< each has sides of its own, as far as there are as many
  KnownDirections directions = KnownDirections::symmetric;
  Policy policy;
  /// A proof column by column (local_policy.h) looked at so many situations; the policy's
  /// structures are examples then. 0: all structures were walked.
  std::size_t local_situations = 0;
  std::shared_ptr<Visibility> visibility;  ///< of such a proof, as are these
  std::shared_ptr<const Precedence> precedence;
  std::vector<WayOn> ways_on;  ///< the bricks after the start, in the order of the proof
  std::unique_ptr<DecisionNode> decision;  ///< null: refused
  bool unknown = false;     ///< refused only since what was allowed was used up: P701 or P712
  Concurrency concurrency;  ///< of what was not refused before
  std::vector<RefusalDrawing> drawings;  ///< that go with what is reported
};

/// Is it proved that as many robots as are wanted may work at once? Not where nobody said how many,
/// unless any number may.
bool robots_may_work(const CompiledRules& compiled);
/// Structures that can occur on the way, where all were walked.
std::size_t structures_on_the_way(const CompiledRules& compiled);
/// "every order of work completes it: …", what that rests on.
std::string completion_text(const CompiledRules& compiled);

/// What policies may rest on, the least first.
std::vector<PolicyScope> policy_scopes(const CompiledRules& compiled);

/// Reports why not to `diagnostics`, codes P7xx. The rule set must outlive the result.
CompiledRules compile_rules(const RuleSet& rules, const Abilities& robot,
                            const CompileOptions& options, Diagnostics& diagnostics);

}  // namespace stig::compiler
