// SPDX-License-Identifier: MIT
// The wording of everything that can be wrong with one value. Messages say what is expected
// and what was found, and suggest a replacement where the intention is plain: a colour by
// its name, a number in quotes, `yes` for true.
#include "base/node_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

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

/// Quoted texts are named as such, because their quotes are mostly what is wrong.
std::string found(const YamlNode& node) {
  if (node.kind != YamlKind::scalar) return std::string(spoken(node.kind));
  return node.style == YamlStyle::quoted ? "the quoted text " + in_quotes(node.text)
                                         : in_quotes(node.text);
}

/// "a, b or c"; of many "a, b, c, … or z".
std::string alternatives(const std::vector<std::string_view>& words) {
  constexpr std::size_t kMany = 20, kFirst = 6;
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool last = i + 1 == words.size();
    if (words.size() > kMany && i >= kFirst && !last) continue;
    if (i > 0) out += last ? (words.size() > kMany ? ", … or " : " or ") : ", ";
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

constexpr std::string_view kHexDigits = "0123456789abcdefABCDEF";

bool is_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of(kHexDigits, 1) == std::string_view::npos;
}

/// What people write in place of a colour by its number. The basic colours of CSS, which is
/// what authors mean by these words.
constexpr std::pair<std::string_view, std::string_view> kNamedColours[] = {
    {"black", "#000000"}, {"white", "#ffffff"},   {"grey", "#808080"}, {"gray", "#808080"},
    {"red", "#ff0000"},   {"green", "#008000"},   {"blue", "#0000ff"}, {"yellow", "#ffff00"},
    {"cyan", "#00ffff"},  {"magenta", "#ff00ff"}, {"pink", "#ffc0cb"}, {"orange", "#ffa500"},
    {"brown", "#a52a2a"}, {"purple", "#800080"}};

/// The colour that a text seems to mean, as it is to be written, or nothing: "red", "#f00",
/// and six hexadecimal digits in a row, whatever stands around them.
std::string colour_meant(std::string_view text) {
  for (const auto& [name, colour] : kNamedColours) {
    if (text == name) return fmt::format("\"{}\"", colour);
  }
  if (text.size() == 4 && text[0] == '#' && text.find_first_not_of(kHexDigits, 1) == text.npos) {
    return fmt::format("\"#{0}{0}{1}{1}{2}{2}\"", text[1], text[2], text[3]);
  }
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = std::min(text.find_first_of(kHexDigits, at), text.size());
    at = std::min(text.find_first_not_of(kHexDigits, begin), text.size());
    if (at - begin == 6) return fmt::format("\"#{}\"", text.substr(begin, 6));
  }
  return {};
}

/// The word that a '#' made a comment of where a value is wanted: in YAML an unquoted '#'
/// after a space begins a comment, so the value of `color: #8d99ae` is empty. A '#' with a
/// space behind it is meant as a comment.
SourceRange swallowed_word(const YamlDocument& document, const YamlNode& node) {
  const std::string& text = document.source->text();
  const std::size_t hash = std::min(text.find_first_not_of(" \t", node.begin + 1U), text.size());
  const std::size_t end = std::min(text.find_first_of(" \t\r\n", hash), text.size());
  if (node.kind != YamlKind::null || hash == end || text[hash] != '#') return {};
  const bool remark =
      end == hash + 1 && end < text.size() && (text[end] == ' ' || text[end] == '\t');
  if (remark) return {};
  return {document.source, static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(end)};
}

/// true or false, where another word for one of them is written.
std::string truth_meant(const YamlNode& node) {
  for (const char* word : {"true", "True", "TRUE", "yes", "Yes", "YES", "on", "On", "ON"}) {
    if (node.text == word) return "true";
  }
  for (const char* word : {"false", "False", "FALSE", "no", "No", "NO", "off", "Off", "OFF"}) {
    if (node.text == word) return "false";
  }
  return {};
}

/// The number that stands in quotes, without them; or nothing.
std::string unquoted_number(const YamlNode& node) {
  YamlNode plain = node;
  plain.style = YamlStyle::plain;
  return node.style == YamlStyle::quoted && number_of(plain) ? node.text : std::string();
}

}  // namespace

