// SPDX-License-Identifier: MIT
// Holding a file to the table of rule_schema.h: diagnostics R1xx.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text.h"
#include "rules/rule_schema.h"
#include "rules/state.h"

namespace stig {

namespace {

std::string_view spoken(YamlKind kind) {
  switch (kind) {
    case YamlKind::null:
      return "nothing";
    case YamlKind::scalar:
      return "a text";
    case YamlKind::sequence:
      return "a list";
    case YamlKind::mapping:
      return "a mapping";
    case YamlKind::broken:
      break;
  }
  return "something broken";
}

std::string found(const YamlNode& node) {
  if (node.kind != YamlKind::scalar) return std::string(spoken(node.kind));
  return node.style == YamlStyle::quoted ? "the quoted text " + in_quotes(node.text)
                                         : in_quotes(node.text);
}

/// "a whole number 0..26": what a key wants, for messages.
std::string wanted_number(const KeySchema& key) {
  const bool whole = key.kind != ValueKind::number;
  const std::string what = whole ? "a whole number" : "a number";
  if (key.above_low) return fmt::format("{} above {} and at most {}", what, key.low, key.high);
  if (key.low == key.high) return fmt::format("{}", key.low);
  return fmt::format("{} from {:.0f} to {:.0f}", what, key.low, key.high);
}

bool has_control(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

bool is_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

std::string article(std::string_view noun) {
  return (std::string_view("aeiou").find(noun[0]) != std::string_view::npos ? "an " : "a ") +
         std::string(noun);
}

std::string joined(const std::vector<std::string_view>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " or " : ", ";
    out += words[i];
  }
  return out;
}

/// Walks nodes beside the table. Every check returns whether the node is sound and
/// marks it when it is not, and so does every node around it.
class ShapeChecker {
 public:
  ShapeChecker(const YamlDocument& document, Diagnostics& diagnostics)
      : document_(document), out_(diagnostics) {}

  bool check_object(const YamlNode& node, ObjectKind kind) {
    const ObjectSchema& schema = object_schema(kind);
    if (!expect_kind(node, YamlKind::mapping, article(schema.title) + " as a mapping of keys")) {
      return mark(node);
    }
    bool sound = true;
    for (const YamlPair& pair : node.pairs) sound = check_pair(pair, schema) && sound;
    for (const KeySchema& key : schema.keys) {
      if (!key.required || node.find(key.name) != nullptr) continue;
      add(Code::R102, head(node),
          fmt::format("{} without the key '{}'", article(schema.title), key.name));
      sound = false;
    }
    return sound || mark(node);
  }

  BadNodes take_bad() { return std::move(bad_); }

 private:
  Diagnostic& add(Code code, const SourceRange& range, std::string message) {
    return out_.add(code, range, std::move(message));
  }
  bool mark(const YamlNode& node) {
    bad_.insert(&node);
    return false;
  }
  SourceRange head(const YamlNode& node) const { return document_.head(node); }

  bool wrong_type(const YamlNode& node, std::string_view wanted) {
    if (node.kind != YamlKind::broken) {
      add(Code::R103, head(node), fmt::format("expected {}, found {}", wanted, found(node)));
    }
    return mark(node);
  }
  bool expect_kind(const YamlNode& node, YamlKind kind, std::string_view wanted) {
    return node.kind == kind || wrong_type(node, wanted);
  }

  bool check_pair(const YamlPair& pair, const ObjectSchema& schema) {
    if (!expect_kind(pair.key, YamlKind::scalar, "a key")) return false;
    const auto known = std::find_if(schema.keys.begin(), schema.keys.end(),
                                    [&](const auto& key) { return key.name == pair.key.text; });
    if (known != schema.keys.end()) return check_value(pair.value, *known);
    Diagnostic& diagnostic =
        add(Code::R101, document_.range(pair.key),
            fmt::format("unknown key {} in {}", in_quotes(pair.key.text), article(schema.title)));
    if (!out_.full()) {
      std::vector<std::string_view> names;
      for (const KeySchema& key : schema.keys) names.push_back(key.name);
      diagnostic.suggest(std::string(nearest(pair.key.text, names)));
    }
    return mark(pair.value);
  }

