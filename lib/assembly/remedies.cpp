// SPDX-License-Identifier: MIT
#include "assembly/remedies.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/precedence.h"
#include "rules/cell_text.h"
#include "sensing/led_code.h"

namespace stig::assembly {

namespace {

constexpr std::size_t kMostRemedies = 3;
/// How many bricks more and less are tried, one at a time; in targets of more bricks none.
constexpr std::size_t kMostChanges = 16, kMostBricksOfChange = 150;
/// Each attempt is a small assembly of its own: what can be mended easily is found with little.
constexpr double kShareOfEffort = 0.05;

class Healer {
 public:
  Healer(const AssemblyTask& task, const Assembly& made, double effort, const AssemblyHooks& hooks)
      : task_(task), effort_(effort * kShareOfEffort), deadline_(hooks.deadline) {
    for (std::size_t i = 0; i < task.target.cells.size(); ++i) {
      cells_.insert(task.target.cells[i]);
      const bool left = made.obstacle && made.obstacle->kind == AssemblyObstacle::Kind::remainder &&
                        made.obstacle->remainder.bricks.has(i);
      if (left) concerned_.push_back(task.target.cells[i]);
    }
    if (made.obstacle) {
      for (const FreeRun& run : made.obstacle->runs) {
        concerned_.insert(concerned_.end(), run.rbegin(), run.rend());
      }
    }
    if (concerned_.empty()) concerned_ = task.target.cells;
  }

  std::vector<AssemblyRemedy> find(const std::vector<OtherRobot>& others) {
    ask_for_less();
    for (const OtherRobot& other : others) {
      AssemblyTask changed = task_;
      changed.robot = other.abilities;
      attempt(changed, fmt::format("with {}", other.name));
    }
    if (task_.target.cells.size() <= kMostBricksOfChange) {
      take_bricks_away();
      add_bricks();
    }
    return std::move(out_);
  }

 private:
  bool attempt(const AssemblyTask& changed, const std::string& what) {
    if (out_.size() >= kMostRemedies || deadline_.passed()) return false;
    AssemblyHooks hooks;
    hooks.deadline = deadline_;
    const Assembly made = assemble(changed, effort_, hooks);
    if (made.plan) out_.push_back({what, made.plan->any_number});
    return made.plan.has_value();
  }

  /// Only what the user asked for beyond the target is taken back, one wish at a time: an answer
  /// then says which of them it was.
  void ask_for_less() {
    AssemblyTask changed = task_;
    changed.sides.clear();
    if (!task_.sides.empty()) attempt(changed, "from other sides");
    changed = task_;
    changed.start.reset();
    if (task_.start) attempt(changed, "from another start");
    changed = task_;
    changed.robots = 1;
    if (task_.robots.value_or(1) > 1) attempt(changed, "by one robot alone");
    changed = task_;
    const bool wished = !task_.target.bricks.empty() || task_.most_colours < task_.kinds;
    const char* needed = "with colours as they are needed";
    changed.most_colours = task_.kinds;
    changed.target.bricks.clear();
    changed.target.colours.assign(task_.target.cells.size(), StateSet::anything());
    if (wished && attempt(changed, needed)) return;
    // Code words on the LEDs, as many as survive one that is misread.
    changed.kinds = sensing::code_size(kBlockColours + 1);
    changed.most_colours = changed.kinds;
    if (task_.kinds >= changed.kinds) return;
    const std::string more = fmt::format("--kinds {}", changed.kinds);
    attempt(changed, wished ? fmt::format("{} and {}", needed, more) : "with " + more);
  }

  /// Cells of a target are sorted, and colours are listed beside them.
  AssemblyTask with_cells(const std::set<Cell>& cells) const {
    AssemblyTask out = task_;
    out.target.cells.assign(cells.begin(), cells.end());
    out.target.colours.clear();
    for (const Cell cell : out.target.cells) {
      const auto at = std::lower_bound(task_.target.cells.begin(), task_.target.cells.end(), cell);
      const bool there = at != task_.target.cells.end() && *at == cell;
      out.target.colours.push_back(
          there ? task_.target.colours[static_cast<std::size_t>(at - task_.target.cells.begin())]
                : StateSet::anything());
    }
    return out;
  }

  /// The highest first: nothing lies on them.
  void take_bricks_away() {
    std::vector<Cell> some = concerned_;
    std::erase_if(some, [&](Cell c) { return cells_.contains(c + Offset{0, 0, 1}); });
    if (task_.start) std::erase(some, *task_.start);
    // Stable, so that cells of a level stay in the order that they had, on every machine.
    std::stable_sort(some.begin(), some.end(), [](Cell a, Cell b) { return a.z > b.z; });
    some.resize(std::min(some.size(), kMostChanges));
    for (const Cell cell : some) {
      std::set<Cell> cells = cells_;
      cells.erase(cell);
      if (cells.size() < 2) return;
      if (attempt(with_cells(cells), "without the brick at " + cell_text(cell))) {
        return;
      }
    }
  }

  /// Beside what is left, on the floor or on a brick.
  void add_bricks() {
    std::set<Cell> known;
    for (const Cell c : concerned_) {
      // Beside or on top, never below: a brick below the target would have to be put first.
      for (const Offset step : {Offset{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}) {
        const Cell cell = c + step;
        const bool held = cell.z == 0 || cells_.contains(cell + Offset{0, 0, -1});
        if (!held || cells_.contains(cell) || known.size() >= kMostChanges) continue;
        if (!known.insert(cell).second) continue;
        std::set<Cell> cells = cells_;
        cells.insert(cell);
        if (attempt(with_cells(cells), "with a brick more at " + cell_text(cell))) {
          return;
        }
      }
    }
  }

  const AssemblyTask& task_;
  double effort_;
  Deadline deadline_;
  std::set<Cell> cells_;
  std::vector<Cell> concerned_;  ///< of the remainder, or all
  std::vector<AssemblyRemedy> out_;
};

}  // namespace

std::vector<AssemblyRemedy> find_remedies(const AssemblyTask& task, const Assembly& made,
                                          const std::vector<OtherRobot>& others, double effort,
                                          const AssemblyHooks& hooks) {
  if (task.target.cells.size() > kMostOrderedBricks) return {};  // no rules would be looked for
  return Healer(task, made, effort, hooks).find(others);
}

}  // namespace stig::assembly
