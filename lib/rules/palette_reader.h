// SPDX-License-Identifier: MIT
// Reading the palette of a rule set, its bricks and its legend, and what stands for some of
// them elsewhere: symbols, and lists of symbols.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "rules/drawing.h"
#include "rules/plain_reader.h"

namespace stig::rules {

/// Names that must be unique, with the place of their first use.
using SeenNames = std::unordered_map<std::string, SourceRange>;

/// Reports R208 for a name that has been seen, if it is not empty.
void check_unique(SeenNames& names, const std::string& name, const SourceRange& range,
                  std::string_view what, Diagnostics& diagnostics);

/// Fills in `bricks` and `legend` of a rule set. All that it is made of must outlive it.
class PaletteReader {
 public:
  /// `context` has the lattice and the floor later than this, and the symbols from here.
  PaletteReader(const PlainReader& plain, SymbolTable& symbols, DrawingContext& context,
                RuleSet& rules)
      : plain_(plain), symbols_(symbols), context_(context), rules_(rules) {}

  void read_bricks(const YamlNode* node);
  void read_legend(const YamlNode* node);
  /// Are there bricks by which symbols can be judged?
  bool known() const { return known_; }

  /// The states of a list of symbols; of bricks' symbols alone within the legend, so that
  /// entries do not depend on each other's order. Nothing, and R204, when one is unknown.
  std::optional<StateSet> states(const YamlNode& list, bool in_legend);
  std::optional<Colour> brick_symbol(const YamlNode& node);

  /// R313 for legend symbols that nothing uses. Call when everything else has been read.
  void report_unused_legend() const;

 private:
  Brick read_brick(const YamlPair& pair) const;
  /// The brick with this symbol, or nullptr.
  const Brick* brick_of(const std::string& symbol) const;
  void unknown_symbol(const YamlNode& node, bool bricks_only);

  const PlainReader& plain_;
  SymbolTable& symbols_;
  DrawingContext& context_;
  RuleSet& rules_;
  std::vector<LegendEntry> legend_;
  bool known_ = false;
};

}  // namespace stig::rules
