// SPDX-License-Identifier: MIT
// Runs the program as a user does: in a process of its own, in an empty folder that
// has the test sets as sets/.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "support/uses.h"

namespace stig {

struct Outcome {
  int exit_code = -1;  ///< -1: killed by a signal
  std::string out, err;
};

class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  /// Runs `stigc` with these arguments to its end.
  Outcome stigc(const std::vector<std::string>& arguments) const;
  /// The same through the shell: "stigc" is the program, redirections and all.
  Outcome shell(const std::string& line) const;
  /// Starts it and returns at once; finish() waits and reports.
  pid_t start(const std::vector<std::string>& arguments) const;
  Outcome finish(pid_t process) const;
  /// Waits until a process has worked for half a second of its own time: then it is past its
  /// beginning, however busy the machine. Fails the test if it never does.
  static void let_work(pid_t process);

  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  /// The bytes of a file in the folder; fails the test when there is none.
  std::string file(const std::string& name) const;
  bool has(const std::string& name) const;
  void write(const std::string& name, const std::string& bytes) const;
  /// Names of the files made so far, sorted.
  std::vector<std::string> files() const;

 private:
  std::string folder_;   ///< current directory of the program
  std::string streams_;  ///< where its output is caught
};

/// Command, exit code and both streams, as golden files have it.
std::string transcript(const std::string& line, const Outcome& outcome);
/// Holds the transcript of a line for the shell to golden/`name`.txt.
void hold(const Workplace& place, const std::string& name, const std::string& line);

}  // namespace stig
