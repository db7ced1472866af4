// SPDX-License-Identifier: MIT
// A program in the manner of the library of 2019 runs as it is, in a scene that says so.
#include "behaviour/support.h"
#include "support/uses.h"

using namespace stig;
using namespace stig::behaviour;

namespace {

const std::string kCarry =
    "stigc_scene: 1\ninterface: 2019\n"
    "robots:\n  - {file: builderbot-2019.yaml, at: [-0.25, 0], program: library_2019/carry.lua,\n"
    "     params: {rules: green}}\nblock_program: library_2019/block.lua\n"
    "blocks:\n  - {name: load, file: stigmergic-2021.yaml, at: [0, 0, 0.0275]}\n";

std::string with(std::string text, const std::string& old, const std::string& now) {
  const auto at = text.find(old);
  REQUIRE(at != text.npos);
  return text.replace(at, old.size(), now);
}

}  // namespace

TEST_CASE("a program of 2019 picks a block up and colours it") {
  Trial trial(kCarry);
  const bool done = trial.until(60, "done");
  INFO(trial.log());
  REQUIRE(done);
  CHECK(trial.said("pick up block at"));
  CHECK(trial.said("received 3 on"));
  CHECK(trial.led("load") == Led::q3);
  CHECK(trial.block("load").p.z > 0.06);
}

TEST_CASE("a scene of 2019 with its files alone runs as it did with its folders") {
  const LoadedScene loaded = scene_of(kCarry);
  Diagnostics diagnostics;
  const auto again = load_scene(loaded.scene.files, 1, diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(again);
  std::uint64_t hashes[2];
  const LoadedScene* scenes[] = {&loaded, &*again};
  for (int i = 0; i < 2; ++i) {
    Simulation run(scenes[i]->scene, scenes[i]->placed);
    run.until(10, {});
    CHECK_FALSE(run.crew()->failed(0));
    hashes[i] = run.world().hash();
  }
  CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("the interface of 2021 has nothing of it") {
  Trial trial(with(kCarry, "interface: 2019", "interface: 2021"));
  trial.until(1);
  CHECK(trial.failed());
  CHECK(trial.said("global 'package'"));
}

TEST_CASE("a module that nobody wrote down is missed with the files that were tried") {
  Trial trial(with(kCarry, "rules: green", "rules: blue"));
  trial.until(1);
  CHECK(trial.failed());
  CHECK(trial.said("there is no module 'blue'"));
  CHECK(trial.said("'library_2019/rules/blue.lua'"));
}
