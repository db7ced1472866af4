// SPDX-License-Identifier: MIT
// stigc schema: what editors are offered where a symbol is wanted.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "support/uses.h"

namespace stig {
namespace {

using Json = nlohmann::json;

/// What is offered in a schema for one of its definitions.
Json offered(const std::string& schema, const char* definition) {
  return Json::parse(schema).at("definitions").at(definition).at("examples");
}

TEST_CASE("a schema offers the symbols of a file's bricks, finished or not") {
  const Workplace place;
  place.write("begun.yaml", "stigc: 1\nbricks:\n  pink: {}\n  7: {}\n  \"010\": {}\n  \"?\": {}\n");
  const Outcome outcome = place.stigc({"schema", "--symbols-of", "begun.yaml"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(offered(outcome.out, "symbol") == Json({"pink", 7, "010"}));
  CHECK(offered(outcome.out, "state") == Json({"pink", 7, "010", ".", "?", "#", "="}));
  const std::string general = place.stigc({"schema"}).out;
  CHECK(offered(general, "symbol") == Json({1, 2, 3, 4}));
  // Nothing else differs: other symbols are as good as before.
  Json with = Json::parse(outcome.out), without = Json::parse(general);
  for (const char* definition : {"symbol", "state"}) {
    with["definitions"][definition].erase("examples");
    without["definitions"][definition].erase("examples");
  }
  CHECK(with == without);
}

TEST_CASE("symbols are those of a rule set that can be read") {
  const Workplace place;
  CHECK(place.stigc({"schema", "--symbols-of", "none.yaml"}).exit_code == 1);
  CHECK(place.stigc({"schema", "scene", "--symbols-of", "sets/line.yaml"}).exit_code == 2);
  place.write("list.yaml", "- 1\n");
  CHECK(offered(place.stigc({"schema", "--symbols-of", "list.yaml"}).out, "symbol") ==
        Json::array());
}

TEST_CASE("a modeline stays the first line") {
  const Workplace place;
  const std::string modeline = "# yaml-language-server: $schema=tower.schema.json\n";
  place.write("tower.yaml", modeline + place.file("sets/line.yaml"));
  CHECK(place.stigc({"check", "-W", "error", "tower.yaml"}).exit_code == 0);
  CHECK(place.stigc({"fmt", "tower.yaml"}).out.starts_with(modeline));
}

}  // namespace
}  // namespace stig
