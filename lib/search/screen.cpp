// SPDX-License-Identifier: MIT
// The fast event engine (see the header). Sites are numbers in an array with a margin of one cell,
// which no view from inside the box leaves.
#include "search/screen.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "base/random.h"
#include "lattice/box.h"
#include "search/pattern_bits.h"

namespace stig::search {

struct Screener::World {
  explicit World(const ScreenConfig& wanted)
      : config(wanted),
        side(wanted.side + 2),
        cells(static_cast<std::size_t>(side * side * side)),
        place_in_open(cells.size(), 0) {}

  const Screening& run_from(const Genome& genome, const std::vector<PlacedBrick>& first,
                            std::uint64_t seed);

  void lay_out(const Genome& genome);
  void take_away();
  void lay(const std::vector<PlacedBrick>& first);
  void grow(const Genome& genome, std::uint64_t seed);
  void deposit(std::uint32_t site, Colour colour, std::uint32_t rule);
  void update(std::uint32_t site, std::size_t seen_at, Colour colour);
  void set_open(std::uint32_t site, bool open_now);
  /// Patterns that the site's height allows. Most genomes have no bounds, and are spared the
  /// division.
  std::uint64_t allowed(std::uint32_t site, std::size_t w) const {
    if (!patterns.limited()) return patterns.all(w);
    return patterns.at_height(low.z + static_cast<std::int32_t>(site) / (side * side) - 1, w);
  }
  int first_match(std::uint32_t site, std::size_t word, std::uint64_t alive) const;
  /// The lowest pattern that matches; -1: none.
  int match(std::uint32_t site) const;
  bool newly_matched(std::uint32_t site, std::size_t seen_at, Colour colour) const;

  Cell cell_of(std::uint32_t site) const {
    const auto n = static_cast<std::int32_t>(site);
    return low + Offset{n % side - 1, n / side % side - 1, n / (side * side) - 1};
  }
  std::uint32_t index_of(Cell cell) const {
    const Offset at = cell - low;
    return static_cast<std::uint32_t>(((at.z + 1) * side + at.y + 1) * side + at.x + 1);
  }

