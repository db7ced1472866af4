// SPDX-License-Identifier: MIT
// What of an ensemble is done, run by run, so that the same command goes on after a kill; and the
// tables that are made of it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app.h"
#include "base/journal.h"
#include "explore_outputs.h"
#include "report.h"
#include "uses.h"

namespace stig::cli {

/// A run for a table: what --json prints of it, after the program's version and the limits in
/// force.
Json run_record(const RuleSet& rules, const SwarmConfig& config, const SwarmResult& result);
/// What --json prints of the run.
Json run_of_record(Json record);

/// The outputs that are tables of all runs.
std::vector<Output> tables_of(const std::vector<Output>& outputs);
/// The journal's name: that of the first table and .journal.
std::string journal_name(const std::vector<Output>& tables);

class RunJournal {
 public:
  /// Takes over what an earlier such command has done, `add` with each record in the order of runs;
  /// false with a complaint.
  bool open(const std::vector<Output>& tables, const RuleSet& rules, const SwarmConfig& config,
            int runs, const std::function<void(const Json& record)>& add, const App& app);
  bool is_open() const { return journal_.is_open(); }
  /// Puts records on the disk; false with a complaint.
  bool append(const std::vector<Json>& records, const App& app);
  /// Writes the tables of the first `runs` runs, and takes the journal away where all are done; an
  /// exit code.
  int write_tables(const std::vector<Output>& tables, int runs, bool all_done, const App& app);

 private:
  Journal journal_;
};

}  // namespace stig::cli
