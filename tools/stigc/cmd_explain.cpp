// SPDX-License-Identifier: MIT
// stigc explain: rule by rule, why it fires at a site or why not.
//
// The explanation itself is made in rules/explain.h, in terms of cells and conditions; here it
// becomes words or JSON.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "lattice/swarm.h"
#include "report.h"
#include "rules/cell_text.h"
#include "rules/explain.h"
#include "rules/rule_printer.h"
#include "rules/rule_table.h"
#include "structure_input.h"

namespace stig::cli {
namespace {

/// More disagreeing cells than this are counted, not listed; the drawing has them.
constexpr std::size_t kMostCells = 6;

/// What is explained, and where.
struct ExplainedSite {
  const RuleSet& rules;
  const Structure& structure;
  std::optional<Box> box;
  Cell site;
  Explanation explanation;

  // The orientation that fires, or the one that fails least.
  Orientation orientation(const RuleExplanation& said) const {
    const Rule& rule = rules.rules[said.rule];
    return orientations(rules.lattice, rules.symmetry_of(rule),
                        rules.inversion_of(rule))[said.orientation];
  }
};

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
  return said.orientations == 1 ? "" : " turned " + scene.orientation(said).name;
}

std::string rule_lines(const ExplainedSite& scene, const RuleExplanation& said, bool color) {
  const Rule& rule = scene.rules.rules[said.rule];
  if (said.fires) {
    return fmt::format("{} {}{} and places {}\n", title(scene, said), green("fires", color),
                       turn_in_words(scene, said),
                       printable(symbol_of(scene.rules, StateSet::of(rule.place))));
  }
  const Orientation orientation = scene.orientation(said);
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

void print_text(const ExplainedSite& scene, const ExplainOptions& options, App& app) {
  const Explanation& explanation = scene.explanation;
  app.print(fmt::format("{}, stage {}, sees\n",
                        bold("site " + cell_text(scene.site), app.color_out()), explanation.stage));
  app.print(indented(draw_view(scene.rules, explanation.view), "      "));
  const std::string problem = site_problem(scene);
  if (!problem.empty()) {
    app.print(fmt::format("{}: no rule can act, whatever is said below\n",
                          yellow(problem, app.color_out())));
  }
  const auto firing = std::count_if(explanation.rules.begin(), explanation.rules.end(),
                                    [](const RuleExplanation& said) { return said.fires; });
  app.print(fmt::format("{} of {} rules {}\n", firing, explanation.rules.size(),
                        firing == 1 ? "fires" : "fire"));
  for (const RuleExplanation& said : explanation.rules) {
    // The command line counts rules from 1, as files are read.
    if (options.rule && static_cast<std::uint32_t>(*options.rule) != said.rule + 1) continue;
    app.print("\n" + rule_lines(scene, said, app.color_out()));
  }
}

Json json_of_rule(const ExplainedSite& scene, const RuleExplanation& said) {
  const Rule& rule = scene.rules.rules[said.rule];
  Json json{{"rule", said.rule + 1},
            {"name", rule.name},
            {"place", rule.place == 0 ? "" : scene.rules.brick(rule.place).symbol},
            {"fires", said.fires},
            {"orientation", scene.orientation(said).name},
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

void print_json(const ExplainedSite& scene, const ExplainOptions& options, App& app) {
  Json json{{"ruleset", scene.rules.name},
            {"site", to_json(scene.site)},
            {"stage", scene.explanation.stage},
            {"problem", site_problem(scene)},
            {"rules", Json::array()}};
  for (const RuleExplanation& said : scene.explanation.rules) {
    if (options.rule && static_cast<std::uint32_t>(*options.rule) != said.rule + 1) continue;
    json["rules"].push_back(json_of_rule(scene, said));
  }
  app.print(dump(json));
}

/// The words of what is wrong with the numbers asked for, or empty.
std::string options_problem(const ExplainOptions& options, const RuleSet& rules) {
  if (options.stage > rules.stage_count()) {
    return fmt::format("there is no stage {}: the rule set has {}", options.stage,
                       rules.stage_count());
  }
  if (options.rule && static_cast<std::size_t>(*options.rule) > rules.rules.size()) {
    return fmt::format("there is no rule {}: the rule set has {}", *options.rule,
                       rules.rules.size());
  }
  return {};
}

}  // namespace

int run(const ExplainOptions& options, App& app) {
  const std::optional<RuleSet> rules = app.read_rules(options.file);
  if (!rules) return kFailed;
  const std::string problem = options_problem(options, *rules);
  if (!problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  Structure structure(rules->lattice, rules->start);
  if (options.structure) {
    auto read = read_structure_for(*rules, *options.structure, app);
    if (!read) return kFailed;
    structure = std::move(*read);
  }
  std::optional<Box> box;
  // The file's own box: sites beyond it look like walls.
  if (rules->box) box = lay_box(*rules->box, rules->start, rules->floor);
  const RuleTable table(*rules);
  const View view = view_at(structure, table, box, options.at);
  const ExplainedSite scene{*rules, structure, box, options.at,
                            explain(*rules, view, options.at.z, options.stage)};
  options.json ? print_json(scene, options, app) : print_text(scene, options, app);
  return kOk;
}

}  // namespace stig::cli
