// SPDX-License-Identifier: MIT
// Runs go in batches, so that memory holds a batch of structures at a time; results come in the
// order of runs whatever thread they ran in, and so all that is printed is the same for any number
// of threads.
#include "ensemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/file_io.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "progress.h"
#include "report.h"
#include "run_journal.h"

namespace stig::cli {
namespace {

void count_run(const RunSummary& run, Ensemble& ensemble) {
  ensemble.runs.push_back(run);
  // An interrupted run's structure is not one that the rules end in.
  if (run.terminated != Terminated::interrupted) ++ensemble.structures[run.hash];
}

void add_json(const Json& run, Ensemble& ensemble) {
  if (!ensemble.runs_json.empty()) ensemble.runs_json += ",\n";
  ensemble.runs_json += dump(run);
  // The line end of a text file; a comma follows.
  ensemble.runs_json.pop_back();
}

/// Takes over one finished run.
void add_run(const RuleSet& rules, const SwarmConfig& config, const SwarmResult& result,
             const ExploreOptions& options, Ensemble& ensemble) {
  count_run(
      {result.steps, result.deposits, result.structure.size(), structure_hash(result.structure),
       result.enabled_left, result.out_of_reach, result.terminated},
      ensemble);
  for (std::size_t r = 0; r < ensemble.fired.size(); ++r) {
    ensemble.fired[r] += result.rules[r].fired;
  }
  if (options.json) add_json(run_json(rules, config, result), ensemble);
}

Terminated terminated_of(const std::string& word) {
  for (const Terminated way : {Terminated::saturated, Terminated::steps, Terminated::deposits}) {
    if (word == to_string(way)) return way;
  }
  return Terminated::interrupted;
}

/// Takes over one that an earlier command has done.
void add_record(const Json& record, const ExploreOptions& options, Ensemble& ensemble) {
  const auto count = [&](const char* key) { return record.at(key).get<std::uint64_t>(); };
  count_run({count("steps"), count("deposits"), count("bricks"),
             std::stoull(record.at("structure_hash").get<std::string>(), nullptr, 16),
             count("enabled_left"), count("out_of_reach"),
             terminated_of(record.at("terminated").get<std::string>())},
            ensemble);
  for (std::size_t r = 0; r < ensemble.fired.size(); ++r) {
    ensemble.fired[r] += record.at("rules").at(r).at("fired").get<std::uint64_t>();
  }
  if (options.json) add_json(run_of_record(record), ensemble);
}

// The table is of all runs, and traces are refused before.
std::vector<Output> of_each_run(const std::vector<Output>& outputs) {
  std::vector<Output> kept;
  std::copy_if(outputs.begin(), outputs.end(), std::back_inserter(kept),
               [](const Output& output) { return output.kind == OutputKind::structure; });
  return kept;
}

/// The runs that were not interrupted: what is left of the others is no sample.
std::vector<RunSummary> finished(const std::vector<RunSummary>& runs) {
  std::vector<RunSummary> kept;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(kept),
               [](const RunSummary& run) { return run.terminated != Terminated::interrupted; });
  return kept;
}

struct Range {
  std::uint64_t least = 0, most = 0;
  double mean = 0;
};

/// The range of a value over at least one run.
template <class Value>
Range range_of(const std::vector<RunSummary>& runs, const Value& value) {
  Range range{value(runs.front()), value(runs.front()), 0};
  for (const RunSummary& run : runs) {
    range.least = std::min(range.least, value(run));
    range.most = std::max(range.most, value(run));
    range.mean += static_cast<double>(value(run)) / static_cast<double>(runs.size());
  }
  return range;
}

std::string range_in_words(const Range& range) {
  if (range.least == range.most) return fmt::format("{} in every run", range.least);
  return fmt::format("{} to {}, {:.1f} on average", range.least, range.most, range.mean);
}

std::string endings_in_words(const std::vector<RunSummary>& runs) {
  std::string text;
  for (const Terminated way :
       {Terminated::saturated, Terminated::steps, Terminated::deposits, Terminated::interrupted}) {
    const auto number = std::count_if(runs.begin(), runs.end(),
                                      [&](const RunSummary& run) { return run.terminated == way; });
    if (number > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, to_string(way));
  }
  return text;
}

std::string structure_table(const Ensemble& ensemble) {
  constexpr std::size_t kMostShown = 12;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> rows;  // runs, hash
  for (const auto& [hash, runs] : ensemble.structures) rows.emplace_back(runs, hash);
  // Ties by the hash: any order would do, but always the same.
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  std::string out;
  for (std::size_t i = 0; i < std::min(rows.size(), kMostShown); ++i) {
    out += fmt::format("{:>9}  {}\n", rows[i].first, to_hex(rows[i].second));
  }
  if (rows.size() > kMostShown) {
    out += fmt::format("{:>9}  and {} more\n", "…", rows.size() - kMostShown);
  }
  return out;
}

/// How many runs go together. Without a journal enough that a long run holds nobody up; with one
/// as many as take about a second, since no more than that is to be lost.
class BatchSize {
 public:
  BatchSize(int threads, bool journal)
      : least_(journal ? 2 * threads : std::max(32, 8 * threads)), now_(least_), grows_(journal) {}
  int now() const { return now_; }
  void took(std::chrono::duration<double> time) {
    constexpr int kMost = 4096;
    if (!grows_) return;
    if (time.count() < 0.3) now_ = std::min(2 * now_, kMost);
    if (time.count() > 2) now_ = std::max(now_ / 2, least_);
  }

