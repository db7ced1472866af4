// SPDX-License-Identifier: MIT
// stigc sweep: a study, item by item. Each record is on the disk, in a journal, before it counts as
// done; when all are, the tables are made of the journal, in the order of items.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "base/journal.h"
#include "commands.h"
#include "item_work.h"
#include "progress.h"
#include "report.h"
#include "sweep_item.h"
#include "sweep_tables.h"

namespace stig::cli {
namespace {

constexpr std::uint64_t kNoItem = ~std::uint64_t{0};

/// The item that a line is of; kNoItem: it is no record of this plan's.
std::uint64_t item_of(std::string_view line, const SweepPlan& plan) {
  const Json record = Json::parse(line, nullptr, false);
  if (!record.is_object() || record.value("plan", "") != to_hex(plan.hash)) return kNoItem;
  const std::uint64_t item = record.value("item", kNoItem);
  return item < plan.items ? item : kNoItem;
}

class Study {
 public:
  Study(const SweepPlan& plan, const SweepOptions& options, App& app)
      : plan_(plan), options_(options), app_(app), progress_(app) {}

  int run() {
    if (!workforce().leads) {
      workforce().share({}, options_.threads, work(), {});
      return kOk;
    }
    const std::string name = options_.outputs.front() + ".journal";
    if (const int code = check_tables(options_.outputs, {name}, app_); code != kOk) return code;
    if (!open(name)) return kRunFailed;
    stop_on_signals();
    const bool all = workforce().share(left(), options_.threads, work(),
                                       [this](const auto& lines) { return take(lines); });
    progress_.clear();
    return finish(name, all);
  }

 private:
  DoItem work() const {
    return [this](const std::string& item) { return item_record(plan_, std::stoull(item)); };
  }

  bool open(const std::string& name) {
    const auto add = [this](std::string_view line) {
      const std::uint64_t item = item_of(line, plan_);
      return item != kNoItem && mine(item) && done_.emplace(item, true).second;
    };
    // Not the slice's: what is done is done, however the rest is parted.
    const std::string work =
        fmt::format("stigc {} sweep, {}, {}/{}", STIG_VERSION, to_hex(plan_.hash),
                    options_.slice.number, options_.slice.of);
    FileError error;
    if (!journal_.open(name, work, add, error)) {
      app_.complain(error.message);
      return false;
    }
    if (!done_.empty()) {
      app_.say(fmt::format("going on after {} items, by {}", done_.size(), printable(name)));
    }
    return true;
  }

  bool mine(std::uint64_t item) const {
    return item % options_.slice.of == options_.slice.number - 1;
  }
  std::vector<std::string> left() {
    std::vector<std::string> items;
    for (std::uint64_t item = options_.slice.number - 1; item < plan_.items;
         item += options_.slice.of) {
      if (done_.count(item) == 0) items.push_back(std::to_string(item));
    }
    all_ = items.size() + done_.size();
    before_ = count_ = done_.size();
    return items;
  }

  bool take(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    FileError error;
    if (!journal_.append(text, error)) {
      progress_.clear();
      app_.complain(error.message);
      return false;
    }
    count_ += lines.size();
    // Of what was left to do: what an earlier command did says nothing of the time.
    progress_.show(static_cast<double>(count_ - before_) / static_cast<double>(all_ - before_),
                   fmt::format("{} of {} items", count_, all_));
    return true;
  }

  /// The journal's lines in the order of items. Those that came too early wait, which are few:
  /// items are begun in their order.
  bool in_order(const std::function<bool(std::string_view line)>& each) {
    std::map<std::uint64_t, std::string> waiting;
    bool good = true;
    std::uint64_t next = options_.slice.number - 1;
    const auto hand_over = [&](bool last) {
      while (good && !waiting.empty() && (last || waiting.begin()->first == next)) {
        good = each(waiting.begin()->second);
        next = waiting.begin()->first + options_.slice.of;
        waiting.erase(waiting.begin());
      }
    };
    FileError error;
    const bool read = journal_.read(
        [&](std::string_view line) {
          waiting.emplace(item_of(line, plan_), line);
          hand_over(false);
          return true;
        },
        error);
    hand_over(true);
    if (!read) app_.complain(error.message);
    return read && good;
  }

  int finish(const std::string& name, bool all) {
    const TablesWritten written = write_tables(
        options_.outputs, [this](const auto& each) { return in_order(each); }, app_);
    app_.print(study_summary(written, all_, options_.json));
    if (all && written.code == kOk) {
      journal_.remove();
      return kOk;
    }
    app_.say(fmt::format("what is done stands in {}; the same command goes on", printable(name)));
    return kRunFailed;
  }

  const SweepPlan& plan_;
  const SweepOptions& options_;
  App& app_;
  Progress progress_;
  Journal journal_;
  std::map<std::uint64_t, bool> done_;  ///< by earlier commands
  std::size_t all_ = 0, before_ = 0, count_ = 0;
};

int run_one(const SweepPlan& plan, std::uint64_t item, App& app) {
  if (item >= plan.items) {
    app.complain(fmt::format("there are {} items, from 0 on", plan.items));
    return kUsage;
  }
  stop_on_signals();
  const std::string record = item_record(plan, item);
  if (record.empty()) return kRunFailed;
  app.print(record + "\n");
  return kOk;
}

}  // namespace

int run(const SweepOptions& options, App& app) {
  if (options.run.has_value() != options.outputs.empty()) {
    app.complain("say where the records go, with -o FILE; or which item is run, with --run K");
    return kUsage;
  }
  const auto plan = read_sweep(options.plan, app);
  if (!plan) return kFailed;
  if (options.run) return workforce().leads ? run_one(*plan, *options.run, app) : kOk;
  return Study(*plan, options, app).run();
}

}  // namespace stig::cli
