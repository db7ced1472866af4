// SPDX-License-Identifier: MIT
// A line of progress on the terminal, with the time left; nothing before a second
// has passed, and nothing when standard error is no terminal.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "app.h"
#include "uses.h"

namespace stig::cli {

class Progress {
 public:
  explicit Progress(const App& app) : on_(app.progress_wanted()), began_(Clock::now()) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows `what` and, for a fraction in (0, 1], the time left at this pace. Cheap
  /// enough to be called often, from any thread.
  void show(double fraction, const std::string& what);
  /// Removes the line.
  void clear();
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool on_;
  Clock::time_point began_;
  Clock::time_point shown_{};
  bool visible_ = false;
  std::mutex mutex_;
};

/// "12 s", "3 min 05 s", "2 h 10 min".
std::string duration_in_words(double seconds);

}  // namespace stig::cli