 private:
  int least_, now_;
  bool grows_;
};

/// The records of a batch's runs up to the first that was interrupted.
std::vector<Json> records_of(const RuleSet& rules, SwarmConfig config,
                             const std::vector<SwarmResult>& results) {
  std::vector<Json> out;
  for (const SwarmResult& result : results) {
    if (result.terminated == Terminated::interrupted) break;
    out.push_back(run_record(rules, config, result));
    ++config.run;
  }
  return out;
}

}  // namespace

Ensemble run_all(const RuleSet& rules, const RuleTable& table, const ExploreConfig& config,
                 const ExploreOptions& options, const std::vector<Output>& outputs,
                 const App& app) {
  Ensemble ensemble;
  ensemble.fired.resize(rules.rules.size());
  const std::vector<Output> each = of_each_run(outputs), tables = tables_of(outputs);
  RunJournal journal;
  const auto add_old = [&](const Json& record) { add_record(record, options, ensemble); };
  if (!tables.empty() && !journal.open(tables, rules, config.swarm, options.runs, add_old, app)) {
    ensemble.exit_code = kRunFailed;
    return ensemble;
  }
  const int threads = thread_count(options.threads);
  BatchSize batch(threads, journal.is_open());
  Progress progress(app);
  SwarmConfig own = config.swarm;
  bool failed = false;
  for (int first = static_cast<int>(ensemble.runs.size());
       first < options.runs && !ensemble.interrupted && !failed;) {
    const int runs = std::min(batch.now(), options.runs - first);
    own.run = static_cast<std::uint32_t>(first);
    const auto done = [&](int finished) {
      progress.show((first + finished) / static_cast<double>(options.runs),
                    fmt::format("{} of {} runs", first + finished, options.runs));
    };
    const auto begun = std::chrono::steady_clock::now();
    const auto results =
        run_ensemble(table, rules.start, own, runs, threads, done, &stop_requested());
    batch.took(std::chrono::steady_clock::now() - begun);
    if (journal.is_open()) failed = !journal.append(records_of(rules, own, results), app);
    for (const SwarmResult& result : results) {
      add_run(rules, own, result, options, ensemble);
      ensemble.interrupted |= result.terminated == Terminated::interrupted;
      if (!each.empty()) {
        progress.clear();
        OutputWriter writer(each, rules, own);
        ensemble.exit_code = std::max(ensemble.exit_code, writer.write(result, app));
      }
      // Runs have one seed in common, and are told apart by their number.
      ++own.run;
    }
    first += runs;
    // A stop between two batches.
    ensemble.interrupted |= stop_requested() && first < options.runs;
  }
  progress.clear();
  if (journal.is_open()) {
    const int code =
        journal.write_tables(tables, options.runs, !ensemble.interrupted && !failed, app);
    ensemble.exit_code = std::max({ensemble.exit_code, code, failed ? kRunFailed : kOk});
  }
  return ensemble;
}

std::string ensemble_lines(const RuleSet& rules, const ExploreConfig& config,
                           const Ensemble& ensemble, bool color) {
  std::string out = setting_lines(rules, config.swarm, color);
  out += line("runs", fmt::format("{}: {}", ensemble.runs.size(), endings_in_words(ensemble.runs)));
  const std::vector<RunSummary> runs = finished(ensemble.runs);
  if (runs.empty()) return out + line("structures", "none: no run was finished");
  out += line("steps", range_in_words(range_of(runs, [](auto& r) { return r.steps; })));
  out += line("deposits", range_in_words(range_of(runs, [](auto& r) { return r.deposits; })));
  out += line("bricks", range_in_words(range_of(runs, [](auto& r) { return r.bricks; })));
  out += line("structures", fmt::format("{} distinct", ensemble.structures.size()));
  return out + bold("runs by structure hash", color) + "\n" + structure_table(ensemble);
}

}  // namespace stig::cli
