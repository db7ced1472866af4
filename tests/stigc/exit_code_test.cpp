// SPDX-License-Identifier: MIT
// What ends how: 0 ok, 1 invalid or a property fails, 2 usage, 3 failed, out of
// budget or interrupted.
#include <doctest/doctest.h>

#include <csignal>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

int code(const Workplace& place, const std::string& line) {
  const Outcome outcome = place.shell(line);
  CAPTURE(outcome.err);
  return outcome.exit_code;
}

TEST_CASE("exit codes by class") {
  const Workplace place;
  CHECK(code(place, "stigc check sets/line.yaml") == 0);
  CHECK(code(place, "stigc --version") == 0);
  CHECK(code(place, "stigc check sets/bad.yaml") == 1);
  CHECK(code(place, "stigc explore sets/bad.yaml") == 1);
  CHECK(code(place, "stigc test sets/wrong_expectation.yaml") == 1);
  CHECK(code(place, "stigc fmt --check sets/corner.yaml") == 1);
  CHECK(code(place, "echo nonsense > t.stigt; stigc replay t.stigt") == 1);
  CHECK(code(place, "stigc measure missing.vox") == 1);
  CHECK(code(place, "stigc explore sets/line.yaml --steps") == 2);
  CHECK(code(place, "stigc explore sets/line.yaml -o missing/x.png") == 3);
  // Of a set that grows for ever nobody knows whether two orders end differently.
  CHECK(
      code(place,
           "sed 's/endless/order-dependent/' sets/sheet.yaml > open.yaml; stigc test open.yaml") ==
      3);
}

TEST_CASE("rules of which nothing was shown within what is allowed are not refused for good") {
  const Workplace place;
  place.write("exact.yaml", project_file("rulesets/staircase-exact.yaml"));
  const std::string compile = "stigc compile exact.yaml ";
  CHECK(place.shell(compile + "--budget 0.000001").err.find("error[P701]") != std::string::npos);
  CHECK(code(place, compile + "--budget 0.000001") == 3);
  CHECK(place.shell(compile + "--states 1").err.find("error[P712]") != std::string::npos);
  CHECK(code(place, compile + "--states 1") == 3);
  CHECK(code(place, compile) == 1);
  // Proved that orders end differently.
  CHECK(code(place, "stigc compile sets/corner.yaml") == 1);
}

TEST_CASE("what one sample did not contradict, a proof does") {
  const Workplace place;
  const std::string one = "stigc test --states 0 --samples 1 ";
  const auto expecting = [&](const std::string& what) {
    return place.shell("sed 's/verdict: order-dependent/" + what +
                       "/' sets/corner.yaml > t.yaml; " + one + "t.yaml");
  };
  const Outcome coordinated = expecting("verdict: coordinated");
  CHECK(coordinated.exit_code == 1);
  CHECK(coordinated.out.find("failed           coordinated: order-dependent (a proof)") !=
        std::string::npos);
  CHECK(expecting("verdict: order-dependent").exit_code == 0);
  // Both ends have four bricks, which contradicts nothing.
  CHECK(expecting("bricks: 4").exit_code == 0);
  const Outcome endless = place.shell(
      "sed 's/verdict: endless/verdict: coordinated/' sets/sheet.yaml > s.yaml; " + one + "s.yaml");
  CHECK(endless.exit_code == 1);
  CHECK(endless.out.find("an order that never ends (a proof)") != std::string::npos);
}

TEST_CASE("a run in which every program failed exits with 1, and one that cannot begin") {
  const Workplace place;
  const auto with = [&](const std::string& program) {
    place.write("b.lua", program);
    place.write("s.yaml",
                "stigc_scene: 1\nduration: 0.5\nblocks: [{name: a, at: [0, 0, 0.0275]}, "
                "{name: b, at: [1, 0, 0.0275]}]\nblock_program: b.lua\n");
  };
  with("function step() end\n");
  CHECK(code(place, "stigc check s.yaml && stigc simulate s.yaml") == 0);
  with("function step() if robot.id == 'b' then error('no') end end\n");
  CHECK(code(place, "stigc check s.yaml && stigc simulate s.yaml") == 0);
  with("function step() error('no') end\n");
  CHECK(code(place, "stigc check s.yaml") == 0);
  const Outcome all = place.shell("stigc simulate s.yaml");
  CHECK(all.exit_code == 1);
  CHECK(all.err.find("every program failed") != std::string::npos);
  CHECK(code(place, "stigc simulate s.yaml --runs 2") == 1);
  CHECK(place.shell("stigc simulate s.yaml --runs 2").err.find("seed 2: every program failed") !=
        std::string::npos);
  for (const char* program : {"function on_step() end\n", "function step( end\n"}) {
    with(program);
    CHECK(code(place, "stigc check s.yaml") == 1);
    CHECK(code(place, "stigc simulate s.yaml --trace t.stigp") == 1);
    CHECK_FALSE(place.has("t.stigp"));
  }
}

