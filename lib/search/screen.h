// SPDX-License-Identifier: MIT
// Runs of genomes, many thousands a second: the event engine of lattice/swarm.h again, for
// worlds that are small, rules that are new each time, and nothing that is kept.
//
// It gives the deposits that run_swarm gives for rule_set_of(genome) under Motion::event, in the
// same order; a law in the tests holds it to that. It differs in what it costs. The world is an
// array with a margin; rules become bit sets in memory that was there before; and after a
// deposit a site that was closed is looked at for those patterns alone that ask for the new
// brick, which mostly are none.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "search/genome.h"
#include "search/uses.h"

namespace stig::search {

struct ScreenConfig {
  int side = 20;                      ///< of the box, cells, 1..64; laid around the start brick
  std::uint64_t most_deposits = 500;  ///< after which a run ends
};

struct ScreenedBrick {
  Cell at;
  Colour brick = 0;
  std::uint32_t rule = 0;  ///< index into Genome::rules
  auto operator<=>(const ScreenedBrick&) const = default;
};

struct Screening {
  std::vector<ScreenedBrick> placed;  ///< in order, without the start
  std::vector<std::uint64_t> fired;   ///< by rule
  bool saturated = false;             ///< no site was open at the end
  std::uint64_t open_sites = 0;       ///< summed over the deposits, each time before it
};

/// One for each thread: it holds the memory that runs use again.
class Screener {
 public:
  explicit Screener(const ScreenConfig& config);
  ~Screener();
  Screener(Screener&&) noexcept;
  Screener& operator=(Screener&&) noexcept;

  /// A run of the genome. `seed` as SwarmConfig::seed. The result is good until the next run.
  const Screening& run(const Genome& genome, std::uint64_t seed);
  /// The same from these bricks, no two in one cell, in place of the start; those outside the box
  /// are left out. What the result calls placed is without them.
  const Screening& run_from(const Genome& genome, const std::vector<PlacedBrick>& bricks,
                            std::uint64_t seed);

 private:
  struct World;
  std::unique_ptr<World> world_;
};

/// The bricks of a run with its start, in the order of cells.
std::vector<PlacedBrick> built(const Genome& genome, const Screening& screening);

}  // namespace stig::search
