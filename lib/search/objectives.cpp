// SPDX-License-Identifier: MIT
// The table of objectives and the few measures that lattice/measures.h has not.
#include "search/objectives.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/hash.h"
#include "search/repeated_parts.h"

namespace stig::search {
namespace {

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

double bricks(const Outcome& o) { return static_cast<double>(o.bricks.size()); }

double rules_used(const Outcome& o) {
  const auto fired = std::count_if(o.run.fired.begin(), o.run.fired.end(),
                                   [](std::uint64_t times) { return times > 0; });
  return share(static_cast<double>(fired), static_cast<double>(o.run.fired.size()));
}

double compactness(const Outcome& o) {
  return o.shape.mean_neighbours / neighbourhood(o.genome.lattice).faces;
}

double symmetry(const Outcome& o) { return o.shape.symmetry_order; }
double enclosed(const Outcome& o) { return static_cast<double>(o.shape.cavity_cells); }
double height(const Outcome& o) { return static_cast<double>(o.shape.height_profile.size()); }
double saturated(const Outcome& o) { return o.run.saturated ? 1 : 0; }
double same_ends(const Outcome& o) { return o.trials.same_ends; }
double lost_bricks(const Outcome& o) { return o.trials.lost_bricks; }
double extra_bricks(const Outcome& o) { return o.trials.extra_bricks; }
double coordinated(const Outcome& o) { return is_coordinated(o.coordination) ? 1 : 0; }
double verdict(const Outcome& o) { return static_cast<double>(o.coordination); }
double distance(const Outcome& o) { return o.distance; }
double robots(const Outcome& o) { return o.work.robots; }
double refusal(const Outcome& o) { return o.work.refusal; }

double parallelism(const Outcome& o) {
  return share(static_cast<double>(o.run.open_sites), static_cast<double>(o.run.placed.size()));
}

/// How many deposits have to follow each other: the longest chain of neighbouring bricks, each
/// placed after the one before it.
double stages(const Outcome& o) {
  const Neighbourhood& n = neighbourhood(o.genome.lattice);
  std::map<Cell, int> depth{{Cell{}, 0}};
  int deepest = 0;
  for (const ScreenedBrick& brick : o.run.placed) {
    int own = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      const auto before = depth.find(brick.at + n.offsets[i]);
      if (before != depth.end()) own = std::max(own, before->second);
    }
    depth.emplace(brick.at, ++own);
    deepest = std::max(deepest, own);
  }
  return deepest;
}

/// The bricks around each brick, as a hash: colours and places within its neighbourhood.
std::map<std::uint64_t, int> patterns_of(const Outcome& o) {
  const Neighbourhood& n = neighbourhood(o.genome.lattice);
  std::map<Cell, Colour> at;
  for (const PlacedBrick& b : o.bricks) at.emplace(b.at, b.brick);
  std::map<std::uint64_t, int> times;
  for (const PlacedBrick& b : o.bricks) {
    std::uint64_t pattern = mix(b.brick);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      const auto near = at.find(b.at + n.offsets[i]);
      pattern = combine(pattern, near == at.end() ? 0 : near->second);
    }
    ++times[pattern];
  }
  return times;
}

double repetition(const Outcome& o) {
  double repeated = 0;
  for (const auto& [pattern, times] : patterns_of(o)) repeated += times > 1 ? times : 0;
  return share(repeated, static_cast<double>(o.bricks.size()));
}

double modules(const Outcome& o) {
  const auto times = patterns_of(o);
  return static_cast<double>(std::count_if(times.begin(), times.end(),
                                           [](const auto& entry) { return entry.second > 1; }));
}

double repeated(const Outcome& o) { return repeated_parts(o.genome.lattice, o.bricks); }

constexpr std::string_view kOwn = "this project";
constexpr std::string_view kBonabeau = "after Bonabeau et al. 2000, BioSystems 56:13-32";

constexpr std::string_view kTheraulaz =
    "after Theraulaz & Bonabeau 1995, J. theor. Biol. 177:381-400";
constexpr std::string_view kJaccard = "Jaccard 1901, Bull. Soc. vaud. sci. nat. 37:547-579";

constexpr std::array kObjectives = {
    Objective{"bricks", "bricks in the end, the start included", kOwn, bricks},
    Objective{"rules_used", "share of the rules that fired", kBonabeau, rules_used},
    Objective{"compactness", "mean share of a brick's faces that touch another", kBonabeau,
              compactness},
    Objective{"modules", "kinds of neighbourhood, colours included, that two bricks or more have",
              kBonabeau, modules},
    Objective{"repetition", "share of the bricks whose neighbourhood another brick has too", kOwn,
              repetition},
    Objective{"symmetry", "maps onto itself, of 16 cubic or 24 hexagonal ones", kOwn, symmetry},
    Objective{"enclosed", "empty cells with no way out by faces", kOwn, enclosed},
    Objective{"height", "levels from the lowest brick to the highest", kOwn, height},
    Objective{"stages", "longest chain of neighbouring bricks, each after the one before", kOwn,
              stages},
    Objective{"saturated", "1 where no rule matched anywhere in the end, else 0", kOwn, saturated},
    Objective{"same_ends", "share of further random orders that end in the same bricks", kOwn,
              same_ends},
    Objective{"parallelism", "sites open at once, mean over the deposits", kOwn, parallelism},
    Objective{"lost_bricks", "share of runs that end in the same bricks though one was lost", kOwn,
              lost_bricks},
    Objective{"extra_bricks", "share of runs that end so but for a brick that was added", kOwn,
              extra_bricks},
    Objective{"coordinated", "1 where every order is proved to end alike, else 0", kTheraulaz,
              coordinated},
    Objective{"verdict", "how that was decided, as a number", kOwn, verdict},
    Objective{"distance", "share of cells in the structure or the target that are not in both",
              kJaccard, distance},
    Objective{"robots", "robots that may work at once, by `stigc compile`; 0 where it refuses",
              kOwn, robots},
    Objective{"refusal", "number of the diagnostic P7xx by which it refuses, else 0", kOwn,
              refusal},
    Objective{"repeated_parts",
              "kinds of part, two contacts around a brick, that are in two places apart", kBonabeau,
              repeated},
};

}  // namespace

std::span<const Objective> objectives() { return kObjectives; }

std::optional<std::size_t> objective_number(std::string_view name) {
  for (std::size_t i = 0; i < kObjectives.size(); ++i) {
    if (kObjectives[i].name == name) return i;
  }
  return std::nullopt;
}

}  // namespace stig::search
