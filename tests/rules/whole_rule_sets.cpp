// SPDX-License-Identifier: MIT
#include "rules/whole_rule_sets.h"

#include <rapidcheck.h>

#include <algorithm>
#include <string>

#include "rules/rule_checks.h"
#include "support/draw_fields.h"
#include "support/uses.h"

namespace stig {

namespace {

/// Texts that are hard on a printer.
std::string random_text() {
  static const std::vector<std::string> kTexts = {"plain",
                                                  "two words",
                                                  "mast, 1 next to a 2",
                                                  "a: b",
                                                  "# no comment",
                                                  "yes",
                                                  "null",
                                                  "~",
                                                  "3",
                                                  "\"quoted\"",
                                                  "it's",
                                                  "- dash",
                                                  "\\ back\\slash",
                                                  "*star",
                                                  "&amp",
                                                  "!bang",
                                                  "tab\there",
                                                  "umlaut ä",
                                                  "[list]",
                                                  "{map}",
                                                  "a #b",
                                                  "trailing:",
                                                  "%pct",
                                                  "@at",
                                                  "`tick`",
                                                  "| bar",
                                                  "> fold",
                                                  "010",
                                                  "1e3",
                                                  "…",
                                                  "\u2028",
                                                  "\U0001F9F1",
                                                  "? question",
                                                  "---",
                                                  "...",
                                                  "x, y]"};
  return *rc::gen::elementOf(kTexts);
}

std::string random_line() {
  std::string text = random_text();
  for (char& c : text) c = c == '\t' ? ' ' : c;
  return text;
}

std::vector<Brick> random_bricks() {
  static const std::vector<std::string> kSymbols = {"1",  "2",    "pink", "ä",  "a#b", "yes", "~",
                                                    "&x", "010",  "{",    "a:", "'",   "\"",  "--",
                                                    "==", "null", "x,y",  "]",  "!",   "|"};
  std::vector<Brick> bricks;
  const int count = 1 + below(4);
  const int first = below(static_cast<int>(kSymbols.size()));
  for (int i = 0; i < count; ++i) {
    Brick brick;
    brick.symbol = kSymbols[static_cast<std::size_t>(first + i) % kSymbols.size()];
    brick.name = chance() ? brick.symbol : random_line() + std::to_string(i);
    brick.color = chance() ? "#00ff7f" : "#012345";
    if (chance()) brick.led = "Q" + std::to_string(i + 1);
    bricks.push_back(brick);
  }
  return bricks;
}

/// Any set but the ones that never match: at least one brick or empty is in it.
StateSet random_states(const RuleSet& rules) {
  const auto empty = chance() ? StateSet::empty_cell() : StateSet();
  StateSet out = empty | StateSet::of(static_cast<State>(1 + below(rules.colours())));
  for (int c = 1; c <= rules.colours(); ++c) {
    if (chance()) out = out | StateSet::of(static_cast<State>(c));
  }
  return rules.floor && chance() ? out | StateSet::floor() : out;
}

StateSet random_cell(const RuleSet& rules) {
  switch (below(5)) {
    case 0:
      return StateSet::empty_cell();
    case 1:
      return StateSet::bricks(rules.colours());
    case 2:
      return rules.legend.empty() ? StateSet::anything()
                                  : (*rc::gen::elementOf(rules.legend)).states;
    default:
      return StateSet::anything();
  }
}

Rule random_rule(const RuleSet& rules, int index) {
  Rule rule;
  rule.name = random_line() + std::to_string(index);
  rule.place = static_cast<Colour>(1 + below(rules.colours()));
  const Neighbourhood& neighbours = neighbourhood(rules.lattice);
  for (int i = 0; i < neighbours.size; ++i) {
    rule.pattern.allowed[static_cast<std::size_t>(i)] = random_cell(rules);
  }
  // A brick on the level, so that the rule neither fires everywhere nor never.
  const int beside = neighbours.first_below - 1 - below(3);
  rule.pattern.allowed[static_cast<std::size_t>(beside)] =
      StateSet::of(static_cast<State>(1 + below(rules.colours())));
  if (chance()) rule.height_max = 5 + below(9);
  if (chance()) rule.height_min = rules.floor ? 1 + below(4) : below(9) - 4;
  if (chance()) rule.counts.push_back({random_states(rules), chance(), 0, 8 + below(19), {}});
  if (chance()) rule.counts.push_back({StateSet::bricks(rules.colours()), false, 1, 26, {}});
  draw_fields(rule, rule_form(), 2, {"height/min", "height/max"});
  return rule;
}

void add_rest(RuleSet& rules) {
  if (chance()) {
    rules.box = BoxSpec{{3 + below(90), 4, 20}, std::nullopt, chance()};
    if (chance()) rules.box->origin = Cell{-1, 0, 0};
  }
  if (chance()) rules.stages = {{1, 7}, {3, 1000000}};
  if (chance()) {
    rules.physical = PhysicalSpec{};
    if (chance()) rules.physical->sides = {"+x", "-y"};
    if (chance()) rules.physical->robots = 3;
  }
  if (!chance()) return;
  rules.expect = Expectation{};
  if (chance()) rules.expect->verdict = static_cast<Verdict>(below(2));
  if (!chance()) return;
  for (const PlacedBrick& brick : rules.start) rules.expect->structure.push_back(brick);
  rules.expect->structure.push_back({{0, 3, 1}, 1});
  std::sort(rules.expect->structure.begin(), rules.expect->structure.end());
}

}  // namespace

RuleSet random_whole_rule_set() {
  RuleSet rules;
  rules.name = random_line();
  if (chance()) rules.title = random_text();
  if (chance()) rules.source = random_text() + "\nsecond line";
  draw_fields(rules, rule_set_form(), 2, {"conflicts"});
  rules.conflicts = chance() ? Conflicts::random : Conflicts::first;
  rules.bricks = random_bricks();
  for (int i = below(3); i > 0; --i) {
    rules.legend.push_back({std::string(1, static_cast<char>('k' + i)), random_states(rules), {}});
  }
  rules.start.push_back({{0, 0, 0}, 1});
  if (chance()) rules.start.push_back({{1, 0, 0}, static_cast<Colour>(rules.colours())});
  for (int i = 1 + below(4); i > 0; --i) rules.rules.push_back(random_rule(rules, i));
  add_rest(rules);
  // Conditions drawn at random may contradict each other.
  Diagnostics diagnostics;
  check_rule_set(rules, CheckScope::all, diagnostics);
  if (diagnostics.has_errors()) {
    for (Rule& rule : rules.rules) rule.counts.clear();
  }
  return rules;
}

}  // namespace stig
