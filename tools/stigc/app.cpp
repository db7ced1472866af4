// SPDX-License-Identifier: MIT
// What a well-behaved Unix program owes its surroundings: results complete or an error, no half
// files after a signal, no colours where nobody sees them, descriptors 0 to 2 that are what they
// seem. Commands know nothing of all this but App.
#include "app.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "base/file_guard.h"
#include "base/file_io.h"
#include "rules/rule_reader.h"

namespace stig::cli {
namespace {

/// Results are written in pieces of this size, so that long ones need no memory.
constexpr std::size_t kPiece = std::size_t{1} << 20;

// Lock-free atomics of this kind may be touched by a signal handler (C++ standard,
// [support.signal]).
std::atomic<bool> stop_flag{false};
std::atomic<bool> signals_are_others{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

/// As the signal would have ended the program by itself, but without half a file left behind. Only
/// functions that are safe in a signal handler (signal-safety(7)).
void die_of(int signal) {
  remove_unfinished_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void on_signal(int signal) {
  // The first signal asks the command to stop, the second does not ask.
  if (stop_flag.exchange(true, std::memory_order_relaxed)) die_of(signal);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  // Calls that a signal interrupts go on; commands look at the flag instead.
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

bool is_terminal(int descriptor) { return isatty(descriptor) == 1; }

bool color_wanted(Coloured wish, int descriptor) {
  if (wish != Coloured::automatic) return wish == Coloured::always;
  // See no-color.org: set and not empty means none, whatever the terminal can do.
  const char* no_color = std::getenv("NO_COLOR");
  const char* term = std::getenv("TERM");
  const bool dumb = term == nullptr || std::strcmp(term, "dumb") == 0;
  return is_terminal(descriptor) && !(no_color != nullptr && *no_color != 0) && !dumb;
}

/// As with "stigc fmt x >> x". The shell would append to the file that is being read, which could
/// go on for ever.
bool stdout_is_read() {
  const auto file = file_number(STDOUT_FILENO);
  return file && was_read(*file);
}

/// The code of the error that is shown first.
std::string first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic* d : sorted_by_place(diagnostics)) {
    if (d->severity == Severity::error) return std::string(info(d->code).name);
  }
  return {};
}

void note_codes(const Diagnostics& diagnostics, std::vector<std::string>& codes) {
  for (const Diagnostic* d : sorted_by_place(diagnostics)) {
    const std::string name(info(d->code).name);
    if (std::find(codes.begin(), codes.end(), name) == codes.end()) codes.push_back(name);
  }
}

std::string styled(std::string_view code, std::string_view text, bool on) {
  return on ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
}

}  // namespace

App::App(const GlobalOptions& options)
    : options_(options),
      color_out_(color_wanted(options.color, STDOUT_FILENO)),
      color_err_(color_wanted(options.color, STDERR_FILENO)),
      progress_wanted_(!options.quiet && is_terminal(STDERR_FILENO)) {}

App::App(const GlobalOptions& options, Captured& captured)
    : options_(options), captured_(&captured) {}

void App::print(std::string_view text) {
  out_ += text;
  // Before the piece grows further; what is kept is bounded so.
  if (out_.size() >= kPiece) flush();
}

bool App::flush() {
  if (captured_ != nullptr) {
    captured_->out += out_;
    out_.clear();
    return true;
  }
  if (!broken_ && !out_.empty() && stdout_is_read()) {
    broken_ = true;
    complain("cannot write to standard output: it is what is read");
  } else if (!broken_ && !write_all(STDOUT_FILENO, out_)) {
    // A reader that has gone (head, less) has what it wanted: no error.
    broken_ = errno != EPIPE;
    if (broken_) complain(fmt::format("cannot write to standard output: {}", strerror(errno)));
  }
  out_.clear();
  return !broken_;
}

void App::talk(std::string_view text) const {
  if (captured_ != nullptr) {
    captured_->err += text;
  } else {
    write_all(STDERR_FILENO, text);
  }
}

void App::say(std::string_view line) const {
  if (!options_.quiet) talk(fmt::format("{}\n", line));
}

void App::complain(std::string_view line) const {
  // Messages are not kept: they appear where in time they belong, and also before a crash.
  talk(fmt::format("stigc: {}\n", line));
}

void App::report(const Diagnostics& diagnostics) const {
  if (diagnostics.all().empty()) return;
  if (captured_ != nullptr) note_codes(diagnostics, captured_->codes);
  if (options_.json_diagnostics) {
    talk(to_json(diagnostics));
  } else {
    TextStyle style;
    style.color = color_err_;
    talk(to_text(diagnostics, style));
    // One hint for all: the code that stands first on the screen.
    if (diagnostics.has_errors()) say("for more: stigc --explain " + first_error(diagnostics));
  }
}

bool App::invalid(const Diagnostics& diagnostics) const {
  return diagnostics.has_errors() ||
         (options_.warnings_are_errors && diagnostics.count(Severity::warning) > 0);
}

std::optional<RuleSet> App::read_rules(const std::string& path) const {
  Diagnostics diagnostics;
  std::optional<RuleSet> rules = read_rule_set_file(path, diagnostics);
  // Warnings alone are one line, since commands that use a rule set are not about its style; as
  // JSON they are shown, for editors.
  const bool bad = invalid(diagnostics);
  const std::size_t warnings = diagnostics.count(Severity::warning);
  if (bad || (options_.json_diagnostics && warnings > 0)) {
    report(diagnostics);
  } else if (warnings > 0) {
    say(fmt::format("{}: {} {}, which stigc check shows", printable(path), warnings,
                    warnings == 1 ? "warning" : "warnings"));
  }
  if (bad) rules.reset();
  return rules;
}

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    // write(2) may take a part, or be interrupted before any.
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string bold(std::string_view text, bool on) { return styled("1", text, on); }
std::string green(std::string_view text, bool on) { return styled("32", text, on); }
std::string red(std::string_view text, bool on) { return styled("31", text, on); }
std::string yellow(std::string_view text, bool on) { return styled("33", text, on); }
std::string dim(std::string_view text, bool on) { return styled("2", text, on); }

void prepare_process() {
  // Otherwise the next file opened would become standard output. Opened for reading,
  // so that writing to it fails and is noticed.
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    // POSIX gives the lowest free number to whatever is opened next.
    if (fcntl(descriptor, F_GETFD) == -1 && open("/dev/null", O_RDONLY) < 0) std::abort();
  }
  guard_files();
  // So that write(2) fails with EPIPE and EFBIG, which are reported as any other error.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Where the shell has a signal ignored, as nohup does, it stays so.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!is_ignored(signal)) handle(signal, die_of);
  }
}

void stop_on_signals() {
  if (signals_are_others) return;
  handle(SIGINT, on_signal);
  handle(SIGTERM, on_signal);
  // A terminal that is closed, unless nohup keeps it off.
  if (!is_ignored(SIGHUP)) handle(SIGHUP, on_signal);
}

void leave_signals_alone() { signals_are_others = true; }
void request_stop(bool stop) { stop_flag = stop; }

const std::atomic<bool>& stop_requested() { return stop_flag; }

void accept_stop() { stop_flag.store(false, std::memory_order_relaxed); }

}  // namespace stig::cli
