// SPDX-License-Identifier: MIT
// A line is a run's bytes, packed, as hexadecimal digits: a few kilobytes.
#include "trial_journal.h"

#include <fmt/format.h>

#include <optional>

#include "base/file_io.h"
#include "base/hash.h"
#include "base/packed.h"
#include "validate/trial_bytes.h"

namespace stig::cli {
namespace {

constexpr std::string_view kDigits = "0123456789abcdef";
constexpr std::size_t kMostTrialBytes = std::size_t{1} << 26;

std::string in_digits(std::string_view bytes) {
  std::string out;
  out.reserve(2 * bytes.size());
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    out += kDigits[byte >> 4U];
    out += kDigits[byte & 15U];
  }
  return out;
}

std::optional<std::string> of_digits(std::string_view digits) {
  std::string out;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    const std::size_t high = kDigits.find(digits[i]), low = kDigits.find(digits[i + 1]);
    if (high == kDigits.npos || low == kDigits.npos) return std::nullopt;
    out += static_cast<char>(high << 4U | low);
  }
  return digits.size() % 2 == 0 ? std::optional(out) : std::nullopt;
}

}  // namespace

bool TrialJournal::open(const std::string& folder, std::uint64_t work, const App& app) {
  const auto take = [this](std::string_view line) {
    const auto packed = of_digits(line);
    const auto bytes = packed ? unpacked(*packed, kMostTrialBytes) : std::nullopt;
    auto trial = bytes ? trial_of(*bytes) : std::nullopt;
    if (!trial) return false;
    const std::uint64_t seed = trial->seed;
    return earlier_.emplace(seed, std::move(*trial)).second;
  };
  FileError error;
  const std::string words = fmt::format("stigc {} validate, {}", STIG_VERSION, to_hex(work));
  if (!journal_.open(folder + "/" + kTrialJournal, words, take, error)) {
    app.complain(error.message);
    return false;
  }
  if (!earlier_.empty()) app.say(fmt::format("going on after {} runs", earlier_.size()));
  return true;
}

bool TrialJournal::add(const Trial& trial, const App& app) {
  const std::string line = in_digits(packed(trial_bytes(trial)));
  const std::lock_guard lock(mutex_);
  FileError error;
  if (journal_.append(line, error)) return true;
  app.complain(error.message);
  return false;
}

}  // namespace stig::cli
