// SPDX-License-Identifier: MIT
#include "validate/out_of_reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>

#include "compiler/open_work.h"
#include "rules/cell_text.h"
#include "validate/crew.h"
#include "validate/set_up.h"

namespace stig::validate {
namespace {

constexpr std::size_t kNamed = 4;  ///< bricks, in a sentence

/// The sides that a robot is bound to, or all.
std::vector<ApproachSide> sides_of(const RobotSpawn& robot, const CompiledRules& compiled) {
  const LuaValue* sides = param_of(robot, "sides");
  return sides == nullptr ? compiled.sides : sides_in(*sides).value_or(compiled.sides);
}

/// Those from which somebody still works, in the order of the compiled ones; nothing where some
/// robot may do anything.
std::optional<std::vector<ApproachSide>> sides_at_work(const CompiledRules& compiled,
                                                       const Scene& scene, const Trial& trial) {
  std::vector<ApproachSide> worked;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const RobotSpawn& robot = scene.robots[i];
    if (!is_builder(scene, robot)) return std::nullopt;
    const RobotRecord& record = trial.robots[i];
    if (record.halted || record.failed || record.left || record.fallen) continue;
    for (const ApproachSide side : sides_of(robot, compiled)) worked.push_back(side);
  }
  std::vector<ApproachSide> out;
  std::copy_if(compiled.sides.begin(), compiled.sides.end(), std::back_inserter(out),
               [&](ApproachSide side) {
                 return std::find(worked.begin(), worked.end(), side) != worked.end();
               });
  return out;
}

/// The bricks that stand, where the structure is right as far as it goes.
std::optional<BrickSet> right_so_far(const Judgement& judgement, const TargetStates& states) {
  if (judgement.against || !judgement.extra.empty()) return std::nullopt;
  BrickSet out(states.bricks());
  for (const BrickCheck& brick : judgement.bricks) {
    if (!brick.block) continue;
    if (!brick.coloured) return std::nullopt;
    out.add(states.brick_at(brick.cell));
  }
  return out;
}

std::string bricks_in_words(const std::vector<std::uint32_t>& bricks, const TargetStates& states) {
  std::vector<std::string> cells;
  for (const std::uint32_t brick : bricks) {
    if (cells.size() < kNamed) cells.push_back(cell_text(states.cell(brick)));
  }
  const std::size_t more = bricks.size() - cells.size();
  return fmt::format("{}{}", fmt::join(cells, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string sentence(const StructureReach& reach, const std::vector<ApproachSide>& sides,
                     const TargetStates& states) {
  if (sides.empty()) return "it cannot be completed: no robot is left that works";
  const std::string who = fmt::format(
      "robots that still run and keep to their sides work from {} alone", sides_text(sides));
  if (reach.never.empty()) {
    return fmt::format("it cannot be completed: {}, from where no order of work leads to the whole",
                       who);
  }
  return fmt::format("it cannot be completed: {}, from where no order of work puts a brick at {}",
                     who, bricks_in_words(reach.never, states));
}

/// Bricks without light on others: nobody takes a brick from where it stands above the floor, and
/// they will never show what the structure wants.
void of_dead_bricks(const Judgement& judgement, const std::string& of,
                    std::vector<std::string>& out) {
  for (const BrickCheck& brick : judgement.bricks) {
    if (!brick.block || brick.coloured || !brick.dead || brick.cell.z == 0) continue;
    out.push_back(
        fmt::format("{}it cannot be completed: all LEDs of the brick at {} are dead, and "
                    "robots take no brick off another",
                    of, cell_text(brick.cell)));
  }
}

}  // namespace

std::optional<StructureReach> reach_of(const CompiledRules& compiled, const BrickSet& standing,
                                       const std::vector<ApproachSide>& sides, std::size_t most) {
  assert(compiled.target != nullptr);
  const TargetStates& states = *compiled.target;
  const OpenWork open(compiled);
  std::set<BrickSet> seen{standing};
  std::vector<BrickSet> due{standing};
  BrickSet reached = standing;
  StructureReach out;
  while (!due.empty()) {
    const BrickSet state = std::move(due.back());
    due.pop_back();
    if (!open.knows(state)) return std::nullopt;
    reached.add(state);
    out.whole = out.whole || state.count() == states.bricks();
    for (const auto& [brick, side] : open.in(state, sides)) {
      BrickSet next = state;
      next.add(brick);
      if (seen.insert(next).second) due.push_back(std::move(next));
    }
    if (seen.size() > most) return std::nullopt;
  }
  for (std::uint32_t brick = 0; brick < states.bricks(); ++brick) {
    if (!reached.has(brick)) out.never.push_back(brick);
  }
  return out;
}

std::vector<std::string> out_of_reach(const BuildTarget& target, const CompiledRules& compiled,
                                      const Scene& scene, const Trial& trial) {
  assert(trial.robots.size() == scene.robots.size());
  std::vector<std::string> out;
  if (compiled.target == nullptr || compiled.decision == nullptr) return out;
  const auto sides = sides_at_work(compiled, scene, trial);
  if (!sides) return out;
  const auto of = [&target](std::size_t i) {
    return target.sites.size() > 1 ? fmt::format("structure {}: ", i + 1) : std::string();
  };
  for (std::size_t i = 0; i < trial.judgements.size(); ++i) {
    of_dead_bricks(trial.judgements[i], of(i), out);
  }
  // From all sides together the whole was proved to be reached.
  if (sides->size() == compiled.sides.size()) return out;
  for (std::size_t i = 0; i < trial.judgements.size(); ++i) {
    if (trial.judgements[i].missing() == 0) continue;
    const auto standing = right_so_far(trial.judgements[i], *compiled.target);
    if (!standing) continue;
    const auto reach = reach_of(compiled, *standing, *sides);
    if (!reach || reach->whole) continue;
    out.push_back(of(i) + sentence(*reach, *sides, *compiled.target));
  }
  return out;
}

}  // namespace stig::validate
