// SPDX-License-Identifier: MIT
// Numbers on the command line, strictly: decimal digits and nothing else, no
// overflow, bounds held. Each function returns the words of what is wrong, empty
// when the text is good.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rules/cell.h"
#include "uses.h"

namespace stig::cli {

std::string parse_integer(std::string_view text, std::int64_t low, std::int64_t high,
                          std::int64_t& out);
/// 0 to 2^64 - 1, also written as 0x…: a seed.
std::string parse_seed(std::string_view text, std::uint64_t& out);
/// Seconds, above 0 and up to ten years: "60", "0.5".
std::string parse_seconds(std::string_view text, double& out);
/// A moment, in seconds or in bricks placed: 0 and up to ten years, as "0" or "1.5".
std::string parse_moment(std::string_view text, double& out);
/// So many a second: above 0 and up to a million.
std::string parse_rate(std::string_view text, double& out);
/// "-0.5": digits with at most one point, and a sign; within ±10^9.
std::string parse_number(std::string_view text, double& out);
/// "55", "55mm", "5.5cm", "0.055m" or "2in" in mm; above 0 and up to a km.
std::string parse_length(std::string_view text, std::optional<double>& out);
/// Multiples of what is done by default; more than 0.
std::string parse_effort(std::string_view text, double& out);
/// "X,Y,Z", coordinates within ±kMaxCoordinate.
std::string parse_cell(std::string_view text, Cell& out);
/// One cell or several, parted by spaces or semicolons.
std::string parse_cells(std::string_view text, std::vector<Cell>& out);
/// Sides of a structure, parted by commas: "+x,-y". Each is added, once.
std::string parse_sides(std::string_view text, std::vector<std::string>& out);
/// "X,Y,Z", each 1 to kMaxCoordinate.
std::string parse_size(std::string_view text, Offset& out);

}  // namespace stig::cli
