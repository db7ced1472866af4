// SPDX-License-Identifier: MIT
// Counterexample-guided colouring: the solver proposes colours, the linear check finds the
// clashes they have, and their clauses are added, until there are no clashes or no
// solution. Most of the possible clauses are never needed. CaDiCaL (A. Biere et al., SAT
// competition 2020) is limited by conflicts and decisions, not by time, so that the same
// call does the same work on every machine.
#include "synthesis/colouring.h"

#include <algorithm>
#include <cadical.hpp>
#include <cassert>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "synthesis/encoding.h"
#include "synthesis/proof_files.h"

namespace stig::synthesis {
namespace {

/// The values that CaDiCaL's solve() returns; 0 means that a limit was met.
constexpr int kSatisfiable = 10, kUnsatisfiable = 20;
/// Clashes asked for in a round: of one state, and in all.
constexpr std::size_t kClashesOfState = 4, kClashesOfRound = 200'000;
/// Clauses on straight runs that are added at once.
constexpr std::size_t kSingleBrickClauses = 300'000;

/// Steps that a conflict and a decision are taken for, with so many literals in the
/// clauses. Rough averages of what the solver takes. They set how long an effort of 1
/// lasts, and decide nothing about correctness.
constexpr std::uint64_t kStepsOfConflict = 15'000, kLiteralsToAStepOfConflict = 20,
                        kStepsOfDecision = 300;
/// After so many clauses, orbits or clashes the clock is looked at.
constexpr std::size_t kClausesBetweenLooks = 4096, kOrbitsBetweenLooks = 256,
                      kClashesBetweenLooks = 1024;
constexpr std::uint64_t kStepsOfLiteral = 60, kStepsOfState = 30, kStepsOfClash = 1'000;

/// A solver that does as much as is allowed, counted by conflicts and decisions, and that
/// spends for what it did. CaDiCaL calls back through two interfaces: terminate() is polled
/// for the deadline, and learning() is called for each conflict.
class Meter : public CaDiCaL::Terminator, public CaDiCaL::Learner {
 public:
  Meter(CaDiCaL::Solver& solver, const Allowance& allowance)
      : solver_(solver), allowance_(allowance) {
    solver_.connect_terminator(this);
    solver_.connect_learner(this);
  }
  ~Meter() override {
    solver_.disconnect_learner();
    solver_.disconnect_terminator();
  }
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  /// When the time is over nothing more is added, for then nothing is solved either.
  void add(std::span<const int> literals) {
    if (++clauses_ % kClausesBetweenLooks == 0) ended_ = ended_ || allowance_.out_of_time();
    if (ended_) return;
    for (const int literal : literals) solver_.add(literal);
    literals_ += literals.size() + 1;
  }
  void end_clause() {
    if (!ended_) solver_.add(0);
  }

  int solve() {
    allowance_.spend((literals_ - charged_) * kStepsOfLiteral);
    charged_ = literals_;
    if (ended_ || allowance_.passed()) return 0;
    // A conflict costs more the more literals there are to propagate.
    const std::uint64_t each = kStepsOfConflict + literals_ / kLiteralsToAStepOfConflict;
    solver_.limit("conflicts", within_int(allowance_.left() / each));
    solver_.limit("decisions", within_int(allowance_.left() / kStepsOfDecision));
    learnt_ = 0;
    const int result = solver_.solve();
    allowance_.spend(learnt_ * each +
                     static_cast<std::uint64_t>(solver_.vars()) * kStepsOfDecision);
    return result;
  }

  bool terminate() override { return allowance_.out_of_time(); }
  bool learning(int) override {
    ++learnt_;
    return false;
  }
  void learn(int) override {}

 private:
  /// One more than is left, since a limit of 0 would allow no work at all.
  static int within_int(std::uint64_t n) {
    return static_cast<int>(std::min<std::uint64_t>(n + 1, std::numeric_limits<int>::max()));
  }

