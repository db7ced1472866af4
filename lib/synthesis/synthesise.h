// SPDX-License-Identifier: MIT
// From a target to a rule set that builds it, and nothing else, in every order.
//
// Orders of placement are tried family by family. For each, conditions on the colours
// follow (clashes.h); a solver finds the fewest colours that meet them (colouring.h);
// the exact rules are merged into general ones (merge.h); and what comes out is checked
// at every local state of every site once more (check_rules.h).
//
// Before that, a skeleton of rays and fills is looked for, whose rules ask for heights
// (by_skeleton.h); where one colour does, or the target is large, nothing else is tried.
//
// "Fewest" is always said of the orders that were tried: a proof is of one order.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/colouring.h"
#include "synthesis/merge.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

enum class Fewest : std::uint8_t { colours, rules };

struct SynthesisOptions {
  Symmetry symmetry = Symmetry::none;
  std::vector<Cell> start;  ///< left out: chosen
  bool floor = false;
  int most_colours = kMaxColours;
  Fewest fewest = Fewest::colours;
  std::optional<OrderFamily> family;  ///< of orders; left out: all
  bool strict_only = false;           ///< no ties
  bool merge = true;                  ///< otherwise one exact rule a neighbourhood
  bool heights = true;                ///< may rules ask for heights? (by_skeleton.h)
  double effort = 1;                  ///< how much is tried (effort.h)
};

struct SynthesisHooks {
  std::function<void(double fraction, const std::string& what)> progress;
  Deadline deadline;  ///< ends the search early; what is found until then is kept
};

/// A colouring of a target under an order, and its rules.
struct Solution {
  std::shared_ptr<const Frame> frame;
  Order order;
  Colouring colours;  ///< by orbit
  int colour_count = 0;
  bool fewer_refuted = false;  ///< one colour fewer does not do for this order
  bool heights = false;        ///< rules ask for heights; not merged from exact ones
  std::size_t exact_rules = 0;
  std::vector<MergedRule> rules;
};

/// Why there is no rule set, or why none was found.
struct Obstacle {
  enum class Kind : std::uint8_t {
    bad_start,      ///< a start that is not of the target, or below the floor
    not_connected,  ///< a part that no neighbour leads to
    asymmetric,     ///< start and rules have a symmetry that the target has not
    look_alike,     ///< two sites look alike whatever the colours are
    colours,        ///< more colours are needed than may be used
  };
  Kind kind = Kind::colours;
  bool proved = false;  ///< true of every order and colouring; otherwise of those tried
  std::string what;     ///< one line
  std::string drawing;  ///< lines that show it; may be empty
  std::vector<std::string> remedies;  ///< each tried, and found to work
};

struct Synthesis {
  std::optional<Solution> best;
  std::vector<Solution> others;  ///< not worse in both colours and rules, by colours
  std::optional<Obstacle> obstacle;
  bool unanswered = false;  ///< neither: what was allowed was used up first
  bool cut_short = false;   ///< the deadline ended the search: another may find better
  std::size_t orders_tried = 0;
  double seconds = 0;
};

Synthesis synthesise(const Target& target, const SynthesisOptions& options,
                     const SynthesisHooks& hooks = {});

/// The starts that are tried when none is given.
std::vector<std::vector<Cell>> likely_starts(const Target& target, Symmetry symmetry, bool floor);

/// For a solution: that one colour fewer does not do under its order. Nothing when the
/// allowance is spent, or when it has one colour.
struct MinimalityProof {
  std::string problem, cnf, drat;  ///< files, see proof_files.h
};
std::optional<MinimalityProof> prove_fewest(const Solution& solution, int named,
                                            const Allowance& allowance);

}  // namespace stig::synthesis
