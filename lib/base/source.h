// SPDX-License-Identifier: MIT
// Source text and places in it.
//
// Every object that a user wrote keeps its SourceRange, so that anything said
// about it later, by any layer, can point at the line it came from.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace stig {

/// A text with the name it is reported under. Immutable once made.
class SourceFile {
 public:
  SourceFile(std::string path, std::string text);

  const std::string& path() const { return path_; }
  const std::string& text() const { return text_; }

  /// Number of lines; a text that ends in a newline has no line after it.
  std::size_t line_count() const { return line_starts_.size(); }
  /// The text of a line, 1-based, without its line end. Empty when out of range.
  std::string_view line(std::size_t number) const;

  struct Position {
    std::size_t line = 1;    ///< 1-based
    std::size_t column = 1;  ///< 1-based, in Unicode code points
  };
  /// Where a byte offset lies; offsets past the end count as the end.
  Position position(std::size_t offset) const;
  /// Byte offset at which a 1-based line starts (end of text when past the last).
  std::size_t line_start(std::size_t number) const;

 private:
  std::string path_;
  std::string text_;
  std::vector<std::size_t> line_starts_;
};

using SourceRef = std::shared_ptr<const SourceFile>;

/// Half-open range of bytes [begin, end) of one file; no file: not from a text.
struct SourceRange {
  SourceRef file;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  explicit operator bool() const { return file != nullptr; }
};

}  // namespace stig
