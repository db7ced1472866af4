// SPDX-License-Identifier: MIT
// stigc merge: the slices of a study, or of a search, as the one file that the whole would have
// written. A study's slices are in the order of their items, so a line of each is all that has to
// be in memory; a search's are joined by SQLite in memory.
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/file_guard.h"
#include "commands.h"
#include "outputs.h"
#include "report.h"
#include "search/merge_results.h"
#include "sweep_tables.h"

namespace stig::cli {
namespace {

constexpr std::uint64_t kEndOfSlice = ~std::uint64_t{0};

/// One slice's file, a record at a time.
struct SliceFile {
  std::string path, line;
  std::ifstream file;
  std::uint64_t item = kEndOfSlice;
};

class Merger {
 public:
  Merger(const std::vector<std::string>& paths, const App& app) : paths_(paths), app_(app) {}

  std::uint64_t items() const { return items_; }

  /// Every record once, in order; false with a complaint.
  bool each_record(const std::function<bool(std::string_view line)>& each) {
    if (!open()) return false;
    for (std::uint64_t next = 0;; ++next) {
      SliceFile* first = nullptr;
      for (SliceFile& slice : slices_) {
        if (first == nullptr || slice.item < first->item) first = &slice;
      }
      if (first->item == kEndOfSlice) return next == items_ || missing(next);
      if (first->item != next) return missing(next);
      const std::string line = first->line;
      // The same item in two slices is no harm where both say the same.
      for (SliceFile& slice : slices_) {
        if (slice.item != next) continue;
        if (slice.line != line) {
          return fail(fmt::format("{} and {} have different records of item {}", first->path,
                                  slice.path, next));
        }
        if (!advance(slice)) return false;
      }
      if (!each(line)) return false;
    }
  }

 private:
  bool fail(const std::string& what) {
    if (!failed_) app_.complain(printable(what));
    failed_ = true;
    return false;
  }
  bool missing(std::uint64_t item) {
    return fail(fmt::format("item {} of {} is in none of these", item, items_));
  }

  bool open() {
    slices_ = std::vector<SliceFile>(paths_.size());
    plan_.clear();
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      slices_[i].path = paths_[i];
      slices_[i].file.open(paths_[i], std::ios::binary);
      if (!slices_[i].file) return fail(fmt::format("cannot open '{}'", paths_[i]));
      if (const auto number = file_number(paths_[i])) note_read(*number);
      if (!advance(slices_[i])) return false;
    }
    return true;
  }

  bool advance(SliceFile& slice) {
    const std::uint64_t before = slice.item;
    slice.item = kEndOfSlice;
    if (!std::getline(slice.file, slice.line)) return true;
    const Json record = Json::parse(slice.line, nullptr, false);
    const bool sound = record.is_object() && record.contains("plan") && record.contains("stigc") &&
                       record.contains("item") && record["item"].is_number_unsigned() &&
                       record.contains("items") && record["items"].is_number_unsigned();
    if (!sound) return fail(fmt::format("'{}' has a line that is no record", slice.path));
    const std::string plan = record["plan"].dump() + record["stigc"].dump();
    if (plan_.empty()) {
      plan_ = plan;
      items_ = record["items"];
    }
    if (plan != plan_) {
      return fail(fmt::format("'{}' is of another plan or another version", slice.path));
    }
    slice.item = record["item"];
    if (before != kEndOfSlice && slice.item <= before) {
      return fail(fmt::format("the records of '{}' are not in their order", slice.path));
    }
    return true;
  }

  const std::vector<std::string>& paths_;
  const App& app_;
  std::vector<SliceFile> slices_;
  std::string plan_;
  std::uint64_t items_ = 0;
  bool failed_ = false;
};

int merge_search(const MergeOptions& options, App& app) {
  if (options.outputs.size() != 1 || options.json) {
    app.complain("slices of a search are merged into one file: -o once, and no --json");
    return kUsage;
  }
  // Results are no text that is read, and so not guarded by themselves.
  std::vector<std::string> files = options.files;
  files.push_back(options.outputs.front());
  if (const int code = check_outputs(files, app); code != kOk) return code;
  std::string error;
  const auto merged = search::merge_results(options.files, error);
  if (!merged) {
    app.complain(printable(error));
    return kFailed;
  }
  return write_output(options.outputs.front(), *merged, app);
}

}  // namespace

int run(const MergeOptions& options, App& app) {
  if (search::is_sqlite_file(options.files.front())) return merge_search(options, app);
  Merger merger(options.files, app);
  // Once through before anything is written: are they all there?
  if (!merger.each_record([](std::string_view) { return true; })) return kFailed;
  if (const int code = check_tables(options.outputs, {}, app); code != kOk) return code;
  const TablesWritten written = write_tables(
      options.outputs, [&](const auto& each) { return merger.each_record(each); }, app);
  app.print(study_summary(written, merger.items(), options.json));
  return written.code;
}

}  // namespace stig::cli
