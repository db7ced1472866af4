// SPDX-License-Identifier: MIT
// How the program ends of an exception that nobody catches. The program itself throws none that a
// test could ask for, so the handler is tried in processes of their own.
#include "stigc/last_words.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <new>
#include <stdexcept>
#include <system_error>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

/// doctest would catch it otherwise.
void without_catcher(void (*body)()) noexcept { body(); }

/// Exit code and standard error of a process that throws.
Outcome end_of(void (*body)()) {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    dup2(ends[1], STDERR_FILENO);
    cli::prepare_last_words();
    without_catcher(body);
    _exit(0);
  }
  close(ends[1]);
  Outcome out;
  char buffer[256];
  for (ssize_t n = 0; (n = read(ends[0], buffer, sizeof buffer)) > 0;) {
    out.err.append(buffer, static_cast<std::size_t>(n));
  }
  close(ends[0]);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  out.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return out;
}

TEST_CASE("an exception that nobody catches ends in a message and exit status 3") {
  const Outcome bug = end_of([] { throw std::out_of_range("map::at"); });
  CHECK(bug.exit_code == 3);
  CHECK(bug.err == "stigc: a bug in stigc, please report it: map::at\n");
  const Outcome odd = end_of([] { throw 7; });
  CHECK(odd.exit_code == 3);
  CHECK(odd.err.find("please report it") != std::string::npos);
  const Outcome memory = end_of([] { throw std::bad_alloc(); });
  CHECK(memory.exit_code == 3);
  CHECK(memory.err == "stigc: there is not enough memory for this\n");
  const Outcome system = end_of(
      [] { throw std::system_error(std::make_error_code(std::errc::no_such_process), "thread"); });
  CHECK(system.exit_code == 3);
  CHECK(system.err.find("stigc: the system gave out: thread") == 0);
}

TEST_CASE("the program prepares its last words before it does anything else") {
  std::string text = project_file("tools/stigc/run_line.cpp");
  text.erase(0, text.find("int run_main("));
  CHECK(text.find("prepare_last_words();") < text.find("parse_command_line("));
}

}  // namespace
}  // namespace stig
