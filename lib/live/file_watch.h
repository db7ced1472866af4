// SPDX-License-Identifier: MIT
// Files that somebody may save while a run goes on.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "live/uses.h"

namespace stig::live {

/// Looks at times and sizes: that finds what an editor writes in place and what it renames, on
/// every file system.
class FileWatch {
 public:
  /// These from now on, as they are now.
  void watch(const std::vector<std::string>& paths);
  /// Has one of them changed since `watch`, and none since the last call? A file that is being
  /// written is so read when it is whole.
  bool saved();

 private:
  struct Stamp {
    std::filesystem::file_time_type time{};
    std::uintmax_t size = 0;
    bool there = false;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  static Stamp stamp_of(const std::string& path);

  std::map<std::string, Stamp> known_, last_;
};

}  // namespace stig::live
