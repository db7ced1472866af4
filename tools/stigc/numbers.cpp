// SPDX-License-Identifier: MIT
// std::from_chars throughout: it knows no locale, no blanks, and says where it stopped.
#include "numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

namespace stig::cli {
namespace {

/// The whole text as a number of base 10 or 16; a leading '+' is taken too.
template <class Number>
bool parse_whole(std::string_view text, Number& out, int base = 10) {
  // from_chars takes '-', but no '+'.
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, out, base);
  return error == std::errc{} && stop == end;
}

/// Digits with at most one point.
bool parse_decimal(std::string_view text, double& out) {
  // fixed would still take "inf" and "nan".
  const bool plain = text.find_first_not_of("0123456789.") == std::string_view::npos;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, out, std::chars_format::fixed);
  return plain && error == std::errc{} && stop == end;
}

/// An upper bound, so that sums of times stay finite.
constexpr double kTenYears = 3.2e8;  ///< s

/// Three integers parted by commas.
std::string parse_three(std::string_view text, std::int64_t low, std::int64_t high,
                        std::array<std::int32_t, 3>& out) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == 2)) {
      return "three integers parted by commas are wanted, like 1,0,2";
    }
    std::int64_t value = 0;
    const std::string problem = parse_integer(text.substr(0, comma), low, high, value);
    if (!problem.empty()) return problem;
    out[i] = static_cast<std::int32_t>(value);
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return {};
}

}  // namespace

std::string parse_integer(std::string_view text, std::int64_t low, std::int64_t high,
                          std::int64_t& out) {
  assert(low <= high);
  if (!parse_whole(text, out)) {
    const bool digits = text.find_first_not_of("+-0123456789") == std::string_view::npos;
    // 19 digits may be too many for 64 bits: then it is a number, and too large.
    return digits && text.size() > 18 ? fmt::format("'{}' is not within {} to {}", text, low, high)
                                      : fmt::format("'{}' is no integer", text);
  }
  if (out < low || out > high) return fmt::format("{} is not within {} to {}", out, low, high);
  return {};
}

std::string parse_seed(std::string_view text, std::uint64_t& out) {
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (parse_whole(hexadecimal ? text.substr(2) : text, out, hexadecimal ? 16 : 10)) return {};
  return fmt::format("'{}' is no integer within 0 to 2^64 - 1", text);
}

std::string parse_seconds(std::string_view text, double& out) {
  if (!parse_decimal(text, out)) return fmt::format("'{}' is no number of seconds", text);
  if (!(out > 0)) return "more than 0 seconds are needed";
  if (out > kTenYears) return fmt::format("{} seconds are more than ten years", text);
  return {};
}

std::string parse_moment(std::string_view text, double& out) {
  if (!parse_decimal(text, out)) return fmt::format("'{}' is no moment", text);
  return out > kTenYears ? fmt::format("{} is more than ten years", text) : "";
}

std::string parse_rate(std::string_view text, double& out) {
  constexpr double kMost = 1e6;
  if (!parse_decimal(text, out)) return fmt::format("'{}' is no number", text);
  if (!(out > 0) || out > kMost) return fmt::format("{} is not above 0 and up to 1000000", text);
  return {};
}

std::string parse_number(std::string_view text, double& out) {
  constexpr double kMost = 1e9;
  const bool negative = text.starts_with('-');
  if (!parse_decimal(negative ? text.substr(1) : text, out) || out > kMost) {
    return fmt::format("'{}' is no number", text);
  }
  if (negative) out = -out;
  return {};
}

std::string parse_effort(std::string_view text, double& out) {
  constexpr double kMost = 1e6;
  if (!parse_decimal(text, out)) return fmt::format("'{}' is no number", text);
  if (!(out > 0) || out > kMost) return fmt::format("{} is not above 0 and up to 1000000", text);
  return {};
}

std::string parse_cell(std::string_view text, Cell& out) {
  std::array<std::int32_t, 3> xyz{};
  const std::string problem = parse_three(text, -kMaxCoordinate, kMaxCoordinate, xyz);
  out = {xyz[0], xyz[1], xyz[2]};
  return problem;
}

std::string parse_cells(std::string_view text, std::vector<Cell>& out) {
  // Several cells in one argument, or one each: both are typed.
  while (true) {
    const std::size_t begin = text.find_first_not_of("; ");
    if (begin == std::string_view::npos) return {};
    text.remove_prefix(begin);
    const std::size_t end = std::min(text.find_first_of("; "), text.size());
    Cell cell;
    std::string problem = parse_cell(text.substr(0, end), cell);
    if (!problem.empty()) return problem;
    out.push_back(cell);
    text.remove_prefix(end);
  }
}

std::string parse_sides(std::string_view text, std::vector<std::string>& out) {
  static constexpr std::string_view kSides[] = {"+x", "-x", "+y", "-y"};
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string side(text.substr(0, comma));
    if (std::find(std::begin(kSides), std::end(kSides), side) == std::end(kSides)) {
      return fmt::format("'{}' is not one of {}", side, fmt::join(kSides, ", "));
    }
    if (std::find(out.begin(), out.end(), side) != out.end()) {
      return fmt::format("{} is given twice", side);
    }
    out.push_back(side);
    if (comma == std::string_view::npos) return {};
    text.remove_prefix(comma + 1);
  }
}

std::string parse_size(std::string_view text, Offset& out) {
  std::array<std::int32_t, 3> xyz{};
  const std::string problem = parse_three(text, 1, kMaxCoordinate, xyz);
  out = {xyz[0], xyz[1], xyz[2]};
  return problem;
}

std::string parse_length(std::string_view text, std::optional<double>& out) {
  struct Unit {
    std::string_view name;
    double mm;
  };
  // Longer names first: each of these ends in m or n.
  constexpr std::array<Unit, 5> kUnits{{{"mm", 1}, {"cm", 10}, {"in", 25.4}, {"m", 1000}, {"", 1}}};
  for (const Unit& unit : kUnits) {
    if (!text.ends_with(unit.name)) continue;
    double number = 0;
    const std::string_view digits = text.substr(0, text.size() - unit.name.size());
    if (!parse_decimal(digits, number) || !(number > 0) || number * unit.mm > 1e6) break;
    out = number * unit.mm;
    return {};
  }
  return fmt::format("'{}' is no length like 55mm, 5.5cm, 0.055m or 2in, above 0 and up to 1000m",
                     text);
}

}  // namespace stig::cli
