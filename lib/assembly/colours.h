// SPDX-License-Identifier: MIT
// Colours by which rules and robots tell what is to be done where.
//
// A *case* is what a robot sees before a column, with a colour for each brick, and what may be done
// there. With few colours cases look alike. Colours are right when
//
//   rules   no key of a brick looks like a local state where another belongs, or none
//           (synthesis/clashes.h); sites on different levels are told apart by the rules' heights
//   sight   what is done in one case is right in each that some question, answered in the first,
//           does not tell from it
//   way on  in every structure that can occur something is done (or what proves it, column by
//           column: compiler/local_policy.h)
//
// What is done in which case and the colours are found together by a SAT solver. Conditions are
// added when a solution violates them.
#pragma once

#include <vector>

#include "assembly/cases.h"
#include "assembly/schedule.h"
#include "assembly/texture.h"
#include "assembly/uses.h"
#include "synthesis/colouring.h"

namespace stig::assembly {

struct PaintResult {
  Answered answer = Answered::given_up;
  std::vector<Colour> colours;  ///< by brick of the candidate
};

/// The solver is asked again and again, each time for so many conflicts at most, and is given up
/// when the allowance has passed.
struct PaintLimits {
  Allowance allowance;
  int conflicts = 20'000;
  bool counted = false;  ///< is the work of each conflict taken off, or only that of each call?
};

/// With colours 1..k, by brick of the candidate those that the target allows. Bricks of one texture
/// get one colour where the target leaves all free.
PaintResult paint(const Target& target, const Cases& cases, const RuleView& rules, int k,
                  const Texture& texture, const PaintLimits& limits);

}  // namespace stig::assembly
