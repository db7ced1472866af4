// SPDX-License-Identifier: MIT
// stigc, the command line program. See command_line.cpp for what it understands.
//
// In this order: streams and signals, last words, arguments. Exceptions that nobody caught end the
// program (last_words.cpp).
#include "app.h"
#include "last_words.h"
#include "run_line.h"

namespace stig::cli {
namespace {

int run_main(int argc, const char* const* argv) {
  prepare_process();
  prepare_last_words();
  Parsed parsed = parse_command_line(argc, argv);
  App app(parsed.line ? parsed.line->global : GlobalOptions{});
  const int code = run_parsed(parsed, app);
  const bool flushed = app.flush();
  // Asked for after the last look at the flag, while measuring or writing, a stop counts
  // all the same.
  return flushed && !stop_requested() ? code : kRunFailed;
}

}  // namespace
}  // namespace stig::cli

int main(int argc, char** argv) { return stig::cli::run_main(argc, argv); }
