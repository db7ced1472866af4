// SPDX-License-Identifier: MIT
// Options that neither an example of the help nor another test gives.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "support/uses.h"

namespace stig {
namespace {

TEST_CASE("synth merges no rules, allows no ties or adds a scaffold when it is told to") {
  const Workplace place;
  place.write("line.txt", "1 1 1\n");
  place.write("square.txt", "1 1 1\n1 1 1\n1 1 1\n");
  CHECK(place.stigc({"synth", "line.txt"}).out.find("? * 1") != std::string::npos);
  const Outcome exact = place.stigc({"synth", "line.txt", "--exact"});
  CHECK(exact.exit_code == 0);
  CHECK(exact.out.find('?') == std::string::npos);
  const auto orders = [&place](std::vector<std::string> more) {
    more.insert(more.begin(), {"synth", "square.txt", "--json", "--order", "breadth-first"});
    return nlohmann::json::parse(place.stigc(more).out).at("orders_tried").get<int>();
  };
  CHECK(orders({"--strict"}) < orders({}));
  const Outcome scaffold = place.stigc({"synth", "line.txt", "--scaffold", "2"});
  CHECK(scaffold.exit_code == 0);
  CHECK(scaffold.out.find("title: line.txt, 4 bricks") != std::string::npos);
}

TEST_CASE("simulate draws what a robot's camera sees, if there is such") {
  const Workplace place;
  place.write("p.lua", "function step() end");
  place.write("s.yaml",
              "stigc_scene: 1\nduration: 0.1\n"
              "robots: [{file: bebot.yaml, name: r, program: p.lua}]\n");
  const Outcome none = place.stigc({"simulate", "s.yaml", "-o", "eye.png", "--camera", "nobody"});
  CHECK(none.exit_code == 2);
  CHECK_FALSE(place.has("eye.png"));
  CHECK(place.stigc({"simulate", "s.yaml", "-o", "eye.png", "--camera", "r"}).exit_code == 0);
  CHECK(place.file("eye.png").starts_with("\x89PNG"));
}

TEST_CASE("compile writes a page about a refusal where it is told to, and none of rules that do") {
  const Workplace place;
  place.write("middle.yaml",
              "stigc: 1\nname: middle\nlattice: cubic\nbricks:\n"
              "  1: {color: \"#8d99ae\", led: Q1}\n  2: {color: \"#ef476f\", led: Q2}\n"
              "start: [{at: [0, 0, 0], brick: 1}, {at: [2, 0, 0], brick: 1}]\n"
              "rules:\n  - name: between\n    place: 2\n    when: |\n"
              "      ? ? ?   ? ? ?   ? ? ?\n      ? ? ?   1 * 1   ? ? ?\n"
              "      ? ? ?   ? ? ?   ? ? ?\n");
  CHECK(place.stigc({"compile", "middle.yaml", "--why", "why.txt"}).exit_code == 2);
  const Outcome refused = place.stigc({"compile", "middle.yaml", "--why", "why.html"});
  CHECK(refused.exit_code != 0);
  // A build without node has no template, and says so.
  if (place.has("why.html")) {
    CHECK(refused.exit_code == 1);
    CHECK(place.file("why.html").find("</html>") != std::string::npos);
  }
  place.stigc({"compile", STIG_SOURCE_DIR "/rulesets/staircase.yaml", "--why", "none.html"});
  CHECK_FALSE(place.has("none.html"));
}

TEST_CASE("view calls its page as it is told to") {
  const Workplace place;
  place.write("line.txt", "1 1 1\n");
  const Outcome outcome =
      place.stigc({"view", "line.txt", "-o", "page.html", "--title", "Three in a row"});
  // A build without node has no template, and says so.
  if (outcome.exit_code != 0) return;
  CHECK(place.file("page.html").find("<title>Three in a row</title>") != std::string::npos);
}

}  // namespace
}  // namespace stig
