// SPDX-License-Identifier: MIT
// A journal's lines are the records that .jsonl tables have; .csv tables are made of them. Tables
// are streamed from the journal, which may be larger than memory.
#include "run_journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/file_io.h"
#include "base/hash.h"
#include "rules/rule_printer.h"

namespace stig::cli {
namespace {

/// One that was asked for; null: none.
Json limit_json(const std::optional<std::uint64_t>& limit) {
  return limit ? Json(*limit) : Json(nullptr);
}

/// In one line, whatever names the rule set has.
std::string in_a_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// What has to be the same for a journal to be gone on with. Not the number of runs: more may be
/// asked for.
std::string work_of(const RuleSet& rules, const SwarmConfig& config) {
  Json setting = setting_json(rules, config);
  setting["max_steps"] = limit_json(config.max_steps);
  setting["max_deposits"] = limit_json(config.max_deposits);
  setting["agents_at"] = Json::array();
  for (const Cell cell : config.agents_at) setting["agents_at"].push_back(to_json(cell));
  return fmt::format("stigc {} explore, {}", STIG_VERSION, to_hex(hash_text(in_a_line(setting))));
}

constexpr const char* kColumns[] = {"run",
                                    "seed",
                                    "steps",
                                    "deposits",
                                    "bricks",
                                    "terminated",
                                    "enabled_left",
                                    "out_of_reach",
                                    "measures.components",
                                    "measures.mean_neighbours",
                                    "measures.symmetry_order",
                                    "measures.cavities",
                                    "measures.cavity_cells",
                                    "structure_hash",
                                    "ruleset_hash"};

/// "measures.cavities" is in the object "measures".
const Json& value_at(const Json& record, std::string_view name) {
  const auto dot = name.find('.');
  if (dot == name.npos) return record.at(name);
  return record.at(name.substr(0, dot)).at(name.substr(dot + 1));
}

std::string csv_line(const Json& record) {
  std::string out;
  for (const char* column : kColumns) {
    const Json& value = value_at(record, column);
    // Texts here are words and hashes, which need no quotes; what was not looked for is empty.
    const std::string text = value.is_null()     ? ""
                             : value.is_string() ? value.get<std::string>()
                                                 : value.dump();
    out += (out.empty() ? "" : ",") + text;
  }
  return out + "\n";
}

std::string csv_head() {
  std::string out;
  for (const std::string_view column : kColumns) {
    out += out.empty() ? "" : ",";
    out += column.substr(column.find('.') == column.npos ? 0 : column.find('.') + 1);
  }
  return out + "\n";
}

}  // namespace

Json run_record(const RuleSet& rules, const SwarmConfig& config, const SwarmResult& result) {
  Json record{{"stigc", STIG_VERSION},
              {"max_steps", limit_json(config.max_steps)},
              {"max_deposits", limit_json(config.max_deposits)}};
  record.update(run_json(rules, config, result));
  return record;
}

Json run_of_record(Json record) {
  for (const char* key : {"stigc", "max_steps", "max_deposits"}) record.erase(key);
  return record;
}

std::vector<Output> tables_of(const std::vector<Output>& outputs) {
  std::vector<Output> tables;
  std::copy_if(outputs.begin(), outputs.end(), std::back_inserter(tables), [](const Output& one) {
    return one.kind == OutputKind::deposits || one.kind == OutputKind::records;
  });
  return tables;
}

std::string journal_name(const std::vector<Output>& tables) {
  return tables.front().path + ".journal";
}

bool RunJournal::open(const std::vector<Output>& tables, const RuleSet& rules,
                      const SwarmConfig& config, int runs,
                      const std::function<void(const Json& record)>& add, const App& app) {
  int done = 0;
  FileError error;
  const auto take = [&](std::string_view line) {
    const Json record = Json::parse(line, nullptr, false);
    if (!record.is_object() || record.value("run", -1) != done) return false;
    // Those beyond what is asked for now stay in the journal.
    if (++done <= runs) add(record);
    return true;
  };
  if (!journal_.open(journal_name(tables), work_of(rules, config), take, error)) {
    app.complain(error.message);
    return false;
  }
  if (done > 0) {
    app.say(fmt::format("going on after {} runs, by {}", std::min(done, runs),
                        printable(journal_name(tables))));
  }
  return true;
}

bool RunJournal::append(const std::vector<Json>& records, const App& app) {
  if (records.empty()) return true;
  std::string lines;
  for (const Json& record : records) lines += (lines.empty() ? "" : "\n") + in_a_line(record);
  FileError error;
  if (journal_.append(lines, error)) return true;
  app.complain(error.message);
  return false;
}

int RunJournal::write_tables(const std::vector<Output>& tables, int runs, bool all_done,
                             const App& app) {
  int code = kOk;
  for (const Output& table : tables) {
    const bool csv = table.kind == OutputKind::deposits;
    GrowingFile file;
    FileError error;
    bool good = file.open(table.path, error);
    if (good && csv) good = file.append(csv_head(), error);
    int left = runs;
    const auto add = [&](std::string_view line) {
      if (!good || left-- <= 0) return false;
      good = file.append(csv ? csv_line(Json::parse(line)) : std::string(line) + "\n", error);
      return good;
    };
    good = good && journal_.read(add, error) && good && file.commit(error);
    if (good) {
      app.say("wrote " + printable(table.path));
    } else {
      app.complain(error.message);
      code = kRunFailed;
    }
  }
  if (code == kOk && all_done) {
    journal_.remove();
  } else {
    app.say(fmt::format("what is done stands in {}; the same command goes on",
                        printable(journal_name(tables))));
  }
  return code;
}

}  // namespace stig::cli
