// SPDX-License-Identifier: MIT
// stigc search and stigc archive: the same results however they came about, and words for each way
// in which they cannot.
#include <doctest/doctest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

using Json = nlohmann::json;

/// A plan with so many evaluations.
std::string plan(int evaluations, const std::string& method = "genetic") {
  return "stigc_search: 1\nname: trial\nmethod: " + method +
         "\nscore: [{objective: modules, weight: 0.1}, {objective: rules_used}]\n"
         "axes: [{objective: bricks, from: 0, to: 100}, {objective: height, from: 0, to: 10}]\n"
         "rules: 10\nbox: 10\ndeposits: 100\nbatch: 64\nevaluations: " +
         std::to_string(evaluations) + "\n";
}

std::string content(const Workplace& place, const std::string& file) {
  return Json::parse(place.stigc({"archive", file, "--json"}).out).at("content_hash");
}

}  // namespace

TEST_CASE("what search and archive print") {
  const Workplace place;
  place.write("plan.yaml", plan(128, "map-elites"));
  hold(place, "search", "stigc search plan.yaml -o found.sqlite --threads 2");
  hold(place, "search-again", "stigc search plan.yaml -o found.sqlite");
  hold(place, "archive", "stigc archive found.sqlite --top 3");
  hold(place, "archive-pick",
       "stigc archive found.sqlite --pick 5 -o rules.yaml && stigc check rules.yaml");
  CHECK(place.stigc({"archive", "found.sqlite", "--pick", "5"}).out == place.file("rules.yaml"));
  hold(place, "search-bad", "stigc search plan.yaml; stigc search none.yaml -o x.sqlite");
  hold(
      place, "archive-bad",
      "stigc archive none.sqlite; stigc archive plan.yaml; stigc archive found.sqlite --pick 9999; "
      "stigc archive found.sqlite -o a.yaml; stigc archive found.sqlite --pick 5 -o found.sqlite");
}

TEST_CASE("one thread, two threads, and a longer plan in two goes find the same") {
  const Workplace place;
  place.write("plan.yaml", plan(640));
  const Outcome one = place.stigc({"search", "plan.yaml", "-o", "one", "--threads", "1"});
  CHECK(one.exit_code == 0);
  CHECK(place.stigc({"search", "plan.yaml", "-o", "two", "--threads", "2"}).out == one.out);
  place.write("short.yaml", plan(256));
  CHECK(place.stigc({"search", "short.yaml", "-o", "three"}).exit_code == 0);
  CHECK(place.stigc({"search", "plan.yaml", "-o", "three"}).out == one.out);
  CHECK(one.out.find(content(place, "three")) != std::string::npos);
}

TEST_CASE("slices that are merged have row by row what the search in one piece has") {
  const Workplace place;
  place.write("plan.yaml", plan(640, "random"));
  REQUIRE(place.stigc({"search", "plan.yaml", "-o", "whole"}).exit_code == 0);
  for (const std::string part : {"1", "2", "3"}) {
    const Outcome slice = place.stigc({"search", "plan.yaml", "-o", part, "--slice", part + "/3"});
    CHECK(slice.exit_code == 0);
    CHECK(slice.out.find(part == "1" ? "256" : "192") != std::string::npos);  // 4, 3, 3 batches
  }
  hold(place, "search-slices",
       "stigc merge 1 2 -o less; stigc merge 1 2 3 2 -o less; stigc merge whole 2 3 -o less; stigc "
       "merge 1 plan.yaml 3 -o less; stigc merge 1 2 3 -o 2; stigc merge 1 2 3 -o less -o more; "
       "stigc "
       "search plan.yaml -o 1 --slice 2/3; stigc search plan.yaml -o 1; ls less; stigc merge 3 1 2 "
       "-o merged");
  CHECK(content(place, "merged") == content(place, "whole"));
  const std::string tables =
      "import sqlite3, sys\n"
      "for table in 'meta', 'structures', 'individuals', 'batches':\n"
      "  for row in sqlite3.connect(sys.argv[1]).execute(f'SELECT * FROM {table} ORDER BY 1'): "
      "print(row)\n";
  place.write("tables.py", tables);
  const std::string rows = place.shell("python3 tables.py whole").out;
  CHECK(std::count(rows.begin(), rows.end(), '\n') > 40);
  CHECK(place.shell("python3 tables.py merged").out == rows);
  // And it goes on as the whole would.
  place.write("plan.yaml", plan(896, "random"));
  place.stigc({"search", "plan.yaml", "-o", "merged"});
  place.stigc({"search", "plan.yaml", "-o", "whole"});
  CHECK(content(place, "merged") == content(place, "whole"));
  place.stigc({"search", "plan.yaml", "-o", "1", "--slice", "1/3"});
  const Outcome behind = place.stigc({"merge", "1", "2", "3", "-o", "uneven"});
  CHECK(behind.err.find("evaluations 640 to 703 are in none of these") != std::string::npos);
  place.write("genetic.yaml", plan(640));
  CHECK(place.stigc({"search", "genetic.yaml", "-o", "x", "--slice", "1/2"}).exit_code == 1);
  CHECK_FALSE(place.has("x"));
}

