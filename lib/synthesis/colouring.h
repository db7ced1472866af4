// SPDX-License-Identifier: MIT
// Colours for a schedule, or the proof that so many do not do, by a SAT solver.
//
// Variables: orbit o has colour c; pair p is equal. Conditions A and B are added when
// a solution violates them, until find_clashes finds none; for the target's cells are
// few and the pairs of a key and a state very many. The clauses over pairs
// (differences.h) are kept from one number of colours to the next.
//
// A proof is the clauses met, as CNF with a comment on why each holds, and the
// solver's DRAT proof that they contradict each other. The claim is "fewest colours
// for this order"; other orders may do with fewer.
#pragma once

#include <functional>
#include <string>

#include "synthesis/differences.h"
#include "synthesis/effort.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// given_up: what was allowed did not suffice.
enum class Answered : std::uint8_t { yes, no, given_up };

struct ColouringLimits {
  Allowance allowance;
  std::function<void(int colours, int rounds)> progress;  ///< before every round; may be empty
};

class ColouringSearch {
 public:
  /// Colours 1..named are those of the target; further ones are interchangeable. The
  /// schedule must outlive the search.
  /// When the time of the allowance is over less is known from the outset, and none of it wrong.
  ColouringSearch(const Schedule& schedule, int named, const Allowance& allowance = {});

  /// Is there a colouring with colours 1..k? One near to what `colours` holds, if it
  /// holds anything, is looked for first.
  Answered colour(int k, const ColouringLimits& limits, Colouring& colours);

  /// Steps that it took to make this.
  std::uint64_t cost() const;
  /// No fewer than this will do, as far as is known without a solver.
  int at_least() const;
  const Differences& differences() const { return differences_; }
  /// Orbits whose colours may be named in this order without loss.
  const std::vector<int>& naming() const { return naming_; }
  int rounds() const { return rounds_; }

 private:
  void update_naming();

  Differences differences_;
  int named_;
  std::vector<int> naming_;
  int rounds_ = 0;
  std::size_t named_at_ = 0;  ///< clauses when naming_ was last worked out
};

/// The clauses met by a search whose answer for k colours was no.
struct Refutation {
  std::string cnf;   ///< DIMACS, with comments (proof_files.h)
  std::string drat;  ///< text form
};
/// Nothing when the allowance is spent before the solver is done.
std::optional<Refutation> refute(const ColouringSearch& search, int named, int k,
                                 const Allowance& allowance);

/// Clashes that k colours cannot all avoid, none of which can be spared; empty when k
/// colours do or the allowance is spent before that is known.
std::vector<Clash> unsatisfiable_core(ColouringSearch& search, int named, int k,
                                      const Allowance& allowance);

}  // namespace stig::synthesis