TEST_CASE("a rule set comes from standard input as well") {
  const Workplace place;
  CHECK(code(place, "cat sets/line.yaml | stigc check -") == 0);
  for (const std::string command : {"check", "fmt"}) {
    CHECK(place.shell("stigc " + command + " - < sets/bad.yaml").err.find("<stdin>:") !=
          std::string::npos);
  }
}

TEST_CASE("-W error makes warnings fail") {
  const Workplace place;
  const std::string line =
      "sed 's/place: 3/place: 2/; s/2 [*]/1 */; s/stage: 2/stage: 1/' "
      "sets/line.yaml | sed '/^expect/,$d' > repeat.yaml; ";
  CHECK(code(place, line + "stigc check repeat.yaml") == 0);
  CHECK(code(place, line + "stigc check -W error repeat.yaml") == 1);
  CHECK(code(place, line + "stigc explore --werror repeat.yaml") == 1);
}

/// A command for each that prints something on standard output, in every form.
constexpr const char* kPrinting[] = {
    "--help",
    "--version",
    "check --help",
    "check sets/line.yaml",
    "check -q sets/line.yaml",
    "check --diagnostics json sets/bad.yaml",
    "fmt sets/line.yaml",
    "fmt --check sets/corner.yaml",
    "explore sets/line.yaml",
    "explore sets/line.yaml --json",
    "explore sets/line.yaml --runs 2",
    "explain sets/line.yaml --at 1,0,0",
    "test sets/line.yaml",
    "verify sets/line.yaml",
    "certify sets/line.yaml sets/line.cert",
    "certify staircase.yaml work.cert",
    "graph sets/line.yaml",
    "replay t.stigt",
    "replay t.stigp",
    "schema",
    "schema robot",
    "measure s.txt",
    "synth s.txt",
    "synth s.txt -o -",
    "synth s.txt -o s.yaml",
    "simulate sets/still.yaml --duration 0.01",
    "describe bebot.yaml",
    "compile staircase.yaml",
    "compile staircase.yaml --target lua -o -",
    "compile staircase.yaml -o c.lua --report -",
    "validate staircase.yaml --duration 0.1",
    "completions bash",
    "doctor sets/line.yaml",
};

void put_inputs(const Workplace& place) {
  place.write("s.txt", "1 1\n");
  place.write("bebot.yaml", project_file("robots/bebot.yaml"));
  place.write("staircase.yaml", project_file("rulesets/staircase.yaml"));
  REQUIRE(place
              .shell("stigc explore sets/line.yaml --trace t.stigt; "
                     "stigc compile staircase.yaml --certificate work.cert -o s.lua; "
                     "stigc simulate sets/still.yaml --duration 0.01 --trace t.stigp")
              .exit_code == 0);
}

TEST_CASE("standard output that cannot be written fails every command, and it says so") {
  const Workplace place;
  put_inputs(place);
  for (const std::string command : kPrinting) {
    CAPTURE(command);
    const Outcome full = place.shell("stigc " + command + " > /dev/full");
    CHECK(full.exit_code == 3);
    CHECK(full.err.find("stigc: cannot write to standard output: No space left on device\n") !=
          std::string::npos);
    const Outcome closed = place.shell("stigc " + command + " >&-");
    CHECK(closed.exit_code == 3);
    CHECK(closed.err.find("stigc: cannot write to standard output: ") != std::string::npos);
  }
}

TEST_CASE("a reader that has left is no failure of any command") {
  const Workplace place;
  put_inputs(place);
  for (const std::string command : kPrinting) {
    CAPTURE(command);
    const int usual = code(place, "stigc " + command + " > /dev/null");
    // The only reader of the pipe is gone before the command begins.
    const Outcome left = place.shell("exec 4> >(true); wait $!; stigc " + command + " >&4");
    CHECK(left.exit_code == usual);
    CHECK(left.err.find("standard output") == std::string::npos);
  }
}

TEST_CASE("a command that is silent when all is well needs no standard output") {
  const Workplace place;
  CHECK(code(place, "stigc explore sets/line.yaml -o s.txt -q > /dev/null") == 0);
  CHECK(code(place, "stigc draw s.txt -o s.png > /dev/full") == 0);
  CHECK(code(place, "stigc fmt sets/line.yaml > l.yaml; stigc fmt --check l.yaml > /dev/full") ==
        0);
  CHECK(code(place, "stigc check sets/bad.yaml 2>&-") == 1);
}

TEST_CASE("results are not added to the file that they come from") {
  const Workplace place;
  place.write("set.yaml", place.file("sets/corner.yaml"));
  CHECK(code(place, "stigc fmt set.yaml >> set.yaml") == 3);
  CHECK(place.file("set.yaml") == place.file("sets/corner.yaml"));
}

