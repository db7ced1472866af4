// SPDX-License-Identifier: MIT
// The runs of a validation that are over, in a file in its folder, so that the same command goes on
// after a kill and ends in the same report.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "app.h"
#include "base/journal.h"
#include "uses.h"
#include "validate/trial.h"

namespace stig::cli {

inline constexpr const char* kTrialJournal = "runs.journal";

class TrialJournal {
 public:
  /// `work` is the hash of all that runs depend on but their seeds. False with a complaint.
  bool open(const std::string& folder, std::uint64_t work, const App& app);
  bool is_open() const { return journal_.is_open(); }
  /// What an earlier command did, by seed.
  std::map<std::uint64_t, Trial>& earlier() { return earlier_; }
  /// Puts a run on the disk, from any thread; false with a complaint.
  bool add(const Trial& trial, const App& app);
  void remove() { journal_.remove(); }

 private:
  Journal journal_;
  std::mutex mutex_;
  std::map<std::uint64_t, Trial> earlier_;
};

}  // namespace stig::cli
