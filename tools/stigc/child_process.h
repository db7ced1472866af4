// SPDX-License-Identifier: MIT
// Other programs, run without a shell and waited for; what they print goes into files without
// names, so that nothing is left behind whatever happens.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "uses.h"

namespace stig::cli {

/// A file that has no name and goes with its descriptor; null with errno set.
std::FILE* nameless_file();

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
