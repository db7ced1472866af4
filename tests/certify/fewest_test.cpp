// SPDX-License-Identifier: MIT
// Clauses about colours with their reasons, written by hand: what follows, and what does not.
#include "certify/fewest.h"
#include "support/uses.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>
#include <vector>

namespace stig {
namespace {

/// A row of three from its western end, in two colours unless said otherwise. Orbit o has colour c
/// by variable 2 o + c, so that 7 is the first of a pair.
std::string row(int colours = 2, int named = 0, const std::string& of_second = "\"any\"") {
  return fmt::format(
      R"({{"stigc_colouring": 1, "lattice": "cubic", "symmetry": "none", "floor": false,
"colours": {}, "named": {}, "order": "by hand", "orbits": [
{{"rank": 0, "start": true, "colours": "any", "cells": [[0, 0, 0]]}},
{{"rank": 1, "start": false, "colours": {}, "cells": [[1, 0, 0]]}},
{{"rank": 2, "start": false, "colours": "any", "cells": [[2, 0, 0]]}}]}})",
      colours, named, of_second);
}

/// What is said of the clauses, each line a reason or a clause without its 0.
std::string refusal(const std::string& problem, const std::vector<std::string>& lines) {
  std::string cnf = "p cnf 99 1\n";
  for (const std::string& line : lines) {
    const bool reason = line.find_first_of("abcdefghijklmnopqrstuvwxyzAB") == 0;
    cnf += reason ? "c " + line + "\n" : line + " 0\n";
  }
  const FewestReport report = derive_formula(problem, cnf);
  CHECK(report.derived == report.refusal.empty());
  return report.refusal;
}

bool holds(const std::string& reason, const std::string& clause, const std::string& problem) {
  return refusal(problem, {reason, clause}).empty();
}
bool holds(const std::string& reason, const std::string& clause) {
  return holds(reason, clause, row());
}

TEST_CASE("an orbit has a colour that it may have, and no two") {
  CHECK(holds("colour 0", "1 2"));
  CHECK(holds("colour 0", "5 2 1"));  // says less
  CHECK_FALSE(holds("colour 0", "1"));
  CHECK_FALSE(holds("colour 0", "3 4"));
  CHECK_FALSE(holds("colour 3", "7 8"));
  CHECK_FALSE(holds("colour -1", "-1 0"));
  CHECK(holds("colour 1", "3", row(2, 1, "[1]")));
  CHECK_FALSE(holds("colour 1", "4", row(2, 1, "[1]")));
  CHECK(holds("one 1", "-3 -4"));
  for (const char* clause : {"-3 -3", "-3", "3 4", "-2 -3", "-4 -5", "-3 -4 -3"}) {
    CAPTURE(clause);
    CHECK_FALSE(holds("one 1", clause));
  }
  CHECK_FALSE(holds("one 3", "-7 -8"));
  CHECK(holds("domain 1", "-4", row(2, 1, "[1]")));
  CHECK_FALSE(holds("domain 1", "-3", row(2, 1, "[1]")));
  CHECK_FALSE(holds("domain 0", "-2", row(2, 1, "[1]")));
  CHECK_FALSE(holds("domain 3", "-8", row(2, 1, "[1]")));
}

TEST_CASE("colours that the target does not name are taken in turn") {
  const std::string three = row(3);
  CHECK(holds("naming 1 0", "-2"));
  CHECK(holds("naming 1 0", "-3", three));
  CHECK(holds("naming 2 0", "-3", three));
  CHECK_FALSE(holds("naming 1 0", "-1"));
  CHECK_FALSE(holds("naming 2 0", "-2", three));
  CHECK_FALSE(holds("naming 0 0", "-1"));
  CHECK_FALSE(holds("naming 1 3", "-8"));
  // With one that the target names, the first of the list may have two.
  CHECK_FALSE(holds("naming 1 0", "-2", row(3, 1)));
  CHECK(holds("naming 1 0", "-3", row(3, 1)));
  CHECK_FALSE(holds("naming 1 1", "-6", row(3, 1, "[1]")));
  // A place in the list is one orbit's, and an orbit has one place.
  CHECK(refusal(three, {"naming 1 0", "-2", "-3", "naming 2 1", "-6"}).empty());
  CHECK_FALSE(refusal(three, {"naming 1 0", "-2", "naming 1 1", "-5"}).empty());
  CHECK_FALSE(refusal(three, {"naming 2 0", "-3", "naming 1 0", "-2"}).empty());
}

