// SPDX-License-Identifier: MIT
// The clauses of a colouring problem in numbered variables, for a solver or a file.
//
//   orbit o has colour c     o·k + c
//   pair p is equal          orbits·k + 1 + p
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "synthesis/differences.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// What a clause says, for its comment.
struct ClauseKind {
  enum class Kind : std::uint8_t { colour_of, one_colour, domain, naming, pair, clash } kind;
  int index = 0;  ///< the orbit, the place in the naming list, the pair or the clash
};

class Encoding {
 public:
  using Sink = std::function<void(std::span<const int> literals, ClauseKind kind)>;

  Encoding(const Differences& differences, int named, int k)
      : d_(differences), named_(named), k_(k) {}

  int has(int orbit, int colour) const { return orbit * k_ + colour; }
  int equal(int pair) const {
    return static_cast<int>(d_.schedule().frame->orbits.size()) * k_ + 1 + pair;
  }
  int variables() const { return equal(static_cast<int>(d_.pairs().size()) - 1); }

  /// Domains of the orbits, and the order in which new colours are named.
  void emit_domains(const std::vector<int>& naming, const Sink& sink) const;
  /// The clauses of clashes from number `first` on, with the pairs that they need.
  void emit_clashes(std::size_t first, const Sink& sink);

 private:
  void emit_pair(std::int32_t pair, bool as_equal, const Sink& sink);

  const Differences& d_;
  int named_, k_;
  std::vector<bool> differ_defined_, equal_defined_;
};

}  // namespace stig::synthesis
