// SPDX-License-Identifier: MIT
#include "lattice/structure_json.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "lattice/rgb.h"
#include "lattice/structure_text.h"
#include "support/any_structure.h"
#include "support/uses.h"

namespace stig {
namespace {

std::optional<LoadedStructure> read_json(const std::string& text, Diagnostics& diagnostics) {
  return read_structure_json(std::make_shared<SourceFile>("s.json", text), diagnostics);
}

// Code, place and message of the one thing that is wrong.
std::string json_complaint(const std::string& text) {
  Diagnostics diagnostics;
  CHECK_FALSE(read_json(text, diagnostics).has_value());
  REQUIRE(diagnostics.all().size() == 1);
  const Diagnostic& d = diagnostics.all().front();
  const auto at = d.range.file->position(d.range.begin);
  return std::string(info(d.code).name) + " " + std::to_string(at.line) + ":" +
         std::to_string(at.column) + " " + d.message;
}

// A file that is right but for its cells.
std::string with_cells(const std::string& cells) {
  return R"({"stigc_structure":1,"bricks":[{"symbol":"1","name":"","color":"#000000"}],"cells":)" +
         cells + "}";
}

TEST_CASE("the printed form") {
  const Structure s = structure_literal("2\n---\n1");
  CHECK(print_structure_json(s, numbered_bricks(2)) == R"({"stigc_structure": 1, "lattice": "cubic",
 "bricks": [
  {"symbol": "1", "name": "1", "color": "#0072b2"},
  {"symbol": "2", "name": "2", "color": "#e69f00"}],
 "cells": [
  [0, 0, 0, 1],
  [0, 0, 1, 2]]}
)");
}

TEST_CASE("law: reading a print gives the structure and its bricks") {
  CHECK(rc::check([] {
    const Structure s = any_structure(any_lattice(), 5);
    std::vector<Brick> bricks = numbered_bricks(5);
    bricks[0].name = "a \"quoted\" näme\n";
    Diagnostics diagnostics;
    const auto back = read_json(print_structure_json(s, bricks), diagnostics);
    RC_ASSERT(back.has_value());
    RC_ASSERT(back->structure == s);
    RC_ASSERT(back->bricks.size() == std::size_t{5});
    RC_ASSERT(back->bricks[0].name == bricks[0].name);
    RC_ASSERT(back->bricks[4].color == bricks[4].color);
  }));
}

TEST_CASE("keys may come in any order, and the lattice may be left out") {
  Diagnostics diagnostics;
  const auto back = read_json(
      R"({"cells":[[1,-2,3,1]],"bricks":[{"color":"#ABCDEF","symbol":"a","name":"b"}],
          "stigc_structure":1})",
      diagnostics);
  REQUIRE(back.has_value());
  CHECK(back->structure.at({1, -2, 3}) == 1);
  CHECK(back->structure.lattice() == Lattice::cubic);
}

TEST_CASE("what is wrong with the form") {
  CHECK(json_complaint("").starts_with("F405 1:1 "));
  CHECK(json_complaint("[1]") == "F405 1:1 an array has no place here");
  CHECK(json_complaint("{\"stigc_structure\":1,\n \"size\":2}") == "F405 2:7 unknown key 'size'");
  CHECK(json_complaint(R"({"stigc_structure":1,"stigc_structure":1})").ends_with("comes twice"));
  CHECK(json_complaint(R"({"stigc_structure":2})").find("version 2") != std::string::npos);
  CHECK(json_complaint(R"({"lattice":"square"})").find("unknown lattice 'square'") !=
        std::string::npos);
  CHECK(json_complaint(R"({"stigc_structure":1,"cells":[]})").ends_with("key 'bricks' is missing"));
  CHECK(json_complaint(R"({"bricks":[{"symbol":"1"}]})").ends_with("symbol, name and color"));
  CHECK(json_complaint(R"({"bricks":[{"color":"red"}]})").ends_with("not of the form #rrggbb"));
  CHECK(
      json_complaint(with_cells("[[0,0,0]]")).ends_with("a cell is four numbers: x, y, z, brick"));
  CHECK(json_complaint(with_cells("[[0,0,0,1,1]]")).ends_with("x, y, z, brick"));
  CHECK(json_complaint(with_cells("[[0.5,0,0,1]]")).ends_with("'0.5' is not a whole number"));
  CHECK(json_complaint(with_cells("[[NaN,0,0,1]]")).find("not JSON") != std::string::npos);
  CHECK(json_complaint(with_cells("[[1e400,0,0,1]]")).starts_with("F405"));
  CHECK(json_complaint(with_cells("[[null,0,0,1]]")).starts_with("F405"));
  CHECK(json_complaint(with_cells("[]") + "x").starts_with("F405"));
  CHECK(json_complaint("{\"stigc_structure\":\xff}").starts_with("F405"));
}

TEST_CASE("what is wrong with the cells") {
  CHECK(json_complaint(with_cells("[[0,0,0,1],[0,0,0,1]]")).ends_with("(0, 0, 0) is given twice"));
  CHECK(
      json_complaint(with_cells("[[0,0,0,2]]")).ends_with("a cell names brick 2, but there are 1"));
  CHECK(json_complaint(with_cells("[[0,0,0,0]]")).ends_with("brick 0 is none of 1..62"));
  CHECK(json_complaint(with_cells("[[99999999,0,0,1]]")).starts_with("F406"));
  CHECK(json_complaint(with_cells("[[18446744073709551615,0,0,1]]")).ends_with("number too large"));
  CHECK(json_complaint(with_cells("[[-9223372036854775808,0,0,1]]")).starts_with("F406"));
}

TEST_CASE("depth and scatter cost nothing") {
  CHECK(json_complaint(with_cells(std::string(1000000, '['))).starts_with("F405"));
  CHECK(json_complaint(std::string(1000000, '{')).starts_with("F405"));
}

}  // namespace
}  // namespace stig
