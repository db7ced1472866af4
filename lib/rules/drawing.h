// SPDX-License-Identifier: MIT
// Drawings: neighbourhoods and structures as a file shows them.
//
// A neighbourhood is three slices side by side, above, level and below, symbols
// parted by spaces; * is the site. Cubic rows have 9 symbols:
//
//     . . .   . . .   ? ? ?        y + 1
//     . . .   . * .   ? 3 ?        y
//     . . .   . . .   ? ? ?        y - 1;  x - 1, x, x + 1 in each slice
//
// hexagonal ones 6, 9 and 6 (see neighbourhood.h for the cells):
//
//      . .     . .     . .
//     . 2 .   . * .   . . .
//      . .     . .     . .
//
// A structure is drawn slice by slice from the top down, parted by lines of ---.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/yaml.h"
#include "rules/rule_set.h"

namespace stig::rules {

/// The symbols a file defines, and what they stand for.
class SymbolTable {
 public:
  struct Entry {
    StateSet states;    ///< none: a legend entry that could not be read
    Colour colour = 0;  ///< 0: a legend entry
    bool used = false;
  };

  explicit SymbolTable(int colours) : colours_(colours) {}
  /// False when the symbol is there already.
  bool add(const std::string& symbol, Entry entry);
  const Entry* find(const std::string& symbol) const;
  /// What a symbol of a drawing or list stands for, . ? # = included.
  std::optional<StateSet> states(const std::string& symbol);
  /// Words for the brick with this symbol, which people write in its place.
  void add_name(const std::string& name, const std::string& symbol) { names_[name] = symbol; }
  /// The symbol of the brick that has this name; empty: none has.
  std::string symbol_named(const std::string& name) const;
  /// The defined symbol nearest to a word, for suggestions.
  std::string nearest_to(std::string_view word, bool bricks_only) const;

 private:
  int colours_;
  std::unordered_map<std::string, std::string> names_;
  std::unordered_map<std::string, Entry> entries_;
  std::vector<std::string> order_;
};

/// What reading a drawing needs to know.
struct DrawingContext {
  const YamlDocument& document;
  Lattice lattice;
  bool floor;
  SymbolTable& symbols;
  Diagnostics& diagnostics;
};

/// The pattern, or nothing when something was wrong with it (R201 to R205).
/// `inversion`: the rule holds upside down too, so the floor may show above.
std::optional<Pattern> read_pattern(const YamlNode& node, bool inversion, DrawingContext& context);

/// The bricks, lowest corner at (0, 0, 0), in the order of cells; or nothing.
std::optional<std::vector<PlacedBrick>> read_structure(const YamlNode& node,
                                                       DrawingContext& context);

/// Reports R204 for a symbol that is not defined.
void report_unknown(const SourceRange& range, const std::string& symbol, bool bricks_only,
                    DrawingContext& context);

}  // namespace stig::rules
