// SPDX-License-Identifier: MIT
// The inverse of the readers (plain_reader.cpp, palette_reader.cpp, drawing.cpp): whatever is
// written here is read back as the same value. Texts are the shortest that do that, so that two
// equal rule sets print the same bytes.
#include "rules/value_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/yaml.h"
#include "rules/pattern_text.h"
#include "rules/rule_printer.h"

namespace stig::rules {

std::string ValueTexts::text(const std::string& value, const FormKey& key, bool in_line) const {
  if (key.kind == FormKind::colour) return "\"" + value + "\"";
  return key.kind == FormKind::choice ? value : yaml_text(value, in_line);
}

std::string ValueTexts::text(bool value, const FormKey& key, bool /*in_line*/) const {
  assert(key.kind != FormKind::choice || key.words.size() == 2);
  if (key.kind == FormKind::choice) return std::string(key.words[value ? 0 : 1]);
  return value ? "true" : "false";
}

std::string ValueTexts::text(Colour value, const FormKey& /*key*/, bool in_line) const {
  assert(value >= 1 && value <= rules_.colours());
  return yaml_text(rules_.brick(value).symbol, in_line);
}

std::string ValueTexts::text(std::int64_t value, const FormKey& /*key*/, bool /*in_line*/) const {
  return fmt::to_string(value);
}

// The shortest decimal number that is read back as the same double, on every platform.
std::string ValueTexts::text(double value, const FormKey& /*key*/, bool /*in_line*/) const {
  return fmt::to_string(value);
}

std::string ValueTexts::text(Offset value, const FormKey& /*key*/, bool /*in_line*/) const {
  return fmt::format("[{}, {}, {}]", value.x, value.y, value.z);
}

std::string ValueTexts::text(Cell value, const FormKey& key, bool in_line) const {
  return text(value - Cell{}, key, in_line);
}

std::string ValueTexts::text(StateSet value, const FormKey& /*key*/, bool /*in_line*/) const {
  return state_list(value, true);
}

// Hexagonal drawings begin with spaces, from which YAML would guess a wrong indentation.
std::string ValueTexts::text(const Pattern& /*value*/, const FormKey& /*key*/,
                             bool /*in_line*/) const {
  return rules_.lattice == Lattice::hexagonal ? "|2" : "|";
}

std::string ValueTexts::text(const std::vector<PlacedBrick>& /*value*/, const FormKey& /*key*/,
                             bool /*in_line*/) const {
  return "|";
}

std::string ValueTexts::text(const std::vector<std::string>& words, const FormKey& /*key*/,
                             bool /*in_line*/) const {
  return fmt::format("[{}]", fmt::join(words, ", "));
}

std::string ValueTexts::text(const std::map<int, std::int64_t>& value, const FormKey& /*key*/,
                             bool /*in_line*/) const {
  std::vector<std::string> pairs;
  for (const auto& [stage, number] : value) pairs.push_back(fmt::format("{}: {}", stage, number));
  return fmt::format("{{{}}}", fmt::join(pairs, ", "));
}

std::string ValueTexts::state_list(StateSet states, bool by_legend) const {
  const auto symbol = find_symbol(rules_, states);
  const bool is_legend = std::any_of(rules_.legend.begin(), rules_.legend.end(),
                                     [&](const auto& entry) { return entry.symbol == symbol; });
  if (symbol && (by_legend || !is_legend)) return "[" + yaml_text(*symbol, true) + "]";
  std::string out;
  const auto add = [&](std::string_view text) {
    out += (out.empty() ? "" : ", ") + yaml_text(text, true);
  };
  if (states.contains(kEmpty)) add(".");
  for (Colour c = 1; c <= rules_.colours(); ++c) {
    if (states.contains(c)) add(rules_.brick(c).symbol);
  }
  if (states.contains(kFloor)) add("=");
  return "[" + out + "]";
}

std::string ValueTexts::in_braces(const std::vector<KeyText>& keys) {
  std::vector<std::string> pairs;
  for (const KeyText& key : keys) pairs.push_back(key.key + ": " + key.text);
  return fmt::format("{{{}}}", fmt::join(pairs, ", "));
}

std::vector<KeyText> ValueTexts::in_order(std::map<std::string, KeyText>& written,
                                          const Form& form) {
  std::vector<KeyText> out;
  const auto take = [&](const std::string& path) {
    const auto found = written.find(path);
    if (found == written.end()) return false;
    out.push_back(std::move(found->second));
    return true;
  };
  for (const FormKey& key : form.keys) {
    const std::string name(key.name);
    if (take(name) || key.kind != FormKind::form) continue;
    const std::size_t before = out.size();
    for (const FormKey& part : key.form->keys) {
      take(name + "/" + std::string(part.name));
    }
    if (out.size() == before) continue;
    const auto inner = out.begin() + static_cast<std::ptrdiff_t>(before);
    std::string text = in_braces({inner, out.end()});
    out.erase(inner, out.end());
    out.push_back({name, std::move(text), {}});
  }
  return out;
}

std::string ValueTexts::rows(const Pattern& pattern) const { return draw_pattern(rules_, pattern); }

std::string ValueTexts::rows(const std::vector<PlacedBrick>& structure) const {
  return structure.empty() ? std::string() : draw_structure(rules_, structure);
}

}  // namespace stig::rules