TEST_CASE("an option that there is not is said to be one, with a command and without") {
  const Workplace place;
  for (const std::string line :
       {"stigc --bogus", "stigc --bogus --help", "stigc check --bogus x"}) {
    CAPTURE(line);
    const Outcome outcome = place.shell(line);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.starts_with("stigc: unknown option '--bogus'"));
  }
  CHECK(place.shell("stigc --verison").err.find("did you mean '--version'?") != std::string::npos);
}

TEST_CASE("help of a command that there is not is a usage error") {
  const Workplace place;
  for (const std::string line : {"stigc serch --help", "stigc --help serch", "stigc verfy -h",
                                 "stigc serch --version", "stigc -q synht --help"}) {
    CAPTURE(line);
    const Outcome outcome = place.shell(line);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("stigc: there is no command '"));
  }
  CHECK(place.shell("stigc verfy --help").err ==
        "stigc: there is no command 'verfy'; did you mean 'verify'?\ntry 'stigc --help'\n");
  CHECK(place.shell("stigc verify --help").out == place.shell("stigc --help verify").out);
  CHECK(code(place, "stigc --help") == 0);
}

TEST_CASE("an interrupted run writes whole files, says what was done, and exits 3") {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Workplace place;
    const pid_t process =
        place.start({"explore", "sets/sheet.yaml", "--motion", "event", "--deposits",
                     "1000000000000", "-o", "part.json", "--trace", "part.stigt"});
    Workplace::let_work(process);
    REQUIRE(kill(process, signal) == 0);
    const Outcome outcome = place.finish(process);
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.find("interrupted after") != std::string::npos);
    CHECK(place.files() == std::vector<std::string>{"part.json", "part.stigt"});
    CHECK(place.stigc({"replay", "part.stigt"}).exit_code == 0);
    CHECK(place.stigc({"measure", "part.json"}).exit_code == 0);
  }
}

TEST_CASE("a search for rules that is interrupted says so in its verdict") {
  const Workplace place;
  place.write("bebot.yaml", project_file("robots/bebot.yaml"));
  const std::string row(120, '1');  // a wall whose colours are sought for many seconds
  place.write("wall.txt", row + "\n---\n" + row + "\n---\n" + row + "\n");
  const pid_t process =
      place.start({"synth", "wall.txt", "--robot", "bebot.yaml", "--json", "-o", "rules.yaml"});
  Workplace::let_work(process);
  REQUIRE(kill(process, SIGINT) == 0);
  const Outcome outcome = place.finish(process);
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.out.find("\"verdict\": \"interrupted\"") != std::string::npos);
  CHECK(!place.has("rules.yaml"));
}

TEST_CASE("averages and structures leave interrupted runs out") {
  const Workplace place;
  const pid_t process =
      place.start({"explore", "sets/sheet.yaml", "--motion", "event", "--deposits", "1000000000000",
                   "--runs", "2", "--threads", "2"});
  Workplace::let_work(process);
  REQUIRE(kill(process, SIGINT) == 0);
  const Outcome outcome = place.finish(process);
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.out.find("2: 2 interrupted\n") != std::string::npos);
  CHECK(outcome.out.find("none: no run was finished\n") != std::string::npos);
  CHECK(outcome.out.find("on average") == std::string::npos);
}

TEST_CASE("a stop asked for while results are written counts") {
  const Workplace place;
  // One byte read: the runs are over. The pipe takes no more, so the program waits.
  CHECK(code(place,
             "mkfifo pipe; '" STIGC_PROGRAM "' explore sets/corner.yaml --motion event --json "
             "--runs 300 > pipe & exec 3< pipe; read -r -n 1 -u 3; kill -TERM $!; "
             "cat <&3 > rest; wait $!") == 3);
  CHECK(place.file("rest").ends_with("\n}\n"));
}

TEST_CASE("a command that looks at no flag dies of the first signal") {
  for (const std::string command : {"check", "fmt", "graph", "explain --at 0,0,0"}) {
    for (const int signal : {SIGINT, SIGTERM}) {
      CAPTURE(command);
      const Workplace place;
      // The pipe is empty until after the signal, so the program waits for it. A shell
      // lets what it starts in the background ignore SIGINT, unless told otherwise.
      CHECK(code(place,
                 "mkfifo pipe; exec 3<> pipe; "
                 "env --default-signal=INT '" STIGC_PROGRAM "' " +
                     command + " - < pipe 3>&- & sleep 0.2; kill -" + std::to_string(signal) +
                     " $!; exec 3>&-; wait $!") == 128 + signal);
    }
  }
}

TEST_CASE("a failed write leaves the old file as it was") {
  const Workplace place;
  const std::string before = "stigc explore sets/line.yaml -q -o out.txt >/dev/null; ";
  CHECK(code(place, before + "ulimit -f 0; "
                             "stigc explore sets/corner.yaml -q -o out.txt >/dev/null 2>&1") == 3);
  CHECK(place.file("out.txt").ends_with("\n1 2 3\n"));
  CHECK(place.files() == std::vector<std::string>{"out.txt"});
}

}  // namespace
}  // namespace stig
