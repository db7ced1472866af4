// SPDX-License-Identifier: MIT
// Files that are nowhere but in memory: what is made of a file on the disk by a change, or by a
// program, is read by its name as other files are, and what it names is looked for beside it.
#pragma once

#include <optional>
#include <string>

namespace stig {

/// While it lives, read_file finds this text under this name, whatever is on the disk. Names are
/// the process's, for all threads, and each is given once at a time.
class MemoryFile {
 public:
  MemoryFile(std::string path, std::string text);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The text of such a file.
std::optional<std::string> in_memory(const std::string& path);

}  // namespace stig
