// SPDX-License-Identifier: MIT
// Diagnostics: what is wrong with what a user wrote, as data until the edge.
//
// Readers and checks report every problem they find to a Diagnostics sink and
// go on; the program renders the sink once, as text in the manner of clang and
// rustc or as JSON. Codes are stable and listed once, in diagnostics.def, from
// which docs/diagnostics.md is generated too.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/source.h"

namespace stig {

enum class Severity { error, warning };

/// One enumerator a line of diagnostics.def, for example Code::R101.
enum class Code {
#define STIG_DIAGNOSTIC(code, severity, slug, explanation) code,
#include "base/diagnostics.def"
#undef STIG_DIAGNOSTIC
};

/// What diagnostics.def says of a code.
struct CodeInfo {
  Code code;
  std::string_view name;  ///< "R101"
  Severity severity;
  std::string_view slug;         ///< "unknown-key"
  std::string_view explanation;  ///< one paragraph: why it matters, what to do
};
const std::vector<CodeInfo>& all_codes();
const CodeInfo& info(Code code);

/// A pointer to the other place involved, or a word of help when it has no range.
struct Note {
  SourceRange range;
  std::string message;
};

struct Diagnostic {
  Code code;
  Severity severity;
  SourceRange range;
  std::string message;     ///< one line, no full stop, names quoted 'so'
  std::string suggestion;  ///< replacement text for the range; empty: none near
  std::vector<Note> notes;

  Diagnostic& note(SourceRange where, std::string text);
  Diagnostic& note(std::string text) { return note({}, std::move(text)); }
  Diagnostic& suggest(std::string replacement);
};

/// The sink. Keeps diagnostics in the order reported; renderers sort by place.
/// Past kMostKept they are counted alone, so that no input fills the memory.
class Diagnostics {
 public:
  static constexpr std::size_t kMostKept = 1000;

  /// The reference stays valid until the next add.
  Diagnostic& add(Code code, SourceRange range, std::string message);
  void append(const Diagnostics& other);

  const std::vector<Diagnostic>& all() const { return all_; }
  /// The error reported last of those that are kept, for notes that are thought of afterwards; null
  /// without one. Valid until the next add.
  Diagnostic* last_error();
  /// No more are kept: suggestions and the like need not be thought of.
  bool full() const { return all_.size() >= kMostKept; }
  bool has_errors() const { return errors_ > 0; }
  std::size_t count(Severity severity) const {
    return severity == Severity::error ? errors_ : warnings_;
  }

 private:
  std::vector<Diagnostic> all_;
  Diagnostic spare_{};
  std::size_t errors_ = 0, warnings_ = 0;
};

struct TextStyle {
  bool color = false;
  std::size_t most = 100;  ///< further diagnostics are counted, not shown
};

/// `path:line:col: error[R101]: what`, the source line, a caret, notes; ends in
/// a summary line ("2 errors, 1 warning") when there was anything to say.
std::string to_text(const Diagnostics& diagnostics, const TextStyle& style = {});
/// The same as a JSON array of objects (code, slug, severity, path, line,
/// column, end_line, end_column, message, suggestion, notes).
std::string to_json(const Diagnostics& diagnostics);

/// Pointers into the sink by path, then place; those of no file come first.
std::vector<const Diagnostic*> sorted_by_place(const Diagnostics& diagnostics);

/// Edits (insert, remove, change, swap neighbours) from a to b; when more than
/// `most` are needed, some number greater than `most`.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most);
/// The candidate nearest to `word` by edit distance, if near enough to suggest.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace stig
