// SPDX-License-Identifier: MIT
#include "rules/rule_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <unordered_map>

#include "base/load.h"
#include "base/text.h"
#include "base/yaml.h"
#include "rules/comments.h"
#include "rules/drawing.h"
#include "rules/rule_checks.h"
#include "rules/rule_schema.h"

namespace stig {

namespace {

/// Names that must be unique, with the place of their first use.
using SeenNames = std::unordered_map<std::string, SourceRange>;

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
        bad_(bad),
        out_(diagnostics),
        symbols_(count_bricks(document.root)),
        context_{document, Lattice::cubic, false, symbols_, diagnostics} {}

  RuleSet read() {
    rules_.file = document_.source;
    const YamlNode& root = document_.root;
    read_header(root);
    read_bricks(root.find("bricks"));
    read_legend(root.find("legend"));
    read_world(root);
    read_start(root.find("start"));
    read_rules(root.find("rules"));
    read_physical(good(root, "physical"));
    read_expect(root.find("expect"));
    return std::move(rules_);
  }

  /// Legend symbols that nothing uses. Call after read().
  void report_unused_legend() const {
    for (const LegendEntry& entry : rules_legend_) {
      if (symbols_.find(entry.symbol)->used) continue;
      out_.add(Code::R313, entry.range,
               fmt::format("nothing uses the symbol {}", in_quotes(entry.symbol)));
    }
  }

 private:
  bool is_good(const YamlNode& node) const { return bad_.count(&node) == 0; }
  /// The key's value when it is there and of the right shape.
  const YamlNode* good(const YamlNode& node, std::string_view key) const {
    const YamlNode* value = node.find(key);
    return value != nullptr && is_good(*value) ? value : nullptr;
  }
  SourceRange key_range(const YamlNode& node, std::string_view key) const {
    for (const YamlPair& pair : node.pairs) {
      if (pair.key.text == key) return document_.range(pair.key);
    }
    return {};
  }

