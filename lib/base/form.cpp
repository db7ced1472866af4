// SPDX-License-Identifier: MIT
#include "base/form.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
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

std::string article(std::string_view noun) {
  return (std::string_view("aeiou").find(noun[0]) != std::string_view::npos ? "an " : "a ") +
         std::string(noun);
}

std::string alternatives(const std::vector<std::string_view>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " or " : ", ";
    out += words[i];
  }
  return out;
}

bool is_whole(const FormKey& key) {
  return key.kind == FormKind::integer || key.kind == FormKind::integers;
}

std::string wanted_number(const FormKey& key) {
  const std::string what = is_whole(key) ? "a whole number" : "a number";
  if (key.above_low) return fmt::format("{} above {} and at most {}", what, key.low, key.high);
  return fmt::format("{} from {} to {}", what, key.low, key.high);
}

std::string wanted_list(const FormKey& key) {
  if (key.kind == FormKind::names) return "a list of names";
  if (key.kind == FormKind::forms) return "a list of entries, each " + article(key.form->title);
  if (key.least == key.most) return fmt::format("a list of {} numbers", key.least);
  return "a list of numbers";
}

bool is_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

/// Walks nodes beside the table. Every check returns whether the node is sound and marks it
/// when it is not, and so does every node around it.
class Checker {
 public:
  Checker(const YamlDocument& document, Diagnostics& diagnostics, BadNodes& bad)
      : document_(document), out_(diagnostics), bad_(bad) {}

  bool check_form(const YamlNode& node, const Form& form) {
    if (!expect(node, YamlKind::mapping, article(form.title) + " as a mapping of keys")) {
      return false;
    }
    bool sound = true;
    for (const YamlPair& pair : node.pairs) sound = check_pair(pair, form) && sound;
    for (const FormKey& key : form.keys) {
      if (!key.required || node.find(key.name) != nullptr) continue;
      out_.add(Code::R102, document_.head(node),
               fmt::format("{} without the key '{}'", article(form.title), key.name));
      sound = false;
    }
    return sound || mark(node);
  }

 private:
  bool mark(const YamlNode& node) {
    bad_.insert(&node);
    return false;
  }
  bool wrong(const YamlNode& node, std::string_view wanted) {
    if (node.kind != YamlKind::broken) {
      out_.add(Code::R103, document_.head(node),
               fmt::format("expected {}, found {}", wanted, found(node)));
    }
    return mark(node);
  }
  bool bad_text(const YamlNode& node, std::string message) {
    out_.add(Code::R106, document_.range(node), std::move(message));
    return mark(node);
  }
  bool expect(const YamlNode& node, YamlKind kind, std::string_view wanted) {
    return node.kind == kind || wrong(node, wanted);
  }

  bool check_pair(const YamlPair& pair, const Form& form) {
    if (!expect(pair.key, YamlKind::scalar, "a key")) return false;
    const auto known = std::find_if(form.keys.begin(), form.keys.end(),
                                    [&](const FormKey& key) { return key.name == pair.key.text; });
    if (known != form.keys.end()) return check_value(pair.value, *known);
    Diagnostic& diagnostic = out_.add(
        Code::R101, document_.range(pair.key),
        fmt::format("unknown key {} in {}", in_quotes(pair.key.text), article(form.title)));
    if (!out_.full()) {
      std::vector<std::string_view> names;
      for (const FormKey& key : form.keys) names.push_back(key.name);
      diagnostic.suggest(std::string(nearest(pair.key.text, names)));
    }
    return mark(pair.value);
  }

  bool check_value(const YamlNode& node, const FormKey& key) {
    switch (key.kind) {
      case FormKind::text:
        return expect(node, YamlKind::scalar, "a text");
      case FormKind::name:
        return check_name(node);
      case FormKind::colour:
        return check_colour(node);
      case FormKind::choice:
        return check_choice(node, key);
      case FormKind::boolean:
        return check_boolean(node);
      case FormKind::integer:
      case FormKind::number:
        return check_number(node, key);
      case FormKind::version:
        return check_version(node, key);
      case FormKind::form:
        return check_form(node, *key.form);
      case FormKind::numbers:
      case FormKind::integers:
      case FormKind::names:
      case FormKind::forms:
        return check_list(node, key);
      case FormKind::anything:
        break;
    }
    return node.kind != YamlKind::broken;
  }

  bool check_list(const YamlNode& node, const FormKey& key) {
    if (!expect(node, YamlKind::sequence, wanted_list(key))) return false;
    if (!check_size(node, key)) return false;
    bool sound = true;
    for (const YamlNode& item : node.items) {
      const bool good = key.kind == FormKind::names   ? check_name(item)
                        : key.kind == FormKind::forms ? check_form(item, *key.form)
                                                      : check_number(item, key);
      sound = good && sound;
    }
    return sound || mark(node);
  }

  bool check_size(const YamlNode& node, const FormKey& key) {
    const std::size_t size = node.items.size();
    if (size >= key.least && size <= key.most) return true;
    const std::string wanted = key.least == key.most ? fmt::format("{}", key.least)
                               : size < key.least    ? fmt::format("at least {}", key.least)
                                                     : fmt::format("at most {}", key.most);
    out_.add(Code::R107, document_.head(node),
             fmt::format("'{}' has {} entr{}, it takes {}", key.name, size, size == 1 ? "y" : "ies",
                         wanted));
    return mark(node);
  }

