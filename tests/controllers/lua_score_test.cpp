// SPDX-License-Identifier: MIT
// Scores from programs: a number of what is given alone, or words.
#include <doctest/doctest.h>

#include "lua/lua_score.h"
#include "support/uses.h"

namespace stig {
using namespace lua;
namespace {

const ScoredStructure kTower{7, {{"height", 3}, {"share", 0.5}}, {{0, 0, 0, 1}, {0, 0, 2, 2}}};

std::optional<double> score(const std::string& text, LuaFailure& failure) {
  return lua_score({.path = "s.lua", .text = text, .whole = true}, kTower, failure);
}

double score(const std::string& text) {
  LuaFailure failure;
  const auto out = score(text, failure);
  CHECK_MESSAGE(out.has_value(), failure.what);
  return out.value_or(-1);
}

/// Line and words.
void fails(const std::string& text, std::size_t line, const std::string& what) {
  CAPTURE(text);
  LuaFailure failure;
  CHECK_FALSE(score(text, failure));
  CHECK(failure.line == line);
  CHECK_MESSAGE(failure.what.find(what) != std::string::npos, failure.what);
}

}  // namespace

TEST_CASE("a program sees measures and cells") {
  CHECK(score("function score(o) return o.height + o.share end") == 3.5);
  CHECK(score("function score(o) return o.id * 100 + #o.cells end") == 702);
  CHECK(score("function score(o) local c = o.cells[2] return c.z * 10 + c.color + c.x end") == 22);
  CHECK(score("function score(o) return robot == nil and 1 or 0 end") == 1);
}

TEST_CASE("what is scored before leaves nothing behind, and chance is the same each time") {
  const std::string counts = "n = (n or 0) + 1 function score() n = n + 1 return n end";
  CHECK(score(counts) == 2);
  CHECK(score(counts) == 2);
  const std::string chance = "function score() return math.random() end";
  CHECK(score(chance) == score(chance));
}

TEST_CASE("programs without a score end in words and a line") {
  fails("function score()\n  while true do end\nend", 2, "more than 1000000 instructions");
  fails("while true do end", 1, "more than 1000000 instructions");
  fails("function score()\n  local t = {}\n  while true do t[#t + 1] = {} end\nend", 0,
        "of memory");
  fails("function score()\n  return score()\nend", 2, "more than 1000000 instructions");
  fails("function score() end", 0, "score returned nothing in place of a finite number");
  fails("function score() return '3' end", 0, "score returned '3' in place of");
  fails("function score() return {} end", 0, "in place of a finite number");
  fails("function score() return 0 / 0 end", 0, "in place of a finite number");
  fails("function score() return math.huge end", 0, "in place of a finite number");
  fails("function score(o)\n  return o.hieght + 1\nend", 2, "hieght");
  fails("function scores() return 1 end", 1, "score");
  fails("function score(\nend", 2, "");
  fails("function score() return require 'other' end", 1, "other");
  fails("function score() error(nil) end", 0, "");
}

}  // namespace stig
