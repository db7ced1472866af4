// SPDX-License-Identifier: MIT
// Says and draws why a target cannot be built. Obstacles that hold for every order (a start
// outside the target, separate parts, a missing symmetry) are proved; look-alike sites and
// too few colours are said of the orders that were tried, unless all were.
#include "synthesis/reasons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

#include "rules/cell_text.h"

namespace stig::synthesis {
namespace {

using Kind = Obstacle::Kind;

/// Cells reached from the start by steps between neighbours, corners included, since a rule
/// can continue from whatever it sees.
std::vector<bool> reached(const Target& target, const std::vector<Cell>& start) {
  const Neighbourhood& n = neighbourhood(target.lattice);
  std::vector<bool> seen(target.cells.size(), false);
  std::vector<Cell> queue = start;
  for (const Cell c : start) seen[static_cast<std::size_t>(index_in(target.cells, c))] = true;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (int i = 0; i < n.size; ++i) {
      const Cell beside = queue[next] + n.offsets[static_cast<std::size_t>(i)];
      const int cell = index_in(target.cells, beside);
      if (cell < 0 || seen[static_cast<std::size_t>(cell)]) continue;
      seen[static_cast<std::size_t>(cell)] = true;
      queue.push_back(beside);
    }
  }
  return seen;
}

std::optional<Obstacle> start_problem(const Target& target, const Placing& placing) {
  for (const Cell c : placing.start) {
    if (index_in(target.cells, c) < 0) {
      return Obstacle{Kind::bad_start,
                      true,
                      fmt::format("the start {} is not a cell of the target", cell_text(c)),
                      "",
                      {}};
    }
  }
  if (placing.floor && target.cells.end() != std::find_if(target.cells.begin(), target.cells.end(),
                                                          [](Cell c) { return c.z < 0; })) {
    return Obstacle{Kind::bad_start, true, "the target reaches below the floor (z = 0)", "", {}};
  }
  return std::nullopt;
}

std::string asymmetry_text(const Asymmetry& asymmetry) {
  const std::string cell = cell_text(asymmetry.cell);
  if (!asymmetry.image) {
    return fmt::format("the image of {} ({}) lies between cells, as the start's middle does", cell,
                       asymmetry.orientation);
  }
  const std::string image = cell_text(*asymmetry.image);
  if (asymmetry.colours_differ) {
    return fmt::format("{} and its image {} ({}) have different colours", cell, image,
                       asymmetry.orientation);
  }
  return fmt::format("it has {}, but not its image {} ({})", cell, image, asymmetry.orientation);
}

}  // namespace

/// Order matters: later checks presuppose a start that lies in the target.
std::optional<Obstacle> find_obstacle(const Target& target, const Placing& placing) {
  if (auto problem = start_problem(target, placing)) return problem;
  const std::vector<bool> seen = reached(target, placing.start);
  const auto cut_off = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), false));
  if (cut_off > 0) {
    const auto first =
        static_cast<std::size_t>(std::find(seen.begin(), seen.end(), false) - seen.begin());
    return Obstacle{Kind::not_connected,
                    true,
                    fmt::format("{} of {} cells, {} the first, are not connected to the start: no "
                                "rule can see from one part to the other",
                                cut_off, target.cells.size(), cell_text(target.cells[first])),
                    "",
                    {}};
  }
  if (const auto asymmetry = find_asymmetry(target, placing)) {
    return Obstacle{Kind::asymmetric,
                    true,
                    "the target is not symmetric about the start: " + asymmetry_text(*asymmetry),
                    "",
                    {}};
  }
  return std::nullopt;
}

/// Greedy: a cell of each part that is still cut off, so the parts decide how many starts
/// there are.
std::vector<Cell> one_of_each_part(const Target& target, const std::vector<Cell>& start) {
  assert(!target.cells.empty());
  std::vector<Cell> starts = start.empty() ? std::vector<Cell>{target.cells.front()} : start;
  while (true) {
    const std::vector<bool> seen = reached(target, starts);
    const auto next = std::find(seen.begin(), seen.end(), false);
    if (next == seen.end()) return starts;
    starts.push_back(target.cells[static_cast<std::size_t>(next - seen.begin())]);
  }
}