/// By the first letter, which is right for the nouns of the forms.
std::string with_article(std::string_view noun) {
  assert(!noun.empty());
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

/// A broken node has been reported where it was read; reporting what it is not would only
/// repeat that.
bool NodeChecks::wrong(const YamlNode& node, std::string_view wanted, std::string instead) {
  if (node.kind == YamlKind::broken) return mark(node);
  if (const SourceRange word = swallowed_word(document_, node)) {
    const std::string text = word.file->text().substr(word.begin, word.end - word.begin);
    out_.add(Code::R103, word,
             fmt::format("expected {}, found a comment: '#' begins one unless it is in quotes",
                         wanted))
        .suggest(fmt::format("\"{}\"", text));
  } else {
    out_.add(Code::R103, document_.head(node),
             fmt::format("expected {}, found {}", wanted, found(node)))
        .suggest(std::move(instead));
  }
  return mark(node);
}

bool NodeChecks::out_of_range(const YamlNode& node, std::string message) {
  out_.add(Code::R105, document_.range(node), std::move(message));
  return mark(node);
}

bool NodeChecks::bad_text(const YamlNode& node, std::string message, std::string instead) {
  out_.add(Code::R106, document_.range(node), std::move(message)).suggest(std::move(instead));
  return mark(node);
}

bool NodeChecks::unknown_version(const YamlNode& node, int known) {
  out_.add(Code::R108, document_.range(node),
           fmt::format("version {} of the file format is not known; this program reads version {}",
                       printable(node.text), known));
  return mark(node);
}

bool NodeChecks::wrong_mapping(const YamlNode& node, const Form& form) {
  const std::string what = with_article(form.title);
  return wrong(node, form.example.empty() ? what + " as a mapping of keys"
                                          : fmt::format("{} like {}", what, form.example));
}

bool NodeChecks::unknown_key(const YamlPair& pair, std::string_view title,
                             const std::vector<std::string_view>& known) {
  Diagnostic& diagnostic =
      out_.add(Code::R101, document_.range(pair.key),
               fmt::format("unknown key {} in {}", in_quotes(pair.key.text), with_article(title)));
  if (!out_.full()) diagnostic.suggest(std::string(nearest(pair.key.text, known)));
  return mark(pair.value);
}

void NodeChecks::missing_key(const YamlNode& mapping, std::string_view title, std::string_view key,
                             std::string_view doc, const std::vector<std::string_view>& known) {
  // The missing key is not reported a second time when an unknown key is probably the same
  // one misspelt.
  const auto misspelt = [&](const YamlPair& pair) {
    const bool unknown = std::find(known.begin(), known.end(), pair.key.text) == known.end();
    return unknown && nearest(pair.key.text, known) == key;
  };
  if (!out_.full() && std::any_of(mapping.pairs.begin(), mapping.pairs.end(), misspelt)) return;
  Diagnostic& diagnostic =
      out_.add(Code::R102, document_.head(mapping),
               fmt::format("{} without the key '{}'", with_article(title), key));
  if (!doc.empty()) diagnostic.note(fmt::format("'{}': {}", key, doc));
}

/// The most frequent check, so its success has no cost but a comparison.
bool NodeChecks::expect(const YamlNode& node, YamlKind kind, std::string_view wanted) {
  return node.kind == kind || wrong(node, wanted);
}

bool NodeChecks::check_name(const YamlNode& node) {
  if (!expect(node, YamlKind::scalar, "a name")) return false;
  if (node.text.empty()) return bad_text(node, "a name cannot be empty");
  return !has_control(node.text) || bad_text(node, "a name is one line without control characters");
}

bool NodeChecks::check_colour(const YamlNode& node) {
  // A plain number is a number to an editor, and a colour never looks like one.
  if (node.kind != YamlKind::scalar || number_of(node)) {
    return wrong(node, "a colour \"#rrggbb\" in quotes", colour_meant(node.text));
  }
  return is_colour(node.text) ||
         bad_text(node,
                  fmt::format("{} is no colour: write '#' and six hexadecimal digits, in quotes",
                              in_quotes(node.text)),
                  colour_meant(node.text));
}

/// YAML 1.1 has many words for truth; only two are accepted, since readers disagree on the
/// others.
bool NodeChecks::check_boolean(const YamlNode& node) {
  const bool plain = node.kind == YamlKind::scalar && node.style == YamlStyle::plain;
  return (plain && (node.text == "true" || node.text == "false")) ||
         wrong(node, "true or false", truth_meant(node));
}

bool NodeChecks::check_choice(const YamlNode& node, std::string_view key,
                              const std::vector<std::string_view>& words) {
  assert(!words.empty());
  if (!expect(node, YamlKind::scalar, alternatives(words))) return false;
  if (std::find(words.begin(), words.end(), node.text) != words.end()) return true;
  out_.add(Code::R104, document_.head(node),
           fmt::format("'{}' is {}, not {}", key, alternatives(words), in_quotes(node.text)))
      .suggest(std::string(nearest(node.text, words)));
  return mark(node);
}

/// A whole number may be written as 3 or 3.0; its value is what counts.
bool NodeChecks::check_number(const YamlNode& node, std::string_view key,
                              const NumberBounds& bounds) {
  assert(bounds.low <= bounds.high);
  const std::optional<double> value = number_of(node);
  if (!value || (bounds.whole && std::floor(*value) != *value)) {
    return wrong(node, wanted_number(bounds), unquoted_number(node));
  }
  const bool low = bounds.above_low ? *value > bounds.low : *value >= bounds.low;
  if (low && *value <= bounds.high) return true;
  return out_of_range(
      node, fmt::format("'{}' takes {}, not {}", key, wanted_number(bounds), in_quotes(node.text)));
}

/// The size is reported for the list as a whole, and its entries are looked at by the
/// caller.
bool NodeChecks::check_size(const YamlNode& node, std::string_view key, std::size_t size,
                            std::size_t least, std::size_t most) {
  assert(least <= most);
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
