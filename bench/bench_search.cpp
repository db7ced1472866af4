// SPDX-License-Identifier: MIT
// Random sets of 20 rules a second: drawn, compiled and screened in a 20³ box until no rule fits or
// 500 bricks are placed. Counters beside the rate say how many bricks the sets placed, so that a
// rate bought with sets that build nothing would show. The runs with two threads share out the
// same sets.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "search/draw.h"
#include "search/screen.h"

namespace stig::bench {
namespace {

constexpr std::size_t kSets = 20'000, kPart = 500;

/// The deposits of each set.
std::vector<std::uint64_t> screen_all(const search::DrawSettings& settings, int threads) {
  std::vector<std::uint64_t> deposits(kSets);
  run_parallel(kSets / kPart, threads, [&](std::size_t part) {
    search::Screener screener({20, 500});
    search::DrawnGenome drawn;
    for (std::size_t i = part * kPart; i < (part + 1) * kPart; ++i) {
      Random random(i, 0, search::kDrawing, 0, 0);
      search::draw_genome(settings, random, drawn);
      deposits[i] = screener.run(drawn.genome, i).placed.size();
    }
  });
  return deposits;
}

void screening(benchmark::State& state, const search::DrawSettings& settings, int threads) {
  std::vector<std::uint64_t> deposits;
  for (auto _ : state) deposits = screen_all(settings, threads);
  std::sort(deposits.begin(), deposits.end());
  const auto quantile = [&](double q) {
    return static_cast<double>(deposits[static_cast<std::size_t>(q * (kSets - 1))]);
  };
  const double sum = static_cast<double>(std::accumulate(deposits.begin(), deposits.end(), 0ULL));
  state.counters["sets/s"] =
      benchmark::Counter(static_cast<double>(kSets) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
  state.counters["deposits_mean"] = sum / static_cast<double>(kSets);
  for (const auto& [name, q] : {std::pair("10%", 0.1), std::pair("50%", 0.5), std::pair("90%", 0.9),
                                std::pair("99%", 0.99)}) {
    state.counters[std::string("deposits_") + name] = quantile(q);
  }
}

search::DrawSettings kind(rules::Lattice lattice, double wildcards) {
  search::DrawSettings settings;
  settings.lattice = lattice;
  settings.wildcards = wildcards;
  return settings;
}

// One thread by its processor time, which others on the machine take nothing from; two by the
// clock.
#define STIG_BENCH_SCREENING(name, lattice, wildcards)                                \
  BENCHMARK_CAPTURE(screening, name##_1, kind(rules::Lattice::lattice, wildcards), 1) \
      ->Unit(benchmark::kMillisecond);                                                \
  BENCHMARK_CAPTURE(screening, name##_2, kind(rules::Lattice::lattice, wildcards), 2) \
      ->Unit(benchmark::kMillisecond)                                                 \
      ->UseRealTime()
STIG_BENCH_SCREENING(cubic_exact, cubic, 0.0);
STIG_BENCH_SCREENING(cubic_tenth_wild, cubic, 0.1);
STIG_BENCH_SCREENING(cubic_third_wild, cubic, 0.33);
STIG_BENCH_SCREENING(hexagonal_tenth_wild, hexagonal, 0.1);

}  // namespace
}  // namespace stig::bench
