// SPDX-License-Identifier: MIT
// Reads and checks the target and the order of a minimality proof (docs/proofs.md, "Fewest
// colours"), and computes which bricks must precede which. An order is given by ranks on
// orbits. A neighbour of lower rank always comes first, so the cells that must be there
// before a cell c are the transitive closure `below[c]`, and a structure is reachable under
// the order exactly if it is closed in this sense.
//
// The file is untrusted: whatever is wrong throws and ends as one sentence.
#include "certify/colour_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace stig::certify {
namespace {

using nlohmann::json;

/// The closures of all cells take a bit for each pair, so about 110 MB at most.
constexpr std::size_t kMostCells = 30'000;

[[noreturn]] void wrong(const std::string& what) { throw std::runtime_error(what); }

/// Names are compared with those that the rule language prints, so that the file and the
/// rule sets use the same words.
template <class Enum>
Enum one_of(const json& value, std::initializer_list<Enum> all) {
  for (const Enum each : all) {
    if (value.get<std::string>() == to_string(each)) return each;
  }
  wrong("an unknown lattice or symmetry");
}

Cell cell_from(const json& value) {
  if (value.size() != 3) wrong("a cell without three coordinates");
  std::array<std::int64_t, 3> c{};
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = value.at(i).get<std::int64_t>();
    // The bound keeps twice the coordinate, needed in check_orbits, within 32 bits.
    if (c[i] < -kMaxCoordinate || c[i] > kMaxCoordinate) wrong("a cell too far away");
  }
  return {static_cast<std::int32_t>(c[0]), static_cast<std::int32_t>(c[1]),
          static_cast<std::int32_t>(c[2])};
}

void read_orbit(const json& value, ColourProblem& out) {
  ColourProblem::Orbit orbit;
  orbit.start = value.at("start").get<bool>();
  orbit.rank = value.at("rank").get<std::int64_t>();
  // A cell whose colour the target fixes lists it (or the few it may have); colours that it
  // names are 1 to `named`, and the others can be renamed among each other.
  if (value.at("colours") != "any") {
    orbit.allowed = value.at("colours").get<std::vector<int>>();
    for (const int c : *orbit.allowed) {
      if (c < 1 || c > out.named) wrong("a cell with a colour that is not named");
    }
  }
  if (value.at("cells").empty()) wrong("an orbit without cells");
  for (const json& each : value.at("cells")) {
    const Cell cell = cell_from(each);
    if (out.floor && cell.z < 0) wrong("a cell below the floor");
    if (out.cells.size() >= kMostCells) wrong("more cells than are looked at");
    if (!out.number.emplace(cell, out.cells.size()).second) wrong("a cell that is there twice");
    out.cells.push_back(cell);
    out.orbit_of.push_back(static_cast<std::uint32_t>(out.orbits.size()));
  }
  out.orbits.push_back(orbit);
}

/// Orbits are those of the group about the middle of the start, no more and no less. Why
/// that matters: the colouring has one variable per orbit. If the file joined two orbits,
/// it would demand equal colours where rules could differ, and "fewer colours do not do"
/// would be said of a stronger demand than the real one. If it parted one, symmetric rules
/// could not tell its cells apart.
void check_orbits(const ColourProblem& out) {
  std::optional<Cell> low, high;
  for (std::uint32_t c = 0; c < out.cells.size(); ++c) {
    if (!out.in_start(c)) continue;
    const Cell at = out.cells[c];
    if (!low) low = high = at;
    low = Cell{std::min(low->x, at.x), std::min(low->y, at.y), 0};
    high = Cell{std::max(high->x, at.x), std::max(high->y, at.y), 0};
  }
  if (!low) wrong("no start");
  // Twice the middle is integral; the middle itself need not be, for a start with an even
  // side.
  const Offset twice_middle{low->x + high->x, low->y + high->y, 0};
  std::vector<std::uint32_t> reached(out.orbits.size(), 0);
  std::vector<bool> seen(out.cells.size(), false);
  for (std::uint32_t c = 0; c < out.cells.size(); ++c) {
    const Cell at = out.cells[c];
    // The orbit of its first cell is compared with the listed cells; the others need only
    // stay within, since a group maps an orbit onto itself.
    const bool first = c == 0 || out.orbit_of[c] != out.orbit_of[c - 1];
    for (const Orientation& g : out.group) {
      // Twice the way from the middle, turned.
      const Offset turned = g.apply({2 * at.x - twice_middle.x, 2 * at.y - twice_middle.y, at.z});
      const Offset twice{turned.x + twice_middle.x, turned.y + twice_middle.y, turned.z};
      // An odd image is no cell: the start's middle is not one about which this group maps
      // the lattice to itself (a quarter turn about the middle of a 1 x 2 start, for
      // instance).
      if (twice.x % 2 != 0 || twice.y % 2 != 0) wrong("a start whose middle the group has not");
      const auto image = out.cell({twice.x / 2, twice.y / 2, twice.z});
      if (!image || out.orbit_of[*image] != out.orbit_of[c]) {
        wrong("a cell whose image under the group is in another orbit");
      }
      if (first && !seen[*image]) {
        seen[*image] = true;
        ++reached[out.orbit_of[c]];
      }
    }
  }
  for (std::uint32_t c = 0; c < out.cells.size(); ++c) {
    if (!seen[c]) wrong("an orbit that is more than one");
  }
}

