// SPDX-License-Identifier: MIT
// Runs, structures and measures as JSON objects and as lines for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lattice/measures.h"
#include "lattice/swarm.h"
#include "rules/rule_set.h"
#include "uses.h"

namespace stig::cli {

using Json = nlohmann::ordered_json;

/// Indented by two, lists of plain values in one line, a newline at the end; bytes that
/// are no UTF-8 are replaced.
std::string dump(const Json& json);

Json to_json(Cell cell);
Json to_json(Offset offset);
Json to_json(const std::optional<Box>& box);
Json to_json(const Measures& measures);
/// Brick symbol -> number of bricks, every brick of the set in its order.
Json colours_json(const Measures& measures, const std::vector<Brick>& bricks);

/// What all runs of one call share: rule set, seed, box, motion, agents.
Json setting_json(const RuleSet& rules, const SwarmConfig& config);
/// One run: setting, steps, deposits, bricks, terminated, hash, colours, rules, measures.
Json run_json(const RuleSet& rules, const SwarmConfig& config, const SwarmResult& result);

/// A label of fixed width and a text, one line.
std::string line(std::string_view label, std::string_view text);
/// The lines on a structure: bricks by colour, size, measures, hash.
std::string structure_lines(const Structure& structure, const std::vector<Brick>& bricks);
/// The lines on a run, structure included, and a table of the rules.
std::string run_lines(const RuleSet& rules, const SwarmConfig& config, const SwarmResult& result,
                      bool color);
/// The lines on what all runs share.
std::string setting_lines(const RuleSet& rules, const SwarmConfig& config, bool color);

std::string to_text(Offset size);  ///< "20×20×20"
/// The drawing, when it is small enough to be looked at; otherwise empty.
std::string small_drawing(const Structure& structure, const std::vector<Brick>& bricks);

}  // namespace stig::cli
