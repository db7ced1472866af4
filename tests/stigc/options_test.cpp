// SPDX-License-Identifier: MIT
// Options that neither an example of the help nor another test gives.
#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "support/golden.h"
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

TEST_CASE("what is no run is not taken for a structure") {
  const Workplace place;
  place.shell("mkdir empty");
  CHECK(place.stigc({"view", "empty", "-o", "page.html"}).err ==
        "stigc: there is no trace (.stigp) in the folder 'empty'\n");
  const Outcome rules = place.stigc({"view", "sets/line.yaml", "-o", "page.html"});
  CHECK(rules.exit_code == 1);
  CHECK(rules.err ==
        "stigc: 'sets/line.yaml' is no run: record one by --trace, or look on with --live\n");
}

TEST_CASE("a live run waits where it is paused, and leaves ports alone that others have") {
  const Workplace place;
  place.write("line.txt", "1 1 1\n");
  const bool has_page = place.stigc({"view", "line.txt", "-o", "page.html"}).exit_code == 0;
  // A build without node has no template, and says so.
  if (!has_page) return;
  const Outcome paused = place.shell(
      "timeout --foreground --preserve-status -s INT 2 "
      "stigc view --live sets/line.yaml --paused --trace t.stigt");
  CHECK_MESSAGE(paused.exit_code == 0, paused.err);
  CHECK(place.stigc({"replay", "t.stigt"}).out.find("0 events, identical") != std::string::npos);

  const int taken = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  REQUIRE(bind(taken, reinterpret_cast<sockaddr*>(&address), length) == 0);
  REQUIRE(listen(taken, 1) == 0);
  REQUIRE(getsockname(taken, reinterpret_cast<sockaddr*>(&address), &length) == 0);
  const std::string port = std::to_string(ntohs(address.sin_port));
  const Outcome outcome = place.stigc({"view", "--live", "sets/line.yaml", "--port", port});
  close(taken);
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.err.find("port " + port + " of 127.0.0.1 cannot be had") != std::string::npos);
}

TEST_CASE("--sides takes one argument, and what comes after it is something else") {
  const Workplace place;
  place.write("c.yaml", project_file("rulesets/staircase.yaml"));
  REQUIRE(place.stigc({"verify", "c.yaml", "--certificate", "c.cert"}).exit_code == 0);
  for (const std::vector<std::string>& line :
       std::vector<std::vector<std::string>>{{"compile", "--sides=+x", "c.yaml"},
                                             {"compile", "--sides", "+x", "c.yaml"},
                                             {"compile", "c.yaml", "--sides=+x", "--sides=+y"},
                                             {"certify", "--sides=+x", "c.yaml", "c.cert"},
                                             {"certify", "c.yaml", "--sides=+x", "c.cert"},
                                             {"verify", "--sides=+x,-x,+y,-y", "c.yaml"}}) {
    CAPTURE(line);
    CHECK(place.stigc(line).exit_code == 0);
  }
  const auto refused = [&](const std::vector<std::string>& line, const std::string& message) {
    const Outcome outcome = place.stigc(line);
    CAPTURE(line);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err == "stigc: --sides: " + message + "\ntry 'stigc compile --help'\n");
  };
  refused({"compile", "c.yaml", "--sides=+x,-x,+y,-y,+x"}, "+x is given twice");
  refused({"compile", "c.yaml", "--sides=+x", "--sides=+x"}, "+x is given twice");
  refused({"compile", "c.yaml", "--sides=+x,,-x"}, "'' is not one of +x, -x, +y, -y");
  refused({"compile", "c.yaml", "--sides", ""}, "'' is not one of +x, -x, +y, -y");
}

TEST_CASE("an option with = and nothing after it takes nothing else for its value") {
  const Workplace place;
  place.write("c.yaml", project_file("rulesets/staircase.yaml"));
  for (const std::string option : {"--sides", "--robots", "--target", "--output", "--report"}) {
    for (const std::vector<std::string>& line : std::vector<std::vector<std::string>>{
             {"compile", option + "=", "c.yaml"},
             {"compile", option + "=", "--target", "ir", "c.yaml"},
             {"compile", "c.yaml", option + "="}}) {
      CAPTURE(line);
      const Outcome outcome = place.stigc(line);
      CHECK(outcome.exit_code == 2);
      CHECK(outcome.err ==
            "stigc: " + option + ": a value is wanted after the =\ntry 'stigc compile --help'\n");
    }
  }
  CHECK(place.stigc({"--color=", "check", "c.yaml"}).exit_code == 2);
  CHECK(place.stigc({"compile", "--bogus=", "c.yaml"}).err.starts_with("stigc: unknown option"));
}

}  // namespace
}  // namespace stig
