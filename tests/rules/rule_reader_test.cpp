// SPDX-License-Identifier: MIT
#include "rules/rule_reader.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <map>

namespace stig {

namespace {

RuleSet read(const std::string& text) {
  Diagnostics diagnostics;
  auto rules = read_rule_set(std::make_shared<SourceFile>("f.yaml", text), diagnostics);
  REQUIRE_MESSAGE(rules.has_value(), to_text(diagnostics));
  return *std::move(rules);
}

std::string covered(const SourceRange& range) {
  return range.file->text().substr(range.begin, range.end - range.begin);
}

constexpr const char* kEverything = R"(stigc: 1
name: everything
title: >
  Folded over
  two lines
source: "quoted: yes"
lattice: cubic
symmetry: rotations+mirrors
inversion: false
floor: true
conflicts: random
bricks:
  010: {name: ten, color: "#AABBCC", led: Q2}
  pink: {color: "#ff00aa"}
legend:
  e: [".", pink]
  f: ["=", "#"]
box: {size: [10, 11, 12], origin: [-5, -5, 0], periodic: true}
stages: {1: 8, 2: 100}
start:
  - {at: [0, 0, 0], brick: 010}
  - {at: [-1, +2, 0], brick: pink}
rules:
  - name: one
    stage: 1
    place: pink
    probability: .5
    weight: 2e3
    symmetry: none
    inversion: true
    when: |
      . e ?   . . .   f # ?
      . . .   . * pink   . 010 .
      . . .   . . .   . . .
    height: {min: -3, max: 2}
    count:
      - {of: [pink, "="], among: faces, min: 1, max: 2}
      - {of: [e], among: all}
  - name: two
    stage: 2
    place: 010
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   pink * pink   ? ? ?
      ? ? ?   ? ? ?   ? ? ?
physical: {sides: [+x, -y], robots: 3}
expect:
  bricks: 3
  verdict: order-dependent
  structure: |
    . pink
    . .
    ---
    010 .
    pink .
)";

}  // namespace

TEST_CASE("everything a file can say") {
  const RuleSet rules = read(kEverything);
  CHECK(rules.name == "everything");
  CHECK(rules.title == "Folded over two lines");
  CHECK(rules.source == "quoted: yes");
  CHECK(rules.symmetry == Symmetry::rotations_mirrors);
  CHECK_FALSE(rules.inversion);
  CHECK(rules.floor);
  CHECK(rules.conflicts == Conflicts::random);
  REQUIRE(rules.colours() == 2);
  CHECK(rules.brick(1).symbol == "010");
  CHECK(rules.brick(1).color == "#aabbcc");
  CHECK(rules.brick(1).led == "Q2");
  CHECK(rules.brick(2).name == "pink");
  REQUIRE(rules.legend.size() == 2);
  CHECK(rules.legend[0].states == (StateSet::empty_cell() | StateSet::of(2)));
  CHECK(rules.legend[1].states == (StateSet::floor() | StateSet::bricks(2)));
  REQUIRE(rules.box.has_value());
  CHECK(rules.box->size == Offset{10, 11, 12});
  CHECK(rules.box->origin == Cell{-5, -5, 0});
  CHECK(rules.box->periodic);
  CHECK(rules.stages == std::map<int, std::int64_t>{{1, 8}, {2, 100}});
  CHECK(rules.start == std::vector<PlacedBrick>{{{0, 0, 0}, 1}, {{-1, 2, 0}, 2}});
  REQUIRE(rules.physical.has_value());
  CHECK(rules.physical->sides == std::vector<std::string>{"+x", "-y"});
  CHECK(rules.physical->robots == 3);
  REQUIRE(rules.expect.has_value());
  CHECK(rules.expect->bricks == 3);
  CHECK(rules.expect->verdict == Verdict::order_dependent);
}

TEST_CASE("a structure is read from the top down and moved to the origin") {
  const auto structure = read(kEverything).expect->structure;
  CHECK(structure == std::vector<PlacedBrick>{{{0, 0, 0}, 2}, {{0, 1, 0}, 1}, {{1, 1, 1}, 2}});
}

