// SPDX-License-Identifier: MIT
#include "base/node_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"

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

std::string alternatives(const std::vector<std::string_view>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " or " : ", ";
    out += words[i];
  }
  return out;
}

std::string wanted_number(const NumberBounds& bounds) {
  const std::string_view what = bounds.whole ? "a whole number" : "a number";
  if (bounds.above_low) {
    return fmt::format("{} above {} and at most {}", what, bounds.low, bounds.high);
  }
  return fmt::format("{} from {} to {}", what, bounds.low, bounds.high);
}

bool is_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

}  // namespace

std::string with_article(std::string_view noun) {
  return (std::string_view("aeiou").find(noun[0]) != std::string_view::npos ? "an " : "a ") +
         std::string(noun);
}

bool has_control(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

bool NodeChecks::mark(const YamlNode& node) {
  bad_.insert(&node);
  return false;
}

bool NodeChecks::wrong(const YamlNode& node, std::string_view wanted) {
  if (node.kind != YamlKind::broken) {
    out_.add(Code::R103, document_.head(node),
             fmt::format("expected {}, found {}", wanted, found(node)));
  }
  return mark(node);
}

bool NodeChecks::out_of_range(const YamlNode& node, std::string message) {
  out_.add(Code::R105, document_.range(node), std::move(message));
  return mark(node);
}

bool NodeChecks::bad_text(const YamlNode& node, std::string message) {
  out_.add(Code::R106, document_.range(node), std::move(message));
  return mark(node);
}

bool NodeChecks::unknown_version(const YamlNode& node, int known) {
  out_.add(Code::R108, document_.range(node),
           fmt::format("version {} of the file format is not known; this program reads version {}",
                       printable(node.text), known));
  return mark(node);
}

bool NodeChecks::unknown_key(const YamlPair& pair, std::string_view title,
                             const std::vector<std::string_view>& known) {
  Diagnostic& diagnostic =
      out_.add(Code::R101, document_.range(pair.key),
               fmt::format("unknown key {} in {}", in_quotes(pair.key.text), with_article(title)));
  if (!out_.full()) diagnostic.suggest(std::string(nearest(pair.key.text, known)));
  return mark(pair.value);
}

void NodeChecks::missing_key(const YamlNode& mapping, std::string_view title,
                             std::string_view key) {
  out_.add(Code::R102, document_.head(mapping),
           fmt::format("{} without the key '{}'", with_article(title), key));
}

bool NodeChecks::expect(const YamlNode& node, YamlKind kind, std::string_view wanted) {
  return node.kind == kind || wrong(node, wanted);
}

bool NodeChecks::check_name(const YamlNode& node) {
  if (!expect(node, YamlKind::scalar, "a name")) return false;
  if (node.text.empty()) return bad_text(node, "a name cannot be empty");
  return !has_control(node.text) || bad_text(node, "a name is one line without control characters");
}

bool NodeChecks::check_colour(const YamlNode& node) {
  if (!expect(node, YamlKind::scalar, "a colour \"#rrggbb\" in quotes")) return false;
  return is_colour(node.text) ||
         bad_text(node, fmt::format("{} is no colour \"#rrggbb\"", in_quotes(node.text)));
}

bool NodeChecks::check_boolean(const YamlNode& node) {
  const bool plain = node.kind == YamlKind::scalar && node.style == YamlStyle::plain;
  return (plain && (node.text == "true" || node.text == "false")) || wrong(node, "true or false");
}

bool NodeChecks::check_choice(const YamlNode& node, std::string_view key,
                              const std::vector<std::string_view>& words) {
  if (!expect(node, YamlKind::scalar, alternatives(words))) return false;
  if (std::find(words.begin(), words.end(), node.text) != words.end()) return true;
  out_.add(Code::R104, document_.head(node),
           fmt::format("'{}' is {}, not {}", key, alternatives(words), in_quotes(node.text)))
      .suggest(std::string(nearest(node.text, words)));
  return mark(node);
}

bool NodeChecks::check_number(const YamlNode& node, std::string_view key,
                              const NumberBounds& bounds) {
  const std::optional<double> value = number_of(node);
  if (!value || (bounds.whole && std::floor(*value) != *value)) {
    return wrong(node, wanted_number(bounds));
  }
  const bool low = bounds.above_low ? *value > bounds.low : *value >= bounds.low;
  if (low && *value <= bounds.high) return true;
  return out_of_range(
      node, fmt::format("'{}' takes {}, not {}", key, wanted_number(bounds), in_quotes(node.text)));
}

bool NodeChecks::check_size(const YamlNode& node, std::string_view key, std::size_t size,
                            std::size_t least, std::size_t most) {
  if (size >= least && size <= most) return true;
  const std::string wanted = least == most  ? fmt::format("{}", least)
                             : size < least ? fmt::format("at least {}", least)
                                            : fmt::format("at most {}", most);
  out_.add(
      Code::R107, document_.head(node),
      fmt::format("'{}' has {} entr{}, it takes {}", key, size, size == 1 ? "y" : "ies", wanted));
  return mark(node);
}

}  // namespace stig
