// SPDX-License-Identifier: MIT
// A scene brings what its programs require, so that a trace can run them again anywhere.
#include "behaviour/support.h"
#include "support/uses.h"

using namespace stig;
using namespace stig::behaviour;

TEST_CASE("names that a text requires") {
  const auto names = required_names(
      "local a = require 'one'\nlocal b = require(\"two\")\nrequire 'one'\nrequire '../three'\n"
      "require(name) -- require\nlocal c = require 'part.four'\n");
  CHECK(names == std::vector<std::string>{"one", "two", "part.four"});
  CHECK(module_file("part.four") == "part/four.lua");
  CHECK(required_names("require '").empty());
}

TEST_CASE("a scene with its files alone runs as it did with its folders") {
  const std::string text =
      "stigc_scene: 1\nrobots: [{file: bebot.yaml, program: fetch_and_stack.lua}]\n"
      "blocks: [{at: [0.3, 0, 0.0275]}]\n";
  const LoadedScene loaded = scene_of(text);
  Diagnostics diagnostics;
  const auto again = load_scene(loaded.scene.files, 1, diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(again);
  std::uint64_t hashes[2];
  const LoadedScene* scenes[] = {&loaded, &*again};
  for (int i = 0; i < 2; ++i) {
    Simulation run(scenes[i]->scene, scenes[i]->placed);
    run.until(8, {});
    CHECK_FALSE(run.crew()->failed(0));
    hashes[i] = run.world().hash();
  }
  CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("without the file beside it a program says what is missing") {
  Diagnostics diagnostics;
  LoadedScene loaded =
      scene_of("stigc_scene: 1\nrobots: [{file: bebot.yaml, program: fetch_and_stack.lua}]\n");
  for (LuaProgram& program : loaded.scene.programs) program.modules.clear();
  Simulation run(loaded.scene, loaded.placed);
  std::string said;
  RunHooks hooks;
  hooks.on_line = [&](const CrewLine& line) { said += line.text; };
  run.until(1, hooks);
  CHECK(run.crew()->failed(0));
  CHECK(said.find("there is no file 'common/geometry.lua' beside the program") != said.npos);
}
