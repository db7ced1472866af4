// SPDX-License-Identifier: MIT
// The files that explore writes, of one run or of many.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app.h"
#include "lattice/swarm.h"
#include "lattice/trace.h"
#include "uses.h"

namespace stig::cli {

/// `deposits` is a .csv: the log of a run's deposits, of several runs their table. `records` is a
/// .jsonl: a JSON object for each of several runs.
enum class OutputKind : std::uint8_t { structure, deposits, records, trace };

struct Output {
  OutputKind kind = OutputKind::structure;
  std::string path;
  Palette palette = Palette::file;  ///< of a picture
};

/// Sorts paths into kinds by their endings (`trace` is one whatever its ending); returns
/// an exit code. `ensemble`: .csv is the table of runs, the other files need {run} in their names.
int plan_outputs(const std::vector<std::string>& paths, const std::optional<std::string>& trace,
                 bool ensemble, const App& app, std::vector<Output>& outputs);

/// `path` with {run} replaced.
std::string path_of_run(const std::string& path, std::uint32_t run);

/// The names that the files of these runs have, of ten thousand runs at most.
std::vector<std::string> names_of(const std::vector<Output>& outputs, int runs);

/// Collects what the outputs of one run need while it goes on, and writes them.
class OutputWriter {
 public:
  OutputWriter(const std::vector<Output>& outputs, const RuleSet& rules, const SwarmConfig& config);
  bool wants_deposits() const { return trace_ != nullptr || log_wanted_; }
  void deposit(const Deposit& deposit);
  /// Writes every file and says so; returns an exit code.
  int write(const SwarmResult& result, const App& app);

 private:
  bool write_one(const Output& output, const SwarmResult& result, std::string& error);

  const std::vector<Output>& outputs_;
  const RuleSet& rules_;
  const SwarmConfig& config_;
  std::unique_ptr<TraceWriter> trace_;
  std::string trace_bytes_;
  bool log_wanted_ = false;
  std::string log_;
  std::uint64_t deposits_ = 0;
};

}  // namespace stig::cli
