// SPDX-License-Identifier: MIT
#include "synthesis/reasons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace stig {
namespace {

using Kind = Impossible::Kind;

std::string at(Cell cell) { return fmt::format("({}, {}, {})", cell.x, cell.y, cell.z); }

/// Cells reached from the start by steps between neighbours.
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

std::optional<Impossible> start_problem(const Target& target, const Placing& placing) {
  for (const Cell c : placing.start) {
    if (index_in(target.cells, c) < 0) {
      return Impossible{
          Kind::bad_start, fmt::format("the start {} is not a cell of the target", at(c)), "", {}};
    }
  }
  if (placing.floor && target.cells.end() != std::find_if(target.cells.begin(), target.cells.end(),
                                                          [](Cell c) { return c.z < 0; })) {
    return Impossible{Kind::bad_start, "the target reaches below the floor (z = 0)", "", {}};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Impossible> find_obstacle(const Target& target, const Placing& placing) {
  if (auto problem = start_problem(target, placing)) return problem;
  const std::vector<bool> seen = reached(target, placing.start);
  const auto cut_off = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), false));
  if (cut_off > 0) {
    const auto first =
        static_cast<std::size_t>(std::find(seen.begin(), seen.end(), false) - seen.begin());
    return Impossible{
        Kind::not_connected,
        fmt::format("{} of {} cells, {} the first, are not connected to the start: no "
                    "rule can see from one part to the other",
                    cut_off, target.cells.size(), at(target.cells[first])),
        "",
        {}};
  }
  if (const auto asymmetry = find_asymmetry(target, placing)) {
    return Impossible{
        Kind::asymmetric,
        asymmetry->colours_differ
            ? fmt::format("the target is not symmetric about the start: {} and its image {} ({}) "
                          "have different colours",
                          at(asymmetry->cell), at(asymmetry->image), asymmetry->orientation)
            : fmt::format("the target is not symmetric about the start: it has {}, but not its "
                          "image {} ({})",
                          at(asymmetry->cell), at(asymmetry->image), asymmetry->orientation),
        "",
        {}};
  }
  return std::nullopt;
}

Impossible describe_look_alikes(const Schedule& schedule, const Clash& clash, const Target&) {
  const Frame& frame = *schedule.frame;
  const std::int32_t from = schedule.keys[static_cast<std::size_t>(clash.key)].site;
  const Site& q = frame.sites[static_cast<std::size_t>(from)];
  const Site& s = frame.sites[static_cast<std::size_t>(clash.site)];
  return {Kind::look_alike,
          fmt::format("where {} is to be placed it looks like {}, {}", at(q.at), at(s.at),
                      s.orbit < 0      ? "where nothing belongs"
                      : clash.intended ? "which has another colour"
                                       : "before its turn"),
          "",
          {}};
}

Impossible describe_few_colours(int allowed, int needed, std::size_t orders) {
  return {Kind::colours,
          fmt::format("{} {} not do for any of the {} orders tried; at least {} are needed",
                      allowed, allowed == 1 ? "colour does" : "colours do", orders, needed),
          "",
          {}};
}

}  // namespace stig