TEST_CASE("a search that is killed goes on and ends as if it had not been") {
  const Workplace place;
  place.write("plan.yaml", plan(12'800));
  for (const int signal : {SIGKILL, SIGKILL, SIGTERM}) {
    const pid_t search = place.start({"search", "plan.yaml", "-o", "killed", "--threads", "2"});
    Workplace::let_work(search);
    ::kill(search, signal);
    const Outcome outcome = place.finish(search);
    // A fast machine may be done by then.
    if (signal == SIGTERM && outcome.exit_code != 0) CHECK(outcome.exit_code == 3);
  }
  const Outcome end = place.stigc({"search", "plan.yaml", "-o", "killed"});
  CHECK(end.exit_code == 0);
  CHECK(end.out == place.stigc({"search", "plan.yaml", "-o", "whole"}).out);
}

TEST_CASE("of two searches that write to one file one goes on, and nothing is lost") {
  const Workplace place;
  place.write("plan.yaml", plan(6400));
  const pid_t first = place.start({"search", "plan.yaml", "-o", "both", "--threads", "1"});
  Workplace::let_work(first);
  const Outcome second = place.stigc({"search", "plan.yaml", "-o", "both", "--threads", "1"});
  const Outcome other = place.finish(first);
  CHECK((second.exit_code == 0 || other.exit_code == 0));
  for (const Outcome& outcome : {second, other}) {
    if (outcome.exit_code == 0) continue;
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.err.find("another search has written to it meanwhile") != std::string::npos);
  }
  const Outcome whole = place.stigc({"search", "plan.yaml", "-o", "whole"});
  CHECK(whole.out.find(content(place, "both")) != std::string::npos);
}

TEST_CASE("a program in Lua scores, the same on any number of threads") {
  const Workplace place;
  std::string text = plan(256);
  text.replace(text.find("score:"), text.find("axes:") - text.find("score:"), "score: tall.lua\n");
  place.write("plan.yaml", text);
  place.write("tall.lua", "function score(one)\n  return one.height * 100 + #one.cells\nend\n");
  const Outcome one = place.stigc({"search", "plan.yaml", "-o", "one", "--threads", "1"});
  CHECK(one.exit_code == 0);
  CHECK(place.stigc({"search", "plan.yaml", "-o", "two", "--threads", "2"}).out == one.out);
  const Json archive = Json::parse(place.stigc({"archive", "one", "--json"}).out);
  for (const Json& find : archive.at("finds")) {
    const Json& values = find.at("objectives");
    CHECK(find.at("score") ==
          values.at("height").get<double>() * 100 + values.at("bricks").get<double>());
  }
  // The file's contents are the plan's.
  place.write("tall.lua", "function score(one)\n  while true do end\nend\n");
  CHECK(place.stigc({"search", "plan.yaml", "-o", "one"}).exit_code == 3);
  hold(place, "search-endless", "stigc search plan.yaml -o three");
  place.write("tall.lua", "function score(one)\n  return 'tall'\nend\n");
  hold(place, "search-no-number", "stigc search plan.yaml -o four");
  CHECK(place.shell("rm tall.lua; stigc search plan.yaml -o five").exit_code == 1);
}

TEST_CASE("what compile says of finds is what the command says") {
  const Workplace place;
  place.write("plan.yaml",
              "stigc_search: 1\nname: robots\nmethod: genetic\nfloor: true\n"
              "score: [{objective: robots}, {objective: coordinated}]\nrobot: bebot.yaml\n"
              "rules: 4\nbox: 7\ndeposits: 20\nproof: 1000000\nbatch: 64\nevaluations: 256\n");
  CHECK(place.stigc({"search", "plan.yaml", "-o", "found"}).exit_code == 0);
  const Json all = Json::parse(place.stigc({"archive", "found", "--top", "300", "--json"}).out);
  int built = 0, refused = 0;
  for (const Json& find : all.at("finds")) {
    const double robots = find.at("objectives").at("robots");
    const int code = find.at("objectives").at("refusal");
    CHECK((robots > 0) == (code == 0));
    if (code == 701) continue;
    if (code == 0 ? built++ > 1 : refused++ > 3) continue;
    const std::string id = find.at("id").dump();
    CHECK(place.stigc({"archive", "found", "--pick", id, "-o", "r.yaml"}).exit_code == 0);
    const Outcome compiled = place.stigc({"compile", "r.yaml"});
    CAPTURE(compiled.err);
    CHECK((compiled.exit_code == 0) == (code == 0));
    if (code > 0) {
      CHECK(compiled.err.find("error[P" + std::to_string(code) + "]") != std::string::npos);
    } else {
      CHECK((compiled.out.find("any number at once") != std::string::npos) == (robots > 1));
    }
  }
  CHECK(built > 0);
  CHECK(refused > 0);
  std::string text = place.file("plan.yaml");
  text.replace(text.find("bebot"), 5, "nobot");
  place.write("other.yaml", text);
  CHECK(place.stigc({"search", "other.yaml", "-o", "other"}).exit_code == 1);
}

TEST_CASE("figures and a page of finds") {
  const Workplace place;
  place.write("plan.yaml", plan(256));
  place.write("seed.yaml", plan(256) + "seed: 2\n");
  CHECK(place.stigc({"search", "plan.yaml", "-o", "a"}).exit_code == 0);
  CHECK(place.stigc({"search", "seed.yaml", "-o", "b"}).exit_code == 0);
  for (const std::string names : {"bricks", "bricks,height", "bricks,height,score"}) {
    CHECK(place.stigc({"archive", "a", "--plot", names, "-o", names + ".svg"}).exit_code == 0);
    CHECK(place.file(names + ".svg").rfind("<svg", 0) == 0);
  }
  CHECK(place.stigc({"archive", "a", "--beside", "b", "--plot", "evaluated,best", "-o", "c.svg"})
            .exit_code == 0);
  CHECK(place.file("c.svg").find("class=\"band\"") != std::string::npos);
  CHECK(place.stigc({"archive", "a", "--pick", "0", "-o", "built.txt"}).exit_code == 0);
  CHECK(place.stigc({"measure", "built.txt"}).exit_code == 0);
  CHECK(place.stigc({"archive", "a", "--top", "3", "--gallery", "page.html"}).exit_code == 0);
  const std::string page = place.file("page.html");
  CHECK(page.find("data:image/svg+xml;base64,") != std::string::npos);
  CHECK(page.find("drawn") != std::string::npos);
  CHECK(page.find(content(place, "a")) != std::string::npos);
}

TEST_CASE("figures that cannot be are refused") {
  const Workplace place;
  place.write("plan.yaml", plan(64));
  CHECK(place.stigc({"search", "plan.yaml", "-o", "a"}).exit_code == 0);
  const auto usage = [&](const std::string& line) {
    CAPTURE(line);
    CHECK(place.shell(line).exit_code == 2);
  };
  usage("stigc archive a --plot beauty -o x.svg");
  usage("stigc archive a --plot bricks,score,id,times -o x.svg");
  usage("stigc archive a --plot bricks");
  usage("stigc archive a --plot bricks -o a");
  usage("stigc archive a --gallery a");
  usage("stigc archive a --plot bricks -o x.svg --gallery y.html");
  usage("stigc archive a --beside a");
  CHECK(place.stigc({"archive", "a", "--beside", "none", "--plot", "id", "-o", "x"}).exit_code ==
        1);
}

TEST_CASE("a full disk ends a search with words, and what was reported stays") {
  const Workplace place;
  place.write("plan.yaml", plan(128));
  CHECK(place.stigc({"search", "plan.yaml", "-o", "found"}).exit_code == 0);
  const std::string before = content(place, "found");
  place.write("plan.yaml", plan(12'800));
  // A limit on the size of files is met as a full disk is: in the middle of a write.
  const Outcome full = place.shell("ulimit -f 700; stigc search plan.yaml -o found");
  CHECK(full.exit_code == 3);
  CHECK_MESSAGE(full.err.find("found: ") != std::string::npos, full.err);
  const Outcome after = place.stigc({"archive", "found", "--json"});
  CHECK(after.exit_code == 0);
  CHECK(Json::parse(after.out).at("evaluated") >= 128);
  place.write("plan.yaml", plan(640));
  CHECK(place.stigc({"search", "plan.yaml", "-o", "found"}).exit_code == 0);
}

TEST_CASE("results that cannot be written are refused before the work") {
  const Workplace place;
  place.write("plan.yaml", plan(64));
  CHECK(place.stigc({"search", "plan.yaml", "-o", "plan.yaml"}).exit_code == 2);
  CHECK(place.stigc({"search", "plan.yaml", "-o", "nowhere/found"}).exit_code == 3);
  place.write("text", std::string(4096, 'x'));
  CHECK(place.stigc({"search", "plan.yaml", "-o", "text"}).exit_code == 3);
  CHECK(place.file("text") == std::string(4096, 'x'));
  place.write("other.yaml", plan(64, "random"));
  CHECK(place.stigc({"search", "plan.yaml", "-o", "found"}).exit_code == 0);
  const Outcome other = place.stigc({"search", "other.yaml", "-o", "found"});
  CHECK(other.exit_code == 3);
  CHECK(other.err == "stigc: found: its results are of another plan\n");
  std::filesystem::permissions(place.path("found"), std::filesystem::perms::owner_read);
  // Root may write to it all the same.
  if (::geteuid() != 0) {
    CHECK(place.stigc({"search", "plan.yaml", "-o", "found"}).exit_code == 3);
  }
}

}  // namespace stig