TEST_CASE("a pair's variable says that two orbits have one colour") {
  for (const char* clause : {"7 -1 -3", "7 -2 -4", "-7 -1 3", "-7 1 -3", "-7 2 -4", "3 -1 -7"}) {
    CAPTURE(clause);
    CHECK(holds("pair 7 0 1", clause));
    CHECK(holds("pair 7 1 0", clause));
  }
  for (const char* clause : {"7 -1 -4", "-7 1 3", "-7 -1 -3", "7 1 3", "7", "-1 -3", "7 -1"}) {
    CAPTURE(clause);
    CHECK_FALSE(holds("pair 7 0 1", clause));
  }
  CHECK_FALSE(holds("pair 6 0 1", "6 -1 -3"));  // is a colour's
  CHECK_FALSE(holds("pair 7 0 0", "7 -1"));
  CHECK_FALSE(holds("pair 7 0 3", "7 -1 -7"));
  CHECK_FALSE(refusal(row(), {"pair 7 0 1", "7 -1 -3", "pair 7 0 2", "7 -1 -5"}).empty());
}

/// Clauses of clashes, with pairs 7, 8 and 9 of orbits 0 and 1, 1 and 2, 0 and 2.
bool clash_holds(const std::string& reason, const std::string& clause) {
  return refusal(row(), {"pair 7 0 1", "7 -1 -3", "pair 8 1 2", "8 -3 -5", "pair 9 0 2", "9 -1 -5",
                         reason, clause})
      .empty();
}

TEST_CASE("a rule that would act where no brick is to be meets other colours there") {
  // The second brick's rule asks for the first to the west (bit 12); at (3, 0, 0) the third is.
  CHECK(clash_holds("A 1 1 0 0 0 -1 3 0 0 4096", "-9"));
  CHECK(clash_holds("A 1 1 0 0 0 -1 3 0 0 4096", "-9 -7"));  // says less
  CHECK_FALSE(clash_holds("A 1 1 0 0 0 -1 3 0 0 4096", "-7"));
  CHECK_FALSE(clash_holds("A 1 1 0 0 0 -1 3 0 0 4096", "-9 8"));
  CHECK_FALSE(clash_holds("A 1 1 0 0 0 -1 3 0 0 4096", "-9 -1"));
  for (const char* reason : {"A 2 1 0 0 0 -1 3 0 0 4096",   // another orbit's cell
                             "A 0 0 0 0 0 -1 3 0 0 4096",   // the start's, which no rule places
                             "A 1 9 0 0 0 -1 3 0 0 4096",   // nobody's
                             "A 1 1 0 0 1 -1 3 0 0 4096",   // an orientation that there is not
                             "A 1 1 0 0 -1 -1 3 0 0 4096",  //
                             "A 1 1 0 0 0 2 3 0 0 4096",    // no orbit's site
                             "A 1 1 0 0 0 -1 3 0 0 0",      // beside no brick
                             "A 1 1 0 0 0 -1 3 0 0 8192",   // east, where no brick is
                             "A 1 1 0 0 0 -1 3 0 0 12288",  // both
                             "A 1 1 0 0 0 -1 4 0 0 4096",   // beside none
                             "A 1 1 0 0 0 -1 3 1 0 4096",   //
                             "A 1 1 0 0 0 -1 3 0 0",        // too few numbers
                             "B 1 1 0 0 0 -1 3 0 0 4096"}) {
    CAPTURE(reason);
    CHECK_FALSE(clash_holds(reason, "-9"));
  }
}

TEST_CASE("a rule that acts where a brick is to be places that brick, or meets other colours") {
  // The second brick's rule at the third's site, which sees the second.
  CHECK(clash_holds("B 1 1 0 0 0 2 2 0 0 4096", "-7 8"));
  CHECK(clash_holds("B 1 1 0 0 0 2 2 0 0 4096", "8 -7 -9"));
  CHECK_FALSE(clash_holds("B 1 1 0 0 0 2 2 0 0 4096", "8"));
  // They may well look alike, as long as both are to have one colour.
  CHECK_FALSE(clash_holds("B 1 1 0 0 0 2 2 0 0 4096", "-7"));
  CHECK_FALSE(clash_holds("B 1 1 0 0 0 2 2 0 0 4096", "-7 9"));
  CHECK_FALSE(clash_holds("A 1 1 0 0 0 2 2 0 0 4096", "-7"));
  CHECK_FALSE(clash_holds("B 1 1 0 0 0 1 1 0 0 4096", "-7"));  // at its own site
  CHECK_FALSE(clash_holds("B 1 1 0 0 0 0 0 0 0 4096", "-7"));  // in the start
}

