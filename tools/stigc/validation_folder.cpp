// SPDX-License-Identifier: MIT
#include "validation_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "outputs.h"
#include "trial_journal.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

bool is_trace_name(const std::string& name) {
  constexpr std::string_view kBegin = "run-", kEnd = ".stigp";
  if (name.size() <= kBegin.size() + kEnd.size() || !name.starts_with(kBegin) ||
      !name.ends_with(kEnd)) {
    return false;
  }
  return std::all_of(name.begin() + kBegin.size(), name.end() - kEnd.size(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::string trace_name(std::uint64_t seed) { return fmt::format("run-{}.stigp", seed); }

std::vector<std::string> validation_files(std::vector<std::string> scene_files, std::uint64_t seed,
                                          int runs) {
  std::vector<std::string> names(kReportFiles.begin(), kReportFiles.end());
  names.push_back(kTrialJournal);
  std::move(scene_files.begin(), scene_files.end(), std::back_inserter(names));
  for (int run = 0; run < runs; ++run) {
    names.push_back(trace_name(seed + static_cast<std::uint64_t>(run)));
  }
  return names;
}

int prepare_validation(const std::string& folder, const std::vector<std::string>& files,
                       const App& app) {
  // An earlier report or journal marks the folder as this command's own; of another's journal its
  // reader says so.
  std::error_code ignored;
  const bool ours = has_words(folder + "/" + kReport, {"{\n  \"rules\": ", "\n  \"complete\": "}) ||
                    fs::exists(folder + "/" + kTrialJournal, ignored);
  return prepare_folder({folder, files, ours, "validation"}, app);
}

std::vector<std::string> other_traces(const std::string& folder,
                                      const std::vector<std::string>& files) {
  std::vector<std::string> found;
  std::error_code ignored;
  for (fs::directory_iterator at(folder, ignored), end; at != end; at.increment(ignored)) {
    std::string name = at->path().filename().string();
    if (is_trace_name(name) && std::find(files.begin(), files.end(), name) == files.end()) {
      found.push_back(std::move(name));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace stig::cli