TEST_CASE("a rule's fields") {
  const RuleSet rules = read(kEverything);
  const Rule& rule = rules.rules[0];
  CHECK(rule.stage == 1);
  CHECK(rule.place == 2);
  CHECK(rule.probability == 0.5);
  CHECK(rule.weight == 2000);
  CHECK(rule.symmetry == Symmetry::none);
  CHECK(rule.inversion == true);
  CHECK(rule.height_min == -3);
  CHECK(rule.height_max == 2);
  REQUIRE(rule.counts.size() == 2);
  CHECK(rule.counts[0].of == (StateSet::of(2) | StateSet::floor()));
  CHECK(rule.counts[0].faces_only);
  CHECK(rule.counts[0].max == 2);
  CHECK(rule.counts[1].max == kMaxNeighbours);
  const Neighbourhood& n = neighbourhood(Lattice::cubic);
  const auto at = [&](Offset o) {
    return rule.pattern.allowed[static_cast<std::size_t>(n.index_of(o))];
  };
  CHECK(at({-1, 1, 1}) == StateSet::empty_cell());
  CHECK(at({0, 1, 1}) == rules.legend[0].states);
  CHECK(at({1, 1, 1}) == StateSet::anything());
  CHECK(at({-1, 1, -1}) == rules.legend[1].states);
  CHECK(at({0, 1, -1}) == StateSet::bricks(2));
  CHECK(at({0, 0, -1}) == StateSet::of(1));
  CHECK(at({1, 0, 0}) == StateSet::of(2));
}

TEST_CASE("hexagonal drawings: rows of two, three and two") {
  const RuleSet rules = read(R"(stigc: 1
name: hex
lattice: hexagonal
bricks: {1: {color: "#000000"}, 2: {color: "#000000"}, 3: {color: "#000000"}}
start: [{at: [0, 0, 0], brick: 1}, {at: [9, 0, 0], brick: 3}]
rules:
  - name: a
    place: 2
    when: |2
       . .     1 2     . .
      . 3 .   . * .   . . 1
       . .     . 3     2 .
)");
  const Neighbourhood& n = neighbourhood(Lattice::hexagonal);
  const auto at = [&](Offset o) {
    return rules.rules[0].pattern.allowed[static_cast<std::size_t>(n.index_of(o))];
  };
  CHECK(at({-1, 1, 0}) == StateSet::of(1));
  CHECK(at({0, 1, 0}) == StateSet::of(2));
  CHECK(at({0, 0, 1}) == StateSet::of(3));
  CHECK(at({1, 0, -1}) == StateSet::of(1));
  CHECK(at({1, -1, 0}) == StateSet::of(3));
  CHECK(at({0, -1, -1}) == StateSet::of(2));
}

TEST_CASE("everything keeps its place") {
  const RuleSet rules = read(kEverything);
  CHECK(covered(rules.rules[0].name_range) == "one");
  CHECK(covered(rules.rules[1].place_range) == "010");
  CHECK(covered(rules.rules[0].when_range).substr(0, 9) == "|\n      .");
  CHECK(covered(rules.rules[1].range).substr(0, 9) == "name: two");
  CHECK(covered(rules.bricks[0].range) == "010");
  CHECK(covered(rules.legend[1].range) == "f");
  CHECK(covered(rules.rules[0].counts[1].range) == "{of: [e], among: all}");
  CHECK(covered(rules.expect->bricks_range) == "3");
  CHECK(covered(rules.places.start_bricks[1]) == "[-1, +2, 0]");
}

TEST_CASE("a symbol inside a drawing is pointed at where it stands") {
  std::string text = kEverything;
  text.replace(text.find(". 010 ."), 7, ". 011 .");
  Diagnostics diagnostics;
  read_rule_set(std::make_shared<SourceFile>("f.yaml", text), diagnostics);
  bool found = false;
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.code != Code::R204) continue;
    found = true;
    CHECK(covered(d.range) == "011");
    CHECK(d.suggestion == "010");
  }
  CHECK(found);
}

}  // namespace stig