  CaDiCaL::Solver& solver_;
  Allowance allowance_;
  std::uint64_t literals_ = 0, charged_ = 0, learnt_ = 0, clauses_ = 0;
  bool ended_ = false;
};

/// The solver with the clauses of one number of colours.
class Solver {
 public:
  Solver(const Differences& differences, int named, int k, const std::vector<int>& naming,
         const Allowance& allowance)
      : encoding_(differences, named, k),
        differences_(differences),
        k_(k),
        allowance_(allowance),
        meter_(solver_, allowance) {
    solver_.set("quiet", 1);
    // Both would overwrite the phases, which are the colours that decisions are to lean
    // towards.
    solver_.set("lucky", 0);
    solver_.set("walk", 0);
    encoding_.emit_domains(naming, sink());
    update();
  }

  /// Adds the clauses that came since.
  void update() {
    encoding_.emit_clashes(added_, sink());
    added_ = differences_.clauses().size();
  }
  /// Decisions lean towards these colours; those above k towards any.
  void lean_towards(const Colouring& colours) {
    for (std::size_t i = 0; i < colours.size(); ++i) {
      if (i % kOrbitsBetweenLooks == 0 && allowance_.out_of_time()) return;
      for (int c = 1; c <= k_; ++c) {
        const int v = encoding_.has(static_cast<int>(i), c);
        solver_.phase(colours[i] == c ? v : -v);
      }
    }
  }
  int solve() { return meter_.solve(); }
  Colouring colours() {
    Colouring colours(differences_.schedule().frame->orbits.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
      // A cell may have several colours where the clauses that forbid this were left out
      // for being many; the first will do.
      int c = 1;
      while (solver_.val(encoding_.has(static_cast<int>(i), c)) < 0) ++c;
      assert(c <= k_);
      colours[i] = static_cast<Colour>(c);
    }
    return colours;
  }

 private:
  Encoding::Sink sink() {
    return [this](std::span<const int> literals, ClauseKind) {
      meter_.add(literals);
      meter_.end_clause();
    };
  }

