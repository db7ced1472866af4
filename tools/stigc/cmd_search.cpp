// SPDX-License-Identifier: MIT
// stigc search: batch after batch into a file of results, until the plan is done or somebody stops
// it.
//
// The file is gone on with and not written anew, which no other output is: a batch that is reported
// is in it, whatever happens afterwards.
#include <fmt/format.h>

#include "base/file_guard.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "commands.h"
#include "item_work.h"
#include "outputs.h"
#include "progress.h"
#include "report.h"
#include "search/result_file.h"
#include "search_judges.h"
#include "search_lines.h"

namespace stig::cli {
namespace {

void print_summary(const search::SearchPlan& plan, const search::SearchState& state, App& app) {
  const search::FindArchive& archive = state.archive;
  app.print(bold(printable(plan.name), app.color_out()) + "\n");
  app.print(line("evaluated", std::to_string(state.evaluated)));
  app.print(line("structures", std::to_string(archive.structures())));
  if (!plan.axes.empty()) {
    app.print(line("cells", std::to_string(archive.elites().size())));
  }
  for (const std::size_t best : archive.best(1)) {
    const search::Individual& one = archive.kept()[best];
    app.print(line("best", fmt::format("{}, score {:.6g}", one.id, one.score)));
  }
  app.print(line("content", to_hex(archive.content_hash())));
}

DoItem measuring(const SearchTask& task) {
  return [&task, hash = plan_hash(task.plan)](const std::string& line) {
    std::vector<search::Individual> made = read_candidate_line(line);
    search::Screener screener(task.plan.screen);
    for (search::Individual& one : made) {
      measure_candidate(task.plan, hash, judges_of(task), screener, one);
    }
    return measured_line(made);
  };
}

/// By other processes, which are told of genomes alone: so none of them has to know the archive.
bool measured_by_others(const SearchTask& task, std::vector<search::Individual>& made,
                        int threads) {
  std::size_t back = 0;
  const auto take = [&](const std::vector<std::string>& measured) {
    for (const std::string& line : measured) {
      const auto some = read_measured_line(line, made);
      if (!some) return false;
      back += *some;
    }
    return true;
  };
  return workforce().share(candidate_lines(made), threads, measuring(task), take) &&
         back == made.size();
}

bool measured_here(const SearchTask& task, std::vector<search::Individual>& made, int threads) {
  return measure_batch(task.plan, made, judges_of(task), threads, &stop_requested());
}

/// The next batch, measured; nothing, with the exit code, when it ends here.
std::optional<std::vector<search::Individual>> measured_batch(const SearchTask& task,
                                                              const search::SearchState& state,
                                                              int threads, Progress& progress,
                                                              const App& app, int& code) {
  const search::SearchPlan& plan = task.plan;
  auto made =
      make_batch(plan, state, static_cast<std::size_t>(plan.batch), threads, &stop_requested());
  if (!(workforce().others ? measured_by_others : measured_here)(task, made, threads)) {
    progress.clear();
    app.complain(fmt::format("interrupted after {} of {} evaluations; the same command goes on",
                             state.evaluated, evaluations_of(plan, state.slice)));
    code = kRunFailed;
    return std::nullopt;
  }
  if (const search::Individual* one = first_unscored(made)) {
    progress.clear();
    report_unscored(task, *one, app);
    code = kFailed;
    return std::nullopt;
  }
  return made;
}

/// An exit code. What was done when it ends early is in the file.
int work(const SearchTask& task, search::ResultFile& file, search::SearchState& state, int threads,
         const App& app) {
  Progress progress(app);
  const std::uint64_t begun = state.evaluated, all = search::evaluations_of(task.plan, state.slice);
  while (state.evaluated < all) {
    int code = kOk;
    auto made = measured_batch(task, state, threads, progress, app, code);
    if (!made) return code;
    const search::SearchBatch batch = take_batch(state, std::move(*made));
    std::string error;
    if (!file.add(batch, state.archive, error)) {
      progress.clear();
      app.complain(printable(error));
      return kRunFailed;
    }
    progress.show(static_cast<double>(state.evaluated - begun) / static_cast<double>(all - begun),
                  fmt::format("{} evaluations, {} structures, best of the batch {:.4g}",
                              state.evaluated, state.archive.structures(), batch.best));
  }
  return kOk;
}

}  // namespace

int run(const SearchFileOptions& options, App& app) {
  const auto task = read_search_task(options.plan, app);
  if (!task) return kFailed;
  if (!workforce().leads) {
    workforce().share({}, options.threads, measuring(*task), {});
    return kOk;
  }
  if (options.slice.of > 1 && task->plan.method != search::SearchMethod::random) {
    app.complain(
        fmt::format("--slice is for the method random alone: under {} candidates are made "
                    "of what all slices have found",
                    to_string(task->plan.method)));
    return kFailed;
  }
  if (const int code = check_outputs({options.output}, app); code != kOk) return code;
  search::SearchState state(task->plan, {options.slice.number, options.slice.of});
  std::string error;
  auto file = search::ResultFile::go_on(options.output, task->plan, state, error);
  if (!file) {
    app.complain(printable(error));
    return kRunFailed;
  }
  if (state.evaluated > 0) {
    app.say(fmt::format("going on after {} evaluations", state.evaluated));
  }
  stop_on_signals();
  const int code = work(*task, *file, state, thread_count(options.threads), app);
  if (code == kOk) print_summary(task->plan, state, app);
  return code;
}

}  // namespace stig::cli
