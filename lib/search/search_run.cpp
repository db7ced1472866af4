// SPDX-License-Identifier: MIT
// What each method makes of an archive, and the evaluation of what it made.
#include "search/search_run.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/hash.h"
#include "base/parallel.h"
#include "search/objectives.h"
#include "search/operators.h"
#include "search/shapes.h"

namespace stig::search {
namespace {

/// Candidates that a screener is made for: it takes as long as a few of them.
constexpr std::size_t kPart = 32;

std::uint64_t seed_of(std::uint64_t plan, std::uint64_t id) { return combine(plan, id); }

/// Parents by the method, as positions in the archive; none: a candidate is drawn.
struct Choice {
  std::optional<std::size_t> parent, other;
};

/// The archive's order does not change during a batch, so each candidate of it chooses from the
/// same.
Choice choose_parents(const SearchPlan& plan, const FindArchive& archive, Random& random) {
  // One in sixteen is new, whatever the method: a search that lives off its finds alone ends in
  // the surroundings of its first.
  if (plan.method == SearchMethod::random || archive.kept().empty() || random.below(16) == 0) {
    return {};
  }
  if (plan.method == SearchMethod::local) return {archive.best(1).front(), std::nullopt};
  if (plan.method == SearchMethod::map_elites) {
    const auto elites = archive.elites();
    const std::size_t one = elites[random.below(elites.size())];
    const std::size_t two = elites[random.below(elites.size())];
    return {one, random.below(4) == 0 ? std::optional(two) : std::nullopt};
  }
  const auto population = archive.best(static_cast<std::size_t>(plan.population));
  // Of two, the better: they stand by falling score.
  const auto pick = [&] {
    const auto a = random.below(population.size()), b = random.below(population.size());
    return population[std::min(a, b)];
  };
  const std::size_t one = pick();
  return {one, random.below(2) == 0 ? std::optional(pick()) : std::nullopt};
}

/// One child in three of a parent that does not end alike in every order, where the plan tries
/// further ones.
std::optional<Genome> mended(const SearchPlan& plan, std::uint64_t hash, const Individual& parent,
                             const Screening& run, Screener& screener, Random& random) {
  if (plan.orders == 0 || random.below(3) != 0) return std::nullopt;
  const int order = 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(plan.orders)));
  const std::uint64_t seed = order_seed(seed_of(hash, parent.id), order);
  const auto other_end = built(parent.genome, screener.run(parent.genome, seed));
  return mend(plan.draw, {parent.genome, run}, other_end, random);
}

/// A child of one parent or two. Parents are run again, with the numbers that they were run with
/// first, rather than kept with all that they did.
Genome child_of(const SearchPlan& plan, std::uint64_t hash, const Individual& parent,
                const Individual* other, Screener& screener, Random& random,
                std::string_view& origin) {
  Screening run = screener.run(parent.genome, seed_of(hash, parent.id));
  if (other == nullptr) {
    if (auto child = mended(plan, hash, parent, run, screener, random)) {
      origin = "mended";
      return std::move(*child);
    }
    origin = "mutated";
    return mutate(plan.draw, {parent.genome, run}, random);
  }
  origin = "crossed";
  const Screening& second = screener.run(other->genome, seed_of(hash, other->id));
  const Genome crossed = cross_over({parent.genome, run}, {other->genome, second}, random);
  run = screener.run(crossed, seed_of(hash, parent.id));
  return mutate(plan.draw, {crossed, run}, random);
}

/// The compiler walks all that robots could build; what is not proved it refuses unseen.
RobotWork work_of(const SearchPlan& plan, const Judges& judges, const Genome& genome,
                  Coordination coordination) {
  if (plan.robot.empty() || !judges.compile) return {};
  if (!is_coordinated(coordination)) return {0, kNotProved};
  return judges.compile(genome);
}

void set_score(const SearchPlan& settings, const Judges& judges, Individual& out) {
  if (judges.score) {
    const auto score = judges.score({out.id, out.values, out.bricks}, out.problem);
    out.score = score.value_or(0);
    return;
  }
  for (const ScoreTerm& term : settings.score)
    out.score += term.weight * out.values[term.objective];
}

/// The number of the slice's next evaluation, in the whole search.
std::uint64_t next_id(const SearchPlan& plan, const SearchState& state) {
  const auto batch = static_cast<std::uint64_t>(plan.batch);
  const std::uint64_t whole = state.evaluated / batch * state.slice.of + state.slice.number - 1;
  return whole * batch + state.evaluated % batch;
}

/// Calls `each(place, screener)` for so many, with a screener for some at a time.
template <class Each>
bool in_parts(const SearchPlan& plan, std::size_t count, int threads, Stop stop, const Each& each) {
  const auto stopped = [&] { return stop != nullptr && stop->load(); };
  run_parallel((count + kPart - 1) / kPart, threads,
               [&](std::size_t part) {
                 Screener screener(plan.screen);
                 for (std::size_t i = part * kPart; i < std::min(count, (part + 1) * kPart); ++i) {
                   each(i, screener);
                 }
               },
               stopped);
  return !stopped();
}

}  // namespace

