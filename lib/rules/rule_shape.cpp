// SPDX-License-Identifier: MIT
// Holding a file to the table of rule_schema.h: diagnostics R1xx.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/node_checks.h"
#include "base/text.h"
#include "rules/rule_schema.h"
#include "rules/state.h"

namespace stig {

namespace {

/// Stages, heights and counts are whole numbers; only probabilities and weights are not.
NumberBounds bounds_of(const KeySchema& key) {
  return {key.low, key.high, key.above_low, key.kind != ValueKind::number};
}

/// Walks nodes beside the table. Every check returns whether the node is sound and
/// marks it when it is not, and so does every node around it.
class ShapeChecker : public NodeChecks {
 public:
  using NodeChecks::NodeChecks;

  bool check_object(const YamlNode& node, ObjectKind kind) {
    const ObjectSchema& schema = object_schema(kind);
    if (node.kind != YamlKind::mapping) {
      return wrong(node, fmt::format("{} like {}", with_article(schema.title), schema.example));
    }
    return check_keys(
        node, schema.title, schema.keys,
        [&](const YamlNode& value, const KeySchema& key) { return check_value(value, key); });
  }

 private:
  // The two switches cover ValueKind between them; they are apart so that each stays
  // readable.
  bool check_value(const YamlNode& node, const KeySchema& key) {
    switch (key.kind) {
      case ValueKind::text:
        return expect(node, YamlKind::scalar, "a text");
      case ValueKind::name:
        return check_name(node);
      case ValueKind::symbol:
        return check_symbol(node, false);
      case ValueKind::colour:
        return check_quoted_colour(node);
      case ValueKind::choice:
        return check_choice(node, key.name, key.words);
      case ValueKind::boolean:
        return check_boolean(node);
      case ValueKind::integer:
      case ValueKind::number:
        // The version is looked at first, since another one explains every other error.
        if (key.name == "stigc") return check_version(node);
        return check_number(node, key.name, bounds_of(key));
      case ValueKind::drawing:
        return check_drawing(node);
      default:
        return check_collection(node, key);
    }
  }

  bool check_collection(const YamlNode& node, const KeySchema& key) {
    switch (key.kind) {
      case ValueKind::cell:
        return check_list(
            node, key, 3, 3, "three whole numbers [x, y, z]",
            [&](const YamlNode& item) { return check_number(item, key.name, bounds_of(key)); });
      case ValueKind::symbols:
        return check_states(node, key, key.least);
      case ValueKind::choices:
        return check_list(
            node, key, key.least, key.most, "a list of words",
            [&](const YamlNode& item) { return check_choice(item, key.name, key.words); });
      case ValueKind::objects:
        return check_list(
            node, key, key.least, key.most,
            fmt::format("a list of entries like - {}", object_schema(key.object).example),
            [&](const YamlNode& item) { return check_object(item, key.object); });
      case ValueKind::bricks:
        return check_map(node, key, "symbols and their bricks, like 1: {color: \"#8d99ae\"}",
                         [&](const YamlPair& pair) {
                           const bool symbol = check_symbol(pair.key, false);
                           return check_object(pair.value, key.object) && symbol;
                         });
      case ValueKind::legend:
        return check_map(node, key, "symbols and their lists, like a: [1, 2]",
                         [&](const YamlPair& pair) {
                           const bool symbol = check_symbol(pair.key, false);
                           return check_states(pair.value, key, 1) && symbol;
                         });
      case ValueKind::by_stage:
        return check_map(node, key, "stages and their numbers, like 1: 24",
                         [&](const YamlPair& pair) {
                           const bool stage = check_stage(pair.key);
                           return check_number(pair.value, key.name, bounds_of(key)) && stage;
                         });
      default:
        return check_object(node, key.object);
    }
  }

