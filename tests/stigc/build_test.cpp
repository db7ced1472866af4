// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "program.h"
#include "support/uses.h"

namespace stig {

TEST_CASE("build refuses a folder of the user's, and says why nothing can be built") {
  const Workplace place;
  place.write("line.txt", "1 1\n");
  place.write("apart.txt", "1 . 1\n");
  CHECK(place.shell("mkdir mine && echo kept > mine/rules.yaml").exit_code == 0);
  const Outcome mine = place.stigc({"build", "line.txt", "-o", "mine"});
  CHECK(mine.exit_code == 2);
  CHECK(mine.err.find("no earlier build wrote it") != std::string::npos);
  CHECK(place.file("mine/rules.yaml") == "kept\n");
  // A file of the name that the usual robot has is none that was asked for.
  place.write("bebot.yaml", "no robot\n");
  CHECK(place.stigc({"build", "apart.txt", "-o", "shadow"}).out.starts_with("impossible: "));
  // What only the last of its steps writes is refused before the first.
  CHECK(place.shell("mkdir staged && echo kept > staged/scene.yaml").exit_code == 0);
  const Outcome staged = place.stigc({"build", "line.txt", "-o", "staged"});
  CHECK(staged.exit_code == 2);
  CHECK(staged.err.find("'staged/scene.yaml' is there already") != std::string::npos);
  CHECK(place.file("staged/scene.yaml") == "kept\n");
  CHECK_FALSE(place.has("staged/rules.yaml"));
  CHECK(place.shell("mkdir piped && mkfifo piped/rules.yaml").exit_code == 0);
  CHECK(place.stigc({"build", "line.txt", "-o", "piped"}).exit_code != 0);
  const Outcome apart = place.stigc({"build", "apart.txt", "-o", "out"});
  CHECK(apart.exit_code == 1);
  CHECK(apart.out.starts_with("impossible: "));
  CHECK_FALSE(place.has("out"));
  // Rules of an earlier build are written over, which is not to be taken for an input.
  CHECK(place.shell("mkdir ours && echo 'source: compiled by stigc synth' > ours/rules.yaml")
            .exit_code == 0);
  const Outcome ours = place.stigc({"build", "apart.txt", "-o", "ours"});
  CHECK(ours.exit_code == 1);
  CHECK(ours.err.find("what is in 'ours' is of an earlier build") != std::string::npos);
  CHECK(place.stigc({"build", "line.txt"}).exit_code == 2);
  place.write("blank.txt", "1\n\n.\n1\n");
  const std::string err = place.stigc({"build", "blank.txt", "-o", "blank"}).err;
  CHECK(err.find("warning[F412]") != std::string::npos);
  CHECK(err.find("warning[F412]") == err.rfind("warning[F412]"));
}

#if STIG_WITH_DART
TEST_CASE("build goes from a drawing to a report and pictures, and again") {
  const Workplace place;
  place.write("line.txt", "1 1\n");
  for (int time = 0; time < 2; ++time) {
    const Outcome built = place.stigc({"build", "line.txt", "-o", "out"});
    CHECK(built.exit_code == 0);
    CHECK(built.out.find("complete") != std::string::npos);
    for (const char* name : {"target.png", "rules.yaml", "decisions.txt", "controller.lua",
                             "scene.yaml", "report.html", "report.json", "built.png"}) {
      CAPTURE(name);
      CHECK(place.has(std::string("out/") + name));
    }
  }
}

TEST_CASE("with more kinds of brick than four robots build a line that four colours cannot") {
  const Workplace place;
  place.write("line.txt", "1 1 1 1 1 1 1 1\n");
  const Outcome four = place.stigc({"build", "line.txt", "--colours", "free", "-o", "four"});
  CHECK(four.exit_code == 1);
  CHECK(four.out.find("with --kinds 16") != std::string::npos);
  const Outcome built = place.stigc({"build", "line.txt", "--kinds", "codes", "-o", "out"});
  CHECK(built.exit_code == 0);
  CHECK(built.out.find("complete in 1 of 1 runs") != std::string::npos);
  CHECK(place.file("out/rules.yaml").find("led: Q8") != std::string::npos);
}
#endif

}  // namespace stig