namespace {

/// What a site shows, laid out like the drawings of rule files: the slices above, level and
/// below side by side, rows from the back; a given colour by its symbol, any other brick as #.
std::string draw_site(const Frame& frame, const Site& site, std::uint32_t mask,
                      const std::vector<Brick>& bricks) {
  const Neighbourhood& n = frame.neighbours();
  const auto symbol = [&](Offset o) -> std::string {
    const int i = n.index_of(o);
    if (i < 0) return o == Offset{} ? "*" : " ";
    if ((mask >> i) & 1U) {
      const auto orbit = static_cast<std::size_t>(site.beside[static_cast<std::size_t>(i)]);
      const StateSet colours = frame.orbits[orbit].colours;
      return colours.is_single() ? bricks[colours.first() - 1U].symbol : "#";
    }
    return site.on_floor && o.z < 0 ? "=" : ".";
  };
  std::string out;
  for (int y = 1; y >= -1; --y) {
    out += "   ";
    for (int z = 1; z >= -1; --z) {
      for (int x = -1; x <= 1; ++x) out += " " + symbol({x, y, z});
      out += "  ";
    }
    out.erase(out.find_last_not_of(' ') + 1);
    out += '\n';
  }
  return out;
}

/// Cells of a clique that form a straight run have the most instructive reason: a run has
/// to count.
bool in_a_row(const std::vector<Cell>& cells) {
  if (cells.size() < 3) return false;
  const Offset step = cells[1] - cells[0];
  for (std::size_t i = 2; i < cells.size(); ++i) {
    if (cells[i] - cells[i - 1] != step) return false;
  }
  return true;
}

std::string list(const std::vector<Cell>& cells) {
  std::string out;
  for (std::size_t i = 0; i < std::min<std::size_t>(cells.size(), 12); ++i) {
    out += (i == 0 ? "" : ", ") + cell_text(cells[i]);
  }
  return cells.size() > 12 ? out + ", …" : out;
}

std::string what_belongs(const Clash& clash, const Site& site) {
  if (site.orbit < 0) return "where nothing belongs";
  return clash.intended ? "which has another colour" : "before its turn";
}

std::string draw_pair(const Schedule& schedule, const Clash& clash,
                      const std::vector<Brick>& bricks) {
  const Frame& frame = *schedule.frame;
  const Key& key = schedule.keys[static_cast<std::size_t>(clash.key)];
  const Site& q = frame.sites[static_cast<std::size_t>(key.site)];
  const Site& s = frame.sites[static_cast<std::size_t>(clash.site)];
  return fmt::format("  {}, to be placed:\n{}  {}, {}:\n{}", cell_text(q.at),
                     draw_site(frame, q, key.mask, bricks), cell_text(s.at), what_belongs(clash, s),
                     draw_site(frame, s, clash.mask, bricks));
}

}  // namespace

Obstacle describe_look_alikes(const Schedule& schedule, const Clash& clash, const Target& target) {
  const Frame& frame = *schedule.frame;
  const std::int32_t from = schedule.keys[static_cast<std::size_t>(clash.key)].site;
  const Site& q = frame.sites[static_cast<std::size_t>(from)];
  const Site& s = frame.sites[static_cast<std::size_t>(clash.site)];
  return {Kind::look_alike,
          false,
          fmt::format("where {} is to be placed it looks like {}, {}", cell_text(q.at),
                      cell_text(s.at), what_belongs(clash, s)),
          draw_pair(schedule, clash, target.bricks),
          {}};
}

/// The reason is sought where it is shortest: a clique that is too large, else an
/// irreducible set of clashes that cannot all be avoided.
Obstacle describe_few_colours(const Schedule& schedule, int named, int allowed, int needed,
                              const Allowance& allowance) {
  assert(allowed < needed);
  Obstacle out{Kind::colours,
               false,
               fmt::format("{} {} not do; at least {} are needed", allowed,
                           allowed == 1 ? "colour does" : "colours do", needed),
               "",
               {}};
  ColouringSearch search(schedule, named);
  allowance.spend(search.cost());
  std::vector<Cell> differ;
  for (const int orbit : search.naming()) {
    differ.push_back(schedule.frame->orbits[static_cast<std::size_t>(orbit)].at);
  }
  std::sort(differ.begin(), differ.end());
  if (static_cast<int>(differ.size()) > allowed) {
    out.drawing =
        fmt::format("  {}: {}\n",
                    in_a_row(differ) ? "a straight run has to count, so all of these must differ"
                                     : "all of these must differ in colour",
                    list(differ));
    return out;
  }
  const std::vector<Clash> core = unsatisfiable_core(search, named, allowed, allowance);
  if (core.empty()) return out;
  out.drawing =
      fmt::format("  {} pairs of sites that look alike cannot all be told apart:\n", core.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(core.size(), 3); ++i) {
    out.drawing += draw_pair(schedule, core[i], {});
  }
  return out;
}

}  // namespace stig::synthesis
