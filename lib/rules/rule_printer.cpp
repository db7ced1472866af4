// SPDX-License-Identifier: MIT
// The canonical form: one way to write every rule set. Reading it back gives an equal set,
// and printing that the same bytes; tests hold both as laws. Defaults are left out, keys
// have a fixed order, and comments are printed with the element that they belong to
// (comments.h).
#include "rules/rule_printer.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "base/yaml.h"
#include "rules/pattern_text.h"
#include "rules/rule_schema.h"
#include "rules/value_texts.h"

namespace stig::rules {

namespace {

/// One line each, without its line end.
using Lines = std::vector<std::string>;

/// The sets of states that need a symbol of their own.
template <class Visit>
void visit_cells(const RuleSet& rules, Visit visit) {
  const auto size = static_cast<std::size_t>(neighbourhood(rules.lattice).size);
  for (const Rule& rule : rules.rules) {
    for (std::size_t i = 0; i < size; ++i) visit(rule.pattern.allowed[i]);
  }
}

/// Symbols for new legend entries: a … z, A … Z, then s1, s2, ….
std::string fresh_symbol(const std::set<std::string>& taken, int& next) {
  static constexpr std::string_view kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  while (true) {
    const auto index = static_cast<std::size_t>(next++);
    std::string symbol = index < kLetters.size() ? std::string(1, kLetters[index])
                                                 : fmt::format("s{}", index - kLetters.size() + 1);
    if (taken.count(symbol) == 0) return symbol;
  }
}

/// Sets of states that came from a program may have no symbol yet; they get one in the
/// legend.
RuleSet with_whole_legend(RuleSet rules) {
  std::set<std::string> taken;
  for (const Brick& brick : rules.bricks) taken.insert(brick.symbol);
  for (const LegendEntry& entry : rules.legend) taken.insert(entry.symbol);
  std::set<std::uint64_t> drawn;
  for (const LegendEntry& entry : rules.legend) drawn.insert(entry.states.bits());
  std::vector<LegendEntry> added;
  int next = 0;
  visit_cells(rules, [&](StateSet states) {
    if (find_symbol(rules, states) || !drawn.insert(states.bits()).second) return;
    added.push_back({fresh_symbol(taken, next), states, {}});
  });
  rules.legend.insert(rules.legend.end(), added.begin(), added.end());
  return rules;
}

/// Writes the file line by line, each comment with the element it belongs to.
class Printer {
 public:
  explicit Printer(const RuleSet& rules) : rules_(rules), texts_(rules) {
    for (const Comment& comment : rules.comments) {
      // An element has one line for a trailing comment; further ones go before it.
      Comments& of = comments_[comment.element];
      (comment.trailing && of.trailing.empty() ? of.trailing : of.leading).push_back(comment.text);
    }
  }

  std::string print() {
    RuleSet usual;
    // The symmetry is always written: without it nobody can say what a rule means.
    usual.symmetry = rules_.symmetry == Symmetry::none ? Symmetry::rotations : Symmetry::none;
    // Keys go by the schema and not by the members, so that the schema alone decides the order
    // of a file.
    for (const FormKey& key : rule_set_form().keys) {
      if (key.name == "stigc") line(0, "stigc", fmt::format("stigc: {}", kFormatVersion));
      for_each_pair(rules_, usual, [&](const auto& field, const auto& otherwise) {
        if (field.key != key.name) return;
        const bool written = key.required || !same_fields(field.value, otherwise.value);
        written ? member(key, field.value) : absent(0, std::string(key.name));
      });
    }
    for (const std::string& text : comments_[""].leading) out_ += text + "\n";
    return std::move(out_);
  }

 private:
  struct Comments {
    Lines leading, trailing;
  };

