// SPDX-License-Identifier: MIT
// The files that explore writes. Their names are looked at before a run starts, so
// that a slip does not cost the run; each is written whole or not at all.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app.h"
#include "lattice/swarm.h"
#include "lattice/trace.h"

namespace stig {

enum class OutputKind : std::uint8_t { structure, deposits, trace };

struct Output {
  OutputKind kind = OutputKind::structure;
  std::string path;
};

/// Sorts paths into kinds by their endings (`trace` is one whatever its ending); returns
/// an exit code, kOk when every file can be written as far as can be told beforehand.
/// `ensemble`: .csv is the table of runs, the other files need {run} in their names.
int plan_outputs(const std::vector<std::string>& paths, const std::optional<std::string>& trace,
                 bool ensemble, const App& app, std::vector<Output>& outputs);

/// Is the folder there and may it be written to? The words of what is wrong, or empty.
std::string folder_problem(const std::string& path);

/// Would one of these be written over another, or over what is read? Paths that are not given
/// are left out; links are followed. The words of what is wrong, or empty.
std::string same_file_problem(const std::vector<std::optional<std::string>>& written,
                              const std::vector<std::optional<std::string>>& read);

/// `path` with {run} replaced.
std::string path_of_run(const std::string& path, std::uint32_t run);

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

/// Writes a structure with its picture titled; false with `error` set.
bool write_structure(const std::string& path, const Structure& structure,
                     const std::vector<Brick>& bricks, const std::string& title, bool floor,
                     std::string& error);

}  // namespace stig
