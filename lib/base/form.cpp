// SPDX-License-Identifier: MIT
// Checks a file against a form, and reads from it what is sound. The two are apart on
// purpose: check_form reports every problem once and marks bad nodes; FormView then hands
// out defaults for what is marked, so that readers need no error handling and later checks
// can still say something useful about the rest.
#include "base/form.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/node_checks.h"

namespace stig {

namespace {

NumberBounds bounds_of(const FormKey& key) {
  const bool whole = key.kind == FormKind::integer || key.kind == FormKind::integers;
  return {key.low, key.high, key.above_low, whole};
}

std::string wanted_list(const FormKey& key) {
  if (!key.wanted.empty()) return std::string(key.wanted);
  if (key.kind == FormKind::names) return "a list of names";
  if (key.kind == FormKind::choices) return "a list of words";
  if (key.kind == FormKind::forms && !key.form->example.empty()) {
    return fmt::format("a list of entries like - {}", key.form->example);
  }
  if (key.kind == FormKind::forms) {
    return "a list of entries, each " + with_article(key.form->title);
  }
  if (key.least == key.most) return fmt::format("a list of {} numbers", key.least);
  return "a list of numbers";
}

/// Walks nodes beside the table. Every check returns whether the node is sound and marks it
/// when it is not, and so does every node around it.
class Checker : public NodeChecks {
 public:
  using NodeChecks::NodeChecks;

  bool check_form(const YamlNode& node, const Form& form) {
    return check_keys(node, form, [&](const YamlNode& value, const FormKey& key) {
      return check_value(value, key);
    });
  }

 private:
  bool check_value(const YamlNode& node, const FormKey& key) {
    switch (key.kind) {
      case FormKind::text:
        return expect(node, YamlKind::scalar, "a text");
      case FormKind::name:
        return check_name(node);
      case FormKind::colour:
        return check_colour(node);
      case FormKind::choice:
        return check_choice(node, key.name, key.words);
      case FormKind::boolean:
        return check_boolean(node);
      case FormKind::integer:
      case FormKind::number:
        return check_number(node, key.name, bounds_of(key));
      case FormKind::version:
        return check_version(node, key);
      case FormKind::form:
        return check_form(node, *key.form);
      case FormKind::numbers:
      case FormKind::integers:
      case FormKind::names:
      case FormKind::choices:
      case FormKind::forms:
        return check_list(node, key);
      case FormKind::map:
        return check_map(node, key);
      case FormKind::own:
        return key.own->check(*this, node, key);
      case FormKind::anything:
        break;
    }
    return node.kind != YamlKind::broken;
  }

  bool check_list(const YamlNode& node, const FormKey& key) {
    if (!expect(node, YamlKind::sequence, wanted_list(key))) return false;
    bool sound = check_size(node, key.name, node.items.size(), key.least, key.most);
    // Beyond the limit the list itself is the error: thousands of further ones help nobody.
    if (node.items.size() > key.most) return sound;
    for (const YamlNode& item : node.items) sound = check_item(item, key) && sound;
    return sound || mark(node);
  }

  bool check_item(const YamlNode& item, const FormKey& key) {
    if (key.kind == FormKind::names) return check_name(item);
    if (key.kind == FormKind::choices) return check_choice(item, key.name, key.words);
    if (key.kind == FormKind::forms) return check_form(item, *key.form);
    return check_number(item, key.name, bounds_of(key));
  }

  // Keys and values are both checked, so one error does not hide the other.
  bool check_map(const YamlNode& node, const FormKey& key) {
    if (!expect(node, YamlKind::mapping, key.wanted)) return false;
    bool sound = check_size(node, key.name, node.pairs.size(), key.least, key.most);
    if (node.pairs.size() > key.most) return sound;
    for (const YamlPair& pair : node.pairs) {
      const bool good = key.own->check(*this, pair.key, key);
      sound = check_value(pair.value, *key.entry) && good && sound;
    }
    return sound || mark(node);
  }

  // The version is the key's upper bound; another one is reported as such and not as a
  // number out of range.
  bool check_version(const YamlNode& node, const FormKey& key) {
    const std::optional<double> value = number_of(node);
    if (!value) return wrong(node, fmt::format("the version {}", key.high));
    return *value == key.high || unknown_version(node, static_cast<int>(key.high));
  }
};

}  // namespace

/// Unlike from_chars it takes no infinities and no quoted numbers, but a sign of either kind.
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
  // A static empty mapping serves for absent forms, since views hold pointers.
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
