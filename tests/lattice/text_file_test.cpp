// SPDX-License-Identifier: MIT
#include "lattice/text_file.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "lattice/rgb.h"
#include "lattice/structure_text.h"
#include "support/any_structure.h"
#include "support/uses.h"

namespace stig {
namespace {

std::optional<LoadedStructure> read(const std::string& text, Diagnostics& diagnostics,
                                    std::optional<Lattice> lattice = {},
                                    const std::vector<Brick>& bricks = {}) {
  return read_text_file(std::make_shared<SourceFile>("s.txt", text), lattice, bricks, diagnostics);
}

std::string complaint(const std::string& text, std::optional<Lattice> lattice = {}) {
  Diagnostics diagnostics;
  CHECK_FALSE(read(text, diagnostics, lattice).has_value());
  REQUIRE_FALSE(diagnostics.all().empty());
  const Diagnostic& first = diagnostics.all().front();
  const auto at = first.range.file->position(first.range.begin);
  return std::string(info(first.code).name) + " " + std::to_string(at.line) + ":" +
         std::to_string(at.column);
}

std::vector<Brick> named(const std::vector<std::string>& symbols) {
  std::vector<Brick> bricks = numbered_bricks(static_cast<int>(symbols.size()));
  for (std::size_t i = 0; i < symbols.size(); ++i) bricks[i].symbol = symbols[i];
  return bricks;
}

std::vector<std::string> symbols_of(const LoadedStructure& loaded) {
  std::vector<std::string> symbols;
  for (const Brick& brick : loaded.bricks) symbols.push_back(brick.symbol);
  return symbols;
}

TEST_CASE("law: what is printed is read back, lattice, place and symbols too") {
  const std::vector<std::vector<std::string>> sets = {
      {"1", "2", "3", "4"}, {"a", "b", "A", "wax"}, {"4", "3", "2", "1"}, {"é", "/", "-", ":"}};
  CHECK(rc::check([&] {
    const Structure near = any_structure(any_lattice(), 4);
    const Offset shift{*rc::gen::inRange(-500, 500), 7, -3};
    Structure s(near.lattice());
    for (const PlacedBrick& brick : near.bricks()) s.place(brick.at + shift, brick.brick);
    const auto symbols = *rc::gen::elementOf(sets);
    Diagnostics diagnostics;
    const auto back = read(print_text_file(s, named(symbols)), diagnostics);
    RC_ASSERT(back.has_value());
    RC_ASSERT(back->structure == s);
    RC_ASSERT(back->placed);
    RC_ASSERT(symbols_of(*back) == symbols);
  }));
}

TEST_CASE("rows drawn without spaces have a cell for each character") {
  const auto bricks_in = [](const std::string& text) {
    Diagnostics diagnostics;
    const auto loaded = read(text, diagnostics);
    REQUIRE(loaded.has_value());
    CHECK(diagnostics.all().empty());
    return loaded->structure;
  };
  CHECK(bricks_in("##.\n###\n---\n###\n###\n") == bricks_in("# # .\n# # #\n---\n# # #\n# # #\n"));
  CHECK(bricks_in("// a plate\n121\n.2.\n") == bricks_in("1 2 1\n. 2 .\n"));
  CHECK(bricks_in("111\n121\n") == bricks_in("1 1 1\n1 2 1\n"));
  CHECK(bricks_in("#?\n") == bricks_in("# ?\n"));
  CHECK(bricks_in("11\n11\n") == bricks_in("1 1\n1 1\n"));
  CHECK(bricks_in("12\n---\n11\n") == bricks_in("1 2\n---\n1 1\n"));
  // A structure one cell wide: its rows are symbols.
  CHECK(bricks_in("red\nred\n").size() == 2);
  CHECK(bricks_in("12\n---\n13\n").size() == 2);
  CHECK(bricks_in("// bricks: #. b\n#.\nb\n").size() == 2);
  // Neither the one nor the other: one word here, several there.
  CHECK(complaint("##.\n# # #\n") == "F403 2:1");
}

TEST_CASE("what is no text, or has symbols beyond all measure, is refused") {
  CHECK(complaint(std::string("1 1\n1 \0 1\n", 10)) == "R003 2:3");
  CHECK(complaint("1 1\n1 \xff\n") == "R004 2:3");
  CHECK(complaint("a " + std::string(65, 'b') + "\n") == "F402 1:3");
  CHECK(complaint("// bricks: a " + std::string(65, 'b') + "\na\n") == "F411 1:12");
}

TEST_CASE("symbols that cannot be drawn with become numbers") {
  const Structure s = structure_literal("1 2");
  for (const auto& symbols : {std::vector<std::string>{"a b", "c"},
                              {"x", "x"},
                              {".", "c"},
                              {"//", "c"},
                              {"", "c"},
                              {"a"}}) {
    CHECK(print_text_file(s, named(symbols)).ends_with("// bricks: 1 2\n1 2\n"));
  }
}

TEST_CASE("without a head: cubic, at the origin, numbers or symbols as they appear") {
  Diagnostics diagnostics;
  const auto numbers = read("// a wall\n3 1\n", diagnostics);
  REQUIRE(numbers.has_value());
  CHECK_FALSE(numbers->placed);
  CHECK(numbers->structure == structure_literal("3 1"));
  CHECK(symbols_of(*numbers) == std::vector<std::string>{"1", "2", "3"});
  const auto words = read("b . a\n---\na 7 b\n", diagnostics, Lattice::hexagonal);
  REQUIRE(words.has_value());
  CHECK(words->structure == structure_literal("1 . 2\n---\n2 3 1", Lattice::hexagonal));
  CHECK(symbols_of(*words) == std::vector<std::string>{"b", "a", "7"});
}

TEST_CASE("given bricks win over those of the head") {
  Diagnostics diagnostics;
  const auto loaded = read("// bricks: a b\na b\n", diagnostics, Lattice::cubic, named({"b", "a"}));
  REQUIRE(loaded.has_value());
  CHECK(loaded->structure == structure_literal("2 1"));
}

TEST_CASE("what is wrong with a head is said where it is") {
  CHECK(complaint("// lattice: cubical\n1\n") == "F411 1:13");
  CHECK(complaint("// lattice:\n1\n") == "F411 1:12");
  CHECK(complaint("// lattice: cubic\n// lattice: cubic\n1\n") == "F411 2:13");
  CHECK(complaint("// lowest corner: 1 2\n1\n") == "F411 1:19");
  CHECK(complaint("// lowest corner: 1 2 x\n1\n") == "F411 1:19");
  CHECK(complaint("// lowest corner: 1 2 99999999999\n1\n") == "F411 1:19");
  CHECK(complaint("// lowest corner: 1 2 3 4\n1\n") == "F411 1:19");
  CHECK(complaint("// bricks:\n1\n") == "F411 1:11");
  CHECK(complaint("// bricks: a . b\n1\n") == "F411 1:12");
  CHECK(complaint("// bricks: a a\na\n") == "F411 1:12");
  CHECK(complaint("// bricks: a b\na c\n") == "F402 2:3");
  CHECK(complaint("// lowest corner: 16777216 0 0\n1 1\n").starts_with("F406"));
  CHECK(complaint("// lattice: cubic\n1\n", Lattice::hexagonal).starts_with("F411"));
}

}  // namespace
}  // namespace stig