  void put_comments(std::size_t indent, Lines& comments) {
    for (const std::string& text : comments) out_ += std::string(indent, ' ') + text + "\n";
    comments.clear();
  }
  void comments_before(std::size_t indent, const std::string& element) {
    put_comments(indent, comments_[element].leading);
  }
  /// The comments of an element that is not printed, since it says what holds anyway. A
  /// comment must not vanish because its element does.
  void absent(std::size_t indent, const std::string& element) {
    comments_before(indent, element);
    put_comments(indent, comments_[element].trailing);
  }
  /// The same of all keys of a mapping that are not written.
  void absent_keys(const std::string& path, const Form& form, const std::vector<KeyText>& written) {
    for (const FormKey& key : form.keys) {
      const bool found = std::any_of(written.begin(), written.end(),
                                     [&](const KeyText& text) { return text.key == key.name; });
      if (!found) absent(2, path + "/" + std::string(key.name));
    }
  }
  void put(std::size_t indent, const std::string& element, std::string_view text) {
    out_ += std::string(indent, ' ');
    out_ += text;
    for (const std::string& comment : comments_[element].trailing) out_ += "  " + comment;
    out_ += "\n";
  }
  void line(std::size_t indent, const std::string& element, std::string_view text) {
    comments_before(indent, element);
    put(indent, element, text);
  }
  /// A drawing's rows are set in below the key, by the same two spaces as "|2" announces.
  void key_lines(std::size_t indent, const std::string& path, const KeyText& key) {
    line(indent, path + "/" + key.key, key.key + ": " + key.text);
    for (std::size_t i = 0; i < key.rows.size();) {
      const std::size_t end = std::min(key.rows.find('\n', i), key.rows.size());
      out_ += std::string(indent + 2, ' ');
      out_ += key.rows.substr(i, end - i);
      out_ += "\n";
      i = end + 1;
    }
  }

  /// On one line.
  template <class T>
  void member(const FormKey& key, const T& value) {
    const std::string name(key.name);
    line(0, name, name + ": " + texts_.text(value, key, false));
  }

  void member(const FormKey& /*key*/, const std::vector<Brick>& bricks) {
    line(0, "bricks", "bricks:");
    for (const Brick& brick : bricks) {
      Brick usual;
      usual.name = brick.symbol;
      line(2, "bricks/" + brick.symbol,
           yaml_text(brick.symbol) + ": " + texts_.mapping(brick, usual, brick_form()));
    }
  }

  // An entry is written out, since entries cannot refer to each other.
  void member(const FormKey& /*key*/, const std::vector<LegendEntry>& legend) {
    line(0, "legend", "legend:");
    for (const LegendEntry& entry : legend) {
      line(2, "legend/" + entry.symbol,
           yaml_text(entry.symbol) + ": " + texts_.state_list(entry.states, false));
    }
  }

  void member(const FormKey& key, const std::vector<PlacedBrick>& start) {
    line(0, "start", start.empty() ? "start: []" : "start:");
    for (std::size_t i = 0; i < start.size(); ++i) {
      line(2, fmt::format("start/{}", i),
           "- " + texts_.mapping(start[i], PlacedBrick(), *key.form));
    }
  }

  /// A mapping with a line for each key.
  template <HasFields T>
  void member(const FormKey& key, const std::optional<T>& object) {
    const std::string name(key.name);
    const auto keys = texts_.keys(*object, T(), *key.form, false);
    absent_keys(name, *key.form, keys);
    line(0, name, keys.empty() ? name + ": {}" : name + ":");
    for (const KeyText& text : keys) key_lines(2, name, text);
  }
  void member(const FormKey& key, const std::optional<BoxSpec>& box) {
    line(0, "box", "box: " + texts_.mapping(*box, BoxSpec(), *key.form));
  }

  void member(const FormKey& key, const std::vector<Rule>& rules) {
    line(0, "rules", rules.empty() ? "rules: []" : "rules:");
    for (std::size_t i = 0; i < rules.size(); ++i) {
      one_rule(texts_.keys(rules[i], Rule(), *key.form, false), fmt::format("rules/{}", i));
    }
  }

  /// The name comes first, and its line begins the rule. Comments on keys that are not printed
  /// stand before it, where they still belong to the same rule when the file is read again.
  void one_rule(const std::vector<KeyText>& keys, const std::string& path) {
    absent_keys(path, rule_form(), keys);
    comments_before(2, path);
    comments_before(2, path + "/name");
    put_comments(2, comments_[path].trailing);
    put(2, path + "/name", "- name: " + keys.front().text);
    for (std::size_t i = 1; i < keys.size(); ++i) key_lines(4, path, keys[i]);
  }

  const RuleSet& rules_;
  ValueTexts texts_;
  std::string out_;
  std::unordered_map<std::string, Comments> comments_;
};

}  // namespace

std::string print_rule_set(const RuleSet& rules) {
  const RuleSet whole = with_whole_legend(rules);
  return Printer(whole).print();
}

}  // namespace stig::rules
