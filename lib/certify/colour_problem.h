// SPDX-License-Identifier: MIT
// A target under an order, as the file of a minimality proof gives it, and which of its
// structures can be reached.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/uses.h"
#include "rules/symmetry.h"

namespace stig::certify {

/// A set of the target's cells, by number.
using CellBits = std::vector<std::uint64_t>;

struct ColourProblem {
  Lattice lattice = Lattice::cubic;
  Symmetry symmetry = Symmetry::none;
  bool floor = false;
  int colours = 0;
  int named = 0;  ///< colours that the target fixes somewhere: 1..named
  std::string order;

  struct Orbit {
    bool start = false;
    std::int64_t rank = 0;
    std::optional<std::vector<int>> allowed;  ///< none: any colour
  };
  std::vector<Orbit> orbits;
  std::map<Cell, std::uint32_t> number;  ///< of the target's cells
  std::vector<Cell> cells;
  std::vector<std::uint32_t> orbit_of;  ///< by cell
  std::vector<CellBits> below;          ///< by cell: itself and all that is there before it can be
  std::vector<Orientation> group;

  const Neighbourhood& neighbours() const { return neighbourhood(lattice); }
  std::optional<std::uint32_t> cell(Cell at) const;
  std::int64_t rank(std::uint32_t cell) const { return orbits[orbit_of[cell]].rank; }
  bool in_start(std::uint32_t cell) const { return orbits[orbit_of[cell]].start; }
  /// Neighbours of lower rank, as bits.
  std::uint32_t before(std::uint32_t cell) const;
  /// Is there a reachable structure without a brick at `site` that has just these of the
  /// site's neighbours? (The least with them has no others.)
  bool reachable(Cell site, std::uint32_t neighbours_there) const;
};

/// What is wrong with the text goes to `problem`.
std::optional<ColourProblem> read_colour_problem(std::string_view text, std::string& problem);

}  // namespace stig::certify
