// SPDX-License-Identifier: MIT
// A formula in clauses, and the question whether anything fulfils it; "no" only with a proof that
// has been checked.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "assembly/uses.h"
#include "synthesis/colouring.h"

namespace stig::assembly {

class Clauses {
 public:
  /// A new variable; they count from 1.
  int variable() { return ++variables_; }
  void add(const std::vector<int>& literals);

  std::size_t size() const { return count_; }
  std::size_t literals() const { return literals_.size(); }

  /// With so many conflicts of the solver at most. A refutation is traced, and checked by the
  /// checker of proofs (certify/drat.h); one that does not pass counts as given up.
  Answered fulfilled(int most_conflicts) const;

 private:
  std::string dimacs() const;

  std::vector<int> literals_;  ///< clause by clause, each with a 0 behind it
  std::size_t count_ = 0;
  int variables_ = 0;
};

}  // namespace stig::assembly
