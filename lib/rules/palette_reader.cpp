// SPDX-License-Identifier: MIT
// Bricks get their colours by their order in the file, from 1 on; 0 is the empty cell (state.h).
// Symbols that cannot be read are kept as known ones wherever that is possible: one mistake in
// the palette would otherwise be reported again at every drawing that uses it.
#include "rules/palette_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace stig::rules {

void check_unique(SeenNames& names, const std::string& name, const SourceRange& range,
                  std::string_view what, Diagnostics& diagnostics) {
  if (name.empty()) return;
  const auto [first, added] = names.emplace(name, range);
  if (added) return;
  diagnostics.add(Code::R208, range, fmt::format("a second {} named {}", what, in_quotes(name)))
      .note(first->second, "the first one");
}

void PaletteReader::read_bricks(const YamlNode* node) {
  known_ = node != nullptr && node->kind == YamlKind::mapping && !node->pairs.empty() &&
           node->pairs.size() <= static_cast<std::size_t>(kMaxColours);
  if (!known_) return;
  SeenNames names;
  for (const YamlPair& pair : node->pairs) {
    if (!plain_.is_good(pair.key)) {
      known_ = known_ && pair.key.kind == YamlKind::scalar;
      continue;
    }
    // Colour and position in `bricks` must agree, so a symbol that is refused takes no number.
    const auto colour = static_cast<Colour>(rules_.bricks.size() + 1);
    if (!symbols_.add(pair.key.text, {StateSet::of(colour), colour, true})) continue;
    rules_.bricks.push_back(read_brick(pair));
    const Brick& brick = rules_.bricks.back();
    symbols_.add_name(brick.name, pair.key.text);
    check_unique(names, brick.name, brick.range, "brick", context_.diagnostics);
  }
}

Brick PaletteReader::read_brick(const YamlPair& pair) const {
  Brick brick;
  plain_.read(pair.value, brick_form(), brick);
  brick.symbol = pair.key.text;
  if (brick.name.empty()) brick.name = brick.symbol;
  // Lower case is the canonical form; the hash leaves colours of pictures out.
  std::transform(brick.color.begin(), brick.color.end(), brick.color.begin(),
                 [](char c) { return c >= 'A' && c <= 'F' ? static_cast<char>(c + 32) : c; });
  brick.range = context_.document.range(pair.key);
  return brick;
}

void PaletteReader::read_legend(const YamlNode* node) {
  if (node == nullptr) return;
  for (const YamlPair& pair : node->pairs) {
    const SourceRange range = context_.document.range(pair.key);
    if (!plain_.is_good(pair.key)) continue;
    const auto found = plain_.is_good(pair.value) ? states(pair.value, true) : std::nullopt;
    if (const Brick* brick = brick_of(pair.key.text)) {
      context_.diagnostics
          .add(Code::R206, range,
               fmt::format("the symbol {} is a brick's", in_quotes(brick->symbol)))
          .note(brick->range, "the brick");
      continue;
    }
    // A symbol that could not be read is known all the same, to name errors once.
    if (!symbols_.add(pair.key.text, {found.value_or(StateSet()), 0, false})) continue;
    if (found) rules_.legend.push_back({pair.key.text, *found, range});
  }
  // A copy, since the rule set is moved out before unused entries are reported.
  legend_ = rules_.legend;
}

const Brick* PaletteReader::brick_of(const std::string& symbol) const {
  const SymbolTable::Entry* entry = symbols_.find(symbol);
  return entry == nullptr || entry->colour == 0 ? nullptr : &rules_.brick(entry->colour);
}

std::optional<StateSet> PaletteReader::states(const YamlNode& list, bool in_legend) {
  StateSet all;
  bool sound = true;
  for (const YamlNode& item : list.items) {
    const SymbolTable::Entry* entry = symbols_.find(item.text);
    // "*" marks the site in drawings and stands for no states. Within the legend other entries
    // are refused, or entries would depend on their order.
    const bool refused = item.text == "*" || (in_legend && entry != nullptr && entry->colour == 0);
    const auto found = refused ? std::nullopt : symbols_.states(item.text);
    if (!found) unknown_symbol(item, in_legend);
    sound = sound && found && !found->none();
    all = all | found.value_or(StateSet());
  }
  return sound ? std::optional(all) : std::nullopt;
}

std::optional<Colour> PaletteReader::brick_symbol(const YamlNode& node) {
  const SymbolTable::Entry* entry = symbols_.find(node.text);
  if (entry != nullptr && entry->colour != 0) return entry->colour;
  unknown_symbol(node, true);
  return std::nullopt;
}

void PaletteReader::unknown_symbol(const YamlNode& node, bool bricks_only) {
  if (known_) report_unknown(context_.document.range(node), node.text, bricks_only, context_);
}

void PaletteReader::report_unused_legend() const {
  for (const LegendEntry& entry : legend_) {
    if (symbols_.find(entry.symbol)->used) continue;
    context_.diagnostics.add(Code::R313, entry.range,
                             fmt::format("nothing uses the symbol {}", in_quotes(entry.symbol)));
  }
}

}  // namespace stig::rules
