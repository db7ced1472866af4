// SPDX-License-Identifier: MIT
#include "lattice/structure_text.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "lattice/rgb.h"
#include "support/any_structure.h"
#include "support/uses.h"

namespace stig {
namespace {

std::optional<Structure> read_rows(const std::string& text, Diagnostics& diagnostics,
                                   const std::vector<Brick>& bricks = {}) {
  return read_structure_text(std::make_shared<SourceFile>("s.txt", text), Lattice::cubic, bricks,
                             diagnostics);
}

std::string rows_complaint(const std::string& text) {
  Diagnostics diagnostics;
  CHECK_FALSE(read_rows(text, diagnostics).has_value());
  REQUIRE_FALSE(diagnostics.all().empty());
  const Diagnostic& first = diagnostics.all().front();
  const auto at = first.range.file->position(first.range.begin);
  return std::string(info(first.code).name) + " " + std::to_string(at.line) + ":" +
         std::to_string(at.column) + " " + first.message;
}

std::vector<Brick> bricks_named(const std::vector<std::string>& symbols) {
  std::vector<Brick> bricks = numbered_bricks(static_cast<int>(symbols.size()));
  for (std::size_t i = 0; i < symbols.size(); ++i) bricks[i].symbol = symbols[i];
  return bricks;
}

TEST_CASE("slices are read from the top down, rows from the back to the front") {
  const Structure s = structure_literal("1 .\n. .\n---\n2 3\n4 .\n");
  CHECK(s.size() == 4);
  CHECK(s.at({0, 1, 1}) == 1);
  CHECK(s.at({0, 1, 0}) == 2);
  CHECK(s.at({1, 1, 0}) == 3);
  CHECK(s.at({0, 0, 0}) == 4);
}

TEST_CASE("comments, blank lines, tabs and carriage returns are passed over") {
  CHECK(structure_literal("// a wall\n\n  1\t2 \r\n\n---\n1 2") ==
        structure_literal("1 2\n---\n1 2"));
}

TEST_CASE("printing is what one would draw") {
  CHECK(print_structure(structure_literal(". . .\n3 2 1")) == "3 2 1\n");
  CHECK(print_structure(structure_literal("3 .\n---\n3 2")) == "3 .\n---\n3 2\n");
  CHECK(print_structure(Structure()) == ".\n");
}

TEST_CASE("longer symbols are lined up") {
  Structure s;
  s.place({0, 0, 0}, 12);
  s.place({1, 1, 0}, 1);
  CHECK(print_structure(s) == ".  1\n12 .\n");
  const auto bricks = bricks_named({"wax", "p"});
  CHECK(print_structure(structure_literal("2 1\n1 2"), bricks) == "p   wax\nwax p\n");
}

TEST_CASE("law: reading a print gives the structure at the origin") {
  CHECK(rc::check([] {
    const Structure s = any_structure(any_lattice(), 20);
    Diagnostics diagnostics;
    const auto back = read_structure_text(std::make_shared<SourceFile>("s", print_structure(s)),
                                          s.lattice(), {}, diagnostics);
    RC_ASSERT(back.has_value());
    RC_ASSERT(*back == to_origin(s));
  }));
}

TEST_CASE("what is wrong is said where it is") {
  CHECK(rows_complaint("1 2\n1 x\n") == "F402 2:3 unknown brick 'x'");
  CHECK(rows_complaint("1 2\n1\n") == "F403 2:1 row has 1 cells, the rows before have 2");
  CHECK(rows_complaint("1\n1\n---\n1\n---\n1\n1\n") ==
        "F403 5:1 slice has 1 rows, the slices before have 2");
  CHECK(rows_complaint("1\n---\n---\n1\n") == "F403 3:1 slice without rows");
  CHECK(rows_complaint("1\n---\n") == "F403 2:5 slice without rows");
  CHECK(rows_complaint("// nothing\n").starts_with("F404"));
  CHECK(rows_complaint("").starts_with("F404"));
  CHECK(rows_complaint("63") == "F402 1:1 unknown brick '63'");
}

TEST_CASE("a blank line between rows of a slice is warned of, once") {
  const auto warnings = [](const std::string& text) {
    Diagnostics diagnostics;
    CHECK(read_rows(text, diagnostics).has_value());
    std::string out;
    for (const Diagnostic& one : diagnostics.all()) {
      out += std::string(info(one.code).name) + " " +
             std::to_string(one.range.file->position(one.range.begin).line) + "; ";
    }
    return out;
  };
  CHECK(warnings("1 .\n\n1 1\n\n2 2\n") == "F412 3; ");
  CHECK(warnings("1\n \t\n// a level?\n2\n---\n1\n\n2\n") == "F412 4; ");
  CHECK(warnings("\n1\n2\n\n---\n\n1\n2\n\n") == "");
}

TEST_CASE("all problems are reported, an unknown symbol once") {
  Diagnostics diagnostics;
  read_rows("x 1 x\ny\n1 1 1\n", diagnostics);
  CHECK(diagnostics.all().size() == 3);
}

TEST_CASE("a file that is wrong all over stops at a hundred") {
  std::string text = "1 1\n";
  for (int i = 0; i < 100000; ++i) text += "1\n";
  Diagnostics diagnostics;
  CHECK_FALSE(read_rows(text, diagnostics).has_value());
  CHECK(diagnostics.all().size() <= 100);
}

TEST_CASE("a near symbol is suggested") {
  Diagnostics diagnostics;
  read_rows("pnik", diagnostics, bricks_named({"pink", "wax"}));
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].suggestion == "pink");
}

}  // namespace
}  // namespace stig