  bool check_name(const YamlNode& node) {
    if (!expect(node, YamlKind::scalar, "a name")) return false;
    if (node.text.empty()) return bad_text(node, "a name cannot be empty");
    const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
    if (std::none_of(node.text.begin(), node.text.end(), control)) return true;
    return bad_text(node, "a name is one line without control characters");
  }

  bool check_colour(const YamlNode& node) {
    if (!expect(node, YamlKind::scalar, "a colour \"#rrggbb\" in quotes")) return false;
    if (is_colour(node.text)) return true;
    return bad_text(node, fmt::format("{} is no colour \"#rrggbb\"", in_quotes(node.text)));
  }

  bool check_choice(const YamlNode& node, const FormKey& key) {
    if (!expect(node, YamlKind::scalar, alternatives(key.words))) return false;
    if (std::find(key.words.begin(), key.words.end(), node.text) != key.words.end()) return true;
    out_.add(Code::R104, document_.head(node),
             fmt::format("'{}' is {}, not {}", key.name, alternatives(key.words),
                         in_quotes(node.text)))
        .suggest(std::string(nearest(node.text, key.words)));
    return mark(node);
  }

  bool check_boolean(const YamlNode& node) {
    const bool plain = node.kind == YamlKind::scalar && node.style == YamlStyle::plain;
    return (plain && (node.text == "true" || node.text == "false")) || wrong(node, "true or false");
  }

  bool check_number(const YamlNode& node, const FormKey& key) {
    const std::optional<double> value = number_of(node);
    if (!value || (is_whole(key) && std::floor(*value) != *value)) {
      return wrong(node, wanted_number(key));
    }
    if ((key.above_low ? *value > key.low : *value >= key.low) && *value <= key.high) return true;
    out_.add(
        Code::R105, document_.range(node),
        fmt::format("'{}' takes {}, not {}", key.name, wanted_number(key), in_quotes(node.text)));
    return mark(node);
  }

  bool check_version(const YamlNode& node, const FormKey& key) {
    const std::optional<double> value = number_of(node);
    if (!value) return wrong(node, fmt::format("the version {}", key.high));
    if (*value == key.high) return true;
    out_.add(
        Code::R108, document_.range(node),
        fmt::format("version {} of the file format is not known; this program reads version {}",
                    printable(node.text), key.high));
    return mark(node);
  }

  const YamlDocument& document_;
  Diagnostics& out_;
  BadNodes& bad_;
};

}  // namespace

std::optional<double> number_of(const YamlNode& node) {
  if (node.kind != YamlKind::scalar || node.style != YamlStyle::plain) return std::nullopt;
  std::string_view text = node.text;
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  const std::size_t digit = !text.empty() && text[0] == '-' ? 1 : 0;
  // from_chars would take "inf" and "nan" too.
  if (text.size() <= digit ||
      std::string_view("0123456789.").find(text[digit]) == std::string_view::npos) {
    return std::nullopt;
  }
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool all = result.ec == std::errc() && result.ptr == text.data() + text.size();
  return all && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool check_form(const YamlDocument& document, const YamlNode& node, const Form& form,
                Diagnostics& diagnostics, BadNodes& bad) {
  return Checker(document, diagnostics, bad).check_form(node, form);
}

BadNodes check_form(const YamlDocument& document, const Form& form, Diagnostics& diagnostics) {
  BadNodes bad;
  check_form(document, document.root, form, diagnostics, bad);
  return bad;
}

const YamlNode* FormView::find(std::string_view key) const {
  const YamlNode* value = node_->find(key);
  return value == nullptr || bad_->contains(value) || value->kind == YamlKind::broken ? nullptr
                                                                                      : value;
}

double FormView::number(std::string_view key, double otherwise) const {
  const YamlNode* value = find(key);
  return value == nullptr ? otherwise : number_of(*value).value_or(otherwise);
}

bool FormView::flag(std::string_view key, bool otherwise) const {
  const YamlNode* value = find(key);
  return value == nullptr ? otherwise : value->text == "true";
}

std::string FormView::text(std::string_view key, std::string_view otherwise) const {
  const YamlNode* value = find(key);
  if (value == nullptr) return std::string(otherwise);
  return value->text.substr(0, value->text.find_last_not_of(" \t\r\n") + 1);
}

std::vector<double> FormView::numbers(std::string_view key) const {
  std::vector<double> out;
  if (const YamlNode* value = find(key)) {
    for (const YamlNode& item : value->items) out.push_back(number_of(item).value_or(0));
  }
  return out;
}

Vec3 FormView::vector(std::string_view key, const Vec3& otherwise) const {
  const std::vector<double> v = numbers(key);
  return v.size() == 3 ? Vec3{v[0], v[1], v[2]} : otherwise;
}

std::vector<std::string> FormView::names(std::string_view key) const {
  std::vector<std::string> out;
  if (const YamlNode* value = find(key)) {
    for (const YamlNode& item : value->items) out.push_back(item.text);
  }
  return out;
}

FormView FormView::form(std::string_view key) const {
  static const YamlNode kEmpty{.kind = YamlKind::mapping, .text = {}, .items = {}, .pairs = {}};
  const YamlNode* value = find(key);
  return {value == nullptr ? kEmpty : *value, *bad_};
}

std::vector<FormView> FormView::forms(std::string_view key) const {
  std::vector<FormView> out;
  // One bad entry spoils the list as a node, not its neighbours.
  if (const YamlNode* value = node_->find(key)) {
    for (const YamlNode& item : value->items) {
      if (!bad_->contains(&item)) out.emplace_back(item, *bad_);
    }
  }
  return out;
}

}  // namespace stig
