// SPDX-License-Identifier: MIT
// stigc archive: finds of a search as a table or as JSON, and one of them as a file of rules.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "archive_pictures.h"
#include "base/hash.h"
#include "commands.h"
#include "lattice/structure_files.h"
#include "outputs.h"
#include "report.h"
#include "rules/rule_printer.h"
#include "search/objectives.h"
#include "search/result_file.h"

namespace stig::cli {
namespace {

Json find_json(const search::StoredFind& find) {
  Json json;
  json["id"] = find.id;
  json["origin"] = find.origin;
  json["parents"] = Json::array();
  if (find.parent) json["parents"].push_back(*find.parent);
  if (find.other_parent) json["parents"].push_back(*find.other_parent);
  json["score"] = find.score;
  json["structure"] = to_hex(find.structure);
  json["times"] = find.times;
  for (std::size_t k = 0; k < find.values.size(); ++k) {
    json["objectives"][std::string(search::objectives()[k].name)] = find.values[k];
  }
  return json;
}

void print_json(const search::StoredResults& results, App& app) {
  Json json;
  json["name"] = results.name;
  json["plan"] = to_hex(results.plan);
  json["evaluated"] = results.evaluated;
  json["structures"] = results.structures;
  json["individuals"] = results.kept;
  json["content_hash"] = to_hex(results.content);
  json["finds"] = Json::array();
  for (const search::StoredFind& find : results.finds) json["finds"].push_back(find_json(find));
  app.print(dump(json));
}

void print_table(const search::StoredResults& results, App& app) {
  app.print(bold(printable(results.name), app.color_out()) + "\n");
  app.print(line("evaluated", std::to_string(results.evaluated)));
  app.print(line("structures", std::to_string(results.structures)));
  app.print(line("content", to_hex(results.content)));
  const std::size_t bricks = *search::objective_number("bricks");
  const std::size_t used = *search::objective_number("rules_used");
  const std::size_t robots = *search::objective_number("robots");
  const std::size_t refusal = *search::objective_number("refusal");
  app.print(fmt::format("\n{:>10} {:>12} {:>8} {:>10} {:>6} {:>7} {:>8}  {:16}  {}\n", "id",
                        "score", "bricks", "rules used", "robots", "refusal", "times", "structure",
                        "origin"));
  for (const search::StoredFind& find : results.finds) {
    const std::string origin =
        find.parent ? fmt::format("{} from {}", find.origin, *find.parent) : find.origin;
    // The code that `stigc codes` explains.
    const double code = find.values[refusal];
    const std::string refused = code > 0 ? fmt::format("P{:.0f}", code) : "-";
    app.print(fmt::format("{:>10} {:>12.6g} {:>8} {:>9.0f}% {:>6} {:>7} {:>8}  {}  {}\n", find.id,
                          find.score, find.values[bricks], find.values[used] * 100,
                          find.values[robots], refused, find.times, to_hex(find.structure),
                          printable(origin)));
  }
}

/// What an individual built, in a structure's file or as a picture.
int write_built(const ArchiveOptions& options, const search::StoredFind& find, const App& app) {
  std::string error;
  const auto bricks = search::read_bricks(options.results, find.structure, error);
  if (!bricks) {
    app.complain(printable(error));
    return kFailed;
  }
  const RuleSet rules = rule_set_of(find.genome);
  const std::string title = fmt::format("{}", find.id);
  if (write_structure(*options.output, Structure(find.genome.lattice, *bricks), rules.bricks, title,
                      find.genome.floor, error, Palette::okabe_ito)) {
    app.say("wrote " + printable(*options.output));
    return kOk;
  }
  app.complain(printable(error));
  return kRunFailed;
}

int pick(const ArchiveOptions& options, App& app) {
  std::string error;
  const auto find =
      search::read_find(options.results, static_cast<std::uint64_t>(*options.pick), error);
  if (!find) {
    app.complain(printable(error));
    return kFailed;
  }
  std::string unknown;
  if (options.output && can_write_structure(*options.output, unknown)) {
    return write_built(options, *find, app);
  }
  const std::string rules = print_rule_set(rule_set_of(find->genome));
  if (options.output) return write_output(*options.output, rules, app);
  app.print(rules);
  return kOk;
}

/// An exit code: what is asked for goes together, and no results are written over.
int check_use(const ArchiveOptions& options, const App& app) {
  const int asked = (options.pick ? 1 : 0) + (options.plot ? 1 : 0) + (options.gallery ? 1 : 0);
  std::string problem;
  if (asked > 1) problem = "one of --pick, --plot and --gallery at a time";
  if (options.plot && !options.output) problem = "--plot needs -o: the .svg that it writes";
  if (options.output && !options.pick && !options.plot) {
    problem = "-o is the file of rules that --pick takes out, or the figure of --plot";
  }
  if (!options.beside.empty() && !options.plot && !options.gallery) {
    problem = "--beside is for --plot and --gallery";
  }
  if (!problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  // Results are no text that is read, and so not guarded by themselves.
  std::vector<std::string> files;
  if (options.output) files.push_back(*options.output);
  if (options.gallery) files.push_back(*options.gallery);
  if (files.empty()) return kOk;
  files.push_back(options.results);
  files.insert(files.end(), options.beside.begin(), options.beside.end());
  return check_outputs(files, app);
}

}  // namespace

int run(const ArchiveOptions& options, App& app) {
  if (const int code = check_use(options, app); code != kOk) return code;
  if (options.pick) return pick(options, app);
  if (options.plot) return write_plot(options, app);
  if (options.gallery) return write_gallery(options, app);
  std::string error;
  const auto results =
      search::read_results(options.results, static_cast<std::size_t>(options.top), error);
  if (!results) {
    app.complain(printable(error));
    return kFailed;
  }
  options.json ? print_json(*results, app) : print_table(*results, app);
  return kOk;
}

}  // namespace stig::cli
