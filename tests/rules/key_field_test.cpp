// SPDX-License-Identifier: MIT
// Each member of a rule set that is listed (rules/key_field.h) is changed, one at a time: the
// comparison, the hash and the printed file must all notice, and reading must bring it back.
#include "rules/key_field.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "rules/field_hash.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "rules/rule_schema.h"
#include "support/golden.h"
#include "support/shipped.h"
#include "support/uses.h"

namespace stig {

namespace {

/// As many keys as a file can have.
constexpr const char* kEveryKey = R"(stigc: 1
name: full
title: a title
source: a source
lattice: cubic
symmetry: rotations
inversion: true
floor: true
conflicts: random
bricks:
  1: {name: stone, color: "#aabbcc", led: Q2}
  2: {color: "#102030"}
legend:
  o: [., 2]
box: {size: [10, 11, 12], origin: [-5, -5, 0], periodic: true}
stages: {1: 8}
start:
  - {at: [0, 0, 1], brick: 1}
  - {at: [1, 0, 1], brick: 2}
physical:
  sides: [+x, -y]
  robots: 3
expect:
  bricks: 3
  verdict: order-dependent
  structure: |
    1 2 1
rules:
  - name: first
    stage: 1
    place: 1
    probability: 0.5
    weight: 2
    symmetry: none
    inversion: false
    when: |
      . . .   . . .   ? ? ?
      . . .   o * 1   ? ? ?
      . . .   . . .   ? ? ?
    height: {min: 1, max: 5}
    count: [{of: [1], among: faces, min: 1, max: 4}]
)";

std::optional<RuleSet> read_text(const std::string& text) {
  Diagnostics diagnostics;
  auto rules = read_rule_set(std::make_shared<SourceFile>("full.yaml", text), diagnostics);
  if (!rules) MESSAGE(to_text(diagnostics) << text);
  return rules;
}

// Other values that a file could have in the same place.

std::vector<bool> others(bool value, const FormKey& /*key*/) { return {!value}; }
std::vector<std::int64_t> others(std::int64_t value, const FormKey& key) {
  const auto low = static_cast<std::int64_t>(key.low), high = static_cast<std::int64_t>(key.high);
  return {value < low ? low : value < high ? value + 1 : value - 1};
}
std::vector<int> others(int value, const FormKey& key) {
  return {static_cast<int>(others(std::int64_t{value}, key).front())};
}
std::vector<double> others(double value, const FormKey& key) {
  return {(value + (value > key.low ? key.low : key.high)) / 2};
}
std::vector<Colour> others(Colour value, const FormKey& /*key*/) {
  return {static_cast<Colour>(3 - value)};
}
std::vector<std::string> others(const std::string& value, const FormKey& key) {
  if (key.kind == FormKind::colour) return {"#010203"};
  if (key.kind == FormKind::choice) return {std::string(key.words.front())};
  return {value + "x"};
}
std::vector<Offset> others(Offset o, const FormKey& /*key*/) {
  return {{o.x + 1, o.y, o.z}, {o.x, o.y + 1, o.z}, {o.x, o.y, o.z + 1}};
}
std::vector<Cell> others(Cell c, const FormKey& /*key*/) {
  return {{c.x + 1, c.y, c.z}, {c.x, c.y + 1, c.z}, {c.x, c.y, c.z + 1}};
}
std::vector<StateSet> others(StateSet value, const FormKey& /*key*/) {
  return {value | StateSet::floor()};
}
std::vector<Pattern> others(const Pattern& value, const FormKey& /*key*/) {
  std::vector<Pattern> out(kMaxNeighbours, value);
  for (std::size_t i = 0; i < out.size(); ++i) {
    auto& states = out[i].allowed[i];
    states = states == StateSet::of(1) ? StateSet::bricks(2) : StateSet::of(1);
  }
  return out;
}
template <class T>
requires std::is_enum_v<T> std::vector<T> others(T value, const FormKey& key) {
  const std::size_t next = (static_cast<std::size_t>(value) + 1) % key.words.size();
  return {static_cast<T>(next)};
}
template <class T>
std::vector<std::optional<T>> others(const std::optional<T>& value, const FormKey& key) {
  std::vector<std::optional<T>> out;
  if (value) out.emplace_back(std::nullopt);
  if constexpr (!HasFields<T>) {
    for (const T& other : others(value.value_or(T()), key)) out.emplace_back(other);
  }
  return out;
}
/// Without the last. What is in the lists is changed on its own.
template <class T>
std::vector<std::vector<T>> others(std::vector<T> value, const FormKey& /*key*/) {
  value.pop_back();
  return {value};
}
std::vector<std::map<int, std::int64_t>> others(const std::map<int, std::int64_t>& value,
                                                const FormKey& /*key*/) {
  std::vector<std::map<int, std::int64_t>> out(3, value);
  ++out[0].begin()->second;
  out[1].clear();
  out[2] = {{value.begin()->first + 1, value.begin()->second}};
  return out;
}

/// What a member without a key of its own has for a key.
const FormKey kSymbol{.name = "symbol", .kind = FormKind::own};

enum class Reads : bool { sometimes, always };

/// Changes the members of `part`, which is a part of `rules`, one by one.
template <HasFields T>
void change_each(RuleSet& rules, T& part, const Form& form, bool meant, Reads reads) {
  const RuleSet before = rules;
  for_each_field(part, [&](const auto& field) {
    const FormKey& key = field.key.empty() ? kSymbol : key_of(form, field.key);
    CAPTURE(form.title);
    CAPTURE(field.key);
    const auto kept = field.value;
    // A required list cannot be empty, and a brick in use cannot go.
    const bool list = key.kind == FormKind::forms || key.kind == FormKind::map;
    int tried = 0;
    for (const auto& other : others(kept, key)) {
      if (key.required && list) continue;
      ++tried;
      field.value = other;
      CHECK_FALSE(rules == before);
      CHECK((rule_set_hash(rules) != rule_set_hash(before)) ==
            (meant && field.hashed != Hashed::never));
      const std::string text = print_rule_set(rules);
      CHECK(text != print_rule_set(before));
      if (reads == Reads::always) {
        const auto again = read_text(text);
        REQUIRE(again.has_value());
        CHECK(*again == rules);
      }
    }
    field.value = kept;
    CHECK((tried > 0 || (key.required && list)));
  });
}

/// The keys of the members, those before a slash once.
template <HasFields T>
std::set<std::string> keys_of(const std::string& under = {}) {
  std::set<std::string> keys;
  const T object;
  for_each_field(object, [&](const auto& field) {
    std::string key(field.key);
    if (key.empty() || !key.starts_with(under)) return;
    key.erase(0, under.size());
    keys.insert(key.substr(0, key.find('/')));
  });
  return keys;
}

std::set<std::string> keys_of(const Form& form) {
  std::set<std::string> keys;
  for (const FormKey& key : form.keys) keys.emplace(key.name);
  return keys;
}

}  // namespace

