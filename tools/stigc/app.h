// SPDX-License-Identifier: MIT
// What every command works with: exit codes, the two streams, messages.
//
// Results go to standard output, kept together and written at the end; talk goes
// to standard error as it comes. A reader that goes away early (a closed pipe) is
// no failure; an output that cannot be written (a full disk) is.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/text.h"
#include "options.h"
#include "rules/rule_set.h"
#include "uses.h"

namespace stig::cli {

/// Exit codes of the program.
inline constexpr int kOk = 0;
inline constexpr int kFailed = 1;     ///< invalid input, or a property that does not hold
inline constexpr int kUsage = 2;      ///< the command line is wrong
inline constexpr int kRunFailed = 3;  ///< the work failed, ran out of budget, was interrupted

/// What a command says where nobody but the program listens.
struct Captured {
  std::string out, err;
  std::vector<std::string> codes;  ///< of the diagnostics that it reported, each once, in order
};

class App {
 public:
  explicit App(const GlobalOptions& options);
  /// For a command within another's work: everything goes to `captured`, without colours.
  App(const GlobalOptions& options, Captured& captured);

  const GlobalOptions& options() const { return options_; }
  bool color_out() const { return color_out_; }
  bool color_err() const { return color_err_; }
  /// Are progress and remarks wanted, and is there a terminal to show progress on?
  bool progress_wanted() const { return progress_wanted_; }

  /// Adds to the results.
  void print(std::string_view text);
  /// Writes the results so far; false when standard output does not take them.
  bool flush();
  /// A remark on standard error; --quiet silences it.
  void say(std::string_view line) const;
  /// What went wrong, on standard error: "stigc: …".
  void complain(std::string_view line) const;
  /// Diagnostics on standard error, as --diagnostics asks; where there are none, nothing.
  void report(const Diagnostics& diagnostics) const;
  /// Do these diagnostics make the input invalid (warnings too under -W error)?
  bool invalid(const Diagnostics& diagnostics) const;

  /// Reads a rule set and reports its errors, warnings in one line; nothing when it is
  /// invalid.
  std::optional<RuleSet> read_rules(const std::string& path) const;

 private:
  void talk(std::string_view text) const;

  GlobalOptions options_;
  Captured* captured_ = nullptr;
  bool color_out_ = false, color_err_ = false, progress_wanted_ = false;
  bool broken_ = false;
  std::string out_;
};

/// All of `text` on a file descriptor; false with errno set.
bool write_all(int descriptor, std::string_view text);

/// `text` between escape sequences when `on`.
std::string bold(std::string_view text, bool on);
std::string green(std::string_view text, bool on);
std::string red(std::string_view text, bool on);
std::string yellow(std::string_view text, bool on);
std::string dim(std::string_view text, bool on);

/// Opens /dev/null in place of standard streams that are closed, guards the files that are read,
/// and lets SIGPIPE and SIGXFSZ (a limit on the size of files) be errors of write(2). Signals that
/// end the program take unfinished files away.
void prepare_process();
/// Turns SIGINT and SIGTERM into the flag below; a second signal ends the program at
/// once. For commands that look at the flag: the others die of the first. Does nothing in a process
/// whose signals are somebody else's.
void stop_on_signals();
/// From now on this process's signals are somebody else's, who sets the flag by the next.
void leave_signals_alone();
void request_stop(bool stop);
/// Set when the user asked to stop.
const std::atomic<bool>& stop_requested();
/// A stop was how the command is meant to end, and no failure: the flag is taken back.
void accept_stop();

}  // namespace stig::cli
