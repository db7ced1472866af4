// SPDX-License-Identifier: MIT
// Shown after a second and ten times a second at most: short work shows nothing, and a terminal
// over a slow line is not flooded. Every write is one call, so lines of several threads do not mix.
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace stig::cli {

void Progress::show(double fraction, const std::string& what) {
  if (!on_) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (now - began_ < std::chrono::seconds(1)) return;
  if (visible_ && now - shown_ < std::chrono::milliseconds(100)) return;
  shown_ = now;
  visible_ = true;
  std::string line = what;
  if (fraction > 0) {
    // At the pace so far; "at most", since the fraction is of a limit that need not be reached.
    const double left = seconds() * (1 - fraction) / fraction;
    line += fmt::format(", at most {} left", duration_in_words(left));
  }
  // Back to the line's start, and erase to its end (ECMA-48).
  write_all(STDERR_FILENO, fmt::format("\r\x1b[K{}", line));
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (visible_) write_all(STDERR_FILENO, "\r\x1b[K");
  visible_ = false;
}

double Progress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - began_).count();
}

std::string duration_in_words(double seconds) {
  // Clamped before it is rounded: lround of what no long can hold is undefined.
  const long whole = std::lround(std::fmin(std::fmax(seconds, 0), 1e9));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace stig::cli
