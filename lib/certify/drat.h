// SPDX-License-Identifier: MIT
// A forward checker of proofs that a formula cannot be fulfilled.
//
// The formula is DIMACS CNF, the proof DRAT, as text or binary: clauses added and
// deleted, line by line. An added clause must follow from the clauses that are there by
// unit propagation (RUP), or have the resolution asymmetric tautology property on its
// first literal (RAT; Heule, Hunt, Wetzler 2013); both keep a formula that can be
// fulfilled so. When propagation meets a contradiction without any assumption, the
// formula is refuted. Deletions of clauses that force a literal at that moment are left
// out, as other checkers do and solvers expect.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "certify/uses.h"

namespace stig::certify {

struct DratReport {
  bool refuted = false;  ///< the formula has no solution
  std::string refusal;   ///< else: one sentence, with the number of the proof's step
  std::uint64_t variables = 0, clauses = 0;  ///< of the formula
  std::uint64_t lemmas = 0, deletions = 0;   ///< of the proof, as far as it was needed
};

DratReport check_drat(std::string_view cnf, std::string_view proof);

}  // namespace stig::certify