  std::string text(const YamlNode& node, std::string_view key) const {
    const YamlNode* value = good(node, key);
    if (value == nullptr) return {};
    // A folded or literal block ends in a line end that its author did not mean.
    return value->text.substr(0, value->text.find_last_not_of(" \t\r\n") + 1);
  }
  bool truth(const YamlNode& node, std::string_view key) const {
    const YamlNode* value = good(node, key);
    return value != nullptr && value->text == "true";
  }
  static std::int64_t integer(const YamlNode& node) {
    return static_cast<std::int64_t>(number_of(node).value());
  }
  std::optional<std::int64_t> integer(const YamlNode& node, std::string_view key) const {
    const YamlNode* value = good(node, key);
    return value == nullptr ? std::nullopt : std::optional(integer(*value));
  }
  std::optional<int> small_integer(const YamlNode& node, std::string_view key) const {
    const auto value = integer(node, key);
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
  }
  /// The enumerator whose position in the table's list of words the value has.
  template <class Enum>
  std::optional<Enum> choice(const YamlNode& node, ObjectKind kind, std::string_view key) const {
    const YamlNode* value = good(node, key);
    if (value == nullptr) return std::nullopt;
    const auto& keys = object_schema(kind).keys;
    const auto schema =
        std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.name == key; });
    assert(schema != keys.end());
    const auto word = std::find(schema->words.begin(), schema->words.end(), value->text);
    return static_cast<Enum>(word - schema->words.begin());
  }
  static std::array<std::int32_t, 3> triple(const YamlNode& node) {
    std::array<std::int32_t, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = static_cast<std::int32_t>(integer(node.items[i]));
    return out;
  }

  void read_header(const YamlNode& root) {
    rules_.name = text(root, "name");
    rules_.title = text(root, "title");
    rules_.source = text(root, "source");
    const auto of_set = ObjectKind::rule_set;
    rules_.lattice = choice<Lattice>(root, of_set, "lattice").value_or(Lattice::cubic);
    rules_.symmetry = choice<Symmetry>(root, of_set, "symmetry").value_or(Symmetry::none);
    rules_.conflicts = choice<Conflicts>(root, of_set, "conflicts").value_or(Conflicts::error);
    rules_.inversion = truth(root, "inversion");
    rules_.floor = truth(root, "floor");
    rules_.places.inversion = key_range(root, "inversion");
    rules_.places.conflicts = key_range(root, "conflicts");
    context_.lattice = rules_.lattice;
    context_.floor = rules_.floor;
    // Without a lattice no drawing can be judged.
    lattice_known_ = good(root, "lattice") != nullptr;
  }

  void read_bricks(const YamlNode* node) {
    bricks_known_ = node != nullptr && node->kind == YamlKind::mapping && !node->pairs.empty() &&
                    node->pairs.size() <= static_cast<std::size_t>(kMaxColours);
    if (!bricks_known_) return;
    SeenNames names;
    for (const YamlPair& pair : node->pairs) {
      if (!is_good(pair.key)) {
        bricks_known_ = bricks_known_ && pair.key.kind == YamlKind::scalar;
        continue;
      }
      const auto colour = static_cast<Colour>(rules_.bricks.size() + 1);
      if (!symbols_.add(pair.key.text, {StateSet::of(colour), colour, true})) continue;
      rules_.bricks.push_back(read_brick(pair));
      symbols_.add_name(rules_.bricks.back().name, pair.key.text);
      check_unique(names, rules_.bricks.back().name, rules_.bricks.back().range, "brick");
    }
  }

  Brick read_brick(const YamlPair& pair) const {
    Brick brick;
    brick.symbol = pair.key.text;
    brick.name = text(pair.value, "name");
    if (brick.name.empty()) brick.name = brick.symbol;
    brick.color = text(pair.value, "color");
    std::transform(brick.color.begin(), brick.color.end(), brick.color.begin(),
                   [](char c) { return c >= 'A' && c <= 'F' ? static_cast<char>(c + 32) : c; });
    brick.led = text(pair.value, "led");
    brick.range = document_.range(pair.key);
    return brick;
  }

  void check_unique(SeenNames& names, const std::string& name, const SourceRange& range,
                    std::string_view what) {
    if (name.empty()) return;
    const auto [first, added] = names.emplace(name, range);
    if (added) return;
    out_.add(Code::R208, range, fmt::format("a second {} named {}", what, in_quotes(name)))
        .note(first->second, "the first one");
  }

  void read_legend(const YamlNode* node) {
    if (node == nullptr) return;
    for (const YamlPair& pair : node->pairs) {
      const SourceRange range = document_.range(pair.key);
      if (!is_good(pair.key)) continue;
      const auto states = is_good(pair.value) ? read_states(pair.value, true) : std::nullopt;
      if (const Brick* brick = brick_of(pair.key.text)) {
        out_.add(Code::R206, range,
                 fmt::format("the symbol {} is a brick's", in_quotes(brick->symbol)))
            .note(brick->range, "the brick");
        continue;
      }
      // A symbol that could not be read is known all the same, to name errors once.
      if (!symbols_.add(pair.key.text, {states.value_or(StateSet()), 0, false})) continue;
      if (states) rules_.legend.push_back({pair.key.text, *states, range});
    }
    rules_legend_ = rules_.legend;
  }

  const Brick* brick_of(const std::string& symbol) const {
    const SymbolTable::Entry* entry = symbols_.find(symbol);
    return entry == nullptr || entry->colour == 0 ? nullptr : &rules_.brick(entry->colour);
  }

  /// The states of a list of symbols; legend entries only where allowed to avoid
  /// that entries depend on each other's order.
  std::optional<StateSet> read_states(const YamlNode& list, bool in_legend) {
    StateSet states;
    bool sound = true;
    for (const YamlNode& item : list.items) {
      const SymbolTable::Entry* entry = symbols_.find(item.text);
      const bool refused =
          item.text == "*" || (in_legend && entry != nullptr && entry->colour == 0);
      const auto found = refused ? std::nullopt : symbols_.states(item.text);
      if (!found) unknown_symbol(item, in_legend);
      sound = sound && found && !found->none();
      states = states | found.value_or(StateSet());
    }
    return sound ? std::optional(states) : std::nullopt;
  }

  void unknown_symbol(const YamlNode& node, bool bricks_only) {
    if (bricks_known_) report_unknown(document_.range(node), node.text, bricks_only, context_);
  }

  std::optional<Colour> read_brick_symbol(const YamlNode& node) {
    const SymbolTable::Entry* entry = symbols_.find(node.text);
    if (entry != nullptr && entry->colour != 0) return entry->colour;
    unknown_symbol(node, true);
    return std::nullopt;
  }

  void read_world(const YamlNode& root) {
    if (const YamlNode* box = good(root, "box")) {
      BoxSpec spec;
      const auto size = triple(*box->find("size"));
      spec.size = {size[0], size[1], size[2]};
      if (const YamlNode* origin = box->find("origin")) {
        const auto low = triple(*origin);
        spec.origin = Cell{low[0], low[1], low[2]};
      }
      spec.periodic = truth(*box, "periodic");
      rules_.box = spec;
    }
    if (const YamlNode* stages = good(root, "stages")) {
      for (const YamlPair& pair : stages->pairs) {
        const int stage = std::stoi(pair.key.text);
        rules_.stages[stage] = integer(pair.value);
        rules_.places.stages[stage] = document_.range(pair.key);
      }
    }
  }

  void read_start(const YamlNode* node) {
    if (node == nullptr) return;
    rules_.places.start = key_range(document_.root, "start");
    for (const YamlNode& entry : node->items) {
      if (entry.kind != YamlKind::mapping) continue;
      const YamlNode* at = good(entry, "at");
      const YamlNode* brick = good(entry, "brick");
      const auto colour = brick == nullptr ? std::nullopt : read_brick_symbol(*brick);
      if (at == nullptr || !colour) continue;
      const auto cell = triple(*at);
      rules_.start.push_back({{cell[0], cell[1], cell[2]}, *colour});
      rules_.places.start_bricks.push_back(document_.range(*at));
    }
  }

  void read_rules(const YamlNode* node) {
    if (node == nullptr || node->items.size() > static_cast<std::size_t>(kMaxRules)) return;
    SeenNames names;
    rules_.rules.reserve(node->items.size());
    for (const YamlNode& entry : node->items) {
      if (entry.kind != YamlKind::mapping) continue;
      std::optional<Rule> rule = read_rule(entry);
      const YamlNode* name = good(entry, "name");
      if (name != nullptr) check_unique(names, name->text, document_.range(*name), "rule");
      if (rule) rules_.rules.push_back(std::move(*rule));
    }
  }

  /// The rule, or nothing when something in it was wrong.
  std::optional<Rule> read_rule(const YamlNode& node) {
    Rule rule;
    rule.range = document_.range(node);
    bool sound = is_good(node);
    if (const YamlNode* name = good(node, "name")) {
      rule.name = text(node, "name");
      rule.name_range = document_.range(*name);
    }
    if (const YamlNode* place = good(node, "place")) {
      const auto colour = read_brick_symbol(*place);
      sound = sound && colour.has_value();
      rule.place = colour.value_or(0);
      rule.place_range = document_.range(*place);
    }
    rule.symmetry = choice<Symmetry>(node, ObjectKind::rule, "symmetry");
    if (good(node, "inversion") != nullptr) rule.inversion = truth(node, "inversion");
    if (const YamlNode* when = good(node, "when")) {
      sound = read_when(*when, rule) && sound;
    }
    sound = read_conditions(node, rule) && sound;
    return sound ? std::optional(std::move(rule)) : std::nullopt;
  }

  bool read_when(const YamlNode& when, Rule& rule) {
    rule.when_range = document_.range(when);
    if (!lattice_known_ || !bricks_known_) return false;
    const auto pattern = read_pattern(when, rules_.inversion_of(rule), context_);
    if (pattern) rule.pattern = *pattern;
    return pattern.has_value();
  }

  bool read_conditions(const YamlNode& node, Rule& rule) {
    rule.stage = small_integer(node, "stage").value_or(0);
    if (const YamlNode* value = good(node, "probability")) rule.probability = *number_of(*value);
    if (const YamlNode* value = good(node, "weight")) rule.weight = *number_of(*value);
    bool sound = true;
    if (const YamlNode* height = good(node, "height")) {
      rule.height_min = small_integer(*height, "min");
      rule.height_max = small_integer(*height, "max");
      if (rule.height_min && rule.height_max) {
        sound = check_order(*height, *rule.height_min, *rule.height_max);
      }
    }
    const YamlNode* counts = node.find("count");
    if (counts == nullptr) return sound;
    for (const YamlNode& entry : counts->items) sound = read_count(entry, rule) && sound;
    return sound;
  }

  bool check_order(const YamlNode& node, std::int64_t low, std::int64_t high) {
    if (low <= high) return true;
    out_.add(Code::R317, document_.range(node), fmt::format("min: {} is above max: {}", low, high));
    return false;
  }

  bool read_count(const YamlNode& node, Rule& rule) {
    if (!is_good(node) || node.kind != YamlKind::mapping) return false;
    CountCondition count;
    count.range = document_.range(node);
    count.faces_only = text(node, "among") == "faces";
    count.min = small_integer(node, "min").value_or(0);
    count.max = small_integer(node, "max").value_or(kMaxNeighbours);
    const auto states = read_states(*node.find("of"), false);
    const bool ordered = check_order(node, count.min, count.max);
    if (!states || !ordered) return false;
    count.of = *states;
    rule.counts.push_back(count);
    return true;
  }

  void read_physical(const YamlNode* node) {
    if (node == nullptr) return;
    PhysicalSpec physical;
    if (const YamlNode* sides = node->find("sides")) {
      for (const YamlNode& side : sides->items) physical.sides.push_back(side.text);
    }
    physical.robots = small_integer(*node, "robots");
    rules_.physical = std::move(physical);
  }

  void read_expect(const YamlNode* node) {
    if (node == nullptr || node->kind != YamlKind::mapping) return;
    const auto range_of = [&](std::string_view key) {
      const YamlNode* value = node->find(key);
      return value == nullptr ? SourceRange{} : document_.head(*value);
    };
    Expectation expect;
    expect.range = document_.range(*node);
    expect.bricks = integer(*node, "bricks");
    expect.bricks_range = range_of("bricks");
    expect.verdict = choice<Verdict>(*node, ObjectKind::expect, "verdict");
    expect.verdict_range = range_of("verdict");
    expect.structure_range = range_of("structure");
    const YamlNode* structure = good(*node, "structure");
    if (structure != nullptr && bricks_known_) {
      expect.structure = read_structure(*structure, context_).value_or(std::vector<PlacedBrick>());
    }
    rules_.expect = std::move(expect);
  }

  const YamlDocument& document_;
  const BadNodes& bad_;
  Diagnostics& out_;
  SymbolTable symbols_;
  DrawingContext context_;
  RuleSet rules_;
  std::vector<LegendEntry> rules_legend_;
  bool bricks_known_ = false;
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
    const BadNodes bad = check_shape(*document, found);
    Reader reader(*document, bad, found);
    rules = reader.read();
    // Of a file with errors only what is certain is said: a brick that seems unused
    // may be used by the rule that could not be read.
    const bool whole = !found.has_errors();
    check_rule_set(*rules, whole ? CheckScope::all : CheckScope::certain, found);
    if (whole) reader.report_unused_legend();
    rules->comments = place_comments(*document);
  }
  diagnostics.append(found);
  return found.has_errors() ? std::nullopt : std::move(rules);
}

std::optional<RuleSet> read_rule_set_file(const std::string& path, Diagnostics& diagnostics) {
  SourceRef source = load_source(path, kMaxRuleFileBytes, diagnostics);
  return source ? read_rule_set(std::move(source), diagnostics) : std::nullopt;
}

}  // namespace stig
