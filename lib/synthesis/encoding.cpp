// SPDX-License-Identifier: MIT
// The propositional encoding, direct: one variable for each orbit and colour, one for each
// pair that is compared. Solver and proof file share it, so what is proved is what was
// solved. The definition of a pair's variable is emitted in the direction in which clauses
// use it (Plaisted and Greenbaum 1986), which halves it.
#include "synthesis/encoding.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace stig::synthesis {

namespace {
/// Quadratic in the number of colours: beyond 16 the clauses cost more than they help.
constexpr std::size_t kMostForPairs = 16;
}  // namespace

void Encoding::emit_domains(const std::vector<int>& naming, const Sink& sink) const {
  const std::vector<Orbit>& orbits = d_.schedule().frame->orbits;
  std::vector<int> literals;
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    const int orbit = static_cast<int>(i);
    literals.clear();
    for (int c = 1; c <= k_; ++c) {
      if (orbits[i].colours.contains(static_cast<State>(c))) {
        literals.push_back(has(orbit, c));
      } else {
        sink(std::array{-has(orbit, c)}, {ClauseKind::Kind::domain, orbit});
      }
    }
    sink(literals, {ClauseKind::Kind::colour_of, orbit});
    // Without these an orbit may have several colours, each of which will do: they help
    // the solver, but not where there are very many.
    if (literals.size() > kMostForPairs) continue;
    for (std::size_t a = 0; a < literals.size(); ++a) {
      for (std::size_t b = a + 1; b < literals.size(); ++b) {
        sink(std::array{-literals[a], -literals[b]}, {ClauseKind::Kind::one_colour, orbit});
      }
    }
  }
  // Orbit i of the naming list may have the named colours and the first i + 1 beyond.
  for (std::size_t i = 0; i < naming.size(); ++i) {
    for (int c = named_ + static_cast<int>(i) + 2; c <= k_; ++c) {
      sink(std::array{-has(naming[i], c)}, {ClauseKind::Kind::naming, static_cast<int>(i)});
    }
  }
}

void Encoding::emit_pair(std::int32_t pair, bool as_equal, const Sink& sink) {
  const auto p = static_cast<std::size_t>(pair);
  assert(p < d_.pairs().size());
  if (differ_defined_.size() < d_.pairs().size()) {
    differ_defined_.resize(d_.pairs().size());
    equal_defined_.resize(d_.pairs().size());
  }
  std::vector<bool>& defined = as_equal ? equal_defined_ : differ_defined_;
  if (defined[p]) return;
  defined[p] = true;
  const auto [a, b] = d_.pairs()[p];
  const int same = equal(pair);
  const ClauseKind kind{ClauseKind::Kind::pair, pair};
  for (int c = 1; c <= k_; ++c) {
    const int x = has(a, c), y = has(b, c);
    if (as_equal) {
      sink(std::array{-same, -x, y}, kind);
      sink(std::array{-same, x, -y}, kind);
    } else {
      sink(std::array{same, -x, -y}, kind);
    }
  }
}

void Encoding::emit_clashes(std::size_t first, const Sink& sink) {
  assert(first <= d_.clauses().size());
  std::vector<int> literals;
  for (std::size_t i = first; i < d_.clauses().size(); ++i) {
    const DifferenceClause& clause = d_.clauses()[i];
    literals.clear();
    for (const std::int32_t pair : clause.differ) {
      emit_pair(pair, false, sink);
      literals.push_back(-equal(pair));
    }
    if (clause.equal >= 0) {
      emit_pair(clause.equal, true, sink);
      literals.push_back(equal(clause.equal));
    }
    sink(literals, {ClauseKind::Kind::clash, static_cast<int>(i)});
  }
}

}  // namespace stig::synthesis
