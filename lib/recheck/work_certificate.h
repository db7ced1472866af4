// SPDX-License-Identifier: MIT
// A certificate of robots' work: why every order in which robots follow their decisions ends in
// the whole structure, written so that another program than the compiler can check it.
// docs/proofs.md has the theorem.
//
//     stigc-work-certificate 1
//     rules 5f0c…                rule_set_hash of the set
//     robots any                 or: one, one-a-side
//     sides +x -x                from which robots work
//     look 0.14 0.0825           camera to column, and height of the lift; m
//     ask top-colour 2           a question of the decisions, and how many branches it has
//     is 1 3                     answers that lead to the branch, which follows
//     put 1 0 0 2                before, left, level, colour: a leaf
//     is 2
//     nothing                    a leaf: there is nothing to be done
//     bricks 12 start 1 ordered  or: walked
//     0 0 0 1                    of the start: x y z colour
//     1 0 0 2 +x -1 0 after 0 4  ordered: side and column (before, left of the brick) where
//                                it is certain to go on, and bricks that come before it
//     2 0 0 2                    walked
//     end
//
// Questions are `top-colour`, `top-level`, `cell DU DV Z` and `side`. Answers are colours, levels,
// 0 or a colour, and sides by their number, in the order of kSideNames; each stands once. What is
// put on top of its column is written `put 0 0 0 COLOUR`, at whatever level the top is.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "recheck/uses.h"
#include "rules/rule_set.h"

namespace stig::recheck {

/// Sides by number: a quarter turn to the left from one to the next.
inline constexpr std::array<std::string_view, 4> kSideNames = {"+x", "+y", "-x", "-y"};

/// A cell seen from before a column: du towards the robot, dv to its left, level from the floor.
struct NearCell {
  int du = 0, dv = 0, z = 0;
  auto operator<=>(const NearCell&) const = default;
};

/// A question with branches, or a leaf.
struct WorkNode {
  enum class Kind : std::uint8_t {
    top_colour,
    top_level,
    cell,
    side,
    put,
    nothing
  } kind = Kind::nothing;
  NearCell cell;      ///< that is asked for, or where a block is put; on top: (0, 0, 0)
  Colour colour = 0;  ///< of the block
  std::vector<std::pair<std::vector<int>, std::uint32_t>> branches;  ///< answers, and a later node
  bool operator==(const WorkNode&) const = default;
};

/// From where a robot looks at a column; m.
struct WorkLook {
  double distance = 0, lift = 0;
  bool operator==(const WorkLook&) const = default;
};

/// Robots at work at once.
enum class WorkCrowd : std::uint8_t { one, one_a_side, any };
/// As a certificate has them, by number.
inline constexpr std::array<std::string_view, 3> kCrowdNames = {"one", "one-a-side", "any"};

struct WorkBrick {
  PlacedBrick brick;
  int side = 0;                      ///< where it is certain to go on
  NearCell column;                   ///< from the brick's cell, on the floor
  std::vector<std::uint32_t> after;  ///< bricks that come before it, by number
  bool operator==(const WorkBrick&) const = default;
};

struct WorkCertificate {
  std::uint64_t rule_set_hash = 0;
  WorkCrowd crowd = WorkCrowd::one;
  std::vector<int> sides;
  std::vector<WorkLook> looks;
  std::vector<WorkNode> nodes;  ///< the first is the root
  std::size_t start = 0;        ///< bricks that are there from the beginning, which come first
  bool ordered = false;         ///< otherwise all structures on the way are walked
  std::vector<WorkBrick> bricks;
  bool operator==(const WorkCertificate&) const = default;
};

inline constexpr std::string_view kWorkCertificate = "stigc-work-certificate";

std::string print_work_certificate(const WorkCertificate& certificate);
/// Anything malformed is a diagnostic; memory stays within a small multiple of the text's size.
std::optional<WorkCertificate> read_work_certificate(const std::string& path,
                                                     const std::string& text,
                                                     Diagnostics& diagnostics);

}  // namespace stig::recheck