  bool check_value(const YamlNode& node, const KeySchema& key) {
    switch (key.kind) {
      case ValueKind::text:
        return expect_kind(node, YamlKind::scalar, "a text");
      case ValueKind::name:
        return check_name(node);
      case ValueKind::symbol:
        return check_symbol(node, false);
      case ValueKind::colour:
        return check_colour(node);
      case ValueKind::choice:
        return check_choice(node, key);
      case ValueKind::boolean:
        return check_boolean(node);
      case ValueKind::integer:
      case ValueKind::number:
        return check_number(node, key);
      case ValueKind::drawing:
        return check_drawing(node);
      default:
        return check_collection(node, key);
    }
  }

  bool check_collection(const YamlNode& node, const KeySchema& key) {
    switch (key.kind) {
      case ValueKind::cell:
        return check_list(node, key, 3, 3, "three whole numbers [x, y, z]",
                          [&](const YamlNode& item) { return check_number(item, key); });
      case ValueKind::symbols:
        return check_list(node, key, key.least, key.most, "a list of symbols",
                          [&](const YamlNode& item) { return check_symbol(item, true); });
      case ValueKind::choices:
        return check_list(node, key, key.least, key.most, "a list of words",
                          [&](const YamlNode& item) { return check_choice(item, key); });
      case ValueKind::objects:
        return check_list(
            node, key, key.least, key.most,
            fmt::format("a list of entries, each {}", article(object_schema(key.object).title)),
            [&](const YamlNode& item) { return check_object(item, key.object); });
      case ValueKind::bricks:
        return check_map(node, key, "a mapping from symbols to bricks", [&](const YamlPair& pair) {
          const bool symbol = check_symbol(pair.key, false);
          return check_object(pair.value, key.object) && symbol;
        });
      case ValueKind::legend:
        return check_map(node, key, "a mapping from symbols to lists", [&](const YamlPair& pair) {
          const bool symbol = check_symbol(pair.key, false);
          const bool list =
              check_list(pair.value, key, 1, SIZE_MAX, "a list of symbols",
                         [&](const YamlNode& item) { return check_symbol(item, true); });
          return symbol && list;
        });
      case ValueKind::by_stage:
        return check_map(node, key, "a mapping from stages to numbers", [&](const YamlPair& pair) {
          const bool stage = check_stage(pair.key);
          return check_number(pair.value, key) && stage;
        });
      default:
        return check_object(node, key.object);
    }
  }

  template <class Check>
  bool check_list(const YamlNode& node, const KeySchema& key, std::size_t least, std::size_t most,
                  std::string_view wanted, Check check) {
    if (!expect_kind(node, YamlKind::sequence, wanted)) return false;
    bool sound = check_size(node, key, node.items.size(), least, most);
    if (node.items.size() > most) return sound;  // thousands of further errors help nobody
    for (const YamlNode& item : node.items) sound = check(item) && sound;
    return sound || mark(node);
  }

  template <class Check>
  bool check_map(const YamlNode& node, const KeySchema& key, std::string_view wanted, Check check) {
    if (!expect_kind(node, YamlKind::mapping, wanted)) return false;
    bool sound = check_size(node, key, node.pairs.size(), key.least, key.most);
    if (node.pairs.size() > key.most) return sound;
    for (const YamlPair& pair : node.pairs) sound = check(pair) && sound;
    return sound || mark(node);
  }

  bool check_size(const YamlNode& node, const KeySchema& key, std::size_t size, std::size_t least,
                  std::size_t most) {
    if (size >= least && size <= most) return true;
    const std::string wanted = least == most  ? fmt::format("{}", least)
                               : size < least ? fmt::format("at least {}", least)
                                              : fmt::format("at most {}", most);
    add(Code::R107, head(node),
        fmt::format("'{}' has {} entr{}, it takes {}", key.name, size, size == 1 ? "y" : "ies",
                    wanted));
    return mark(node);
  }

