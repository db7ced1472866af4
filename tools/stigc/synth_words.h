// SPDX-License-Identifier: MIT
// What synth says and does in the same way with robots and without.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app.h"
#include "uses.h"

namespace stig::cli {

/// What a rule set of synth says of itself, and then of what it was compiled.
inline constexpr std::string_view kMadeBySynth = "compiled by stigc synth";

/// Do the rules go into a file? Otherwise to standard output, where there is no JSON.
bool has_file(const SynthOptions& options);

/// "tower", of "models/tower.vox": what a rule set may be called.
std::string set_name(const std::string& path);

/// Why the result of a search that was cut short is not the one that the effort gives.
std::string_view ended_early();
/// The same as the "verdict" of --json.
std::string_view early_verdict();

/// Writes one file and remembers it; returns an exit code.
int write_one(const std::string& path, const std::string& bytes, const App& app,
              std::vector<std::string>& written);

}  // namespace stig::cli
