// SPDX-License-Identifier: MIT
// Trace files (.stigt): a run as data, so that it can be replayed and compared.
//
// Layout, version 1: the 8 bytes "stigtrc1", then one zstd frame, checksum included,
// that holds
//   header    length-prefixed JSON (rule-set hash, seed, run, config, version) and
//             the rule set itself as canonical YAML, so a trace stands alone
//   events    per deposit a tag byte 1 and varints: zigzag site minus the site
//             before (x, y, z), colour, rule, orientation, agent + 1, step minus
//             the step before
//   hashes    tag byte 2 and 8 bytes after every kTraceHashEvery deposits: the sum
//             of placement_hash over the structure
//   end       tag byte 3, varints: steps, termination, and the final hash
// Integers are little-endian. Readers bound every length by what is left.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "lattice/swarm.h"
#include "lattice/uses.h"

namespace stig::lattice {

inline constexpr std::string_view kTraceMagic = "stigtrc1";
inline constexpr std::uint64_t kTraceHashEvery = 1024;

struct Trace {
  std::string rule_set_yaml;  ///< canonical print of the set that ran
  std::uint64_t rule_set_hash = 0;
  /// "swarm": made by run_swarm with `config`, replay re-runs it. "given": an order
  /// of events from elsewhere, replay checks that each event was open.
  std::string kind = "swarm";
  SwarmConfig config;
  std::vector<Deposit> events;
  std::vector<std::uint64_t> hashes;  ///< after deposits kTraceHashEvery, 2·kTraceHashEvery, …
  std::uint64_t steps = 0;
  Terminated terminated = Terminated::saturated;
  std::uint64_t final_hash = 0;
};

/// Streams a trace into memory, compressed as it goes.
class TraceWriter {
 public:
  TraceWriter(const RuleSet& rules, const SwarmConfig& config, const std::string& kind = "swarm");
  ~TraceWriter();
  void deposit(const Deposit& deposit);
  /// The whole file's bytes; the writer is done with.
  std::string finish(std::uint64_t steps, Terminated terminated);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Bytes of a trace file; anything malformed is a diagnostic.
std::optional<Trace> read_trace(const std::string& path, const std::string& bytes,
                                Diagnostics& diagnostics);

/// What is wrong with the events of a trace as deposits of these rules, whatever made them: "event
/// 3 is in a cell that has a brick"; nothing when each places a brick of the rules' in a free cell.
/// A trace is not trusted: its events may be none of the rules that it names.
std::optional<std::string> problem_of_events(const Trace& trace, const RuleSet& rules);

/// What replay found.
struct ReplayReport {
  bool identical = false;
  bool interrupted = false;    ///< by a stop, before any difference: then no verdict
  std::string difference;      ///< first difference in words; empty when identical
  std::uint64_t compared = 0;  ///< events compared
};
/// Replays a trace. It uses the hooks progress and stop.
ReplayReport replay(const Trace& trace, const RuleSet& rules, const SwarmHooks& hooks = {});

}  // namespace stig::lattice
