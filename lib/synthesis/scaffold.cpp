// SPDX-License-Identifier: MIT
// Extra cells that let a straight run count in digits or by height (docs/synthesis.md,
// "Orders, and counting"). Candidates are rows moved to one or two sides of the run, and a
// zigzag wall on a level run; each is tried as a target of its own.
#include "synthesis/scaffold.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace stig::synthesis {
namespace {

/// The step from one cell of a straight run to the next; nothing when it is none.
std::optional<Offset> step_of(const std::vector<Cell>& run) {
  if (run.size() < 2) return std::nullopt;
  const Offset step = run[1] - run[0];
  for (std::size_t i = 2; i < run.size(); ++i) {
    if (run[i] - run[i - 1] != step) return std::nullopt;
  }
  return step;
}

/// Rows beside a run: the run moved to one side, or to two sides and across. Moved along
/// itself it would only be longer. Two sides come with the row across, so that the run
/// becomes two by two.
std::vector<std::vector<Offset>> rows_beside(const Neighbourhood& n, std::optional<Offset> step) {
  std::vector<std::vector<Offset>> rows;
  std::vector<Offset> faces;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    const Offset o = n.offsets[i];
    const bool along = step && (o == *step || Cell{} + o + *step == Cell{});
    if (n.is_face[i] && !along) faces.push_back(o);
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
/// The clique may be a part of the run only; a scaffold along all of it leaves no end
/// without digits.
std::vector<Cell> lengthened(const Target& target, std::vector<Cell> run) {
  const std::optional<Offset> step = step_of(run);
  if (!step) return run;
  while (index_in(target.cells, run.back() + *step) >= 0) run.push_back(run.back() + *step);
  while (index_in(target.cells, run.front() - *step) >= 0) {
    run.insert(run.begin(), run.front() - *step);
  }
  return run;
}

/// A wall on a level run whose top rises and falls by one cell a step, up to `high`. The
/// height of the top identifies the position within a slope, so slopes need one colour
/// each.
std::vector<Cell> wall_on(const Target& target, const std::vector<Cell>& run, std::int32_t high) {
  assert(high >= 1);
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const auto phase = static_cast<std::int32_t>(i % (2 * static_cast<std::size_t>(high)));
    for (std::int32_t z = 1; z <= std::min(phase, 2 * high - phase); ++z) {
      const Cell cell = run[i] + Offset{0, 0, z};
      if (index_in(target.cells, cell) < 0) cells.push_back(cell);
    }
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// The highest such wall of at most `most` cells: the higher, the fewer slopes there are to be
/// told apart. None where rules do not ask for heights, or on a run that is not level.
std::vector<Cell> highest_wall(const Target& target, const std::vector<Cell>& run, std::size_t most,
                               const SynthesisOptions& options) {
  std::vector<Cell> highest;
  const std::optional<Offset> step = step_of(run);
  if (!step || step->z != 0 || !options.heights || options.symmetry != Symmetry::none) return {};
  for (std::int32_t high = 1; high <= static_cast<std::int32_t>((run.size() + 1) / 2); ++high) {
    std::vector<Cell> cells = wall_on(target, run, high);
    if (cells.size() > most) break;
    highest = std::move(cells);
  }
  return highest;
}

/// The scaffolds to be tried, the most promising first.
std::vector<std::vector<Cell>> scaffolds(const Target& target, const std::vector<Cell>& run,
                                         std::size_t most, const SynthesisOptions& options) {
  std::vector<std::vector<Cell>> tries;
  const auto add = [&](std::vector<Cell> cells) {
    const bool known = std::find(tries.begin(), tries.end(), cells) != tries.end();
    if (!cells.empty() && !known) tries.push_back(std::move(cells));
  };
  const std::vector<Cell> whole = lengthened(target, run);
  add(highest_wall(target, whole, most, options));
  for (const std::vector<Offset>& rows : rows_beside(neighbourhood(target.lattice), step_of(run))) {
    for (const std::vector<Cell>& of : {whole, run}) {
      add(cells_beside(target, of, rows, most, options.floor));
    }
  }
  return tries;
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
  const std::vector<std::vector<Cell>> tries = scaffolds(target, run, most, options);
  std::optional<Scaffold> best;
  SynthesisOptions trying = options;
  double left = effort;
  for (std::size_t i = 0; i < tries.size() && !hooks.deadline.passed(); ++i) {
    const std::vector<Cell>& cells = tries[i];
    // Half of what is left, until one is found that does; then each as much as the others.
    trying.effort = left / (best ? static_cast<double>(tries.size() - i) : 2);
    left -= trying.effort;
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

}  // namespace stig::synthesis
