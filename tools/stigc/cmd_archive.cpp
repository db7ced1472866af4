// SPDX-License-Identifier: MIT
// stigc archive: finds of a search as a table or as JSON, and one of them as a file of rules.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "commands.h"
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
  app.print(fmt::format("\n{:>10} {:>12} {:>8} {:>10} {:>8}  {:16}  {}\n", "id", "score", "bricks",
                        "rules used", "times", "structure", "origin"));
  for (const search::StoredFind& find : results.finds) {
    const std::string origin =
        find.parent ? fmt::format("{} from {}", find.origin, *find.parent) : find.origin;
    app.print(fmt::format("{:>10} {:>12.6g} {:>8} {:>9.0f}% {:>8}  {}  {}\n", find.id, find.score,
                          find.values[bricks], find.values[used] * 100, find.times,
                          to_hex(find.structure), printable(origin)));
  }
}

int pick(const ArchiveOptions& options, App& app) {
  std::string error;
  const auto find =
      search::read_find(options.results, static_cast<std::uint64_t>(*options.pick), error);
  if (!find) {
    app.complain(printable(error));
    return kFailed;
  }
  const std::string rules = print_rule_set(rule_set_of(find->genome));
  if (options.output) return write_output(*options.output, rules, app);
  app.print(rules);
  return kOk;
}

}  // namespace

int run(const ArchiveOptions& options, App& app) {
  if (options.output && !options.pick) {
    app.complain("-o is the file of rules that --pick takes out");
    return kUsage;
  }
  if (options.output) {
    // The results are no text that is read, and so not guarded by themselves.
    if (const int code = check_outputs({*options.output, options.results}, app); code != kOk) {
      return code;
    }
  }
  if (options.pick) return pick(options, app);
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
