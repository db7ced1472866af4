// SPDX-License-Identifier: MIT
// A target seen from its start: orbits of cells under the group, and the sites at
// which rules can ever be asked, one of each orbit.
//
// The group turns about the vertical through the middle of the start, so start and
// rules share it; then every structure that the rules build in all orders alike has
// it too, and a target without it cannot be built (find_asymmetry).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rules/symmetry.h"
#include "synthesis/target.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// An empty place beside the target, or one of its cells, with the orbits around it.
struct Site {
  Cell at;
  int orbit = -1;  ///< of the target's cell here; -1: outside
  bool on_floor = false;
  std::array<std::int32_t, kMaxNeighbours> beside{};  ///< orbits; -1: not of the target
  std::uint32_t present = 0;                          ///< neighbours of the target, a bit each
};

struct Orbit {
  Cell at;  ///< its first cell
  int cells = 0;
  bool start = false;
  StateSet colours;
};

struct Frame {
  Lattice lattice = Lattice::cubic;
  Symmetry symmetry = Symmetry::none;
  bool floor = false;
  std::vector<Orientation> group;
  std::vector<Cell> cells;    ///< of the target, sorted
  std::vector<int> orbit_of;  ///< beside `cells`
  std::vector<Orbit> orbits;
  std::vector<Site> sites;  ///< site i is the first cell of orbit i; then those outside

  const Neighbourhood& neighbours() const { return neighbourhood(lattice); }
};

struct Placing {
  std::vector<Cell> start;  ///< cells of the target; not empty
  Symmetry symmetry = Symmetry::none;
  bool floor = false;  ///< cells below z = 0 look like floor; the target stands above
};

/// A cell whose image under the group is not of the target, or of another colour.
struct Asymmetry {
  Cell cell;
  std::optional<Cell> image;  ///< nothing: it lies between cells, as the start's middle does
  std::string orientation;
  bool colours_differ = false;
};
/// Nothing when the target has the symmetry about the start's middle.
std::optional<Asymmetry> find_asymmetry(const Target& target, const Placing& placing);

/// The target must have the symmetry and the start must be mapped to itself (asserted).
Frame make_frame(const Target& target, const Placing& placing);

/// Index of a cell in a sorted list, or -1.
int index_in(const std::vector<Cell>& cells, Cell cell);

}  // namespace stig::synthesis
