// SPDX-License-Identifier: MIT
// A forward DRAT checker with two watched literals per clause, after the scheme of M.
// Moskewicz et al., "Chaff" (DAC 2001). Forward means that each lemma is checked when it is
// met. Backward checking, as in DRAT-trim (SAT 2014), skips lemmas that the refutation does
// not use; it is faster on long proofs, and much more code to trust.
//
// Assignments at the top level are permanent: everything they follow from is in the clause
// set, and clauses that force a literal are never removed.
#include "certify/drat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <unordered_map>
#include <utility>

#include "base/hash.h"
#include "certify/clauses.h"

namespace stig::certify {
namespace {

/// Clauses under unit propagation. Every clause watches its first two literals; they are
/// not false unless the clause is fulfilled or propagation has not come to it yet.
class ClauseSet {
 public:
  explicit ClauseSet(std::uint64_t variables)
      : value_(2 * variables + 2, 0), reason_(variables + 1, 0), watches_(2 * variables + 2) {}

  /// No assignment fulfils the clauses.
  bool contradiction() const { return contradiction_; }

  /// Adds a clause that is known to follow, and what it forces.
  void add(Literals clause);
  /// False when there is none such.
  bool remove(Literals clause);
  /// Does it follow by propagation, or is it redundant for its first literal?
  bool follows(const Literals& clause);

 private:
  struct Clause {
    std::size_t begin;
    std::uint32_t size;
    bool deleted;
  };
  struct Watch {
    std::uint32_t clause;
    Literal other;  ///< some literal of the clause: when it is true, no more need be read
  };

  bool is_true(Literal literal) const { return value_[literal] > 0; }
  bool is_false(Literal literal) const { return value_[literal] < 0; }
  void assign(Literal literal, std::uint32_t reason);
  /// Assumes all literals false; true: that is a contradiction.
  bool refutes(const Literals& clause, Literal except = 0);
  bool propagate();
  bool propagate_false(Literal literal);
  bool move_watch(std::uint32_t number, Literal from);
  bool redundant_for(Literal pivot);
  void take_back(std::size_t trail);

