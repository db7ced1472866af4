// SPDX-License-Identifier: MIT
// JSON is printed by a writer of our own, since the library's either puts everything into one line
// or every number of a list into its own. Keys keep the order in which they were added: readers of
// diffs want that, and bytes are the same everywhere.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "report.h"
#include "rules/rule_printer.h"

namespace stig::cli {
namespace {

// Bytes that are no UTF-8 are replaced rather than refused: names come from files.
std::string in_one_line(const Json& json) {
  return json.dump(-1, ' ', false, nlohmann::detail::error_handler_t::replace);
}

/// Members a line each, except those of a list of plain values: "[20, 20, 20]".
void write(const Json& json, const std::string& line_start, std::string& out) {
  const bool nested = std::any_of(json.begin(), json.end(),
                                  [](const Json& member) { return member.is_structured(); });
  if (!json.is_structured() || json.empty()) {
    out += in_one_line(json);
    return;
  }
  // Lists of plain values stay in their line, as cells do.
  const bool spread = nested || json.is_object();
  const std::string inner = spread ? line_start + "  " : " ";
  out += json.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, member] : json.items()) {
    if (!first) out += ',';
    if (spread || !first) out += inner;
    if (json.is_object()) out += in_one_line(key) + ": ";
    write(member, inner, out);
    first = false;
  }
  if (spread) out += line_start;
  out += json.is_object() ? '}' : ']';
}

}  // namespace

std::string dump(const Json& json) {
  std::string out;
  write(json, "\n", out);
  return out + "\n";
}

Json to_json(Cell cell) { return Json::array({cell.x, cell.y, cell.z}); }
Json to_json(Offset offset) { return Json::array({offset.x, offset.y, offset.z}); }

Json to_json(const std::optional<Box>& box) {
  // null is unbounded space, not a box that is unknown.
  if (!box) return nullptr;
  return {{"origin", to_json(box->low)}, {"size", to_json(box->size)}, {"periodic", box->periodic}};
}

Json to_json(const Measures& measures) {
  Json json;
  json["bounds"] = nullptr;
  if (measures.bounds) {
    json["bounds"] = {{"low", to_json(measures.bounds->low)},
                      {"high", to_json(measures.bounds->high)},
                      {"size", to_json(measures.bounds->size())}};
  }
  json["components"] = measures.components;
  json["mean_neighbours"] = measures.mean_neighbours;
  json["symmetry_order"] = measures.symmetry_order;
  // null where they were not looked for: 0 would be a result.
  json["cavities"] = nullptr;
  json["cavity_cells"] = nullptr;
  if (measures.cavities_known) {
    json["cavities"] = measures.cavities;
    json["cavity_cells"] = measures.cavity_cells;
  }
  json["height_profile"] = measures.height_profile;
  return json;
}

Json colours_json(const Measures& measures, const std::vector<Brick>& bricks) {
  Json json = Json::object();
  for (std::size_t k = 0; k < bricks.size(); ++k) {
    const auto& counts = measures.bricks_by_colour;
    // Every colour of the set, so that all runs have the same keys.
    json[bricks[k].symbol] = k < counts.size() ? counts[k] : 0;
  }
  return json;
}

Json setting_json(const RuleSet& rules, const SwarmConfig& config) {
  Json json;
  json["ruleset"] = rules.name;
  json["ruleset_hash"] = to_hex(rule_set_hash(rules));
  json["seed"] = config.seed;
  json["box"] = to_json(config.box);
  json["motion"] = to_string(config.motion);
  // Event motion has no agents, whatever the config says.
  json["agents"] = config.motion == Motion::event ? 0 : config.agents;
  if (config.motion == Motion::walk) json["moves"] = config.moves;
  return json;
}

Json run_json(const RuleSet& rules, const SwarmConfig& config, const SwarmResult& result) {
  const Measures measures = measure(result.structure);
  Json json = setting_json(rules, config);
  json["run"] = config.run;
  // The names are those of docs/lattice-mode.md, and stay: others read them.
  json["steps"] = result.steps;
  json["deposits"] = result.deposits;
  json["bricks"] = result.structure.size();
  json["terminated"] = to_string(result.terminated);
  json["stage"] = result.stage;
  json["enabled_left"] = result.enabled_left;
  json["out_of_reach"] = result.out_of_reach;
  json["structure_hash"] = to_hex(structure_hash(result.structure));
  json["colours"] = colours_json(measures, rules.bricks);
  json["rules"] = Json::array();
  for (std::size_t r = 0; r < rules.rules.size(); ++r) {
    json["rules"].push_back({{"name", rules.rules[r].name}, {"fired", result.rules[r].fired}});
  }
  json["measures"] = to_json(measures);
  return json;
}

}  // namespace stig::cli
