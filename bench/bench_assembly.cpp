// SPDX-License-Identifier: MIT
// Of targets that robots might be asked for: how many are possible, get rules that a robot can
// follow, and are built by one robot and by two.
//
//   bench_assembly [--build STIGC] [-o FOLDER] [--jobs N] [SEEDS [FIRST_SEED [KIND…]]]
//
// For each kind (all of tests/assembly/targets.h) SEEDS targets (10) are drawn, the first from
// FIRST_SEED (1). "colours" are those that some order of work would build, but no rules do: the
// planner proved that a block's colours are too few, whatever the order. "possible" is what an
// oracle that knows everything could have built by some order of work, less those, "unknown" what
// it gave up on. "synthesised" is what rules were printed for, "compiled"
// what was compiled again from the printed file, with no option. With --build and a stigc, `stigc
// validate` then builds it as physics has it, with each of two seeds: by one robot, and by two
// where there are rules for two (others count as not built). "95+94/98" reads: of 98 compiled
// targets, 95 were built with seed 1, and 94 with seed 2. "s/brick" is simulated time, of complete
// runs.
//
// Targets are done N at a time (as many as there are cores), and each is reported as it is done.
// FOLDER keeps the rules, and the results in rows.jsonl: what stands there is not done again, so
// that a measurement can be stopped and taken up. The exit status is 1 when a share that is asked
// for is missed, 2 for a wrong command line.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <mutex>

#include "assembly/targets.h"
#include "assembly_rows.h"
#include "assembly_trial.h"
#include "base/parallel.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostJobs = 4096;

struct Order {
  std::string stigc;  ///< empty: nothing is built
  std::string folder;
  bool temporary = true;
  int jobs = thread_count(0);
  std::uint64_t seeds = 10, first = 1;
  std::vector<std::string> kinds{kTargetKinds.begin(), kTargetKinds.end()};
};

[[noreturn]] void refuse(const std::string& what) {
  std::cerr << "bench_assembly: " << what
            << "\nbench_assembly [--build STIGC] [-o FOLDER] [--jobs N] [SEEDS [FIRST_SEED "
               "[KIND…]]]\n";
  std::exit(2);
}

std::uint64_t number_from(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || value == 0) {
    refuse(fmt::format("'{}' is not a number from 1 on", text));
  }
  return value;
}

Order order_from(std::vector<std::string> words) {
  Order out;
  std::vector<std::string> plain;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool option = words[i].starts_with("-");
    if (!option) plain.push_back(words[i]);
    if (!option) continue;
    if (i + 1 == words.size()) refuse(fmt::format("nothing follows '{}'", words[i]));
    const std::string& value = words[++i];
    if (words[i - 1] == "--build") {
      out.stigc = value;
    } else if (words[i - 1] == "-o") {
      out.folder = value;
      out.temporary = false;
    } else if (words[i - 1] == "--jobs") {
      out.jobs = static_cast<int>(std::min<std::uint64_t>(number_from(value), kMostJobs));
    } else {
      refuse(fmt::format("unknown option '{}'", words[i - 1]));
    }
  }
  if (!plain.empty()) out.seeds = number_from(plain[0]);
  if (plain.size() > 1) out.first = number_from(plain[1]);
  if (plain.size() > 2) out.kinds.assign(plain.begin() + 2, plain.end());
  for (const std::string& kind : out.kinds) {
    if (std::find(kTargetKinds.begin(), kTargetKinds.end(), kind) == kTargetKinds.end()) {
      refuse(fmt::format("there is no kind '{}'", kind));
    }
  }
  if (out.temporary) {
    out.folder = (fs::temp_directory_path() / fmt::format("bench_assembly-{}", getpid())).string();
  }
  fs::create_directories(out.folder);
  return out;
}

/// All targets, on several threads; what the folder has of them is taken from there.
class Measurement {
 public:
  explicit Measurement(const Order& order) : order_(order), file_(order.folder + "/rows.jsonl") {
    for (const std::string& kind : order.kinds) {
      for (std::uint64_t k = 0; k < order.seeds; ++k) targets_.emplace_back(kind, order.first + k);
    }
    std::ifstream known(file_);
    for (std::string line; std::getline(known, line);) {
      if (auto row = row_from_json(line)) keep(std::move(*row));
    }
  }

  std::vector<AssemblyRow> run() {
    run_parallel(targets_.size(), order_.jobs, [this](std::size_t i) { work(targets_[i]); });
    std::vector<AssemblyRow> out;
    for (const auto& target : targets_) out.push_back(rows_.at(target));
    return out;
  }

 private:
  using TargetName = std::pair<std::string, std::uint64_t>;

  void keep(AssemblyRow row) {
    const TargetName name(row.kind, row.seed);
    rows_[name] = std::move(row);
  }

  bool is_done(const TargetName& target) {
    const std::lock_guard guard(mutex_);
    const auto found = rows_.find(target);
    return found != rows_.end() && (found->second.built || order_.stigc.empty());
  }

  void work(const TargetName& target) {
    if (is_done(target)) return;
    AssemblyRow row = try_target(target.first, target.second, order_.stigc, order_.folder);
    const std::lock_guard guard(mutex_);
    std::cerr << progress_line(row);
    std::ofstream(file_, std::ios::app) << to_json_line(row);
    keep(std::move(row));
  }

  const Order& order_;
  const std::string file_;
  std::vector<TargetName> targets_;
  std::mutex mutex_;  ///< of what follows, and of the file
  std::map<TargetName, AssemblyRow> rows_;
};

}  // namespace
}  // namespace stig::bench

int main(int argc, char** argv) {
  using namespace stig::bench;
  const Order order = order_from({argv + 1, argv + argc});
  const std::vector<AssemblyRow> rows = Measurement(order).run();
  const bool built = !order.stigc.empty();
  const Shares shares = shares_of(rows, built);
  std::cout << table_of(rows, order.kinds, built) << '\n' << shares.lines;
  if (order.temporary) fs::remove_all(order.folder);
  return shares.met ? 0 : 1;
}