  std::vector<Literal> literals_;
  std::vector<Clause> clauses_;
  std::vector<std::int8_t> value_;  ///< by literal: 1 true, -1 false, 0 open
  // The reason 0 also stands for literals assumed during a check. That is harmless:
  // assumptions are taken back before any deletion asks for reasons.
  std::vector<std::uint32_t> reason_;  ///< by variable: the clause that forced it, if it is set
  std::vector<std::vector<Watch>> watches_;
  std::vector<Literal> trail_;  ///< true literals in the order in which they came
  std::size_t done_ = 0;        ///< of the trail, propagated
  bool contradiction_ = false;
  std::unordered_multimap<std::uint64_t, std::uint32_t> by_hash_;
};

void each_once(Literals& clause) {
  std::sort(clause.begin(), clause.end());
  clause.erase(std::unique(clause.begin(), clause.end()), clause.end());
}

/// The same for any order of the literals. A sum and not a polynomial: DRAT deletes a
/// clause by its literals in whatever order the solver had them then.
std::uint64_t hash_of(const Literals& clause) {
  std::uint64_t sum = 0;
  for (const Literal literal : clause) sum += mix(literal);
  return sum;
}

void ClauseSet::assign(Literal literal, std::uint32_t reason) {
  assert(value_[literal] == 0);
  value_[literal] = 1;
  value_[negated(literal)] = -1;
  reason_[literal / 2] = reason;
  trail_.push_back(literal);
}

/// Watches are left as they are. That is what makes the scheme cheap: undoing assignments
/// never breaks the invariant of watched literals.
void ClauseSet::take_back(std::size_t trail) {
  assert(trail <= trail_.size());
  for (std::size_t i = trail; i < trail_.size(); ++i) {
    value_[trail_[i]] = value_[negated(trail_[i])] = 0;
  }
  trail_.resize(trail);
  done_ = trail;
}

void ClauseSet::add(Literals clause) {
  each_once(clause);
  const auto number = static_cast<std::uint32_t>(clauses_.size());
  by_hash_.emplace(hash_of(clause), number);
  // Literals that are not false come to the front, and a true one comes first, so that the
  // clause can be watched in the present assignment: only if less than two literals are not
  // false does it force something now.
  std::stable_partition(clause.begin(), clause.end(),
                        [&](Literal literal) { return !is_false(literal); });
  const auto open =
      std::find_if(clause.begin(), clause.end(), [&](Literal l) { return is_true(l); });
  if (open != clause.end()) std::iter_swap(clause.begin(), open);
  clauses_.push_back({literals_.size(), static_cast<std::uint32_t>(clause.size()), false});
  literals_.insert(literals_.end(), clause.begin(), clause.end());
  // A clause of one literal needs no watch: its literal is assigned for good.
  if (clause.size() > 1) {
    watches_[clause[0]].push_back({number, clause[1]});
    watches_[clause[1]].push_back({number, clause[0]});
  }
  // Empty, or all literals false at the top level: no assignment fulfils the set.
  if (clause.empty() || is_false(clause[0])) {
    contradiction_ = true;
  } else if (!is_true(clause[0]) && (clause.size() == 1 || is_false(clause[1]))) {
    assign(clause[0], number);
    contradiction_ = contradiction_ || propagate();
  }
}

bool ClauseSet::remove(Literals clause) {
  each_once(clause);
  const auto [first, last] = by_hash_.equal_range(hash_of(clause));
  for (auto entry = first; entry != last; ++entry) {
    Clause& found = clauses_[entry->second];
    // Equal hashes need not be equal clauses; the literals decide.
    const auto begin = literals_.begin() + static_cast<std::ptrdiff_t>(found.begin);
    Literals sorted(begin, begin + found.size);
    std::sort(sorted.begin(), sorted.end());
    if (sorted != clause) continue;
    // Deleting the reason of a top-level literal would leave an assignment without a cause.
    // Checkers in use ignore such deletions ("unit deletions"), and solvers' proofs rely on
    // that. Keeping a clause more can make no wrong lemma follow: it was entailed, and
    // satisfiability is still preserved by each step.
    const bool forces = std::any_of(clause.begin(), clause.end(), [&](Literal literal) {
      return is_true(literal) && reason_[literal / 2] == entry->second;
    });
    if (!forces) {
      found.deleted = true;
      by_hash_.erase(entry);
    }
    return true;
  }
  // Not an error for the caller: deleting what is not there has no effect.
  return false;
}

/// True: a contradiction.
bool ClauseSet::propagate() {
  while (done_ < trail_.size()) {
    if (propagate_false(negated(trail_[done_++]))) return true;
  }
  return false;
}

/// Visits the clauses that watch a literal that has just become false. Those which find
/// another watch leave the list; after a contradiction the rest is only kept, so that the
/// list stays complete for later.
bool ClauseSet::propagate_false(Literal literal) {
  assert(is_false(literal));
  std::vector<Watch>& watches = watches_[literal];
  std::size_t kept = 0;
  bool contradiction = false;
  for (std::size_t i = 0; i < watches.size(); ++i) {
    const Watch watch = watches[i];
    const Clause& clause = clauses_[watch.clause];
    if (clause.deleted) continue;
    // Reading the cached literal first saves the access to the clause, which lies elsewhere
    // in memory.
    if (contradiction || is_true(watch.other)) {
      watches[kept++] = watch;
      continue;
    }
    if (move_watch(watch.clause, literal)) continue;
    const Literal first = literals_[clause.begin];
    // No other literal is free: the clause forces its first literal, or contradicts.
    watches[kept++] = {watch.clause, first};
    if (is_false(first)) {
      contradiction = true;
    } else if (!is_true(first)) {
      assign(first, watch.clause);
    }
  }
  watches.resize(kept);
  return contradiction;
}

/// Watches another literal that is not false instead of `from`, which comes second. The
/// clause's literals are permuted in place, so the first two are always the watched ones.
bool ClauseSet::move_watch(std::uint32_t number, Literal from) {
  const Clause& clause = clauses_[number];
  Literal* literals = &literals_[clause.begin];
  if (literals[0] == from) std::swap(literals[0], literals[1]);
  assert(literals[1] == from);
  if (is_true(literals[0])) return false;
  for (std::uint32_t k = 2; k < clause.size; ++k) {
    if (is_false(literals[k])) continue;
    std::swap(literals[1], literals[k]);
    watches_[literals[1]].push_back({number, literals[0]});
    return true;
  }
  return false;
}

/// Reverse unit propagation (E. Goldberg, Y. Novikov, DATE 2003): C follows if assuming all
/// its literals false leads to a contradiction by propagation. A literal that is already
/// true gives it at once.
bool ClauseSet::refutes(const Literals& clause, Literal except) {
  for (const Literal literal : clause) {
    if (literal == except) continue;
    if (is_true(literal)) return true;
    if (!is_false(literal)) assign(negated(literal), 0);
  }
  return propagate();
}

/// DRAT fixes the pivot of a RAT lemma: the first literal as the proof has it, which is why
/// the order in the text is kept up to here.
bool ClauseSet::follows(const Literals& clause) {
  const std::size_t trail = trail_.size();
  const bool yes = refutes(clause) || (!clause.empty() && redundant_for(clause.front()));
  take_back(trail);
  return yes;
}

/// With the clause's literals assumed false: does every clause with the pivot negated
/// give, its other literals assumed false too, a contradiction?
bool ClauseSet::redundant_for(Literal pivot) {
  const std::size_t trail = trail_.size();
  // All clauses are scanned: there are no occurrence lists. RAT lemmas are rare in the
  // proofs of the solvers in use, and a full scan costs no more code.
  for (const Clause& clause : clauses_) {
    if (clause.deleted) continue;
    const auto begin = literals_.begin() + static_cast<std::ptrdiff_t>(clause.begin);
    const Literals other(begin, begin + clause.size);
    if (std::find(other.begin(), other.end(), negated(pivot)) == other.end()) continue;
    const bool yes = refutes(other, negated(pivot));
    take_back(trail);
    if (!yes) return false;
  }
  return true;
}

/// Adds the formula; says what is wrong with it.
std::string add_formula(CnfReader& reader, ClauseSet& clauses) {
  Literals clause;
  for (;;) {
    switch (reader.next(clause)) {
      case Read::end:
        return "";
      case Read::error:
        return reader.problem;
      case Read::clause:
        clauses.add(clause);
    }
  }
}

std::string follow_proof(DratReader& reader, ClauseSet& clauses, DratReport& report) {
  Literals clause;
  bool deletes = false;
  // The proof may go on after the contradiction; nothing of it is needed.
  for (std::uint64_t step = 1; !clauses.contradiction(); ++step) {
    switch (reader.next(clause, deletes)) {
      case Read::end:
        return "the proof ends before a contradiction is found";
      case Read::error:
        return fmt::format("step {} of the proof {}", step, reader.problem);
      case Read::clause:
        break;
    }
    if (deletes) {
      ++report.deletions;
      clauses.remove(clause);
    } else if (clauses.follows(clause)) {
      ++report.lemmas;
      clauses.add(clause);
    } else {
      return fmt::format("step {} of the proof adds a clause that does not follow", step);
    }
  }
  return "";
}

}  // namespace

/// No time limit: the cost is that of the solver's own propagation, and the caller chose
/// the proof.
DratReport check_drat(std::string_view cnf, std::string_view proof) {
  DratReport report;
  CnfReader formula(cnf);
  report.variables = formula.variables;
  report.clauses = formula.clauses;
  ClauseSet clauses(formula.variables);
  report.refusal = add_formula(formula, clauses);
  if (report.refusal.empty()) {
    DratReader steps(proof, formula.variables);
    report.refusal = follow_proof(steps, clauses, report);
  }
  report.refuted = report.refusal.empty();
  return report;
}

}  // namespace stig::certify