/// A cell with nothing before it would have to be placed beside no brick. It would refute
/// the order itself, and not the number of colours.
void check_before(const ColourProblem& out) {
  for (std::uint32_t c = 0; c < out.cells.size(); ++c) {
    if (!out.in_start(c) && out.before(c) == 0)
      wrong("a cell with nothing of lower rank beside it");
  }
}

/// By rising rank, so that what is below a cell is known before it. Cost: cells x
/// neighbours x cells / 64 word operations.
void close_below(ColourProblem& out) {
  std::vector<std::uint32_t> by_rank(out.cells.size());
  for (std::uint32_t c = 0; c < by_rank.size(); ++c) by_rank[c] = c;
  std::sort(by_rank.begin(), by_rank.end(),
            [&](std::uint32_t a, std::uint32_t b) { return out.rank(a) < out.rank(b); });
  const std::size_t words = (out.cells.size() + 63) / 64;
  CellBits start(words, 0);
  for (std::uint32_t c = 0; c < out.cells.size(); ++c) {
    if (out.in_start(c)) start[c / 64] |= std::uint64_t{1} << (c % 64);
  }
  out.below.assign(out.cells.size(), start);
  for (const std::uint32_t c : by_rank) {
    CellBits& below = out.below[c];
    below[c / 64] |= std::uint64_t{1} << (c % 64);
    // A neighbour of lower rank has its closure already, since ranks rise along `by_rank`.
    for (std::uint32_t rest = out.before(c); rest != 0; rest &= rest - 1) {
      const Offset step =
          out.neighbours().offsets[static_cast<std::size_t>(std::countr_zero(rest))];
      const CellBits& more = out.below[*out.cell(out.cells[c] + step)];
      for (std::size_t w = 0; w < words; ++w) below[w] |= more[w];
    }
  }
}

ColourProblem read(const json& value) {
  ColourProblem out;
  if (value.at("stigc_colouring") != 1) wrong("another version of the form");
  out.lattice = one_of(value.at("lattice"), {Lattice::cubic, Lattice::hexagonal});
  out.symmetry = one_of(value.at("symmetry"),
                        {Symmetry::none, Symmetry::rotations, Symmetry::rotations_mirrors});
  out.floor = value.at("floor").get<bool>();
  out.colours = value.at("colours").get<int>();
  out.named = value.at("named").get<int>();
  out.order = value.at("order").get<std::string>();
  // 62 is the number of colours that a rule set can have (rules/state.h).
  if (out.colours < 1 || out.colours > 62 || out.named < 0) wrong("a wrong number of colours");
  for (const json& orbit : value.at("orbits")) read_orbit(orbit, out);
  out.group = orientations(out.lattice, out.symmetry, false);
  check_orbits(out);
  check_before(out);
  close_below(out);
  return out;
}

}  // namespace

std::optional<std::uint32_t> ColourProblem::cell(Cell at) const {
  const auto found = number.find(at);
  if (found == number.end()) return std::nullopt;
  return found->second;
}

/// Cells of equal rank are not before each other: the order leaves open which comes first.
std::uint32_t ColourProblem::before(std::uint32_t of) const {
  assert(of < cells.size());
  std::uint32_t mask = 0;
  for (int i = 0; i < neighbours().size; ++i) {
    const auto beside = cell(cells[of] + neighbours().offsets[static_cast<std::size_t>(i)]);
    if (beside && !in_start(of) && rank(*beside) < rank(of)) mask |= std::uint32_t{1} << i;
  }
  return mask;
}

/// The least structure that contains the wanted neighbours is the union of their closures
/// with the start. Any reachable structure that has them contains it; so if this one has
/// the site itself or an unwanted neighbour, all have.
bool ColourProblem::reachable(Cell site, std::uint32_t neighbours_there) const {
  const std::size_t words = (cells.size() + 63) / 64;
  CellBits there(words, 0);
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    if (in_start(c)) there[c / 64] |= std::uint64_t{1} << (c % 64);
  }
  const auto beside = [&](int i) {
    return cell(site + neighbours().offsets[static_cast<std::size_t>(i)]);
  };
  for (std::uint32_t rest = neighbours_there; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    // The mask comes from the formula's comments and may name neighbours that the lattice
    // has not, or that are not of the target.
    if (i >= neighbours().size || !beside(i)) return false;
    const CellBits& more = below[*beside(i)];
    for (std::size_t w = 0; w < words; ++w) there[w] |= more[w];
  }
  const auto has = [&](std::uint32_t c) { return (there[c / 64] >> (c % 64) & 1U) != 0; };
  const auto own = cell(site);
  if (own && has(*own)) return false;
  for (int i = 0; i < neighbours().size; ++i) {
    const auto other = beside(i);
    const bool wanted = (neighbours_there >> i & 1U) != 0;
    if (other && has(*other) != wanted) return false;
  }
  return true;
}

/// Exceptions stop here: the rest of the checker reports by text, and json's own exceptions
/// carry a message with the place.
std::optional<ColourProblem> read_colour_problem(std::string_view text, std::string& problem) {
  try {
    return read(json::parse(text));
  } catch (const std::exception& error) {
    problem = fmt::format("the problem cannot be read: {}", error.what());
    return std::nullopt;
  }
}

}  // namespace stig::certify
