// SPDX-License-Identifier: MIT
// The sink and its rendering as JSON. Codes, severities and explanations come from one
// list (diagnostics.def), expanded here into a table; an enumerator's value is its index in
// it. Suggestions use the edit distance of F. Damerau (1964) in its restricted form, in
// which no part is edited twice.
#include "base/diagnostic.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <numeric>

#include "base/text.h"

namespace stig {

const std::vector<CodeInfo>& all_codes() {
  static const std::vector<CodeInfo> codes = {
#define STIG_DIAGNOSTIC(code, severity, slug, explanation) \
  {Code::code, #code, Severity::severity, slug, explanation},
#include "base/diagnostics.def"
#undef STIG_DIAGNOSTIC
  };
  return codes;
}

/// The assertion ties the order of the enumeration to that of the table.
const CodeInfo& info(Code code) {
  const auto index = static_cast<std::size_t>(code);
  assert(index < all_codes().size() && all_codes()[index].code == code);
  return all_codes()[index];
}

Diagnostic& Diagnostic::note(SourceRange where, std::string text) {
  notes.push_back({std::move(where), std::move(text)});
  return *this;
}

Diagnostic& Diagnostic::suggest(std::string replacement) {
  suggestion = std::move(replacement);
  return *this;
}

Diagnostic& Diagnostics::add(Code code, SourceRange range, std::string message) {
  const Severity severity = info(code).severity;
  ++(severity == Severity::error ? errors_ : warnings_);
  Diagnostic diagnostic{code, severity, std::move(range), std::move(message), {}, {}};
  // Past the limit a diagnostic is built all the same and thrown away, so that callers can
  // add notes to it without asking.
  if (all_.size() >= kMostKept) return spare_ = std::move(diagnostic);
  return all_.emplace_back(std::move(diagnostic));
}

void Diagnostics::append(const Diagnostics& other) {
  const std::size_t room = kMostKept - std::min(kMostKept, all_.size());
  const auto taken = static_cast<std::ptrdiff_t>(std::min(room, other.all_.size()));
  all_.insert(all_.end(), other.all_.begin(), other.all_.begin() + taken);
  errors_ += other.errors_;
  warnings_ += other.warnings_;
}

Diagnostic* Diagnostics::last_error() {
  const auto found = std::find_if(all_.rbegin(), all_.rend(), [](const Diagnostic& one) {
    return one.severity == Severity::error;
  });
  return found == all_.rend() ? nullptr : &*found;
}

/// Stable: diagnostics of one place keep the order in which they were found. Those
/// without a place come first.
std::vector<const Diagnostic*> sorted_by_place(const Diagnostics& diagnostics) {
  std::vector<const Diagnostic*> sorted;
  for (const Diagnostic& d : diagnostics.all()) sorted.push_back(&d);
  const auto before = [](const Diagnostic* a, const Diagnostic* b) {
    const std::string_view a_path = a->range ? a->range.file->path() : std::string_view();
    const std::string_view b_path = b->range ? b->range.file->path() : std::string_view();
    return std::tie(a_path, a->range.begin) < std::tie(b_path, b->range.begin);
  };
  std::stable_sort(sorted.begin(), sorted.end(), before);
  return sorted;
}

namespace {

void put_place(nlohmann::ordered_json& out, const SourceRange& range) {
  if (!range) {
    for (const char* key : {"path", "line", "column", "end_line", "end_column"}) out[key] = nullptr;
    return;
  }
  const auto begin = range.file->position(range.begin);
  const auto end = range.file->position(range.end);
  out["path"] = range.file->path();
  out["line"] = begin.line;
  out["column"] = begin.column;
  out["end_line"] = end.line;
  out["end_column"] = end.column;
}

nlohmann::ordered_json as_json(const Diagnostic& diagnostic) {
  nlohmann::ordered_json out;
  out["code"] = info(diagnostic.code).name;
  out["slug"] = info(diagnostic.code).slug;
  out["severity"] = diagnostic.severity == Severity::error ? "error" : "warning";
  put_place(out, diagnostic.range);
  out["message"] = diagnostic.message;
  out["suggestion"] = diagnostic.suggestion;
  out["notes"] = nlohmann::ordered_json::array();
  for (const Note& note : diagnostic.notes) {
    nlohmann::ordered_json entry;
    put_place(entry, note.range);
    entry["message"] = note.message;
    out["notes"].push_back(std::move(entry));
  }
  return out;
}

}  // namespace

/// Editors and CI read this form; its keys are part of the program's interface.
std::string to_json(const Diagnostics& diagnostics) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const Diagnostic* d : sorted_by_place(diagnostics)) out.push_back(as_json(*d));
  // A path need not be UTF-8, JSON must be.
  return out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// Rows are cut off as soon as all their entries exceed `most`, so a comparison of unlike
/// words costs little.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > most) return most + 1;
  // Two rows back is enough for swapped neighbours (optimal string alignment).
  std::vector<std::size_t> before(a.size() + 1), last(a.size() + 1), row(a.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t j = 1; j <= b.size(); ++j) {
    row[0] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
      const std::size_t change = last[i - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[i] = std::min({last[i] + 1, row[i - 1] + 1, change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[i] = std::min(row[i], before[i - 2] + 1);
    }
    if (*std::min_element(row.begin(), row.end()) > most) return most + 1;
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[a.size()];
}

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
  // Long words are hardly misspelt keys, and comparing them with every key would be
  // quadratic in hostile input.
  if (word.empty() || word.size() > 64) return {};
  // One slip in a word of two or three letters, one more for every three letters.
  std::size_t best = word.size() < 2 ? 0 : 1 + (word.size() - 1) / 3;
  std::string_view found;
  for (const std::string_view candidate : candidates) {
    // A word that shares nothing with the candidate is not near, however short.
    const std::size_t room = std::min(best, candidate.empty() ? 0 : candidate.size() - 1);
    const std::size_t distance = edit_distance(word, candidate, room);
    if (distance > room || distance == 0) continue;
    if (found.empty() || distance < best) found = candidate;
    best = std::min(best, distance);
  }
  return found;
}

}  // namespace stig
