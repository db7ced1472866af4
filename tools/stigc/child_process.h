// SPDX-License-Identifier: MIT
// Other programs, run without a shell; what they print goes into files without names, so that
// nothing is left behind whatever happens.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "uses.h"

namespace stig::cli {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

/// Where temporary files go: TMPDIR, or /tmp.
std::string temporary_folder();

/// A file that has no name and goes with its descriptor; null with errno set.
OpenFile nameless_file();

/// The file from its beginning, up to `most` bytes.
std::string contents(std::FILE* file, std::size_t most);

inline constexpr std::size_t kMostWords = 600;  ///< bytes kept of what a program says

struct ProgramStart {
  std::string program;                           ///< its path
  std::vector<std::string> words;                ///< its command line, its name first
  std::vector<std::pair<int, int>> descriptors;  ///< of ours and its own; without 0: /dev/null
  bool own_group = false;  ///< Ctrl-C does not reach it; otherwise it ends with us
};

/// Starts it with the usual signals: 0, or an error as errno has them.
int start_program(const ProgramStart& start, pid_t& process);

/// Waits for its end. -1: it was killed.
int exit_code_of(pid_t process);

struct Finished {
  int exit_code = -1;  ///< -1: it was killed
  std::string out;     ///< at most so many bytes as asked for
  std::string words;   ///< the first of what it said on standard error
};

/// Runs a program to its end. Nothing with `problem` set when it cannot be started, or printed more
/// than `most` bytes.
std::optional<Finished> run_program(const std::string& program,
                                    const std::vector<std::string>& arguments, std::size_t most,
                                    std::string& problem);

}  // namespace stig::cli
