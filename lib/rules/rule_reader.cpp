// SPDX-License-Identifier: MIT
// Reads a rule set in three passes: YAML into a tree (base/yaml.h), the tree against the schema
// (base/form.h), and what is sound of it into a RuleSet, which is then checked as a whole
// (rule_checks.h). Each pass reports all that it finds, so that an author sees every mistake of
// a file at once; a set is handed out only when none was an error.
#include "rules/rule_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/load.h"
#include "base/text.h"
#include "base/yaml.h"
#include "rules/comments.h"
#include "rules/drawing.h"
#include "rules/palette_reader.h"
#include "rules/plain_reader.h"
#include "rules/rule_checks.h"
#include "rules/rule_schema.h"

namespace stig::rules {

namespace {

/// Colours when there is no usable `bricks`: enough to check what can be checked.
int count_bricks(const YamlNode& root) {
  const YamlNode* bricks = root.find("bricks");
  const std::size_t size = bricks == nullptr ? 0 : bricks->pairs.size();
  return static_cast<int>(std::min<std::size_t>(size, kMaxColours));
}

/// From a tree whose shape has been checked to a RuleSet. Nodes in `bad` have been
/// reported; what stands beside them is read all the same.
class Reader {
 public:
  Reader(const YamlDocument& document, const BadNodes& bad, Diagnostics& diagnostics)
      : document_(document),
        out_(diagnostics),
        plain_(document, bad),
        symbols_(count_bricks(document.root)),
        context_{document, Lattice::cubic, false, symbols_, diagnostics},
        palette_(plain_, symbols_, context_, rules_) {}

  RuleSet read() {
    // In an order in which each part has what it needs: drawings need the lattice, the floor and
    // all symbols, and the legend needs the bricks.
    rules_.file = document_.source;
    const YamlNode& root = document_.root;
    read_header(root);
    palette_.read_bricks(root.find("bricks"));
    palette_.read_legend(root.find("legend"));
    read_world(root);
    read_start(root.find("start"));
    read_rules(root.find("rules"));
    read_physical(plain_.good(root, "physical"));
    read_expect(root.find("expect"));
    return std::move(rules_);
  }

  /// Call after read().
  void report_unused_legend() const { palette_.report_unused_legend(); }

 private:
  void read_header(const YamlNode& root) {
    plain_.read(root, rule_set_form(), rules_);
    rules_.places.inversion = plain_.key_range(root, "inversion");
    rules_.places.conflicts = plain_.key_range(root, "conflicts");
    context_.lattice = rules_.lattice;
    context_.floor = rules_.floor;
    // Without a lattice no drawing can be judged.
    lattice_known_ = plain_.good(root, "lattice") != nullptr;
  }

  void read_world(const YamlNode& root) {
    if (const YamlNode* box = plain_.good(root, "box")) {
      plain_.read(*box, box_form(), rules_.box.emplace());
    }
    if (const YamlNode* stages = plain_.good(root, "stages")) {
      const FormKey& deposits = *key_of(rule_set_form(), "stages").entry;
      for (const YamlPair& pair : stages->pairs) {
        // The shape has been checked: the key is a number from 1 to kMaxStage.
        const int stage = std::stoi(pair.key.text);
        PlainReader::read_value(pair.value, deposits, rules_.stages[stage]);
        rules_.places.stages[stage] = document_.range(pair.key);
      }
    }
  }

  void read_start(const YamlNode* node) {
    if (node == nullptr) return;
    rules_.places.start = plain_.key_range(document_.root, "start");
    for (const YamlNode& entry : node->items) {
      if (entry.kind != YamlKind::mapping) continue;
      PlacedBrick placed;
      plain_.read(entry, start_form(), placed);
      const YamlNode* at = plain_.good(entry, "at");
      const YamlNode* brick = plain_.good(entry, "brick");
      const auto colour = brick == nullptr ? std::nullopt : palette_.brick_symbol(*brick);
      if (at == nullptr || !colour) continue;
      placed.brick = *colour;
      rules_.start.push_back(placed);
      rules_.places.start_bricks.push_back(document_.range(*at));
    }
  }

  void read_rules(const YamlNode* node) {
    // Too many are an error that has been reported; reading them would only take time.
    if (node == nullptr || node->items.size() > static_cast<std::size_t>(kMaxRules)) return;
    SeenNames names;
    rules_.rules.reserve(node->items.size());
    for (const YamlNode& entry : node->items) {
      if (entry.kind != YamlKind::mapping) continue;
      std::optional<Rule> rule = read_rule(entry);
      // A rule that is not sound has a name all the same, and a second one of it is a mistake.
      const YamlNode* name = plain_.good(entry, "name");
      if (name != nullptr) check_unique(names, name->text, document_.range(*name), "rule", out_);
      if (rule) rules_.rules.push_back(std::move(*rule));
    }
  }

