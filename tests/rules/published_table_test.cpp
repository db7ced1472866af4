// SPDX-License-Identifier: MIT
// Published tables: the same rules in every form, and those of the files that ship.
#include "rules/published_table.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "rules/rule_printer.h"
#include "support/golden.h"
#include "support/shipped.h"
#include "support/uses.h"

namespace stig {
namespace {

std::optional<RuleSet> read_table(const std::string& text, const TableReading& reading,
                                  Diagnostics& diagnostics) {
  return read_published_table(std::make_shared<SourceFile>("table.txt", text), reading,
                              diagnostics);
}

RuleSet table(const std::string& name, const TableReading& reading = {}) {
  Diagnostics diagnostics;
  auto rules = read_table(project_file("tests/rules/tables/" + name), reading, diagnostics);
  REQUIRE_MESSAGE(rules.has_value(), to_text(diagnostics));
  return *rules;
}

/// The hash of what both have; tables say nothing of a world.
std::uint64_t hash_in_world_of(RuleSet rules, const RuleSet& other) {
  rules.start = other.start;
  rules.box = other.box;
  return rule_set_hash(rules);
}

/// "LINE:COLUMN what", of all that is wrong.
std::string problems(const std::string& text, const TableReading& reading = {}) {
  Diagnostics diagnostics;
  const auto rules = read_table(text, reading, diagnostics);
  CHECK(rules.has_value() != diagnostics.has_errors());
  std::string out;
  for (const Diagnostic* one : sorted_by_place(diagnostics)) {
    const auto at = one->range.file->position(one->range.begin);
    out += fmt::format("{}:{} {}\n", at.line, at.column, one->message);
  }
  return out;
}

TEST_CASE("architecture 4(n) is the set that ships") {
  const RuleSet imported = table("architecture-4n.txt");
  const RuleSet there = shipped("architecture-4n");
  REQUIRE(imported.rules.size() == 66);
  for (std::size_t i = 0; i < 66; ++i) {
    CAPTURE(i);
    CHECK(imported.rules[i].name == there.rules[i].name);
    CHECK(imported.rules[i].pattern == there.rules[i].pattern);
  }
  CHECK(hash_in_world_of(imported, there) == rule_set_hash(there));
}

TEST_CASE("architecture 4(c) is the set that ships, in every form") {
  const RuleSet there = shipped("architecture-4c");
  TableReading both;
  both.inversion = true;
  TableReading matrices = both;
  matrices.matrices_of = Lattice::hexagonal;
  CHECK(hash_in_world_of(table("architecture-4c.txt", both), there) == rule_set_hash(there));
  CHECK(hash_in_world_of(table("architecture-4c-lines.txt", both), there) == rule_set_hash(there));
  CHECK(hash_in_world_of(table("architecture-4c-matrices.txt", matrices), there) ==
        rule_set_hash(there));
}

TEST_CASE("comments are kept, and probabilities") {
  const std::string text =
      "// of a paper\n0,0,0,0,0,0,1 0,0,0,0,0,0 0,0,0,0,0,0,0 2 0.25\n# in between\n# rule 2\n"
      "0,0,0,0,0,0,2 0,0,0,0,0,0 0,0,0,0,0,0,0 1\n// behind\x1b\n";
  Diagnostics diagnostics;
  const auto rules = read_table(text, {}, diagnostics);
  REQUIRE(rules.has_value());
  CHECK(rules->rules[0].probability == 0.25);
  CHECK(rules->rules[1].probability == 1);
  const std::string printed = print_rule_set(*rules);
  CHECK(printed.starts_with("# of a paper\nstigc: 1\n"));
  CHECK(printed.find("\n  # in between\n  - name: rule 2\n") != std::string::npos);
  CHECK(printed.ends_with("# behind\\x1b\n"));
}

TEST_CASE("rules of a step that is begun again have names of their own") {
  const std::string one = "0 0 0 0 0 0 1\n0 0 0 0 0 0\n0 0 0 0 0 0 0\n=> 1\n";
  Diagnostics diagnostics;
  const auto rules =
      read_table("# step 1\n" + one + "# step 2\n" + one + "# step 1\n" + one, {}, diagnostics);
  REQUIRE(rules.has_value());
  CHECK(rules->rules[0].name == "step 1 rule 1");
  CHECK(rules->rules[1].name == "step 2 rule 1");
  CHECK(rules->rules[2].name == "step 1 rule 2");
  CHECK(rules->rules[2].stage == 1);
}

TEST_CASE("what is wrong with a table") {
  CHECK(problems("") == "1:1 there are no rules in this file\n");
  CHECK(problems("# step 1\n\n") == "2:2 there are no rules in this file\n");
  CHECK(problems("1 2 3\n") == "1:1 no table of rules begins with a line of 3 entries\n");
  CHECK(problems("0 0 0 0 0 0 x\n0 0 0 0 0\n=> 0\n0 0 0 0 0 0 1\n=> 1\n0 0 0 0 0 0 1\n") ==
        "1:13 'x' is no state: 0 is empty, 1 to 62 are bricks\n"
        "2:1 this line has 5 entries, 6 are wanted\n"
        "3:1 2 lines of 3 stand before this '=>'\n"
        "5:1 1 line of 3 stand before this '=>'\n"
        "6:15 the last rule lacks its end: '=>' and the brick to place\n");
}

TEST_CASE("what is wrong with a rule's end") {
  const std::string drawing = "0 0 0 0 0 0 1\n0 0 0 0 0 0\n0 0 0 0 0 0 0\n";
  CHECK(problems(drawing + "=> 2 p=1.0\n").empty());
  CHECK(problems(drawing + "=>\n") ==
        "4:1 '=>', the brick, and p=PROBABILITY or nothing are wanted\n");
  CHECK(problems(drawing + "=> 63\n") == "4:4 the brick to place is a number from 1 to 62\n");
  CHECK(problems(drawing + "=> 2 p=1.5\n") == "4:6 a probability is more than 0 and at most 1\n");
  CHECK(problems(drawing + "=> 2 p=nan\n") == "4:6 a probability is more than 0 and at most 1\n");
  CHECK(problems(drawing + drawing + "=> 2\n") ==
        "4:1 '=>' and the brick to place are wanted here\n"
        "5:1 '=>' and the brick to place are wanted here\n"
        "6:1 '=>' and the brick to place are wanted here\n");
  CHECK(problems("0,0,0,0,0,0,1 0,0,0,0,0,0 0,0,0,0,0,0 2\n# step 64\n# step by step\n") ==
        "1:1 this line has 20 entries, 21 or 22 are wanted\n2:8 steps are numbered from 1 to 63\n");
  CHECK(problems(drawing + "=> 2\n# Step 1:\n" + drawing + "=> 1\n") ==
        "5:8 rules stand before the first step\n");
}

TEST_CASE("dashes where cells are remind of the hexagonal lattice") {
  Diagnostics diagnostics;
  CHECK(!read_table("0 0 - 0 0 0 0 0 0\n0 1 0 0 * 0 0 0 0\n0 0 0 0 0 0 0 0 0\n=> 2\n", {},
                    diagnostics));
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all().front().notes.size() == 1);
}

TEST_CASE("sites and corners of matrices") {
  const std::string wrong = "0 0 1 0 0 0 0 0 0\n0 1 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0 0\n=> 2\n";
  CHECK(problems(wrong) == "2:9 the middle of the level slice is the site, '*'\n");
  TableReading hexagonal;
  hexagonal.matrices_of = Lattice::hexagonal;
  CHECK(problems(wrong, hexagonal) ==
        "1:5 this corner of a matrix is no cell of the hexagonal lattice, and holds '0' or '-'\n"
        "2:9 the middle of the level slice is the site, '*'\n");
  TableReading slices;
  slices.form = TableForm::slices;
  CHECK(problems(wrong, slices).starts_with("1:1 this line has 9 entries, 7 are wanted\n"));
}

}  // namespace
}  // namespace stig
