// SPDX-License-Identifier: MIT
#include "support/key_changes.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "support/uses.h"

namespace stig {

namespace {

std::string inside(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}/{}", path, key);
}

void add_declared(const Form& form, const std::string& path, std::set<std::string>& out) {
  for (const FormKey& key : form.keys) {
    if (key.form != nullptr) {
      add_declared(*key.form, inside(path, key.name), out);
    } else if (key.kind != FormKind::version) {
      out.insert(inside(path, key.name));
    }
  }
}

/// The values of all keys `name`, however deep.
void add_names(const YamlNode& node, std::vector<std::string>& out) {
  for (const YamlNode& item : node.items) add_names(item, out);
  for (const YamlPair& pair : node.pairs) {
    if (pair.key.text == "name") out.push_back(pair.value.text);
    add_names(pair.value, out);
  }
}

/// Walks a file beside its form, and collects the changes.
class Changer {
 public:
  Changer(const YamlDocument& document, std::vector<std::string> words)
      : text_(document.source->text()), words_(std::move(words)) {}

  void change_form(const YamlNode& node, const Form& form, const std::string& path) {
    for (const YamlPair& pair : node.pairs) {
      const auto key = std::find_if(form.keys.begin(), form.keys.end(),
                                    [&](const FormKey& k) { return k.name == pair.key.text; });
      REQUIRE_MESSAGE(key != form.keys.end(), form.title, " has no key ", pair.key.text);
      change_key(pair.value, *key, inside(path, key->name));
    }
  }

  std::vector<KeyChange> take() { return std::move(out_); }

 private:
  void change_key(const YamlNode& node, const FormKey& key, const std::string& name) {
    switch (key.kind) {
      case FormKind::form:
        return change_form(node, *key.form, name);
      case FormKind::forms:
        for (const YamlNode& item : node.items) change_form(item, *key.form, name);
        return;
      case FormKind::numbers:
      case FormKind::integers:
      case FormKind::names:
      case FormKind::choices:
        for (std::size_t i = 0; i < node.items.size(); ++i) {
          change_value(node.items[i], key, fmt::format("{}[{}]", name, i));
        }
        return;
      default:
        return change_value(node, key, name);
    }
  }

  void change_value(const YamlNode& node, const FormKey& key, const std::string& name) {
    switch (key.kind) {
      case FormKind::version:
        return;
      case FormKind::boolean:
        return put(node, name, node.text == "true" ? "false" : "true");
      case FormKind::integer:
      case FormKind::integers:
      case FormKind::number:
      case FormKind::numbers:
        return change_number(node, key, name);
      case FormKind::choice:
      case FormKind::choices:
        for (const std::string_view word : key.words) put(node, name, yaml_text(word, true));
        return;
      case FormKind::colour:
        return put(node, name, "\"#010203\"");
      case FormKind::text:
      case FormKind::name:
      case FormKind::names:
        put(node, name, yaml_text(node.text + "x", true));
        for (const std::string& word : words_) put(node, name, yaml_text(word, true));
        return;
      case FormKind::anything:
        return put(node, name, "{another: 1}");
      case FormKind::own:
        for (const std::string& word : words_) put(node, name, word);
        return;
      default:
        FAIL("no changes are known for ", name);
    }
  }

  /// Somewhat more and somewhat less: what bounds and other keys allow is found out by trying.
  void change_number(const YamlNode& node, const FormKey& key, const std::string& name) {
    const double value = number_of(node).value();
    const bool whole = key.kind == FormKind::integer || key.kind == FormKind::integers;
    const double by = whole ? 1 : std::max(std::abs(value) / 100, 1e-6);
    for (const double other : {value + by, value - by}) {
      if (other >= key.low && other <= key.high) put(node, name, fmt::format("{}", other));
    }
  }

  void put(const YamlNode& node, const std::string& name, const std::string& value) {
    std::string text = text_;
    if (text.compare(node.begin, node.end - node.begin, value) == 0) return;
    text.replace(node.begin, node.end - node.begin, value);
    out_.push_back({name, std::move(text)});
  }

  const std::string& text_;
  std::vector<std::string> words_;
  std::vector<KeyChange> out_;
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool has_word(const std::string& text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_word(text[at - 1])) && (end == text.size() || !is_word(text[end]))) {
      return true;
    }
  }
  return false;
}

/// What stands between backticks, three of a fence as well, and lines indented by four.
std::string code_of(const std::string& page) {
  std::string out;
  bool code = false;
  for (std::size_t at = 0; at < page.size(); ++at) {
    if (page[at] == '`') {
      code = !code;
      out += ' ';
    } else if (code) {
      out += page[at];
    } else if (page.compare(at, 5, "\n    ") == 0) {
      const std::size_t end = std::min(page.find('\n', at + 1), page.size());
      out += page.substr(at, end - at);
      at = end - 1;
    }
  }
  return out;
}

}  // namespace

std::vector<KeyChange> key_changes(const std::string& text, const Form& form,
                                   const std::vector<std::string>& words) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<SourceFile>("full.yaml", text);
  const auto document = parse_yaml(source, {}, diagnostics);
  REQUIRE_MESSAGE(document.has_value(), to_text(diagnostics));
  std::vector<std::string> all = words;
  add_names(document->root, all);
  Changer changer(*document, std::move(all));
  changer.change_form(document->root, form, "");
  return changer.take();
}

std::set<std::string> declared_keys(const Form& form) {
  std::set<std::string> out;
  add_declared(form, "", out);
  return out;
}

std::vector<std::string> unread_keys(const std::vector<std::string>& texts, const Form& form,
                                     const std::vector<std::string>& words, const ShownText& read) {
  std::set<std::string> missing = declared_keys(form), tried, taken, unseen;
  std::vector<std::string> out;
  for (const std::string& text : texts) {
    const auto before = read(text);
    if (!before) out.emplace_back("a file of this test is refused");
    for (const KeyChange& change : key_changes(text, form, words)) {
      missing.erase(change.key.substr(0, change.key.find('[')));
      tried.insert(change.key);
      const auto after = read(change.text);
      if (!after) continue;
      taken.insert(change.key);
      if (after == before) unseen.insert(change.key);
    }
  }
  for (const auto& key : missing) out.push_back(key + " is in none of the files of this test");
  for (const auto& key : tried) {
    if (taken.contains(key)) continue;
    out.push_back(key + " takes no other value in the files of this test");
  }
  for (const auto& key : unseen) out.push_back(key + " is changed and nobody notices");
  return out;
}

std::vector<std::string> words_missing_on(const std::string& page,
                                          const std::vector<std::string>& words) {
  const std::string code = code_of(page);
  std::vector<std::string> out;
  for (const std::string& word : words) {
    if (!has_word(code, word)) out.push_back(word + " is not on the page");
  }
  return out;
}

std::vector<std::string> keys_missing_on(const std::string& page, const Form& form) {
  std::vector<std::string> words;
  for (const std::string& key : declared_keys(form))
    words.push_back(key.substr(key.rfind('/') + 1));
  return words_missing_on(page, words);
}

}  // namespace stig
