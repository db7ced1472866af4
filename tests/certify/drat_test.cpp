// SPDX-License-Identifier: MIT
#include "certify/drat.h"
#include "support/uses.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>

#include <vector>

namespace stig {
namespace {

using Clauses = std::vector<std::vector<int>>;

std::string cnf(int variables, const Clauses& clauses) {
  std::string text = fmt::format(
      "c a formula, its variables numbered from one and no more of them than bytes\np cnf {} {}\n",
      variables, clauses.size());
  for (const auto& clause : clauses) text += fmt::format("{} 0\n", fmt::join(clause, " "));
  return text;
}

/// The same steps in the binary form.
std::string binary(const Clauses& steps) {
  std::string bytes;
  for (const auto& clause : steps) {
    bytes += 'a';
    for (const int literal : clause) {
      auto number = static_cast<unsigned>(literal > 0 ? 2 * literal : -2 * literal + 1);
      for (; number > 127; number >>= 7U) bytes += static_cast<char>(128 + (number & 127U));
      bytes += static_cast<char>(number);
    }
    bytes += '\0';
  }
  return bytes;
}

std::string refusal(const std::string& formula, const std::string& proof) {
  const DratReport report = check_drat(formula, proof);
  CHECK(report.refuted == report.refusal.empty());
  return report.refusal;
}

/// All signs of two variables.
const Clauses kSquare{{1, 2}, {1, -2}, {-1, 2}, {-1, -2}};
/// The example of Wetzler, Heule, Hunt, "DRAT-trim" (2014).
const Clauses kEight{{1, 2, -3},   {-1, -2, 3}, {2, 3, -4}, {-2, -3, 4},
                     {-1, -3, -4}, {1, 3, 4},   {-1, 2, 4}, {1, -2, -4}};

TEST_CASE("proofs by unit propagation, as text and binary") {
  CHECK(refusal(cnf(2, kSquare), "1 0\n0\n").empty());
  CHECK(refusal(cnf(2, kSquare), "1 0").empty());  // the contradiction is there already
  CHECK(refusal(cnf(2, kSquare), binary({{1}, {}})).empty());
  CHECK(refusal(cnf(70, {{70, 2}, {70, -2}, {-70, 2}, {-70, -2}}), binary({{70}})).empty());
  CHECK(refusal(cnf(1, {{1}, {-1}}), "").empty());
  CHECK(refusal(cnf(1, {{}}), "").empty());
}

TEST_CASE("a clause that is redundant, though it does not follow") {
  const std::string proof = "-1 0\nd -1 2 4 0\n2 0\n0\n";
  CHECK(refusal(cnf(4, kEight), proof).empty());
  // Without 1 -2 -4 the formula has a solution; the first clause is redundant all the same.
  Clauses seven = kEight;
  seven.pop_back();
  CHECK(refusal(cnf(4, seven), proof) == "step 4 of the proof adds a clause that does not follow");
}

TEST_CASE("what does not prove is refused with its step") {
  CHECK(refusal(cnf(2, kSquare), "") == "the proof ends before a contradiction is found");
  CHECK(refusal(cnf(2, kSquare), "0\n") ==
        "step 1 of the proof adds a clause that does not follow");
  CHECK(refusal(cnf(2, {{1, 2}, {-1, 2}, {1, -2}}), "1 0\n-2 0\n") ==
        "step 2 of the proof adds a clause that does not follow");
  CHECK(refusal(cnf(2, kSquare), "d 1 2 0\nd -1 -2 0\n1 0\n2 0\n0\n") ==
        "step 3 of the proof adds a clause that does not follow");
}

TEST_CASE("deletion: what is gone no longer helps, what forces a literal stays") {
  const Clauses clauses{{1},         {-1, 2},        {-2, 3}, {-3, 4}, {-4, -1, 5},
                        {-5, -1, 6}, {-5, -6, 7, 8}, {7, -8}, {-7, 8}, {-7, -8}};
  CHECK(refusal(cnf(8, clauses), "d 1 0\nd -1 2 0\n7 0\n").empty());
  CHECK_FALSE(refusal(cnf(8, clauses), "d 7 -8 0\n7 0\n").empty());
  CHECK(refusal(cnf(8, clauses), "d -8 7 8 0\n7 0\n").empty());  // no such clause
}

TEST_CASE("malformed formulas and proofs") {
  CHECK(refusal("", "") == "the formula has no line 'p cnf VARIABLES CLAUSES'");
  CHECK(refusal("p cnf 2\n", "") == "the formula has no line 'p cnf VARIABLES CLAUSES'");
  CHECK(refusal("p cnf 99999 1\n1 0\n", "") ==
        "the formula has more variables than its text has room for");
  CHECK(refusal("p cnf 2 2\n1 0\n", "") == "the formula has 1 clauses, and its header says 2");
  CHECK(refusal("p cnf 2 1\n1 3 0\n", "") == "clause 1 of the formula is malformed");
  CHECK(refusal("p cnf 2 1\n1 2\n", "") == "clause 1 of the formula is malformed");
  CHECK(refusal("p cnf 2 1\n1 x 0\n", "") == "clause 1 of the formula is malformed");
  const std::string formula = cnf(2, kSquare);
  const std::string malformed =
      "step 1 of the proof is no clause of the formula's variables, "
      "ended by 0";
  CHECK(refusal(formula, "1 2\n") == malformed);
  CHECK(refusal(formula, "3 0\n") == malformed);
  CHECK(refusal(formula, "d") == malformed);
  CHECK(refusal(formula, "1 -9223372036854775808 0\n") == malformed);
  CHECK(refusal(formula, "a\x02") == malformed);
  CHECK(refusal(formula, std::string("a\x01\0", 3)) == malformed);
  CHECK(refusal(formula, std::string("a\xff\xff\xff\xff\xff\xff\0", 8)) == malformed);
  CHECK(refusal(formula, "proof") == "step 1 of the proof neither adds nor deletes a clause");
}

bool has_solution(int variables, const Clauses& clauses) {
  for (int values = 0; values < 1 << variables; ++values) {
    const auto holds = [&](int literal) {
      return ((values >> (std::abs(literal) - 1) & 1) != 0) == (literal > 0);
    };
    if (std::all_of(clauses.begin(), clauses.end(), [&](const auto& clause) {
          return std::any_of(clause.begin(), clause.end(), holds);
        })) {
      return true;
    }
  }
  return false;
}

TEST_CASE("no formula with a solution is refuted, whatever the proof") {
  int refuted = 0;
  CHECK(rc::check("random proofs", [&] {
    const auto number = [](int low, int high) {
      return *rc::gen::resize(100, rc::gen::inRange(low, high + 1));
    };
    const int variables = number(2, 6);
    const auto clause = [&](int longest) {
      std::vector<int> literals(static_cast<std::size_t>(number(1, longest)));
      for (int& literal : literals) literal = number(1, variables) * (number(0, 1) * 2 - 1);
      return literals;
    };
    for (int attempt = 0; attempt < 20; ++attempt) {
      Clauses clauses;
      for (int i = number(1, 4 * variables); i > 0; --i) clauses.push_back(clause(4));
      // Steps that are refused are left out, so that many wrong ones get their turn.
      std::string proof;
      DratReport report;
      for (int i = 0; i < 25 && !report.refuted; ++i) {
        const bool deletes = number(0, 3) == 0;
        const auto& any =
            clauses[static_cast<std::size_t>(number(0, static_cast<int>(clauses.size()) - 1))];
        const std::string step =
            fmt::format("{}{} 0\n", deletes ? "d " : "", fmt::join(deletes ? any : clause(3), " "));
        report = check_drat(cnf(variables, clauses), proof + step);
        if (report.refusal.find("does not follow") == std::string::npos) proof += step;
      }
      if (!report.refuted) continue;
      ++refuted;
      RC_ASSERT(!has_solution(variables, clauses));
    }
  }));
  CHECK(refuted > 200);
}

}  // namespace
}  // namespace stig