  ScreenConfig config;
  std::int32_t side;                             ///< of the array
  std::vector<std::uint8_t> cells;               ///< rows of PatternBits
  std::vector<std::uint32_t> open;               ///< sites where a rule matches
  std::vector<std::uint32_t> place_in_open;      ///< 1 + position in open; 0: closed
  std::vector<std::uint32_t> bricks;             ///< sites to be cleared
  std::vector<Cell> around;                      ///< those that a run began with
  Cell low;                                      ///< of the box
  std::optional<std::pair<Lattice, bool>> laid;  ///< lattice and floor of the run before
  std::array<std::int32_t, kMaxNeighbours> step{};
  std::array<std::uint8_t, kMaxNeighbours> opposite{};
  std::size_t neighbours = 0;
  PatternBits patterns;
  Screening result;
};

/// What a run leaves behind is cleared brick by brick: the array is larger than most growths.
void Screener::World::take_away() {
  for (const std::uint32_t site : bricks) cells[site] = 0;
  for (const std::uint32_t site : open) place_in_open[site] = 0;
  bricks.clear();
  open.clear();
}

void Screener::World::lay_out(const Genome& genome) {
  if (laid == std::pair(genome.lattice, genome.floor)) return;
  laid = {genome.lattice, genome.floor};
  const BoxSpec spec{{config.side, config.side, config.side}, std::nullopt, false};
  low = lay_box(spec, {{Cell{}, genome.start}}, genome.floor).low;
  const Neighbourhood& n = neighbourhood(genome.lattice);
  neighbours = static_cast<std::size_t>(n.size);
  for (std::size_t i = 0; i < neighbours; ++i) {
    const Offset o = n.offsets[i];
    step[i] = (o.z * side + o.y) * side + o.x;
    opposite[i] = static_cast<std::uint8_t>(n.opposite(static_cast<int>(i)));
  }
  for (std::uint32_t site = 0; site < cells.size(); ++site) {
    const Offset at = cell_of(site) - low;
    const auto within = [&](std::int32_t v) { return v >= 0 && v < config.side; };
    const bool inside = within(at.x) && within(at.y) && within(at.z);
    const bool floor = genome.floor && low.z + at.z < 0;
    cells[site] = inside ? std::uint8_t{0} : floor ? kRowFloor : kRowOutside;
  }
}

/// The first pattern of a word that is alive after every neighbour has been asked.
int Screener::World::first_match(std::uint32_t site, std::size_t word, std::uint64_t alive) const {
  const std::uint8_t* here = cells.data() + site;
  for (const std::uint8_t i : patterns.order()) {
    alive &= patterns.accepting(i, here[step[i]], word);
    if (alive == 0) return -1;
  }
  return static_cast<int>(word) * 64 + std::countr_zero(alive);
}

int Screener::World::match(std::uint32_t site) const {
  for (std::size_t w = 0; w < patterns.words(); ++w) {
    if (const int found = first_match(site, w, allowed(site, w)); found >= 0) return found;
  }
  return -1;
}

/// Of a closed site beside a new brick: only patterns can match now that did not accept what was
/// there before, which was nothing.
bool Screener::World::newly_matched(std::uint32_t site, std::size_t seen_at, Colour colour) const {
  for (std::size_t w = 0; w < patterns.words(); ++w) {
    std::uint64_t asking =
        patterns.accepting(seen_at, colour, w) & ~patterns.accepting(seen_at, 0, w);
    if (asking == 0) continue;
    asking &= allowed(site, w);
    if (asking != 0 && first_match(site, w, asking) >= 0) return true;
  }
  return false;
}

/// The list changes as CellMarks does: the last takes the place of one that goes.
void Screener::World::set_open(std::uint32_t site, bool open_now) {
  const std::uint32_t place = place_in_open[site];
  if ((place != 0) == open_now) return;
  if (open_now) {
    open.push_back(site);
    place_in_open[site] = static_cast<std::uint32_t>(open.size());
    return;
  }
  open[place - 1] = open.back();
  place_in_open[open.back()] = place;
  open.pop_back();
  place_in_open[site] = 0;
}

void Screener::World::update(std::uint32_t site, std::size_t seen_at, Colour colour) {
  if (place_in_open[site] != 0) {
    set_open(site, match(site) >= 0);
  } else if (newly_matched(site, seen_at, colour)) {
    set_open(site, true);
  }
}

void Screener::World::deposit(std::uint32_t site, Colour colour, std::uint32_t rule) {
  cells[site] = colour;
  bricks.push_back(site);
  result.placed.push_back({cell_of(site), colour, rule});
  ++result.fired[rule];
  for (std::size_t i = 0; i < neighbours; ++i) {
    const auto neighbour = static_cast<std::uint32_t>(static_cast<std::int32_t>(site) + step[i]);
    if (cells[neighbour] == 0) update(neighbour, opposite[i], colour);
  }
}

/// Lays the bricks that a run begins with, and opens sites in the order of cells, as
/// LatticeWorld::candidates has them.
void Screener::World::lay(const std::vector<PlacedBrick>& first) {
  around.clear();
  for (const PlacedBrick& brick : first) {
    const Offset at = brick.at - low;
    if (std::min({at.x, at.y, at.z}) < 0 || std::max({at.x, at.y, at.z}) >= config.side) continue;
    const std::uint32_t site = index_of(brick.at);
    cells[site] = brick.brick;
    bricks.push_back(site);
    for (std::size_t i = 0; i < neighbours; ++i) {
      around.push_back(
          cell_of(static_cast<std::uint32_t>(static_cast<std::int32_t>(site) + step[i])));
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  for (const Cell cell : around) {
    const std::uint32_t site = index_of(cell);
    if (cells[site] == 0 && match(site) >= 0) set_open(site, true);
  }
}

void Screener::World::grow(const Genome& genome, std::uint64_t seed) {
  const std::size_t turns = patterns.orientations();
  for (std::uint64_t step_number = 1; !open.empty(); ++step_number) {
    if (result.placed.size() >= config.most_deposits) return;
    // As the event engine draws: a stream for each step, and from it the site.
    Random random(seed, 0, Purpose::event, 0, step_number);
    result.open_sites += open.size();
    const std::uint32_t site = open[random.below(open.size())];
    const int found = match(site);
    assert(found >= 0);
    const auto rule = static_cast<std::uint32_t>(static_cast<std::size_t>(found) / turns);
    set_open(site, false);
    deposit(site, genome.rules[rule].place, rule);
  }
  result.saturated = true;
}

const Screening& Screener::World::run_from(const Genome& genome,
                                           const std::vector<PlacedBrick>& first,
                                           std::uint64_t seed) {
  take_away();
  lay_out(genome);
  patterns.compile(genome, low.z, low.z + config.side - 1);
  result.placed.clear();
  result.fired.assign(genome.rules.size(), 0);
  result.saturated = false;
  result.open_sites = 0;
  lay(first);
  grow(genome, seed);
  return result;
}

Screener::Screener(const ScreenConfig& config) : world_(std::make_unique<World>(config)) {
  assert(config.side >= 1 && config.side <= 64);
}
Screener::~Screener() = default;
Screener::Screener(Screener&&) noexcept = default;
Screener& Screener::operator=(Screener&&) noexcept = default;

const Screening& Screener::run(const Genome& genome, std::uint64_t seed) {
  return world_->run_from(genome, {{Cell{}, genome.start}}, seed);
}

const Screening& Screener::run_from(const Genome& genome, const std::vector<PlacedBrick>& bricks,
                                    std::uint64_t seed) {
  return world_->run_from(genome, bricks, seed);
}

std::vector<PlacedBrick> built(const Genome& genome, const Screening& screening) {
  std::vector<PlacedBrick> bricks{{Cell{}, genome.start}};
  for (const ScreenedBrick& b : screening.placed) bricks.push_back({b.at, b.brick});
  std::sort(bricks.begin(), bricks.end());
  return bricks;
}

}  // namespace stig::search
