// SPDX-License-Identifier: MIT
#include "rules/rule_printer.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "base/yaml.h"
#include "rules/pattern_text.h"
#include "rules/rule_schema.h"

namespace stig {

namespace {

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
  explicit Printer(const RuleSet& rules) : rules_(rules) {
    for (const Comment& comment : rules.comments) {
      Comments& of = comments_[comment.element];
      (comment.trailing && of.trailing.empty() ? of.trailing : of.leading).push_back(comment.text);
    }
  }

  std::string print() {
    header();
    bricks();
    legend();
    box();
    stages();
    start();
    physical();
    expect();
    rule_list();
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
  /// The comments of an element that is not printed, since it says what holds anyway.
  void absent(std::size_t indent, const std::string& element) {
    comments_before(indent, element);
    put_comments(indent, comments_[element].trailing);
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
  void rows(std::size_t indent, std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      out_ += std::string(indent, ' ');
      out_ += text.substr(i, end - i);
      out_ += "\n";
      i = end + 1;
    }
  }
  void key(const std::string& name, bool present, const std::string& value) {
    present ? line(0, name, name + ": " + value) : absent(0, name);
  }

  void header() {
    key("stigc", true, fmt::format("{}", kFormatVersion));
    key("name", true, yaml_text(rules_.name));
    key("title", !rules_.title.empty(), yaml_text(rules_.title));
    key("source", !rules_.source.empty(), yaml_text(rules_.source));
    key("lattice", true, std::string(to_string(rules_.lattice)));
    key("symmetry", true, std::string(to_string(rules_.symmetry)));
    key("inversion", rules_.inversion, "true");
    key("floor", rules_.floor, "true");
    key("conflicts", rules_.conflicts != Conflicts::error,
        std::string(to_string(rules_.conflicts)));
  }

  void bricks() {
    line(0, "bricks", "bricks:");
    for (const Brick& brick : rules_.bricks) {
      std::string fields;
      if (brick.name != brick.symbol) fields += "name: " + yaml_text(brick.name, true) + ", ";
      fields += fmt::format("color: \"{}\"", brick.color);
      if (!brick.led.empty()) fields += ", led: " + brick.led;
      line(2, "bricks/" + brick.symbol, fmt::format("{}: {{{}}}", yaml_text(brick.symbol), fields));
    }
  }

  /// Symbols in brackets that together stand for a set of states.
  std::string state_list(StateSet states, bool by_legend) const {
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

  void legend() {
    if (rules_.legend.empty()) return absent(0, "legend");
    line(0, "legend", "legend:");
    for (const LegendEntry& entry : rules_.legend) {
      line(2, "legend/" + entry.symbol,
           yaml_text(entry.symbol) + ": " + state_list(entry.states, false));
    }
  }

  void box() {
    if (!rules_.box) return absent(0, "box");
    const BoxSpec& box = *rules_.box;
    std::string text = fmt::format("box: {{size: [{}, {}, {}]", box.size.x, box.size.y, box.size.z);
    if (box.origin) {
      text += fmt::format(", origin: [{}, {}, {}]", box.origin->x, box.origin->y, box.origin->z);
    }
    line(0, "box", text + (box.periodic ? ", periodic: true}" : "}"));
  }

  void stages() {
    if (rules_.stages.empty()) return absent(0, "stages");
    std::string text;
    for (const auto& [stage, deposits] : rules_.stages) {
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", stage, deposits);
    }
    line(0, "stages", "stages: {" + text + "}");
  }

  void start() {
    line(0, "start", rules_.start.empty() ? "start: []" : "start:");
    for (std::size_t i = 0; i < rules_.start.size(); ++i) {
      const auto& [at, brick] = rules_.start[i];
      line(2, fmt::format("start/{}", i),
           fmt::format("- {{at: [{}, {}, {}], brick: {}}}", at.x, at.y, at.z,
                       yaml_text(rules_.brick(brick).symbol, true)));
    }
  }

  void physical() {
    if (!rules_.physical) return absent(0, "physical");
    const PhysicalSpec& physical = *rules_.physical;
    if (physical.sides.empty()) absent(0, "physical/sides");
    line(0, "physical", physical.sides.empty() && !physical.robots ? "physical: {}" : "physical:");
    if (!physical.sides.empty()) {
      line(2, "physical/sides", fmt::format("sides: [{}]", fmt::join(physical.sides, ", ")));
    }
    if (physical.robots) line(2, "physical/robots", fmt::format("robots: {}", *physical.robots));
  }

  void expect() {
    if (!rules_.expect) return absent(0, "expect");
    const Expectation& expect = *rules_.expect;
    const bool any = expect.bricks || expect.verdict || !expect.structure.empty();
    line(0, "expect", any ? "expect:" : "expect: {}");
    if (expect.bricks) line(2, "expect/bricks", fmt::format("bricks: {}", *expect.bricks));
    if (expect.verdict) {
      line(2, "expect/verdict", fmt::format("verdict: {}", to_string(*expect.verdict)));
    }
    if (expect.structure.empty()) return;
    line(2, "expect/structure", "structure: |");
    rows(4, draw_structure(rules_, expect.structure));
  }

  void rule_list() {
    line(0, "rules", rules_.rules.empty() ? "rules: []" : "rules:");
    for (std::size_t i = 0; i < rules_.rules.size(); ++i) {
      one_rule(rules_.rules[i], fmt::format("rules/{}", i));
    }
  }

  /// The keys of a rule that are written, but for its drawing, in order.
  std::vector<std::pair<std::string, std::string>> fields(const Rule& rule) const {
    std::vector<std::pair<std::string, std::string>> out;
    if (rule.stage > 0) out.emplace_back("stage", fmt::format("{}", rule.stage));
    out.emplace_back("place", yaml_text(rules_.brick(rule.place).symbol));
    if (rule.probability != 1) out.emplace_back("probability", fmt::format("{}", rule.probability));
    if (rule.weight != 1) out.emplace_back("weight", fmt::format("{}", rule.weight));
    if (rule.symmetry) out.emplace_back("symmetry", to_string(*rule.symmetry));
    if (rule.inversion) out.emplace_back("inversion", *rule.inversion ? "true" : "false");
    out.emplace_back("when", rules_.lattice == Lattice::hexagonal ? "|2" : "|");
    if (rule.height_min || rule.height_max) out.emplace_back("height", height(rule));
    if (!rule.counts.empty()) out.emplace_back("count", counts(rule));
    return out;
  }

  void one_rule(const Rule& rule, const std::string& path) {
    const auto written = fields(rule);
    for (const KeySchema& schema : object_schema(ObjectKind::rule).keys) {
      const bool found = schema.name == "name" ||
                         std::any_of(written.begin(), written.end(),
                                     [&](const auto& field) { return field.first == schema.name; });
      if (!found) absent(2, path + "/" + std::string(schema.name));
    }
    comments_before(2, path);
    comments_before(2, path + "/name");
    put_comments(2, comments_[path].trailing);
    put(2, path + "/name", "- name: " + yaml_text(rule.name));
    for (const auto& [name, value] : written) {
      line(4, path + "/" + name, name + ": " + value);
      if (name == "when") rows(6, draw_pattern(rules_, rule.pattern));
    }
  }

  static std::string height(const Rule& rule) {
    std::string out;
    if (rule.height_min) out = fmt::format("min: {}", *rule.height_min);
    if (rule.height_max) {
      out += fmt::format("{}max: {}", out.empty() ? "" : ", ", *rule.height_max);
    }
    return "{" + out + "}";
  }

  std::string counts(const Rule& rule) const {
    std::string out;
    for (const CountCondition& count : rule.counts) {
      out += (out.empty() ? "{of: " : ", {of: ") + state_list(count.of, true);
      if (count.faces_only) out += ", among: faces";
      if (count.min > 0) out += fmt::format(", min: {}", count.min);
      if (count.max < kMaxNeighbours) out += fmt::format(", max: {}", count.max);
      out += "}";
    }
    return "[" + out + "]";
  }

  const RuleSet& rules_;
  std::string out_;
  std::unordered_map<std::string, Comments> comments_;
};

}  // namespace

std::string print_rule_set(const RuleSet& rules) {
  const RuleSet whole = with_whole_legend(rules);
  return Printer(whole).print();
}

}  // namespace stig