  /// The rule, or nothing when something in it was wrong.
  std::optional<Rule> read_rule(const YamlNode& node) {
    Rule rule;
    plain_.read(node, rule_form(), rule);
    rule.range = document_.range(node);
    bool sound = plain_.is_good(node);
    if (const YamlNode* name = plain_.good(node, "name")) rule.name_range = document_.range(*name);
    if (const YamlNode* place = plain_.good(node, "place")) {
      const auto colour = palette_.brick_symbol(*place);
      sound = sound && colour.has_value();
      rule.place = colour.value_or(0);
      rule.place_range = document_.range(*place);
    }
    if (const YamlNode* when = plain_.good(node, "when")) sound = read_when(*when, rule) && sound;
    if (const YamlNode* height = plain_.good(node, "height")) {
      const bool bounded = rule.height_min && rule.height_max;
      sound = (!bounded || check_order(*height, *rule.height_min, *rule.height_max)) && sound;
    }
    if (const YamlNode* counts = node.find("count")) {
      for (const YamlNode& entry : counts->items) sound = read_count(entry, rule) && sound;
    }
    return sound ? std::optional(std::move(rule)) : std::nullopt;
  }

  bool read_when(const YamlNode& when, Rule& rule) {
    rule.when_range = document_.range(when);
    // Without lattice and palette every drawing would seem wrong; the cause has been reported.
    if (!lattice_known_ || !palette_.known()) return false;
    const auto pattern = read_pattern(when, rules_.inversion_of(rule), context_);
    if (pattern) rule.pattern = *pattern;
    return pattern.has_value();
  }

  bool check_order(const YamlNode& node, std::int64_t low, std::int64_t high) {
    if (low <= high) return true;
    out_.add(Code::R317, document_.range(node), fmt::format("min: {} is above max: {}", low, high));
    return false;
  }

  bool read_count(const YamlNode& node, Rule& rule) {
    if (!plain_.is_good(node) || node.kind != YamlKind::mapping) return false;
    CountCondition count;
    plain_.read(node, count_form(), count);
    count.range = document_.range(node);
    const auto states = palette_.states(*node.find("of"), false);
    const bool ordered = check_order(node, count.min, count.max);
    if (!states || !ordered) return false;
    count.of = *states;
    rule.counts.push_back(count);
    return true;
  }

  void read_physical(const YamlNode* node) {
    if (node != nullptr) plain_.read(*node, physical_form(), rules_.physical.emplace());
  }

  void read_expect(const YamlNode* node) {
    if (node == nullptr || node->kind != YamlKind::mapping) return;
    const auto range_of = [&](std::string_view key) {
      const YamlNode* value = node->find(key);
      return value == nullptr ? SourceRange{} : document_.head(*value);
    };
    Expectation& expect = rules_.expect.emplace();
    plain_.read(*node, expect_form(), expect);
    expect.range = document_.range(*node);
    expect.bricks_range = range_of("bricks");
    expect.verdict_range = range_of("verdict");
    expect.structure_range = range_of("structure");
    const YamlNode* structure = plain_.good(*node, "structure");
    if (structure != nullptr && palette_.known()) {
      // A drawing that cannot be read has been reported, and the set is not handed out.
      expect.structure = read_structure(*structure, context_).value_or(std::vector<PlacedBrick>());
    }
  }

  const YamlDocument& document_;
  Diagnostics& out_;
  PlainReader plain_;
  SymbolTable symbols_;
  DrawingContext context_;
  RuleSet rules_;
  PaletteReader palette_;
  bool lattice_known_ = false;
};

}  // namespace

std::optional<RuleSet> read_rule_set(SourceRef source, Diagnostics& diagnostics) {
  YamlLimits limits;
  limits.bytes = kMaxRuleFileBytes;
  Diagnostics found;
  const auto document = parse_yaml(std::move(source), limits, found);
  std::optional<RuleSet> rules;
  if (document) {
    const BadNodes bad = check_form(*document, rule_set_form(), found);
    Reader reader(*document, bad, found);
    rules = reader.read();
    // Only what is certain is said of a file with errors: a brick that seems unused
    // may be used by the rule that could not be read.
    const bool whole = !found.has_errors();
    check_rule_set(*rules, whole ? CheckScope::all : CheckScope::certain, found);
    if (whole) reader.report_unused_legend();
    rules->comments = place_comments(*document);
  }
  // The caller's list may hold errors of other files, which must not spoil this one.
  diagnostics.append(found);
  return found.has_errors() ? std::nullopt : std::move(rules);
}

std::optional<RuleSet> read_rule_set_file(const std::string& path, Diagnostics& diagnostics) {
  SourceRef source = load_source(path, kMaxRuleFileBytes, diagnostics);
  return source ? read_rule_set(std::move(source), diagnostics) : std::nullopt;
}

}  // namespace stig::rules
