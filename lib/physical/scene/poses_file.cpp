// SPDX-License-Identifier: MIT
// Six numbers a line, as spreadsheets write them; numbers by std::from_chars, which knows no
// locale. A first line of column names is taken for what it is, anything else that is no row is an
// error: a pose that is passed over in silence would be missing.
#include "physical/scene/poses_file.h"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <charconv>
#include <string_view>
#include <utility>

#include "base/degree.h"

namespace stig::physics {

namespace {

constexpr double kFarthest = 1e6;  ///< m or degrees: beyond, it is no pose of anything here

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Exactly six numbers, or nothing.
std::optional<std::array<double, 6>> row_of(std::string_view line) {
  std::array<double, 6> row{};
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::size_t comma = line.find(',');
    // The last field has no comma behind it, all others have.
    if ((comma == std::string_view::npos) != (i + 1 == row.size())) return std::nullopt;
    const std::string_view field = trimmed(line.substr(0, comma));
    const char* end = field.data() + field.size();
    const auto [at, error] = std::from_chars(field.data(), end, row[i]);
    // Written so that NaN fails.
    if (error != std::errc() || at != end || !(std::abs(row[i]) <= kFarthest)) return std::nullopt;
    if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
  }
  return row;
}

/// Nothing to read, or a comment.
bool is_idle(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || text.front() == '#';
}

/// Words alone: a line with a digit in it is a row gone wrong.
bool is_header(std::string_view line) {
  return line.find_first_of("0123456789") == std::string_view::npos;
}

SourceRange range_of_line(const SourceRef& source, std::size_t number) {
  const std::size_t begin = source->line_start(number);
  return {source, static_cast<std::uint32_t>(begin),
          static_cast<std::uint32_t>(begin + source->line(number).size())};
}

}  // namespace

Quat turned(const Vec3& degrees_zyx) {
  const Vec3 a = degrees_zyx * kDegree;
  // Intrinsic turns, so that factors stand in the order in which they are made.
  return normalised(rotation({0, 0, a.x}) * rotation({0, a.y, 0}) * rotation({a.z, 0, 0}));
}

std::optional<std::vector<Pose>> read_poses_file(SourceRef source, Diagnostics& diagnostics) {
  assert(source != nullptr);
  std::vector<Pose> poses;
  bool first = true;
  for (std::size_t number = 1; number <= source->line_count(); ++number) {
    const std::string_view line = source->line(number);
    if (is_idle(line)) continue;
    const bool may_name_columns = std::exchange(first, false);
    const auto row = row_of(line);
    // The limit is checked where the row is good, for a message of its own.
    if (row && poses.size() < kMostPoses) {
      const auto& [x, y, z, rz, ry, rx] = *row;
      poses.push_back({{x, y, z}, turned({rz, ry, rx})});
    } else if (row || !may_name_columns || !is_header(line)) {
      diagnostics.add(Code::S607, range_of_line(source, number),
                      row ? fmt::format("there are more than {} poses", kMostPoses)
                          : "this line is not six numbers x,y,z,rz,ry,rx");
      return std::nullopt;
    }
  }
  if (!poses.empty()) return poses;
  diagnostics.add(Code::S607, {source, 0, 0}, "there is no pose in this file");
  return std::nullopt;
}

}  // namespace stig::physics
