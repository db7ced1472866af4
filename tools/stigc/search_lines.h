// SPDX-License-Identifier: MIT
// Candidates on their way to other processes and back, some to a line of JSON: there their numbers
// and genomes, back all that was measured. Numbers come back as they were, to the last bit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "search/find_archive.h"
#include "uses.h"

namespace stig::cli {

/// Candidates of a line: a few, since who measures them needs memory that takes time to get.
inline constexpr std::size_t kCandidatesOfLine = 8;

std::vector<std::string> candidate_lines(const std::vector<search::Individual>& made);
/// The candidates that a line names; none where it is none of these.
std::vector<search::Individual> read_candidate_line(const std::string& line);

std::string measured_line(const std::vector<search::Individual>& measured);
/// Adds what was measured to the candidates of these numbers, which rise by one in `made`. How
/// many there were; nothing where the line is none of theirs.
std::optional<std::size_t> read_measured_line(const std::string& line,
                                              std::vector<search::Individual>& made);

}  // namespace stig::cli