  Encoding encoding_;
  const Differences& differences_;
  int k_;
  Allowance allowance_;
  CaDiCaL::Solver solver_;
  Meter meter_;
  std::size_t added_ = 0;
};

}  // namespace

ColouringSearch::ColouringSearch(const Schedule& schedule, int named, const Allowance& allowance)
    : differences_(schedule), named_(named) {
  assert(named >= 0);
  differences_.add_single_bricks(kSingleBrickClauses, allowance);
  if (!allowance.out_of_time()) update_naming();
}

/// Orbits that pairwise differ may be given the colours beyond the named ones in turn: that
/// removes the symmetry between interchangeable colours (docs/synthesis.md, "Fewest
/// colours").
void ColouringSearch::update_naming() {
  named_at_ = differences_.clauses().size();
  naming_.clear();
  for (const int orbit : differences_.clique()) {
    const StateSet colours =
        differences_.schedule().frame->orbits[static_cast<std::size_t>(orbit)].colours;
    if (colours == StateSet::anything()) naming_.push_back(orbit);
  }
}

std::uint64_t ColouringSearch::cost() const {
  return differences_.schedule().states.masks.size() * kStepsOfState +
         differences_.clauses().size() * kStepsOfClash;
}

int ColouringSearch::at_least() const {
  return std::max({1, named_, static_cast<int>(naming_.size())});
}

Answered ColouringSearch::colour(int k, const ColouringLimits& limits, Colouring& colours) {
  std::optional<Solver> solver;
  while (true) {
    // A clique of more than k orbits refutes k without the solver.
    if (differences_.hopeless() || at_least() > k) return Answered::no;
    if (limits.progress) limits.progress(k, rounds_);
    if (!solver) {
      solver.emplace(differences_, named_, k, naming_, limits.allowance);
      if (!colours.empty()) solver->lean_towards(colours);
    }
    const int result = solver->solve();
    if (result == kUnsatisfiable) return Answered::no;
    if (result != kSatisfiable) return Answered::given_up;
    colours = solver->colours();
    ++rounds_;
    const std::vector<Clash> clashes = find_clashes(
        differences_.schedule(), colours, kClashesOfState, kClashesOfRound, limits.allowance);
    if (limits.allowance.out_of_time()) return Answered::given_up;
    if (clashes.empty()) return Answered::yes;
    for (std::size_t i = 0; i < clashes.size(); ++i) {
      differences_.add(clashes[i]);
      if (i % kClashesBetweenLooks == 0 && limits.allowance.out_of_time()) {
        return Answered::given_up;
      }
    }
    limits.allowance.spend(differences_.schedule().states.masks.size() * kStepsOfState +
                           clashes.size() * kStepsOfClash);
    // Recomputing the clique costs about as much as the clauses there are, so it is done
    // when their number has doubled.
    if (differences_.clauses().size() > 2 * named_at_) {
      const std::size_t before = naming_.size();
      update_naming();
      if (naming_.size() > before) {
        // The solver's clauses name colours by the old clique, so a larger one needs a new
        // solver.
        solver.reset();
        continue;
      }
    }
    solver->update();
    solver->lean_towards(colours);
  }
}

/// A second, plain run of the solver on all clauses met, this time with a trace: proofs of
/// the incremental runs would mix numbers of colours.
std::optional<Refutation> refute(const ColouringSearch& search, int named, int k,
                                 const Allowance& allowance) {
  assert(k >= 1);
  Refutation refutation;
  refutation.cnf = print_cnf(search.differences(), named, k, search.naming());
  char* bytes = nullptr;
  std::size_t size = 0;
  std::FILE* memory = open_memstream(&bytes, &size);
  if (memory == nullptr) return std::nullopt;
  int result = 0;
  // The braces end the solver before the stream that it writes to is closed.
  {
    CaDiCaL::Solver solver;
    Meter meter(solver, allowance);
    solver.set("quiet", 1);
    solver.set("binary", 0);
    solver.trace_proof(memory, "memory");
    Encoding encoding(search.differences(), named, k);
    const auto sink = [&](std::span<const int> literals, ClauseKind) {
      meter.add(literals);
      meter.end_clause();
    };
    encoding.emit_domains(search.naming(), sink);
    encoding.emit_clashes(0, sink);
    result = meter.solve();
    solver.flush_proof_trace();
    solver.close_proof_trace();
  }
  std::fclose(memory);
  refutation.drat.assign(bytes, size);
  std::free(bytes);
  if (result != kUnsatisfiable) return std::nullopt;
  return refutation;
}

namespace {

/// Which of some clauses contradict each other, with k colours; nothing when they do not.
std::optional<std::vector<std::size_t>> contradicting(const ColouringSearch& search, int named,
                                                      int k, const std::vector<std::size_t>& of,
                                                      const Allowance& allowance) {
  const Differences& differences = search.differences();
  CaDiCaL::Solver solver;
  Meter meter(solver, allowance);
  solver.set("quiet", 1);
  Encoding encoding(differences, named, k);
  // One selector variable for each clash: assuming it switches the clash's clause on, and
  // the failed assumptions are a core.
  const int first = encoding.variables() + 1;
  const auto sink = [&](std::span<const int> literals, ClauseKind kind) {
    meter.add(literals);
    if (kind.kind == ClauseKind::Kind::clash) solver.add(-(first + kind.index));
    meter.end_clause();
  };
  encoding.emit_domains(search.naming(), sink);
  encoding.emit_clashes(0, sink);
  for (const std::size_t i : of) solver.assume(first + static_cast<int>(i));
  std::optional<std::vector<std::size_t>> core;
  if (meter.solve() == kUnsatisfiable) {
    core.emplace();
    for (const std::size_t i : of) {
      if (solver.failed(first + static_cast<int>(i))) core->push_back(i);
    }
  }
  return core;
}

}  // namespace

std::vector<Clash> unsatisfiable_core(ColouringSearch& search, int named, int k,
                                      const Allowance& allowance) {
  Colouring colours;
  if (search.colour(k, {allowance, {}}, colours) != Answered::no) return {};
  std::vector<std::size_t> all(search.differences().clauses().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  auto core = contradicting(search, named, k, all, allowance);
  if (!core) return {};
  // Deletion-based minimisation: at most one call of the solver for each clause of the
  // first core. The result is irreducible, and not necessarily the smallest.
  for (std::size_t i = 0; i < core->size() && !allowance.passed();) {
    std::vector<std::size_t> without = *core;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    if (auto smaller = contradicting(search, named, k, without, allowance)) {
      core = std::move(smaller);
    } else {
      ++i;
    }
  }
  std::vector<Clash> clashes;
  for (const std::size_t i : *core) clashes.push_back(search.differences().clauses()[i].reason);
  return clashes;
}

}  // namespace stig::synthesis
