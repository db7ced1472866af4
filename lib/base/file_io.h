// SPDX-License-Identifier: MIT
// Whole files in and out. Writing is atomic: to a temporary file beside the
// target, synced, then renamed, so a reader never sees half a file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stig {

struct FileError {
  std::string message;     ///< "cannot open 'x': No such file or directory"
  bool too_large = false;  ///< the one reason that is the file's own
};

/// The file's bytes, or nothing with `error` set. Files larger than `most` bytes
/// are refused without being read; directories, devices and pipes too
/// (except "-": standard input). Files in memory (memory_file.h) come first.
std::optional<std::string> read_file(const std::string& path, std::size_t most, FileError& error);

/// False with `error` set when the file could not be written; the target is then
/// as it was. A symbolic link is followed, permissions of a replaced file are kept;
/// directories, devices and pipes are refused. "-" is standard output.
bool write_file(const std::string& path, std::string_view bytes, FileError& error);

/// A file that grows piece by piece and appears under its name when it is whole: until
/// then, and when it is never committed, there is only a temporary file beside it.
class GrowingFile {
 public:
  GrowingFile() = default;
  ~GrowingFile() { discard(); }
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// False with `error` set; directories, devices and pipes are refused.
  bool open(const std::string& path, FileError& error);
  bool is_open() const { return fd_ >= 0; }
  bool append(std::string_view bytes, FileError& error);
  /// Syncs, closes and renames.
  bool commit(FileError& error);
  void discard();

 private:
  std::string path_, target_, temporary_;
  int fd_ = -1;
  int slot_ = -1;  ///< where remove_unfinished_files() finds the name
};

/// Takes away what files that were not committed have left beside their targets. For signal
/// handlers that end the program: it calls nothing that they may not.
void remove_unfinished_files();

}  // namespace stig