Individual make_candidate(const SearchPlan& plan, std::uint64_t hash, const FindArchive& archive,
                          std::uint64_t id, Screener& screener) {
  Individual out;
  out.id = id;
  Random random(seed_of(hash, out.id), 0, kDrawing, 0, 0);
  const Choice choice = choose_parents(plan, archive, random);
  if (!choice.parent) {
    DrawnGenome drawn;
    draw_genome(plan.draw, random, drawn);
    out.genome = std::move(drawn.genome);
    out.origin = "drawn";
    return out;
  }
  const Individual& parent = archive.kept()[*choice.parent];
  const Individual* other = choice.other ? &archive.kept()[*choice.other] : nullptr;
  out.genome = child_of(plan, hash, parent, other, screener, random, out.origin);
  out.parent = parent.id;
  if (other) out.other_parent = other->id;
  return out;
}

void measure_candidate(const SearchPlan& settings, std::uint64_t plan, const Judges& judges,
                       Screener& screener, Individual& out) {
  const std::uint64_t seed = seed_of(plan, out.id);
  const Screening run = screener.run(out.genome, seed);
  out.bricks = built(out.genome, run);
  out.structure = shape_hash(out.genome.lattice, out.bricks);
  const Measures shape = measure(Structure(out.genome.lattice, out.bricks));
  const TrialCounts counts{settings.orders, settings.faults};
  const Trials trials = try_again(counts, out.genome, run, out.bricks, seed, screener);
  const Coordination coordination =
      coordination_of(out.genome, run, counts, trials, settings.proof);
  const Outcome outcome{out.genome,
                        run,
                        out.bricks,
                        shape,
                        trials,
                        coordination,
                        shape_distance(out.genome.lattice, out.bricks, settings.target),
                        work_of(settings, judges, out.genome, coordination)};
  for (const Objective& objective : objectives()) out.values.push_back(objective.value(outcome));
  set_score(settings, judges, out);
}

Individual evaluate(const SearchPlan& settings, std::uint64_t plan, const FindArchive& archive,
                    std::uint64_t id, Screener& screener, const Judges& judges) {
  Individual out = make_candidate(settings, plan, archive, id, screener);
  measure_candidate(settings, plan, judges, screener, out);
  return out;
}

std::uint64_t evaluations_of(const SearchPlan& plan, const BatchSlice& slice) {
  const auto batch = static_cast<std::uint64_t>(plan.batch);
  const std::uint64_t batches = (plan.evaluations + batch - 1) / batch;
  // Those from the slice's first on, every so many of them.
  return batches < slice.number ? 0 : ((batches - slice.number) / slice.of + 1) * batch;
}

std::vector<Individual> make_batch(const SearchPlan& plan, const SearchState& state,
                                   std::size_t count, int threads, Stop stop) {
  const std::uint64_t hash = plan_hash(plan), first = next_id(plan, state);
  std::vector<Individual> made(count);
  in_parts(plan, count, threads, stop, [&](std::size_t i, Screener& screener) {
    made[i] = make_candidate(plan, hash, state.archive, first + i, screener);
  });
  return made;
}

bool measure_batch(const SearchPlan& plan, std::vector<Individual>& made, const Judges& judges,
                   int threads, Stop stop) {
  const std::uint64_t hash = plan_hash(plan);
  return in_parts(plan, made.size(), threads, stop, [&](std::size_t i, Screener& screener) {
    measure_candidate(plan, hash, judges, screener, made[i]);
  });
}

SearchBatch take_batch(SearchState& state, std::vector<Individual> made) {
  assert(!made.empty());
  SearchBatch batch;
  batch.first_kept = state.archive.kept().size();
  batch.best = made.front().score;
  batch.until = made.back().id + 1;
  double sum = 0, squares = 0;
  for (Individual& one : made) {
    ++batch.built[one.structure];
    batch.best = std::max(batch.best, one.score);
    sum += one.score;
    squares += one.score * one.score;
    state.archive.offer(std::move(one));
  }
  const auto count = static_cast<double>(made.size());
  batch.mean = sum / count;
  batch.deviation = std::sqrt(std::max(0.0, squares / count - batch.mean * batch.mean));
  state.evaluated += made.size();
  batch.evaluated = state.evaluated;
  return batch;
}

const Individual* first_unscored(const std::vector<Individual>& measured) {
  const auto it = std::find_if(measured.begin(), measured.end(),
                               [](const Individual& one) { return !one.problem.empty(); });
  return it == measured.end() ? nullptr : &*it;
}

std::optional<SearchBatch> run_batch(const SearchPlan& plan, SearchState& state, int threads,
                                     Stop stop, const Judges& judges) {
  std::vector<Individual> made =
      make_batch(plan, state, static_cast<std::size_t>(plan.batch), threads, stop);
  if (!measure_batch(plan, made, judges, threads, stop)) return std::nullopt;
  if (first_unscored(made) != nullptr) return std::nullopt;
  return take_batch(state, std::move(made));
}

}  // namespace stig::search
