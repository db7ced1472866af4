// SPDX-License-Identifier: MIT
#include "base/yaml_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace stig {

namespace {

std::string article(std::string_view noun) {
  const bool vowel = std::string_view("aeiou").find(noun[0]) != std::string_view::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

std::string joined(const std::vector<std::string_view>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    out += i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
    out += words[i];
  }
  return out;
}

std::string_view found(const YamlNode& node) {
  switch (node.kind) {
    case YamlKind::null:
      return "nothing";
    case YamlKind::sequence:
      return "a list";
    case YamlKind::mapping:
      return "a mapping";
    default:
      return node.style != YamlStyle::plain ? "a text in quotes"
             : number_of(node)              ? "a number"
                                            : "a text";
  }
}

bool is_whole(const YamlKey& key) {
  return key.type == YamlType::integer || key.type == YamlType::integers;
}

std::string wanted_number(const YamlKey& key) {
  const char* noun = is_whole(key) ? "a whole number" : "a number";
  return key.above_low ? fmt::format("{} above {}, at most {}", noun, key.low, key.high)
                       : fmt::format("{} from {} to {}", noun, key.low, key.high);
}

/// Walks the tree and the table together; each check says whether all was well.
class ShapeChecker {
 public:
  ShapeChecker(const YamlDocument& document, Diagnostics& out) : document_(document), out_(out) {}

  bool object(const YamlNode& node, const YamlObject& object) {
    if (!kind(node, YamlKind::mapping, article(object.title))) return false;
    bool good = true;
    for (const YamlPair& pair : node.pairs) good = this->pair(pair, object) && good;
    for (const YamlKey& key : object.keys) {
      if (!key.required || node.find(key.name) != nullptr) continue;
      error(Code::R102, node,
            fmt::format("the key '{}' is missing in {}", key.name, article(object.title)));
      good = false;
    }
    return good;
  }

 private:
  void error(Code code, const YamlNode& node, std::string message, std::string_view near = {}) {
    if (node.kind == YamlKind::broken) return;
    Diagnostic& diagnostic = out_.add(code, document_.head(node), std::move(message));
    if (!near.empty()) diagnostic.suggest(std::string(near));
  }

  bool wrong_type(const YamlNode& node, std::string_view wanted) {
    error(Code::R103, node, fmt::format("expected {}, found {}", wanted, found(node)));
    return false;
  }
  bool kind(const YamlNode& node, YamlKind kind, std::string_view wanted) {
    return node.kind == kind || wrong_type(node, wanted);
  }

  bool pair(const YamlPair& pair, const YamlObject& object) {
    if (!kind(pair.key, YamlKind::scalar, "a key")) return false;
    for (const YamlKey& key : object.keys) {
      if (key.name == pair.key.text) return value(pair.value, key);
    }
    std::vector<std::string_view> names;
    if (!out_.full()) {
      for (const YamlKey& key : object.keys) names.push_back(key.name);
    }
    error(Code::R101, pair.key,
          fmt::format("unknown key {} in {}", in_quotes(pair.key.text), article(object.title)),
          nearest(pair.key.text, names));
    return false;
  }

  bool value(const YamlNode& node, const YamlKey& key) {
    switch (key.type) {
      case YamlType::text:
        return kind(node, YamlKind::scalar, "a text");
      case YamlType::name:
        return name(node);
      case YamlType::number:
      case YamlType::integer:
        return number(node, key);
      case YamlType::boolean:
        return boolean(node);
      case YamlType::choice:
        return choice(node, key);
      case YamlType::numbers:
      case YamlType::integers:
        return list(node, key, fmt::format("a list of {} numbers", key.least),
                    [&](const YamlNode& item) { return number(item, key); });
      case YamlType::object:
        return object(node, *key.object);
      case YamlType::objects:
        return list(node, key, "a list of entries, each " + article(key.object->title),
                    [&](const YamlNode& item) { return object(item, *key.object); });
    }
    return false;
  }

  bool name(const YamlNode& node) {
    if (!kind(node, YamlKind::scalar, "a name")) return false;
    const bool control = std::any_of(node.text.begin(), node.text.end(), [](char c) {
      return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    });
    if (!node.text.empty() && !control) return true;
    error(Code::R106, node, "a name is one line of text, not empty");
    return false;
  }

  bool number(const YamlNode& node, const YamlKey& key) {
    const std::optional<double> value = number_of(node);
    if (!value || (is_whole(key) && std::floor(*value) != *value)) {
      return wrong_type(node, wanted_number(key));
    }
    const bool low = key.above_low ? *value > key.low : *value >= key.low;
    if (low && *value <= key.high) return true;
    if (key.name.starts_with("stigc_")) {
      error(Code::R108, node,
            fmt::format("version {} is not known; this program reads version {}",
                        printable(node.text), key.high));
    } else {
      error(
          Code::R105, node,
          fmt::format("'{}' takes {}, not {}", key.name, wanted_number(key), in_quotes(node.text)));
    }
    return false;
  }

  bool boolean(const YamlNode& node) {
    const bool plain = node.kind == YamlKind::scalar && node.style == YamlStyle::plain;
    return (plain && (node.text == "true" || node.text == "false")) ||
           wrong_type(node, "true or false");
  }

  bool choice(const YamlNode& node, const YamlKey& key) {
    if (!kind(node, YamlKind::scalar, joined(key.words))) return false;
    if (std::find(key.words.begin(), key.words.end(), node.text) != key.words.end()) return true;
    error(Code::R104, node,
          fmt::format("'{}' is {}, not {}", key.name, joined(key.words), in_quotes(node.text)),
          nearest(node.text, key.words));
    return false;
  }

  template <class Check>
  bool list(const YamlNode& node, const YamlKey& key, std::string_view wanted, Check check) {
    if (!kind(node, YamlKind::sequence, wanted)) return false;
    const std::size_t size = node.items.size();
    if (size < key.least || size > key.most) {
      error(Code::R107, node,
            fmt::format("'{}' has {} entr{}, it takes {}", key.name, size, size == 1 ? "y" : "ies",
                        key.least == key.most ? fmt::format("{}", key.least)
                        : size < key.least    ? fmt::format("at least {}", key.least)
                                              : fmt::format("at most {}", key.most)));
      return false;
    }
    bool good = true;
    for (const YamlNode& item : node.items) good = check(item) && good;
    return good;
  }

  const YamlDocument& document_;
  Diagnostics& out_;
};

}  // namespace

bool check_shape(const YamlDocument& document, const YamlNode& node, const YamlObject& object,
                 Diagnostics& diagnostics) {
  return ShapeChecker(document, diagnostics).object(node, object);
}

double number_or(const YamlNode& mapping, std::string_view key, double otherwise) {
  const YamlNode* node = mapping.find(key);
  return node == nullptr ? otherwise : number_of(*node).value_or(otherwise);
}

bool flag_or(const YamlNode& mapping, std::string_view key, bool otherwise) {
  const YamlNode* node = mapping.find(key);
  return node == nullptr ? otherwise : node->text == "true";
}

std::string text_or(const YamlNode& mapping, std::string_view key, std::string_view otherwise) {
  const YamlNode* node = mapping.find(key);
  return std::string(node == nullptr ? otherwise : node->text);
}

std::vector<double> numbers_or(const YamlNode& mapping, std::string_view key,
                               std::vector<double> otherwise) {
  const YamlNode* node = mapping.find(key);
  if (node == nullptr) return otherwise;
  std::vector<double> out;
  for (const YamlNode& item : node->items) out.push_back(number_of(item).value_or(0));
  return out;
}

}  // namespace stig
