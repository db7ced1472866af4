// SPDX-License-Identifier: MIT
// Targets compiled into rule sets, each with the default budget: colours, rules, and
// whether the verifier proves the result. The bars show what rows side by side are
// worth: one alone counts in ones, two and four in digits.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>

#include "support/uses.h"
#include "synthesis/emit.h"
#include "synthesis/shapes.h"
#include "synthesis/synthesise.h"
#include "verify/verify.h"

namespace stig::bench {
namespace {

using Keep = std::function<bool(Cell)>;

/// Two legs and a lintel that overhangs between them.
Keep arch(Offset size, std::int32_t thick) {
  return [=](Cell c) { return c.x < thick || c.x >= size.x - thick || c.z >= size.z - thick; };
}

Keep ball(double radius) {
  return
      [=](Cell c) { return std::hypot(c.x - radius, c.y - radius, c.z - radius) <= radius + 0.2; };
}

Keep dome(double radius) {
  return [=](Cell c) { return std::hypot(c.x - radius, c.y - radius, c.z) <= radius; };
}

/// S, two cells deep.
bool letter_s(Cell c) {
  static constexpr const char* kRows[] = {"11110", "00001", "01110", "10000", "01111"};
  return kRows[c.z][c.x] == '1';
}

void compile(benchmark::State& state, const Target& target, Symmetry symmetry) {
  SynthesisOptions options;
  options.symmetry = symmetry;
  Synthesis result;
  for (auto _ : state) result = synthesise(target, options);
  if (!result.best) return state.SkipWithError("not compiled");
  const Solution& s = *result.best;
  const RuleSet rules = make_rule_set(*s.frame, s.colours, s.colour_count, {}, s.rules, {});
  state.counters["bricks"] = static_cast<double>(target.cells.size());
  state.counters["colours"] = s.colour_count;
  state.counters["rules"] = static_cast<double>(s.rules.size());
  state.counters["exact_rules"] = static_cast<double>(s.exact_rules);
  state.counters["proved"] = verify::verify(rules, {}).verdict == ProofVerdict::proved ? 1 : 0;
  state.SetLabel(s.order.name);
}

void add(const std::string& name, const Target& target, Symmetry symmetry = Symmetry::none) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { compile(state, target, symmetry); })
      ->Iterations(1)
      ->Unit(benchmark::kSecond);
}

const bool kRegistered = [] {
  add("plate_7x7/rotations", box({7, 7, 1}), Symmetry::rotations);
  add("pyramid_6/rotations", pyramid(5), Symmetry::rotations);
  add("hollow_box_5", hollow_box(5));
  add("hollow_box_9", hollow_box(9));
  add("cube_8", box({8, 8, 8}));
  add("cube_10", box({10, 10, 10}));
  add("arch", carved({24, 6, 16}, arch({24, 6, 16}, 3)));
  add("letter_s", carved({5, 2, 5}, letter_s));
  add("ball", carved({13, 13, 13}, ball(6)));
  add("dome_32/rotations", carved({32, 32, 16}, dome(15.5)), Symmetry::rotations);
  add("cube_32/rotations", box({32, 32, 32}), Symmetry::rotations);
  for (const int n : {10, 20, 50, 100}) {
    if (n <= 50) add("bar_1x1/" + std::to_string(n), box({n, 1, 1}));
    add("bar_2x1/" + std::to_string(n), box({n, 2, 1}));
    add("bar_2x2/" + std::to_string(n), box({n, 2, 2}));
  }
  return true;
}();

}  // namespace
}  // namespace stig::bench
