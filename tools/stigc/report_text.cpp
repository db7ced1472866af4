// SPDX-License-Identifier: MIT
// For people: one line a figure, a label of twelve columns, and an end to every list. What programs
// want is in the JSON.
#include <fmt/format.h>

#include "app.h"
#include "base/hash.h"
#include "lattice/structure_text.h"
#include "report.h"
#include "rules/cell_text.h"

namespace stig::cli {
namespace {

/// A drawing of more lines or wider lines than this is no longer looked at. A drawing prints slices
/// one below the other, so lines are rows times levels.
constexpr std::int32_t kMostDrawnLines = 40;
constexpr std::int32_t kMostDrawnColumns = 38;
constexpr std::size_t kMostRulesShown = 40;
constexpr std::size_t kMostLevelsShown = 24;

std::string count(std::uint64_t number, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", number, number == 1 ? one : many);
}

std::string box_in_words(const std::optional<Box>& box) {
  if (!box) return "unbounded";
  // A solid side is a wall: agents turn back there.
  return fmt::format("{} from {}, {} sides", to_text(box->size), cell_text(box->low),
                     box->periodic ? "periodic" : "solid");
}

std::string motion_in_words(const SwarmConfig& config) {
  if (config.motion == Motion::event) return fmt::format("event, seed {}", config.seed);
  const std::string agents = count(static_cast<std::uint64_t>(config.agents), "agent", "agents");
  if (config.motion == Motion::teleport) {
    return fmt::format("teleport, {}, seed {}", agents, config.seed);
  }
  return fmt::format("walk, {}, {} moves, seed {}", agents, config.moves, config.seed);
}

std::string ended_in_words(const SwarmResult& result) {
  // A step is one of the swarm's, not of an agent.
  const std::string after = fmt::format("after {}", count(result.steps, "step", "steps"));
  if (result.terminated == Terminated::saturated) {
    return fmt::format("saturated {}: no rule fits anywhere", after);
  }
  // A run that was stopped, by a limit or by its user, leaves sites at which rules would have
  // fired.
  std::string text = fmt::format(
      "{} {}", result.terminated == Terminated::interrupted ? "interrupted" : "stopped", after);
  text += fmt::format(", {} left", count(result.enabled_left, "enabled site", "enabled sites"));
  if (result.out_of_reach > 0) text += fmt::format(", {} out of reach", result.out_of_reach);
  return text;
}

std::string bricks_in_words(const Measures& measures, const std::vector<Brick>& bricks) {
  std::string text;
  for (std::size_t k = 0; k < measures.bricks_by_colour.size(); ++k) {
    const std::uint64_t number = measures.bricks_by_colour[k];
    if (number == 0) continue;
    // Structure files may have colours without names.
    const std::string name = k < bricks.size() && !bricks[k].name.empty()
                                 ? printable(bricks[k].name)
                                 : fmt::format("brick {}", k + 1);
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", name, number);
  }
  return text;
}

std::string levels_in_words(const Measures& measures) {
  const auto& levels = measures.height_profile;
  const std::size_t shown = std::min(levels.size(), kMostLevelsShown);
  std::string text =
      fmt::format("{}", fmt::join(levels.begin(), levels.begin() + static_cast<long>(shown), " "));
  if (shown < levels.size()) text += fmt::format(" … ({} levels)", levels.size());
  return text + " from the lowest level up";
}

std::string rule_table(const RuleSet& rules, const SwarmResult& result, bool color) {
  std::string out = bold("rules fired", color) + "\n";
  // Rules that never fired are counted and not listed: of a large set they are most.
  std::size_t never = 0, shown = 0;
  for (std::size_t r = 0; r < rules.rules.size(); ++r) {
    const std::uint64_t fired = result.rules[r].fired;
    if (fired == 0) ++never;
    if (fired == 0 || ++shown > kMostRulesShown) continue;
    out += fmt::format("{:>9}  {}\n", fired, printable(rules.rules[r].name));
  }
  if (shown > kMostRulesShown) {
    out += fmt::format("{:>9}  and {} more rules\n", "…", shown - kMostRulesShown);
  }
  if (never > 0) out += fmt::format("{:>9}  {} never fired\n", "–", count(never, "rule", "rules"));
  return out;
}

}  // namespace

std::string to_text(Offset s) { return fmt::format("{}×{}×{}", s.x, s.y, s.z); }

std::string line(std::string_view label, std::string_view text) {
  return fmt::format("  {:<12}{}\n", label, text);
}

std::string structure_lines(const Structure& structure, const std::vector<Brick>& bricks) {
  // Measured once more for the words: measures are linear in the structure.
  const Measures m = measure(structure);
  if (structure.empty()) return line("bricks", "none");
  std::string out = line("colours", bricks_in_words(m, bricks));
  out +=
      line("size", fmt::format("{} from {}", to_text(m.bounds->size()), cell_text(m.bounds->low)));
  out += line("components", fmt::to_string(m.components));
  out += line("neighbours", fmt::format("{:.3f} per brick on average", m.mean_neighbours));
  out += line("symmetry", fmt::format("order {}", m.symmetry_order));
  if (!m.cavities_known) {
    out += line("cavities", "not looked for: the bounding box is too large");
  } else if (m.cavities == 0) {
    out += line("cavities", "none");
  } else {
    out += line("cavities", fmt::format("{}, of {} in all", m.cavities,
                                        count(m.cavity_cells, "cell", "cells")));
  }
  out += line("levels", levels_in_words(m));
  return out + line("hash", to_hex(structure_hash(structure)));
}

std::string setting_lines(const RuleSet& rules, const SwarmConfig& config, bool color) {
  const std::string title = rules.title.empty() ? "" : ": " + printable(rules.title);
  return bold(printable(rules.name), color) + title + "\n" +
         line("motion", motion_in_words(config)) + line("box", box_in_words(config.box));
}

std::string run_lines(const RuleSet& rules, const SwarmConfig& config, const SwarmResult& result,
                      bool color) {
  std::string out = setting_lines(rules, config, color);
  out += line("ended", ended_in_words(result));
  if (rules.stage_count() > 1) {
    out += line("stage", fmt::format("{} of {}", result.stage, rules.stage_count()));
  }
  out += line("bricks", fmt::format("{}: {} at the start, {} placed", result.structure.size(),
                                    rules.start.size(), result.deposits));
  out += structure_lines(result.structure, rules.bricks);
  return out + rule_table(rules, result, color);
}

std::string small_drawing(const Structure& structure, const std::vector<Brick>& bricks) {
  if (structure.empty()) return {};
  const Offset size = structure.bounds()->size();
  // In 64 bits: an unbounded structure may be long. Each slice has one line more than its rows,
  // which parts it from the next.
  const std::int64_t lines = (std::int64_t{size.y} + 1) * size.z;
  if (lines > kMostDrawnLines || size.x > kMostDrawnColumns) return {};
  return print_structure(structure, bricks);
}

}  // namespace stig::cli
