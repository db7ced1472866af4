// SPDX-License-Identifier: MIT
// What a long piece of work has done so far, a line each, in a file that outlives the process:
// after a kill or a full disk the same work goes on where it was.
//
// A line counts once append has returned: it is then on the disk. A last line that was torn is
// dropped when the journal is opened again. One process at a time has it: the others are told.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/file_io.h"

namespace stig {

class Journal {
 public:
  Journal() = default;
  ~Journal() { close(); }
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Opens the file, or makes it. `work` says in one line what the journal is of. Where there are
  /// lines of the same work already, `each` is called with every one of them and may refuse it,
  /// with which those from it on are dropped. False with `error` set: another work's journal, a
  /// file that is none, one that another process has, or one that cannot be written.
  bool open(const std::string& path, std::string_view work,
            const std::function<bool(std::string_view line)>& each, FileError& error);
  bool is_open() const { return fd_ >= 0; }
  /// Lines without line ends, all or none of which are then in the file. False with `error` set.
  bool append(std::string_view lines, FileError& error);
  /// Calls with every line after the first, as open does; false with `error` set.
  bool read(const std::function<bool(std::string_view line)>& each, FileError& error);
  void close();
  /// Takes the file away: the work is done.
  void remove();

 private:
  bool check_head(std::string_view work, FileError& error);

  std::string path_;
  int fd_ = -1;
  std::size_t size_ = 0;  ///< bytes of whole lines
};

}  // namespace stig
