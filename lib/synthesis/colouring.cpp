// SPDX-License-Identifier: MIT
#include "synthesis/colouring.h"

#include <algorithm>
#include <cadical.hpp>
#include <cstdio>
#include <cstdlib>
#include <numeric>

#include "synthesis/encoding.h"
#include "synthesis/proof_files.h"

namespace stig {
namespace {

constexpr int kSatisfiable = 10, kUnsatisfiable = 20;
/// Clashes asked for in a round: of one state, and in all.
constexpr std::size_t kClashesOfState = 4, kClashesOfRound = 200'000;
/// Clauses on straight runs that are added at once.
constexpr std::size_t kSingleBrickClauses = 300'000;

class OutOfTime : public CaDiCaL::Terminator {
 public:
  explicit OutOfTime(const Deadline& deadline) : deadline_(deadline) {}
  bool terminate() override { return deadline_.passed(); }

 private:
  Deadline deadline_;
};

/// The solver with the clauses of one number of colours.
class Solver {
 public:
  Solver(const Differences& differences, int named, int k, const std::vector<int>& naming,
         const Deadline& deadline)
      : encoding_(differences, named, k), differences_(differences), k_(k), time_(deadline) {
    solver_.set("quiet", 1);
    // Both would drop the colours that decisions are to lean towards.
    solver_.set("lucky", 0);
    solver_.set("walk", 0);
    solver_.connect_terminator(&time_);
    encoding_.emit_domains(naming, sink());
    update();
  }
  ~Solver() { solver_.disconnect_terminator(); }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// Adds the clauses that came since.
  void update() {
    encoding_.emit_clashes(added_, sink());
    added_ = differences_.clauses().size();
  }
  /// Decisions lean towards these colours; those above k towards any.
  void lean_towards(const Colouring& colours) {
    for (std::size_t i = 0; i < colours.size(); ++i) {
      for (int c = 1; c <= k_; ++c) {
        const int v = encoding_.has(static_cast<int>(i), c);
        solver_.phase(colours[i] == c ? v : -v);
      }
    }
  }
  int solve() { return solver_.solve(); }
  Colouring colours() {
    Colouring colours(differences_.schedule().frame->orbits.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
      int c = 1;
      while (solver_.val(encoding_.has(static_cast<int>(i), c)) < 0) ++c;
      colours[i] = static_cast<Colour>(c);
    }
    return colours;
  }

 private:
  Encoding::Sink sink() {
    return [this](std::span<const int> literals, ClauseKind) {
      for (const int literal : literals) solver_.add(literal);
      solver_.add(0);
    };
  }

  Encoding encoding_;
  const Differences& differences_;
  int k_;
  OutOfTime time_;
  CaDiCaL::Solver solver_;
  std::size_t added_ = 0;
};

}  // namespace

ColouringSearch::ColouringSearch(const Schedule& schedule, int named)
    : differences_(schedule), named_(named) {
  differences_.add_single_bricks(kSingleBrickClauses);
  update_naming();
}

void ColouringSearch::update_naming() {
  named_at_ = differences_.clauses().size();
  naming_.clear();
  for (const int orbit : differences_.clique()) {
    const StateSet colours =
        differences_.schedule().frame->orbits[static_cast<std::size_t>(orbit)].colours;
    if (colours == StateSet::anything()) naming_.push_back(orbit);
  }
}

int ColouringSearch::at_least() const {
  return std::max({1, named_, static_cast<int>(naming_.size())});
}

Answered ColouringSearch::colour(int k, const ColouringLimits& limits, Colouring& colours) {
  std::optional<Solver> solver;
  while (true) {
    if (differences_.hopeless() || at_least() > k) return Answered::no;
    if (limits.progress) limits.progress(k, rounds_);
    if (!solver) {
      solver.emplace(differences_, named_, k, naming_, limits.deadline);
      if (!colours.empty()) solver->lean_towards(colours);
    }
    const int result = solver->solve();
    if (result == kUnsatisfiable) return Answered::no;
    if (result != kSatisfiable) return Answered::out_of_time;
    colours = solver->colours();
    ++rounds_;
    const std::vector<Clash> clashes =
        find_clashes(differences_.schedule(), colours, kClashesOfState, kClashesOfRound);
    if (clashes.empty()) return Answered::yes;
    for (const Clash& clash : clashes) differences_.add(clash);
    if (differences_.clauses().size() > 2 * named_at_) {
      const std::size_t before = naming_.size();
      update_naming();
      if (naming_.size() > before) {
        solver.reset();
        continue;
      }
    }
    solver->update();
    solver->lean_towards(colours);
  }
}

std::optional<Refutation> refute(const ColouringSearch& search, int named, int k,
                                 const Deadline& deadline) {
  Refutation refutation;
  refutation.cnf = print_cnf(search.differences(), named, k, search.naming());
  char* bytes = nullptr;
  std::size_t size = 0;
  std::FILE* memory = open_memstream(&bytes, &size);
  if (memory == nullptr) return std::nullopt;
  int result = 0;
  {
    CaDiCaL::Solver solver;
    OutOfTime time(deadline);
    solver.set("quiet", 1);
    solver.set("binary", 0);
    solver.trace_proof(memory, "memory");
    solver.connect_terminator(&time);
    Encoding encoding(search.differences(), named, k);
    const auto sink = [&](std::span<const int> literals, ClauseKind) {
      for (const int literal : literals) solver.add(literal);
      solver.add(0);
    };
    encoding.emit_domains(search.naming(), sink);
    encoding.emit_clashes(0, sink);
    result = solver.solve();
    solver.flush_proof_trace();
    solver.close_proof_trace();
    solver.disconnect_terminator();
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
                                                      const Deadline& deadline) {
  const Differences& differences = search.differences();
  CaDiCaL::Solver solver;
  OutOfTime time(deadline);
  solver.set("quiet", 1);
  solver.connect_terminator(&time);
  Encoding encoding(differences, named, k);
  const int first = encoding.variables() + 1;
  const auto sink = [&](std::span<const int> literals, ClauseKind kind) {
    for (const int literal : literals) solver.add(literal);
    if (kind.kind == ClauseKind::Kind::clash) solver.add(-(first + kind.index));
    solver.add(0);
  };
  encoding.emit_domains(search.naming(), sink);
  encoding.emit_clashes(0, sink);
  for (const std::size_t i : of) solver.assume(first + static_cast<int>(i));
  std::optional<std::vector<std::size_t>> core;
  if (solver.solve() == kUnsatisfiable) {
    core.emplace();
    for (const std::size_t i : of) {
      if (solver.failed(first + static_cast<int>(i))) core->push_back(i);
    }
  }
  solver.disconnect_terminator();
  return core;
}

}  // namespace

std::vector<Clash> unsatisfiable_core(ColouringSearch& search, int named, int k,
                                      const Deadline& deadline) {
  Colouring colours;
  if (search.colour(k, {deadline, {}}, colours) != Answered::no) return {};
  std::vector<std::size_t> all(search.differences().clauses().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  auto core = contradicting(search, named, k, all, deadline);
  if (!core) return {};
  for (std::size_t i = 0; i < core->size() && !deadline.passed();) {
    std::vector<std::size_t> without = *core;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    if (auto smaller = contradicting(search, named, k, without, deadline)) {
      core = std::move(smaller);
    } else {
      ++i;
    }
  }
  std::vector<Clash> clashes;
  for (const std::size_t i : *core) clashes.push_back(search.differences().clauses()[i].reason);
  return clashes;
}

}  // namespace stig
