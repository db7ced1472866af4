// SPDX-License-Identifier: MIT
// stigc init: what it writes works as its README says.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

TEST_CASE("every command of a new project's README runs") {
  const Workplace place;
  REQUIRE(place.stigc({"init", "mine"}).exit_code == 0);
  std::istringstream page(place.file("mine/README.md"));
  int commands = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("    stigc ")) continue;
    CAPTURE(line);
    const Outcome outcome = place.shell("cd mine && " + line);
    CHECK_MESSAGE(outcome.exit_code == 0, outcome.err);
    ++commands;
  }
  CHECK(commands >= 12);
  // The schemas that came are those that the README's commands wrote.
  REQUIRE(place.stigc({"init", "again"}).exit_code == 0);
  for (const std::string schema : {"rules.schema.json", "scene.schema.json"}) {
    CHECK(place.file("mine/" + schema) == place.file("again/" + schema));
  }
}

TEST_CASE("a new project goes into a folder that has nothing of these names") {
  const Workplace place;
  std::filesystem::create_directory(place.path("mine"));
  place.write("mine/notes.txt", "mine");
  CHECK(place.stigc({"init", "mine"}).exit_code == 0);
  CHECK(place.file("mine/notes.txt") == "mine");
  place.write("mine/rules.yaml", "changed");
  std::filesystem::create_directory(place.path("one"));
  place.write("one/scene.yaml", "changed");
  hold(place, "init-there", "stigc init mine; stigc init one; ls one; stigc init none/one");
  CHECK(place.file("mine/rules.yaml") == "changed");
}

}  // namespace
}  // namespace stig
