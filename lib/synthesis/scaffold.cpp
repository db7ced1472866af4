// SPDX-License-Identifier: MIT
#include "synthesis/scaffold.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace stig {
namespace {

/// Rows beside a run: the run moved to one side, or to two sides and across.
std::vector<std::vector<Offset>> rows_beside(const Neighbourhood& n) {
  std::vector<std::vector<Offset>> rows;
  std::vector<Offset> faces;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    if (n.is_face[i]) faces.push_back(n.offsets[i]);
  }
  for (const Offset a : faces) rows.push_back({a});
  for (const Offset a : faces) {
    for (const Offset b : faces) {
      const Offset across = (Cell{} + a + b) - Cell{};
      if (a < b && n.index_of(across) >= 0) rows.push_back({a, b, across});
    }
  }
  return rows;
}

/// The cells beside the run that the target lacks; empty when there are too many.
std::vector<Cell> cells_beside(const Target& target, const std::vector<Cell>& run,
                               const std::vector<Offset>& rows, std::size_t most, bool floor) {
  std::set<Cell> cells;
  for (const Cell c : run) {
    for (const Offset o : rows) {
      const Cell beside = c + o;
      if (floor && beside.z < 0) return {};
      if (index_in(target.cells, beside) < 0) cells.insert(beside);
    }
  }
  if (cells.size() > most) return {};
  return {cells.begin(), cells.end()};
}

/// A run as long as the target makes it, when the cells are in a row; otherwise themselves.
std::vector<Cell> lengthened(const Target& target, std::vector<Cell> run) {
  if (run.size() < 2) return run;
  const Offset step = run[1] - run[0];
  for (std::size_t i = 2; i < run.size(); ++i) {
    if (run[i] - run[i - 1] != step) return run;
  }
  while (index_in(target.cells, run.back() + step) >= 0) run.push_back(run.back() + step);
  while (index_in(target.cells, run.front() - step) >= 0) {
    run.insert(run.begin(), run.front() - step);
  }
  return run;
}

Target with(const Target& target, const std::vector<Cell>& cells) {
  Target out = target;
  out.cells.insert(out.cells.end(), cells.begin(), cells.end());
  std::sort(out.cells.begin(), out.cells.end());
  out.colours.clear();
  for (const Cell c : out.cells) {
    const int own = index_in(target.cells, c);
    out.colours.push_back(own < 0 ? StateSet::anything()
                                  : target.colours[static_cast<std::size_t>(own)]);
  }
  return out;
}

}  // namespace

std::vector<Cell> counting_cells(const Solution& solution, int named) {
  BadOrder bad;
  const auto schedule = make_schedule(*solution.frame, solution.order, bad);
  assert(schedule);
  const ColouringSearch search(*schedule, named);
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < solution.frame->cells.size(); ++i) {
    const int orbit = solution.frame->orbit_of[i];
    const bool counts =
        std::find(search.naming().begin(), search.naming().end(), orbit) != search.naming().end();
    if (counts || solution.frame->orbits[static_cast<std::size_t>(orbit)].start) {
      cells.push_back(solution.frame->cells[i]);
    }
  }
  return cells;
}

std::vector<Cell> longest_run(const Target& target) {
  const Neighbourhood& n = neighbourhood(target.lattice);
  std::vector<Cell> longest;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    if (!n.is_face[i]) continue;
    for (const Cell first : target.cells) {
      if (index_in(target.cells, first - n.offsets[i]) >= 0) continue;
      std::vector<Cell> run{first};
      while (index_in(target.cells, run.back() + n.offsets[i]) >= 0) {
        run.push_back(run.back() + n.offsets[i]);
      }
      if (run.size() > longest.size()) longest = std::move(run);
    }
  }
  return longest;
}

std::optional<Scaffold> find_scaffold(const Target& target, const std::vector<Cell>& run,
                                      std::size_t most, int colours,
                                      const SynthesisOptions& options, double effort,
                                      const SynthesisHooks& hooks) {
  std::vector<std::vector<Cell>> tries;
  for (const std::vector<Offset>& rows : rows_beside(neighbourhood(target.lattice))) {
    for (const std::vector<Cell>& of : {lengthened(target, run), run}) {
      std::vector<Cell> cells = cells_beside(target, of, rows, most, options.floor);
      const bool known = std::find(tries.begin(), tries.end(), cells) != tries.end();
      if (!cells.empty() && !known) tries.push_back(std::move(cells));
    }
  }
  std::optional<Scaffold> best;
  SynthesisOptions trying = options;
  trying.effort = effort / static_cast<double>(std::max<std::size_t>(1, tries.size()));
  for (const std::vector<Cell>& cells : tries) {
    if (hooks.deadline.passed()) break;
    trying.most_colours = best ? best->result.best->colour_count : colours - 1;
    if (trying.most_colours < 1) break;
    Scaffold scaffold{cells, with(target, cells), {}};
    scaffold.result = synthesise(scaffold.target, trying, hooks);
    if (!scaffold.result.best) continue;
    const auto size = [](const Scaffold& s) {
      return std::pair(s.result.best->colour_count, s.cells.size());
    };
    if (!best || size(scaffold) < size(*best)) best = std::move(scaffold);
  }
  return best;
}

}  // namespace stig
