// SPDX-License-Identifier: MIT
// Targets compiled into rule sets, each with the default budget: colours, rules, and
// whether the verifier proves the result. The bars show what rows side by side are
// worth: one alone counts in ones, two and four in digits.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "synthesis/emit.h"
#include "synthesis/synthesise.h"
#include "verify/verify.h"

namespace stig::bench {
namespace {

using Keep = std::function<bool(Cell)>;

Target carved(Offset size, const Keep& keep) {
  Target target;
  for (std::int32_t x = 0; x < size.x; ++x) {
    for (std::int32_t y = 0; y < size.y; ++y) {
      for (std::int32_t z = 0; z < size.z; ++z) {
        if (keep(Cell{x, y, z})) target.cells.push_back({x, y, z});
      }
    }
  }
  target.colours.assign(target.cells.size(), StateSet::anything());
  return target;
}

bool everything(Cell) { return true; }

Keep hollow(std::int32_t side) {
  return [=](Cell c) {
    return c.x % (side - 1) == 0 || c.y % (side - 1) == 0 || c.z % (side - 1) == 0;
  };
}

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

Keep pyramid(std::int32_t radius) {
  return [=](Cell c) {
    return std::max(std::abs(c.x - radius), std::abs(c.y - radius)) <= radius - c.z;
  };
}

/// S, two cells deep.
bool letter_s(Cell c) {
  static constexpr const char* kRows[] = {"11110", "00001", "01110", "10000", "01111"};
  return kRows[c.z][c.x] == '1';
}

void compile(benchmark::State& state, const Offset size, const Keep& keep, Symmetry symmetry) {
  const Target target = carved(size, keep);
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
  state.counters["proved"] = verify(rules, {}).verdict == ProofVerdict::proved ? 1 : 0;
  state.SetLabel(s.order.name);
}

void add(const std::string& name, Offset size, const Keep& keep,
         Symmetry symmetry = Symmetry::none) {
  benchmark::RegisterBenchmark(
      name.c_str(), [=](benchmark::State& state) { compile(state, size, keep, symmetry); })
      ->Iterations(1)
      ->Unit(benchmark::kSecond);
}

const bool kRegistered = [] {
  add("plate_7x7/rotations", {7, 7, 1}, everything, Symmetry::rotations);
  add("pyramid_6/rotations", {11, 11, 6}, pyramid(5), Symmetry::rotations);
  add("hollow_box_5", {5, 5, 5}, hollow(5));
  add("hollow_box_9", {9, 9, 9}, hollow(9));
  add("cube_8", {8, 8, 8}, everything);
  add("cube_10", {10, 10, 10}, everything);
  add("arch", {24, 6, 16}, arch({24, 6, 16}, 3));
  add("letter_s", {5, 2, 5}, letter_s);
  add("ball", {13, 13, 13}, ball(6));
  add("dome_32/rotations", {32, 32, 16}, dome(15.5), Symmetry::rotations);
  add("cube_32/rotations", {32, 32, 32}, everything, Symmetry::rotations);
  for (const int n : {10, 20, 50, 100}) {
    if (n <= 50) add("bar_1x1/" + std::to_string(n), {n, 1, 1}, everything);
    add("bar_2x1/" + std::to_string(n), {n, 2, 1}, everything);
    add("bar_2x2/" + std::to_string(n), {n, 2, 2}, everything);
  }
  return true;
}();

}  // namespace
}  // namespace stig::bench