  /// A list of symbols, those of drawings too. A single symbol without brackets is the
  /// usual slip, and the mended form is suggested.
  bool check_states(const YamlNode& node, const KeySchema& key, std::size_t least) {
    if (node.kind == YamlKind::scalar) {
      return wrong(node, "a list of symbols", fmt::format("[{}]", yaml_text(node.text, true)));
    }
    return check_list(node, key, least, SIZE_MAX, "a list of symbols",
                      [&](const YamlNode& item) { return check_symbol(item, true); });
  }

  template <class Check>
  bool check_list(const YamlNode& node, const KeySchema& key, std::size_t least, std::size_t most,
                  std::string_view wanted, Check check) {
    if (!expect(node, YamlKind::sequence, wanted)) return false;
    bool sound = check_size(node, key.name, node.items.size(), least, most);
    if (node.items.size() > most) return sound;  // thousands of further errors help nobody
    for (const YamlNode& item : node.items) sound = check(item) && sound;
    return sound || mark(node);
  }

  // Keys and values are both checked, so one error does not hide the other.
  template <class Check>
  bool check_map(const YamlNode& node, const KeySchema& key, std::string_view wanted, Check check) {
    if (!expect(node, YamlKind::mapping, wanted)) return false;
    bool sound = check_size(node, key.name, node.pairs.size(), key.least, key.most);
    if (node.pairs.size() > key.most) return sound;
    for (const YamlPair& pair : node.pairs) sound = check(pair) && sound;
    return sound || mark(node);
  }

  // Lengths count code points, as editors show them.
  bool check_symbol(const YamlNode& node, bool of_states) {
    if (!expect(node, YamlKind::scalar, "a symbol")) return false;
    const std::string shown = in_quotes(node.text);
    if (node.text.empty()) return bad_text(node, "a symbol cannot be empty");
    if (has_control(node.text) || node.text.find(' ') != std::string::npos) {
      return bad_text(node, fmt::format("a symbol has no space in it: {}", shown));
    }
    if (count_code_points(node.text) > kMaxSymbolLength) {
      return bad_text(node, fmt::format("a symbol has at most {} characters", kMaxSymbolLength));
    }
    if (!of_states && is_reserved_symbol(node.text)) {
      return bad_text(node,
                      fmt::format("{} has a meaning of its own and is no brick's symbol", shown));
    }
    return true;
  }

  /// A plain number is a number to an editor, and a colour never looks like one.
  bool check_quoted_colour(const YamlNode& node) {
    return number_of(node) ? wrong(node, "a colour \"#rrggbb\" in quotes") : check_colour(node);
  }

  bool check_version(const YamlNode& node) {
    const std::optional<double> value = number_of(node);
    if (!value || std::floor(*value) != *value) return wrong(node, std::to_string(kFormatVersion));
    return *value == kFormatVersion || unknown_version(node, kFormatVersion);
  }

  // Leading zeros are refused: YAML readers disagree on whether 010 is eight or ten.
  bool check_stage(const YamlNode& node) {
    int stage = 0;
    const char* end = node.text.data() + node.text.size();
    const auto result = std::from_chars(node.text.data(), end, stage);
    const bool digits = node.kind == YamlKind::scalar && result.ec == std::errc() &&
                        result.ptr == end && node.text[0] != '0';
    if (!digits) return wrong(node, "the number of a stage");
    if (stage >= 1 && stage <= kMaxStage) return true;
    return out_of_range(node, fmt::format("stages are numbered from 1 to {}", kMaxStage));
  }

  bool check_drawing(const YamlNode& node) {
    constexpr std::string_view kWanted = "a drawing: a bar '|' and the rows below it";
    if (!expect(node, YamlKind::scalar, kWanted)) return false;
    // `when: 3` is a number to an editor.
    const bool plain = node.style == YamlStyle::plain;
    if (plain && (number_of(node) || node.text == "true" || node.text == "false")) {
      return wrong(node, kWanted);
    }
    return true;
  }
};

}  // namespace

BadNodes check_shape(const YamlDocument& document, Diagnostics& diagnostics) {
  BadNodes bad;
  ShapeChecker(document, diagnostics, bad).check_object(document.root, ObjectKind::rule_set);
  return bad;
}

}  // namespace stig
