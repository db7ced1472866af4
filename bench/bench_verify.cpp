// SPDX-License-Identifier: MIT
// Proofs by size: a box filled from a corner, and a sheet of three colours with exact
// patterns; the fit says whether the time is linear in the number of bricks. And the checker
// on the same certificates.
#include <benchmark/benchmark.h>

#include <cmath>

#include "certify/check.h"
#include "shipped.h"
#include "support/uses.h"
#include "verify/verify.h"

namespace stig::bench {
namespace {

/// A brick beside any brick on three of its faces, within a cube of about `bricks` cells.
RuleSet filled_box(std::int64_t bricks) {
  RuleSet rules;
  rules.name = "filled box";
  rules.bricks.resize(1);
  rules.bricks[0].symbol = "1";
  const auto side = static_cast<std::int32_t>(std::lround(std::cbrt(static_cast<double>(bricks))));
  rules.box = BoxSpec{{side, side, side}, Cell{0, 0, 0}, false};
  rules.start = {{{0, 0, 0}, 1}};
  const Neighbourhood& n = neighbourhood(Lattice::cubic);
  for (const Offset from : {Offset{-1, 0, 0}, Offset{0, -1, 0}, Offset{0, 0, -1}}) {
    Rule rule;
    rule.name = "beside";
    rule.place = 1;
    rule.pattern.allowed[static_cast<std::size_t>(n.index_of(from))] = StateSet::of(1);
    rules.rules.push_back(rule);
  }
  return rules;
}

/// The shipped tiling, in a box of one level.
RuleSet sheet(std::int64_t bricks) {
  RuleSet rules = shipped("tiling");
  const auto side = static_cast<std::int32_t>(std::lround(std::sqrt(static_cast<double>(bricks))));
  rules.box = BoxSpec{{side, side, 1}, std::nullopt, false};
  return rules;
}

void prove(benchmark::State& state, RuleSet (*make)(std::int64_t)) {
  const RuleSet rules = make(state.range(0));
  VerifyOptions options;
  options.box = file_box(rules);
  options.seconds = 3600;
  std::size_t bricks = 0;
  for (auto _ : state) {
    const VerifyResult result = verify::verify(rules, options);
    if (result.verdict != ProofVerdict::proved) state.SkipWithError("not proved");
    if (result.structure) bricks = result.structure->size();
  }
  state.SetComplexityN(static_cast<std::int64_t>(bricks));
  state.counters["bricks"] = static_cast<double>(bricks);
  state.counters["peak_MB"] = peak_megabytes();
}

void check(benchmark::State& state, RuleSet (*make)(std::int64_t)) {
  const RuleSet rules = make(state.range(0));
  VerifyOptions options;
  options.box = file_box(rules);
  options.seconds = 3600;
  const VerifyResult result = verify::verify(rules, options);
  if (!result.certificate) return state.SkipWithError("not proved");
  for (auto _ : state) {
    const CheckReport report = check_certificate(rules, *result.certificate);
    if (!report.accepted) state.SkipWithError("refused");
  }
  state.SetComplexityN(static_cast<std::int64_t>(result.structure->size()));
}

void sizes(benchmark::internal::Benchmark* b) {
  b->Arg(1'000)->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
  b->Iterations(1)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);
}

BENCHMARK_CAPTURE(prove, filled_box, filled_box)->Apply(sizes);
BENCHMARK_CAPTURE(prove, sheet, sheet)->Apply(sizes);
BENCHMARK_CAPTURE(check, filled_box, filled_box)->Apply(sizes);
BENCHMARK_CAPTURE(check, sheet, sheet)->Apply(sizes);

}  // namespace
}  // namespace stig::bench
