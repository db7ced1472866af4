// SPDX-License-Identifier: MIT
// Sessions: whoever looks, the run is the same; what is asked is done, and is in the trace.
#include "live_support.h"

#include <filesystem>
#include <fstream>

#include "lattice/trace.h"
#include "physical/simulation/simulation.h"
#include "physical/simulation/verify_trace.h"

namespace stig {
namespace {

std::string simulated(const LoadedScene& loaded) {
  std::string out;
  Simulation run(loaded.scene, loaded.placed, false);
  PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                         [&](std::string_view bytes) { out += bytes; });
  run.record(writer);
  const RunEnd end = run.until(loaded.scene.duration, {});
  run.end_script({});
  run.finish(end);
  return out;
}

std::string explored(const RuleSet& rules, const SwarmConfig& config) {
  TraceWriter writer(rules, config);
  SwarmHooks hooks;
  hooks.deposit = [&](const Deposit& deposit) { writer.deposit(deposit); };
  const SwarmResult result = run_swarm(RuleTable(rules), rules.start, config, hooks);
  return writer.finish(result.steps, result.terminated);
}

bool has_ended(const Json& state) { return state["mode"] == "ended"; }

PoseTrace pose_trace(const std::string& bytes) {
  Diagnostics diagnostics;
  auto trace = read_pose_trace("t", bytes, diagnostics);
  REQUIRE_MESSAGE(trace, to_text(diagnostics));
  return std::move(*trace);
}

TEST_CASE("a physical run has the bytes of stigc simulate, whoever looks") {
  const std::string expected = simulated(falling_blocks());
  for (const std::size_t lookers : {0, 3}) {
    CAPTURE(lookers);
    AtWork work([] { return pose_live(falling_blocks()); });
    std::vector<Looker> all(lookers);
    for (Looker& looker : all) {
      REQUIRE(work.session.join());
      told(work.session, looker, "state", has_ended);
    }
    // Where nobody sees it end, it is asked for more steps than it has.
    for (int i = 0; lookers == 0 && i < 10; ++i) work.ask(R"({"do":"step","count":1000})");
    CHECK(work.end() == expected);
  }
}

TEST_CASE("a lattice run has the bytes of stigc explore, however it is stepped") {
  const RuleSet rules = tower_rules(2000);
  const std::string expected = explored(rules, event_config());
  AtWork work([] { return lattice_live(tower_rules(2000), event_config(), "tower"); }, true);
  REQUIRE(work.session.join());
  Looker looker;
  for (const int count : {1, 2, 300}) work.ask(Json{{"do", "step"}, {"count", count}}.dump());
  const Json state =
      told(work.session, looker, "state", [](const Json& now) { return now["time"] == 303; });
  CHECK(state["mode"] == "paused");
  work.ask(R"({"do":"run"})");
  CHECK(told(work.session, looker, "state", has_ended)["time"] == 2000);
  CHECK(work.end() == expected);
}

TEST_CASE("a lattice run that is broken off can be replayed as far as it came") {
  AtWork work([] { return lattice_live(tower_rules(50), event_config(), "tower"); }, true);
  work.ask(R"({"do":"step","count":7})");
  Diagnostics diagnostics;
  const auto trace = read_trace("t", work.end(), diagnostics);
  REQUIRE(trace);
  CHECK(trace->events.size() == 7);
  CHECK(replay(*trace, tower_rules(50)).identical);
}

TEST_CASE("a lattice run goes back to a checkpoint, and on as before") {
  AtWork work([] { return lattice_live(tower_rules(50), event_config(), "tower"); }, true);
  REQUIRE(work.session.join());
  Looker looker;
  work.ask(R"({"do":"step","count":5})");
  CHECK(work.ask(R"({"do":"checkpoint"})")["checkpoint"] == 1);
  work.ask(R"({"do":"step","count":20})");
  work.ask(R"({"do":"back","checkpoint":1})");
  CHECK(work.ask(R"({"do":"back","checkpoint":2})")["problem"] == "there is no such checkpoint");
  told(work.session, looker, "state",
       [](const Json& now) { return now["run"] == 2 && now["time"] == 5; });
  work.ask(R"({"do":"run"})");
  told(work.session, looker, "state", has_ended);
  CHECK(work.end() == explored(tower_rules(50), event_config()));
}

TEST_CASE("what is done by hand is in the trace, and going back takes it out again") {
  const LoadedScene loaded = falling_blocks();
  AtWork work([] { return pose_live(falling_blocks()); }, true);
  CHECK(work.ask(R"({"do":"move","block":0,"at":[0.3,0,0.2],"yaw":0.4})")["ok"] == true);
  CHECK(work.ask(R"({"do":"checkpoint"})")["ok"] == true);
  work.ask(R"({"do":"step","count":40})");
  CHECK(work.ask(R"({"do":"drop","at":[-0.3,0,0.2]})")["ok"] == true);
  CHECK(work.ask(R"({"do":"checkpoint"})")["ok"] == true);
  CHECK(work.ask(R"({"do":"move","block":1,"at":[0.3,0.3,0.2]})")["ok"] == true);
  work.ask(R"({"do":"step","count":30})");
  const auto replayed = [&](const std::string& bytes, std::size_t hands) {
    const PoseTrace trace = pose_trace(bytes);
    CHECK(trace.hands.size() == hands);
    const TraceComparison report = verify_trace(trace, loaded, {});
    CHECK_MESSAGE(report.identical, report.difference);
  };
  SUBCASE("the whole of it") { replayed(work.end(), 3); }
  SUBCASE("back to the second checkpoint") {
    work.ask(R"({"do":"back","checkpoint":2})");
    work.ask(R"({"do":"step","count":250})");
    replayed(work.end(), 2);
  }
  SUBCASE("back to the first, at the beginning") {
    work.ask(R"({"do":"back","checkpoint":1})");
    work.ask(R"({"do":"step","count":250})");
    replayed(work.end(), 1);
  }
}

TEST_CASE("who comes late or reads slowly is told all news and the latest state") {
  AtWork work([] { return lattice_live(tower_rules(3000), event_config(), "tower"); });
  REQUIRE(work.session.join());
  Looker first;
  told(work.session, first, "state", has_ended);
  REQUIRE(work.session.join());
  Looker late;
  std::size_t bricks = 0, states = 0;
  while (states == 0) {
    const auto text = work.session.next(late, std::chrono::milliseconds(20));
    REQUIRE(text);
    for (std::size_t at = text->find("event: news"); at != std::string::npos;
         at = text->find("event: news", at + 1)) {
      const std::size_t from = text->find("data: ", at) + 6;
      bricks += Json::parse(text->substr(from, text->find('\n', from) - from)).size();
    }
    states += text->find("event: state") != std::string::npos ? 1 : 0;
  }
  CHECK(bricks == 3000);
}

TEST_CASE("a session takes no more than so many who look") {
  AtWork work([] { return lattice_live(tower_rules(3), event_config(), "tower"); });
  for (std::size_t i = 0; i < kMostLookers; ++i) CHECK(work.session.join());
  CHECK(!work.session.join());
  work.session.leave();
  CHECK(work.session.join());
}

TEST_CASE("a file counts as saved when it is whole, and stays so until it is watched anew") {
  const auto path = std::filesystem::temp_directory_path() / "stig-watch-test.txt";
  const auto write = [&](const std::string& text) { std::ofstream(path) << text; };
  write("one");
  FileWatch watch;
  watch.watch({path.string()});
  CHECK(!watch.saved());
  write("two and more");
  CHECK(!watch.saved());  // it may still be written
  CHECK(watch.saved());
  watch.watch({path.string()});
  CHECK(!watch.saved());
  std::filesystem::remove(path);
  CHECK(!watch.saved());
  CHECK(!watch.saved());
}

TEST_CASE("commands are read strictly") {
  const auto problem_of = [](const std::string& text) {
    std::string problem;
    const bool good = read_command(text, problem).has_value();
    CHECK(good == problem.empty());
    return problem;
  };
  for (const std::string good :
       {R"({"do":"run"})", R"({"do":"speed","times":null})", R"({"do":"speed","times":2.5})",
        R"({"do":"move","robot":0,"at":[0,1,2]})", R"({"do":"drop","at":[0,1,2],"yaw":1})",
        R"({"do":"break","robot":3})"}) {
    CHECK_MESSAGE(problem_of(good) == "", good);
  }
  for (const std::string bad :
       {"", "[]", "7", "{", R"({"do":"run"} x)", R"({"do":1})", R"({"do":"fly"})",
        R"({"do":"run","x":1})", R"({"do":"step"})", R"({"do":"step","count":0})",
        R"({"do":"step","count":1.5})", R"({"do":"step","count":-1})",
        R"({"do":"speed","times":"2"})", R"({"do":"speed","times":1e400})",
        R"({"do":"move","block":0,"at":[0,1]})", R"({"do":"move","block":0,"at":[0,1,"2"]})",
        R"({"do":"move","block":0,"robot":0,"at":[0,1,2]})",
        R"({"do":"move","block":0,"at":[0,1,1e9]})", R"({"do":"mend","block":3})"}) {
    CHECK_MESSAGE(problem_of(bad) != "", bad);
  }
  CHECK(problem_of("{\"do\":\"run\"" + std::string(kMostCommandBytes, ' ') + "}") != "");
  CHECK(problem_of(std::string(kMostCommandBytes, '[')) != "");
}

}  // namespace
}  // namespace stig
