// SPDX-License-Identifier: MIT
#include "base/source.h"

#include <algorithm>

#include "base/text.h"

namespace stig {

/// Line starts are found once; a position is then a binary search.
SourceFile::SourceFile(std::string path, std::string text)
    : path_(std::move(path)), text_(std::move(text)) {
  if (!text_.empty()) line_starts_.push_back(0);
  // A newline at the very end begins no further line.
  for (std::size_t i = 0; i + 1 < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
  }
}

std::string_view SourceFile::line(std::size_t number) const {
  if (number == 0 || number > line_starts_.size()) return {};
  const std::size_t begin = line_starts_[number - 1];
  std::size_t end = line_start(number + 1);
  // A line end is no part of its line, be it that of Windows or the usual one.
  if (end > begin && text_[end - 1] == '\n') --end;
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

SourceFile::Position SourceFile::position(std::size_t offset) const {
  if (line_starts_.empty()) return {};
  offset = std::min(offset, text_.size());
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto number = static_cast<std::size_t>(next - line_starts_.begin());
  const std::size_t begin = line_starts_[number - 1];
  // Columns count code points, as editors do, so the line up to the offset has to be
  // decoded.
  const std::string_view before = std::string_view(text_).substr(begin, offset - begin);
  return {number, 1 + count_code_points(before)};
}

/// Past the last line this is the end of the text, so that ranges can be closed.
std::size_t SourceFile::line_start(std::size_t number) const {
  if (number == 0) return 0;
  return number <= line_starts_.size() ? line_starts_[number - 1] : text_.size();
}

}  // namespace stig
