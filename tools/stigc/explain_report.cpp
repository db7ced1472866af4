// SPDX-License-Identifier: MIT
#include "explain_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app.h"
#include "rules/cell_text.h"
#include "rules/rule_printer.h"
#include "rules/rule_table.h"

namespace stig::cli {
namespace {

/// More disagreeing cells than this are counted, not listed; the drawing has them.
constexpr std::size_t kMostCells = 6;

// The orientation that fires, or the one that fails least.
Orientation orientation_of(const ExplainedSite& scene, const RuleExplanation& said) {
  const Rule& rule = scene.rules.rules[said.rule];
  return orientations(scene.rules.lattice, scene.rules.symmetry_of(rule),
                      scene.rules.inversion_of(rule))[said.orientation];
}

/// Why no brick can be placed in the site whatever the rules say; or empty. Rules are explained all
/// the same: why a rule would fire is a fair question of a full site.
std::string site_problem(const ExplainedSite& scene) {
  if (scene.rules.floor && scene.site.z < 0) return "the site is below the floor";
  if (scene.box && !scene.box->contains(scene.site)) return "the site is outside the box";
  const State state = scene.structure.at(scene.site);
  if (state == kEmpty) return {};
  return fmt::format("brick {} stands here already",
                     printable(symbol_of(scene.rules, StateSet::of(state))));
}

// Line by line, as drawings have no indentation of their own.
std::string indented(std::string_view drawing, std::string_view indent) {
  std::string out;
  while (!drawing.empty()) {
    const std::size_t end = std::min(drawing.find('\n'), drawing.size());
    out += fmt::format("{}{}\n", indent, drawing.substr(0, end));
    drawing.remove_prefix(std::min(end + 1, drawing.size()));
  }
  return out;
}

std::string condition_in_words(const ExplainedSite& scene, const Rule& rule,
                               const FailedCondition& failed) {
  // Bounds as people say them: a number, a range, or one side of it.
  std::string bounds;
  if (failed.min && failed.max && *failed.min == *failed.max) {
    bounds = fmt::to_string(*failed.min);
  } else if (failed.min && failed.max) {
    bounds = fmt::format("{} to {}", *failed.min, *failed.max);
  } else {
    bounds = failed.min ? fmt::format("at least {}", *failed.min)
                        : fmt::format("at most {}", *failed.max);
  }
  if (failed.key == "stage") {
    return fmt::format("its stage is {}, this is stage {}", bounds, failed.seen);
  }
  if (failed.key != "count") {
    return fmt::format("wants {} {}, the site is at {}", failed.key, bounds, failed.seen);
  }
  const CountCondition& count = rule.counts[failed.index];
  return fmt::format("wants {} neighbours{} of {}, sees {}", bounds,
                     count.faces_only ? " at its faces" : "",
                     printable(symbol_of(scene.rules, count.of)), failed.seen);
}

std::string cell_in_words(const ExplainedSite& scene, const FailedCell& cell) {
  return fmt::format("at {} wants {}, sees {}", cell_text(scene.site + cell.offset),
                     printable(symbol_of(scene.rules, cell.wanted)),
                     printable(symbol_of(scene.rules, StateSet::of(cell.seen))));
}

std::string title(const ExplainedSite& scene, const RuleExplanation& said) {
  const Rule& rule = scene.rules.rules[said.rule];
  // A generated rule has no place in a file.
  std::string place;
  if (rule.range)
    place = fmt::format(" (line {})", rule.range.file->position(rule.range.begin).line);
  return fmt::format("rule {} '{}'{}", said.rule + 1, printable(rule.name), place);
}

/// " turned 90°", or nothing when the rule has but one orientation.
std::string turn_in_words(const ExplainedSite& scene, const RuleExplanation& said) {
  return said.orientations == 1 ? "" : " turned " + orientation_of(scene, said).name;
}

std::string rule_lines(const ExplainedSite& scene, const RuleExplanation& said, bool color) {
  const Rule& rule = scene.rules.rules[said.rule];
  if (said.fires) {
    return fmt::format("{} {}{} and places {}\n", title(scene, said), green("fires", color),
                       turn_in_words(scene, said),
                       printable(symbol_of(scene.rules, StateSet::of(rule.place))));
  }
  const Orientation orientation = orientation_of(scene, said);
  std::string out = fmt::format("{} {}", title(scene, said), red("does not fire", color));
  if (said.orientations > 1) out += fmt::format("; nearest{}", turn_in_words(scene, said));
  out += "\n";
  // Conditions first: they are few, and hold in every orientation.
  for (const FailedCondition& failed : said.conditions) {
    out += fmt::format("  {}\n", condition_in_words(scene, rule, failed));
  }
  for (std::size_t i = 0; i < std::min(said.cells.size(), kMostCells); ++i) {
    out += fmt::format("  {}\n", cell_in_words(scene, said.cells[i]));
  }
  if (said.cells.size() > kMostCells) {
    out += fmt::format("  and {} more cells disagree\n", said.cells.size() - kMostCells);
  }
  // The pattern as turned, so that it can be laid over the view above.
  const int size = neighbourhood(scene.rules.lattice).size;
  const Pattern pattern = oriented(rule.pattern, orientation, size);
  return out + dim(indented(draw_pattern(scene.rules, pattern), "      "), color);
}

Json json_of_rule(const ExplainedSite& scene, const RuleExplanation& said) {
  const Rule& rule = scene.rules.rules[said.rule];
  Json json{{"rule", said.rule + 1},
            {"name", rule.name},
            {"place", rule.place == 0 ? "" : scene.rules.brick(rule.place).symbol},
            {"fires", said.fires},
            {"orientation", orientation_of(scene, said).name},
            {"cells", Json::array()},
            {"conditions", Json::array()}};
  for (const FailedCell& cell : said.cells) {
    json["cells"].push_back({{"offset", to_json(cell.offset)},
                             {"wanted", symbol_of(scene.rules, cell.wanted)},
                             {"seen", symbol_of(scene.rules, StateSet::of(cell.seen))}});
  }
  for (const FailedCondition& failed : said.conditions) {
    Json condition{{"kind", failed.key},
                   {"seen", failed.seen},
                   {"text", condition_in_words(scene, rule, failed)}};
    condition["min"] = failed.min ? Json(*failed.min) : Json(nullptr);
    condition["max"] = failed.max ? Json(*failed.max) : Json(nullptr);
    json["conditions"].push_back(condition);
  }
  return json;
}

}  // namespace

ExplainedSite explained_site(const RuleSet& rules, const Structure& structure, Cell site,
                             int stage) {
  std::optional<Box> box;
  if (rules.box) box = lay_box(*rules.box, rules.start, rules.floor);
  const View view = view_at(structure, RuleTable(rules), box, site);
  return {rules, structure, box, site, explain(rules, view, site.z, stage)};
}

std::string explain_text(const ExplainedSite& scene, std::optional<int> rule, bool color) {
  const Explanation& explanation = scene.explanation;
  std::string out = fmt::format("{}, stage {}, sees\n",
                                bold("site " + cell_text(scene.site), color), explanation.stage);
  out += indented(draw_view(scene.rules, explanation.view), "      ");
  const std::string problem = site_problem(scene);
  if (!problem.empty()) {
    out += fmt::format("{}: no rule can act, whatever is said below\n", yellow(problem, color));
  }
  const auto firing = std::count_if(explanation.rules.begin(), explanation.rules.end(),
                                    [](const RuleExplanation& said) { return said.fires; });
  out += fmt::format("{} of {} rules {}\n", firing, explanation.rules.size(),
                     firing == 1 ? "fires" : "fire");
  for (const RuleExplanation& said : explanation.rules) {
    // The command line counts rules from 1, as files are read.
    if (rule && static_cast<std::uint32_t>(*rule) != said.rule + 1) continue;
    out += "\n" + rule_lines(scene, said, color);
  }
  return out;
}

Json explain_json(const ExplainedSite& scene, std::optional<int> rule) {
  Json json{{"ruleset", scene.rules.name},
            {"site", to_json(scene.site)},
            {"stage", scene.explanation.stage},
            {"problem", site_problem(scene)},
            {"rules", Json::array()}};
  for (const RuleExplanation& said : scene.explanation.rules) {
    if (rule && static_cast<std::uint32_t>(*rule) != said.rule + 1) continue;
    json["rules"].push_back(json_of_rule(scene, said));
  }
  return json;
}

}  // namespace stig::cli
