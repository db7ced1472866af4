// SPDX-License-Identifier: MIT
// Chart and decisions as they are found in a compiled controller's text.
#include "view/robot_program.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

namespace stig {
namespace {

constexpr const char* kProgram =
    "-- Builds.\n"
    "local function decide(column)\n"
    "   if column.top_colour == 2 then\n"
    "      return { what = 'raise', colour = 2 }\n"
    "   end\n"
    "end\n"
    "local CHART = {\n"
    "   first = 'search block',\n"
    "   ['search block'] = { does = 'search_block',\n"
    "      on = { found = 'approach block', none = 'search block' } },\n"
    "   ['approach block'] = { does = 'approach_block',\n"
    "      on = { lost = 'search block' } },\n"
    "}\n"
    "local other = {\n"
    "   ['no state'] = { on = { a = 'b' } },\n"
    "}\n";

TEST_CASE("a controller's chart and decisions are found in its text") {
  const auto program = program_json(kProgram);
  CHECK(
      program["chart"].dump() ==
      R"([{"state":"search block","does":"search_block","to":[["found","approach block"],["none","search block"]]},)"
      R"({"state":"approach block","does":"approach_block","to":[["lost","search block"]]}])");
  CHECK(program["decides"]["line"] == 2);
  const std::string text = program["decides"]["text"];
  CHECK(text.starts_with("local function decide(column)\n   if"));
  CHECK(text.ends_with("   end\nend\n"));
}

TEST_CASE("any other text has neither") {
  for (const std::string text :
       {"", "local CHART = {", "local CHART = {\n on = { = 'x', } },\n['\n['a\non = {{{ = \n",
        "function step() end\n"}) {
    const auto program = program_json(text);
    CHECK(program["decides"]["text"] == "");
    for (const auto& state : program["chart"]) CHECK(state["to"].empty());
  }
}

}  // namespace
}  // namespace stig
