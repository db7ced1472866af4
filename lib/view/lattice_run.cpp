// SPDX-License-Identifier: MIT
// Columns instead of a list of events: numbers of one kind lie together, so that their differences
// are small. Names and texts come from files that anybody may have written: all go through
// printable().
#include "view/lattice_run.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "base/text.h"
#include "lattice/rgb.h"

namespace stig::view {

namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::int64_t>;

/// Bricks and events by column, as the page wants them.
struct LatticeColumns {
  Numbers x, y, z, colour, rule, agent, step;

  void brick(Cell cell, Colour what) {
    x.push_back(cell.x);
    y.push_back(cell.y);
    z.push_back(cell.z);
    colour.push_back(what);
  }
  void event(const Deposit& deposit) {
    brick(deposit.site, deposit.colour);
    rule.push_back(deposit.match.rule);
    agent.push_back(deposit.agent);
    step.push_back(static_cast<std::int64_t>(deposit.step));
  }
  Json json(PageColumns& columns) const {
    return {{"x", columns.add(x)},       {"y", columns.add(y)},
            {"z", columns.add(z)},       {"colour", columns.add(colour)},
            {"rule", columns.add(rule)}, {"agent", columns.add(agent)},
            {"step", columns.add(step)}};
  }
};

// A structure file may use colours that it has no names for; they get what symbol_of and rgb_of
// give to such.
/// Kinds of bricks up to the highest colour there is.
Json kinds_json(const std::vector<Brick>& bricks, const Numbers& colours) {
  std::int64_t most = static_cast<std::int64_t>(bricks.size());
  for (const std::int64_t colour : colours) most = std::max(most, colour);
  Json out = Json::array();
  for (std::int64_t k = 1; k <= most; ++k) {
    const auto colour = static_cast<Colour>(k);
    const bool known = static_cast<std::size_t>(k) <= bricks.size();
    out.push_back({{"symbol", printable(symbol_of(bricks, colour))},
                   {"name", known ? printable(bricks[static_cast<std::size_t>(k - 1)].name) : ""},
                   {"color", to_color(rgb_of(bricks, colour))}});
  }
  return out;
}

Json rules_json(const RuleSet& rules) {
  Json out = Json::array();
  for (const Rule& rule : rules.rules) {
    // A range ends behind its last character, which may be the first of the next line.
    const std::size_t last = rule.range.end > rule.range.begin ? rule.range.end - 1 : 0;
    out.push_back({{"name", printable(rule.name)},
                   {"place", rule.place},
                   {"first", rules.file->position(rule.range.begin).line},
                   {"last", rules.file->position(last).line}});
  }
  return out;
}

/// The text with every line safe to be looked at.
// Line by line, as printable() would take line ends for control characters.
std::string source_text(const SourceFile& file) {
  std::string out;
  for (std::size_t i = 1; i <= file.line_count(); ++i) {
    out += printable(file.line(i)) + (i < file.line_count() ? "\n" : "");
  }
  return out;
}

Json facts_json(const Trace& trace, const RuleSet& rules) {
  const SwarmConfig& config = trace.config;
  Json out = Json::array();
  const auto add = [&](const char* name, const std::string& value) {
    out.push_back({name, value});
  };
  add("rules", printable(rules.name));
  if (trace.kind == "swarm") {
    add("motion", std::string(to_string(config.motion)));
    if (config.motion != Motion::event) add("agents", std::to_string(config.agents));
    add("seed", std::to_string(config.seed));
  } else {
    add("order", "given");
  }
  if (config.box) {
    const Offset size = config.box->size;
    add("box", fmt::format("{}×{}×{}{}", size.x, size.y, size.z,
                           config.box->periodic ? ", periodic" : ""));
  }
  add("bricks", fmt::format("{} at the start, {} placed", rules.start.size(), trace.events.size()));
  add("ended", fmt::format("{}, {} steps", to_string(trace.terminated), trace.steps));
  add("hash", to_hex(trace.final_hash));
  return out;
}

/// A structure as a run that is all start; `placed`: does its file say where it stands?
Json structure_json(const LoadedStructure& loaded, const std::string& name, PageColumns& into) {
  LatticeColumns columns;
  const std::vector<PlacedBrick> bricks = loaded.structure.bricks();
  for (const PlacedBrick& brick : bricks) columns.brick(brick.at, brick.brick);
  return {{"kind", "lattice"},
          {"name", printable(name)},
          {"title", printable(name)},
          {"lattice", to_string(loaded.structure.lattice())},
          {"floor", false},
          {"facts", Json::array({{"bricks", std::to_string(bricks.size())},
                                 {"hash", to_hex(structure_hash(loaded.structure))}})},
          {"bricks", kinds_json(loaded.bricks, columns.colour)},
          {"rules", Json::array()},
          {"source", ""},
          {"start", bricks.size()},
          {"placed", loaded.placed},
          {"columns", columns.json(into)}};
}

}  // namespace

// The start's bricks come first in the columns of bricks, `start` says how many; rule, agent and
// step are those of events alone.
std::optional<std::string> add_lattice_run(const Trace& trace, const RuleSet& rules,
                                           const std::string& name, PageContent& page) {
  if (const auto problem = problem_of_events(trace, rules)) return problem;
  LatticeColumns columns;
  for (const PlacedBrick& brick : rules.start) columns.brick(brick.at, brick.brick);
  for (const Deposit& event : trace.events) columns.event(event);
  page.add({{"kind", "lattice"},
            {"name", printable(name)},
            {"title", printable(rules.title.empty() ? rules.name : rules.title)},
            {"lattice", to_string(rules.lattice)},
            {"floor", rules.floor},
            {"facts", facts_json(trace, rules)},
            {"bricks", kinds_json(rules.bricks, columns.colour)},
            {"rules", rules_json(rules)},
            {"source", source_text(*rules.file)},
            {"start", rules.start.size()},
            {"columns", columns.json(page.columns())}});
  return std::nullopt;
}

void add_structure(const LoadedStructure& loaded, const std::string& name, PageContent& page) {
  page.add(structure_json(loaded, name, page.columns()));
}

void add_marked_structure(const RuleSet& rules, const std::vector<PlacedBrick>& bricks,
                          const std::string& name, const std::vector<SceneMark>& marks,
                          const std::vector<std::string>& why, PageContent& page) {
  const LoadedStructure loaded{Structure(rules.lattice, bricks), rules.bricks};
  Json json = structure_json(loaded, name, page.columns());
  json["title"] = printable(rules.title.empty() ? rules.name : rules.title);
  json["floor"] = rules.floor;
  json["marks"] = Json::array();
  for (const SceneMark& mark : marks) {
    json["marks"].push_back({{"at", {mark.at.x, mark.at.y, mark.at.z}},
                             {"way", mark.in_the_way},
                             {"text", printable(mark.text)}});
  }
  json["why"] = Json::array();
  for (const std::string& line : why) json["why"].push_back(printable(line));
  page.add(std::move(json));
}

void set_target(const LoadedStructure& loaded, const std::string& name, PageContent& page) {
  page.set_target(structure_json(loaded, name, page.columns()));
}

}  // namespace stig::view
