// SPDX-License-Identifier: MIT
// The report of a validation as one HTML file that needs nothing else: the verdict, the runs
// themselves or pictures of them, the curve, what robots' time went into, bricks as they stand,
// attempts, what went wrong.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validate/uses.h"
#include "validate/work_summary.h"

namespace stig::validate {

/// Runs that can be played in the report, ready to be put into it; lib/view makes such.
struct ReportPlayer {
  std::string script;    ///< as a content security policy names it
  std::string style;     ///< of the player
  std::string body;      ///< markup, with the data of runs
  std::size_t runs = 0;  ///< of the report, from the first on, that it shows
};

struct ValidationReport {
  const BuildTarget* target = nullptr;
  std::string decision;                     ///< the robots' decisions in words; empty: not known
  std::string robots;                       ///< how many may work at once, likewise
  std::vector<Trial> trials;                ///< one a run, by seed
  const CompiledRules* compiled = nullptr;  ///< null: what sites are open is not known
  std::optional<ReportPlayer> player{};     ///< without one: pictures of the trials
  std::string no_player{};                  ///< why there is none, a sentence; empty: unsaid
};

/// Did every run build the right structure, in an order that the rules allow?
bool all_complete(const ValidationReport& report);
/// "complete in 9 of 10 runs".
std::string verdict_text(const ValidationReport& report);
std::vector<ProgressCurve> curves_of(const ValidationReport& report);

std::string report_html(const ValidationReport& report);

}  // namespace stig::validate