TEST_CASE("a change of any member is seen by comparison, hash, printer and reader") {
  auto read = read_text(kEveryKey);
  REQUIRE(read.has_value());
  RuleSet& rules = *read;
  Rule& rule = rules.rules.front();
  change_each(rules, rule, rule_form(), true, Reads::always);
  change_each(rules, rule.counts.front(), count_form(), true, Reads::always);
  change_each(rules, *rules.box, box_form(), true, Reads::always);
  change_each(rules, *rules.physical, physical_form(), false, Reads::always);
  // What follows can contradict the rest of the file.
  change_each(rules, rules, rule_set_form(), true, Reads::sometimes);
  change_each(rules, rules.bricks.front(), brick_form(), true, Reads::sometimes);
  change_each(rules, rules.start.front(), start_form(), true, Reads::sometimes);
  change_each(rules, *rules.expect, expect_form(), false, Reads::sometimes);
  change_each(rules, rules.legend.front(), rule_set_form(), false, Reads::sometimes);
}

TEST_CASE("an equal set has equal hash and text") {
  const auto first = read_text(kEveryKey),
             second = read_text(std::string("# a comment\n") + kEveryKey);
  REQUIRE(first.has_value());
  REQUIRE(second.has_value());
  CHECK(*first == *second);
  CHECK(rule_set_hash(*first) == rule_set_hash(*second));
}

TEST_CASE("members and the keys of the schema are the same") {
  auto of_set = keys_of<RuleSet>();
  of_set.insert("stigc");
  CHECK(of_set == keys_of(rule_set_form()));
  CHECK(keys_of<Rule>() == keys_of(rule_form()));
  CHECK(keys_of<Rule>("height/") == keys_of(height_form()));
  CHECK(keys_of<CountCondition>() == keys_of(count_form()));
  CHECK(keys_of<Brick>() == keys_of(brick_form()));
  CHECK(keys_of<PlacedBrick>() == keys_of(start_form()));
  CHECK(keys_of<BoxSpec>() == keys_of(box_form()));
  CHECK(keys_of<PhysicalSpec>() == keys_of(physical_form()));
  CHECK(keys_of<Expectation>() == keys_of(expect_form()));
}

namespace {

/// A struct before and after it got another member.
struct Older {
  int size = 1;
};
struct Newer {
  int size = 1;
  int depth = 0;
  int width = 0;
};

template <SameButConst<Older> O>
auto fields(O& object) {
  auto& [size] = object;
  return std::tuple(KeyField{"size", size});
}
template <SameButConst<Newer> N>
auto fields(N& object) {
  auto& [size, depth, width] = object;
  return std::tuple(KeyField{"size", size}, KeyField{"depth", depth, Hashed::when_set},
                    KeyField{"width", width, Hashed::when_set});
}

template <class T>
std::uint64_t hash_of(const T& object) {
  FieldHash hash(26);
  hash.add(object);
  return hash.value();
}

}  // namespace

TEST_CASE("a younger key leaves the hash of what does not use it") {
  CHECK(hash_of(Newer{7, 0, 0}) == hash_of(Older{7}));
  CHECK(hash_of(Newer{7, 1, 0}) != hash_of(Older{7}));
  CHECK(hash_of(Newer{7, 1, 0}) != hash_of(Newer{7, 2, 0}));
  CHECK(hash_of(Newer{7, 1, 0}) != hash_of(Newer{7, 0, 1}));
}

TEST_CASE("shipped rule sets keep the hashes that traces and certificates have") {
  std::string hashes;
  for (const std::string& name : shipped_names()) {
    hashes += name + " " + to_hex(rule_set_hash(shipped(name))) + "\n";
  }
  check_golden("tests/golden/rule-set-hashes.txt", hashes);
}

}  // namespace stig