TEST_CASE("a clause stands on a line of its own behind its reason") {
  const auto of = [](const std::string& cnf) { return derive_formula(row(), cnf).refusal; };
  CHECK(of("p cnf 6 1\nc colour 0\n1 2 0\n").empty());
  CHECK(of("c colour 0\n\n  1\t2 0\r\n").empty());
  CHECK(of("c colour 0\n1 2\n0\n") == "clause 1 is not on a line of its own");
  CHECK(of("c colour 0\n1 2 0\n1 x 0\n") == "clause 2 is not on a line of its own");
  CHECK(of("c colour 0\n1 2 99999999999 0\n") == "clause 1 is not on a line of its own");
  CHECK(of("c colour 0\n1 0 2 0\n") == "clause 1 has a 0 within");
  CHECK(of("1 2 0\n") == "clause 1 does not follow from its reason ''");
  CHECK(of("c colour 0\n1 2 0\nc colour 1\n1 2 0\n") ==
        "clause 2 does not follow from its reason 'colour 1'");
  CHECK(of("c colour\n1 2 0\n") == "clause 1 does not follow from its reason 'colour'");
  CHECK(of("c colour 0 1\n1 2 0\n") == "clause 1 does not follow from its reason 'colour 0 1'");
  CHECK(of("c colour zero\n1 2 0\n") == "clause 1 does not follow from its reason 'colour zero'");
  const FewestReport report = derive_formula(row(), "c colour 0\n1 2 0\n");
  CHECK(report.cells == 3);
  CHECK(report.colours == 2);
  CHECK(report.order == "by hand");
  CHECK(report.clashes == 0);
}

/// The problem with one text in place of another.
std::string problem_with(std::string problem, const std::string& from, const std::string& to) {
  const std::size_t at = problem.find(from);
  REQUIRE(at != std::string::npos);
  problem.replace(at, from.size(), to);
  return derive_formula(problem, "").refusal;
}

TEST_CASE("a problem's orbits are those of the group about the middle of the start") {
  // A start of four, and four arms that the quarter turns map to each other.
  const std::string cross =
      R"({"stigc_colouring": 1, "lattice": "cubic", "symmetry": "rotations", "floor": true,
"colours": 2, "named": 0, "order": "by hand", "orbits": [
{"rank": 0, "start": true, "colours": "any", "cells": [[4, 4, 0], [5, 4, 0], [4, 5, 0], [5, 5, 0]]},
{"rank": 1, "start": false, "colours": "any", "cells": [[6, 4, 0], [5, 6, 0], [3, 5, 0], [4, 3, 0]]}
]})";
  CHECK(derive_formula(cross, "").derived);
  CHECK(problem_with(cross, "[6, 4, 0]", "[6, 5, 0]").find("in another orbit") !=
        std::string::npos);
  CHECK(problem_with(cross, ", [4, 3, 0]", "").find("in another orbit") != std::string::npos);
  CHECK(problem_with(cross, "[6, 4, 0]", "[6, 4, -1]").find("below the floor") !=
        std::string::npos);
  CHECK(problem_with(cross, ", [5, 4, 0], [4, 5, 0], [5, 5, 0]", ", [5, 4, 0]")
            .find("whose middle the group has not") != std::string::npos);
  // Two orbits as one: each is mapped into it, and not all from its first cell.
  CHECK(problem_with(cross, "[4, 3, 0]]", "[4, 3, 0], [6, 4, 1], [5, 6, 1], [3, 5, 1], [4, 3, 1]]")
            .find("more than one") != std::string::npos);
}

TEST_CASE("problems that are none are refused") {
  CHECK(problem_with(row(), "colouring\": 1", "colouring\": 2").find("version") !=
        std::string::npos);
  CHECK(problem_with(row(), "\"cubic\"", "\"conic\"").find("unknown lattice") != std::string::npos);
  CHECK(problem_with(row(), "\"colours\": 2", "\"colours\": 0").find("number of colours") !=
        std::string::npos);
  CHECK(problem_with(row(), "\"colours\": 2", "\"colours\": 63").find("number of colours") !=
        std::string::npos);
  CHECK(problem_with(row(), "\"named\": 0", "\"named\": -1").find("number of colours") !=
        std::string::npos);
  CHECK(problem_with(row(2, 1, "[1]"), "[1]", "[2]").find("not named") != std::string::npos);
  CHECK(problem_with(row(2, 1, "[1]"), "[1]", "[0]").find("not named") != std::string::npos);
  CHECK(problem_with(row(), "[2, 0, 0]", "[1, 0, 0]").find("there twice") != std::string::npos);
  CHECK(problem_with(row(), "[2, 0, 0]", "[2, 0]").find("three coordinates") != std::string::npos);
  CHECK(problem_with(row(), "[2, 0, 0]", "[20000000, 0, 0]").find("too far") != std::string::npos);
  CHECK(problem_with(row(), "[[2, 0, 0]]", "[]").find("without cells") != std::string::npos);
  CHECK(problem_with(row(), "\"start\": true", "\"start\": false").find("no start") !=
        std::string::npos);
  CHECK(problem_with(row(), "\"rank\": 2", "\"rank\": 1").find("nothing of lower rank") !=
        std::string::npos);
}

}  // namespace
}  // namespace stig