  bool bad_text(const YamlNode& node, std::string message) {
    add(Code::R106, document_.range(node), std::move(message));
    return mark(node);
  }

  bool check_name(const YamlNode& node) {
    if (!expect_kind(node, YamlKind::scalar, "a name")) return false;
    if (node.text.empty()) return bad_text(node, "a name cannot be empty");
    if (has_control(node.text))
      return bad_text(node, "a name is one line without control characters");
    return true;
  }

  bool check_symbol(const YamlNode& node, bool of_states) {
    if (!expect_kind(node, YamlKind::scalar, "a symbol")) return false;
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

  bool check_colour(const YamlNode& node) {
    if (!expect_kind(node, YamlKind::scalar, "a colour \"#rrggbb\" in quotes")) return false;
    // A plain number is a number to an editor, and a colour never looks like one.
    if (is_colour(node.text)) return true;
    if (number_of(node)) return wrong_type(node, "a colour \"#rrggbb\" in quotes");
    return bad_text(node, fmt::format("{} is no colour \"#rrggbb\"", in_quotes(node.text)));
  }

  bool check_choice(const YamlNode& node, const KeySchema& key) {
    if (!expect_kind(node, YamlKind::scalar, joined(key.words))) return false;
    if (std::find(key.words.begin(), key.words.end(), node.text) != key.words.end()) return true;
    add(Code::R104, head(node),
        fmt::format("'{}' is {}, not {}", key.name, joined(key.words), in_quotes(node.text)))
        .suggest(std::string(nearest(node.text, key.words)));
    return mark(node);
  }

  bool check_boolean(const YamlNode& node) {
    const bool plain = node.kind == YamlKind::scalar && node.style == YamlStyle::plain;
    return (plain && (node.text == "true" || node.text == "false")) ||
           wrong_type(node, "true or false");
  }

  bool check_number(const YamlNode& node, const KeySchema& key) {
    const std::optional<double> value = number_of(node);
    const bool whole = key.kind != ValueKind::number;
    if (!value || (whole && std::floor(*value) != *value))
      return wrong_type(node, wanted_number(key));
    const bool low = key.above_low ? *value > key.low : *value >= key.low;
    if (low && *value <= key.high) return true;
    if (key.name == "stigc") {
      add(Code::R108, document_.range(node),
          fmt::format("version {} of the file format is not known; this program reads version {}",
                      printable(node.text), kFormatVersion));
    } else {
      add(Code::R105, document_.range(node),
          fmt::format("'{}' takes {}, not {}", key.name, wanted_number(key), in_quotes(node.text)));
    }
    return mark(node);
  }

  bool check_stage(const YamlNode& node) {
    int stage = 0;
    const char* end = node.text.data() + node.text.size();
    const auto result = std::from_chars(node.text.data(), end, stage);
    const bool digits = node.kind == YamlKind::scalar && result.ec == std::errc() &&
                        result.ptr == end && node.text[0] != '0';
    if (!digits) return wrong_type(node, "the number of a stage");
    if (stage >= 1 && stage <= kMaxStage) return true;
    add(Code::R105, document_.range(node),
        fmt::format("stages are numbered from 1 to {}", kMaxStage));
    return mark(node);
  }

  bool check_drawing(const YamlNode& node) {
    if (!expect_kind(node, YamlKind::scalar, "a drawing")) return false;
    // `when: 3` is a number to an editor.
    const bool plain = node.style == YamlStyle::plain;
    if (plain && (number_of(node) || node.text == "true" || node.text == "false")) {
      return wrong_type(node, "a drawing");
    }
    return true;
  }

  const YamlDocument& document_;
  Diagnostics& out_;
  BadNodes bad_;
};

}  // namespace

BadNodes check_shape(const YamlDocument& document, Diagnostics& diagnostics) {
  ShapeChecker checker(document, diagnostics);
  checker.check_object(document.root, ObjectKind::rule_set);
  return checker.take_bad();
}

}  // namespace stig
