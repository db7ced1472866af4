// SPDX-License-Identifier: MIT
#include "search/trials.h"

#include <algorithm>

#include "base/hash.h"
#include "search/draw.h"

namespace stig::search {
namespace {

struct Candidate {
  const Genome& genome;
  const Screening& run;
  const std::vector<PlacedBrick>& bricks;
};

/// The bricks that stand after so many deposits, the start first.
std::vector<PlacedBrick> after(const Candidate& candidate, std::size_t deposits) {
  std::vector<PlacedBrick> bricks{{Cell{}, candidate.genome.start}};
  for (std::size_t i = 0; i < deposits; ++i) {
    bricks.push_back({candidate.run.placed[i].at, candidate.run.placed[i].brick});
  }
  return bricks;
}

bool has(const std::vector<PlacedBrick>& sorted, Cell cell) {
  return std::binary_search(sorted.begin(), sorted.end(), PlacedBrick{cell, 0},
                            [](const PlacedBrick& a, const PlacedBrick& b) { return a.at < b.at; });
}

/// Do the bricks, and what grows from them, make the candidate's structure, but for a brick in
/// `besides`?
bool ends_alike(const Candidate& candidate, std::vector<PlacedBrick> bricks,
                std::optional<Cell> besides, std::uint64_t seed, Screener& screener) {
  const Screening& run = screener.run_from(candidate.genome, bricks, seed);
  if (!run.saturated) return false;
  for (const ScreenedBrick& b : run.placed) bricks.push_back({b.at, b.brick});
  if (besides) std::erase_if(bricks, [&](const PlacedBrick& b) { return b.at == *besides; });
  std::sort(bricks.begin(), bricks.end());
  return bricks == candidate.bricks;
}

/// After a random number of deposits one of them, or nothing where there were none.
bool survives_loss(const Candidate& candidate, std::uint64_t seed, Screener& screener) {
  if (candidate.run.placed.empty()) return false;
  Random random(seed, 0, kDrawing, 1, 0);
  auto bricks = after(candidate, 1 + random.below(candidate.run.placed.size()));
  const std::size_t lost = 1 + random.below(bricks.size() - 1);
  bricks.erase(bricks.begin() + static_cast<std::ptrdiff_t>(lost));
  return ends_alike(candidate, std::move(bricks), std::nullopt, seed, screener);
}

/// A brick in a cell that the structure leaves free, beside one that stands at that time.
bool survives_addition(const Candidate& candidate, std::uint64_t seed, Screener& screener) {
  Random random(seed, 0, kDrawing, 2, 0);
  auto bricks = after(candidate, random.below(candidate.run.placed.size() + 1));
  const Neighbourhood& n = neighbourhood(candidate.genome.lattice);
  for (int tries = 0; tries < 64; ++tries) {
    const Cell cell = bricks[random.below(bricks.size())].at +
                      n.offsets[random.below(static_cast<std::uint64_t>(n.size))];
    if (has(candidate.bricks, cell) || (candidate.genome.floor && cell.z < 0)) continue;
    const auto colours = static_cast<std::uint64_t>(candidate.genome.colours);
    bricks.push_back({cell, static_cast<Colour>(1 + random.below(colours))});
    return ends_alike(candidate, std::move(bricks), cell, seed, screener);
  }
  return false;
}

template <class Test>
double share_of(int count, const Test& test) {
  int passed = 0;
  for (int k = 1; k <= count; ++k) passed += test(k) ? 1 : 0;
  return count == 0 ? 0 : static_cast<double>(passed) / count;
}

}  // namespace

std::uint64_t order_seed(std::uint64_t seed, int k) {
  return combine(seed, static_cast<std::uint64_t>(k));
}

Trials try_again(const TrialCounts& counts, const Genome& genome, const Screening& run,
                 const std::vector<PlacedBrick>& bricks, std::uint64_t seed, Screener& screener) {
  Trials trials;
  if (!run.saturated) return trials;
  const Candidate candidate{genome, run, bricks};
  const auto alike = [&](int k) {
    return ends_alike(candidate, {{Cell{}, genome.start}}, std::nullopt, order_seed(seed, k),
                      screener);
  };
  trials.same_ends = share_of(counts.orders, alike);
  // What ends anyhow in each order does not end alike after a fault.
  if (counts.orders > 0 && trials.same_ends < 1) return trials;
  const auto own_seed = [&](int k) { return order_seed(seed, -k); };
  trials.lost_bricks = share_of(
      counts.faults, [&](int k) { return survives_loss(candidate, own_seed(k), screener); });
  trials.extra_bricks = share_of(
      counts.faults, [&](int k) { return survives_addition(candidate, own_seed(k), screener); });
  return trials;
}

}  // namespace stig::search
