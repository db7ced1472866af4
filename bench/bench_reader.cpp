// SPDX-License-Identifier: MIT
// Reading rule sets: the 66 rules of architecture-4n, and files at and over the size
// limit.
#include <benchmark/benchmark.h>

#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "shipped.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

void read_text(benchmark::State& state, const std::string& text, bool good) {
  const auto source = std::make_shared<SourceFile>("bench.yaml", text);
  for (auto _ : state) {
    Diagnostics diagnostics;
    const auto rules = read_rule_set(source, diagnostics);
    if (rules.has_value() != good) state.SkipWithError("unexpected verdict");
  }
  state.counters["bytes"] = static_cast<double>(text.size());
}

void read_architecture_4n(benchmark::State& state) {
  read_text(state, print_rule_set(shipped("architecture-4n")), true);
}

/// Exact rules, all different, as many as `bytes` hold: the site's surroundings spell
/// the rule's number.
std::string many_rules(std::size_t bytes) {
  RuleSet set = shipped("wall");
  Rule rule = set.rules.front();
  rule.pattern.allowed.fill(StateSet::empty_cell());
  rule.counts.clear();
  rule.height_min.reset();
  rule.height_max.reset();
  set.rules.clear();
  set.symmetry = Symmetry::none;
  set.expect.reset();
  set.comments.clear();
  const std::size_t one = 150;  // about what a rule takes in print
  for (std::size_t i = 0; i < bytes / one && i < 20000; ++i) {
    rule.name = "rule " + std::to_string(i);
    for (std::size_t bit = 0; bit < 16; ++bit) {
      rule.pattern.allowed[bit] = StateSet::of((i >> bit & 1U) != 0 ? 1 : kEmpty);
    }
    rule.pattern.allowed[25] = StateSet::of(1);
    set.rules.push_back(rule);
  }
  return print_rule_set(set);
}

void read_large(benchmark::State& state) { read_text(state, many_rules(900'000), true); }
void read_too_large(benchmark::State& state) {
  read_text(state, std::string(static_cast<std::size_t>(state.range(0)), 'x'), false);
}

BENCHMARK(read_architecture_4n)->Unit(benchmark::kMillisecond);
BENCHMARK(read_large)->Unit(benchmark::kMillisecond);
BENCHMARK(read_too_large)->Arg(5 << 20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stig::bench
