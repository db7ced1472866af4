// SPDX-License-Identifier: MIT
// Proofs that fewer colours do not do, before the checker that derives them again.
#include <doctest/doctest.h>

#include "certify/drat.h"
#include "certify/fewest.h"
#include "shapes.h"
#include "support/uses.h"
#include "synthesis/synthesise.h"

namespace stig {
namespace {

std::optional<MinimalityProof> proof_for(const Target& target, SynthesisOptions options) {
  options.effort = 0.25;
  const Synthesis found = synthesise(target, options);
  REQUIRE(found.best);
  return prove_fewest(*found.best, 0, {});
}

MinimalityProof line_of_five() {
  SynthesisOptions options;
  options.start = {{0, 0, 0}};
  const auto proof = proof_for(box({5, 1, 1}), options);
  REQUIRE(proof);
  return *proof;
}

TEST_CASE("proofs for lines, plates and cubes are derived again and hold") {
  struct Case {
    Target target;
    SynthesisOptions options;
  };
  std::vector<Case> cases(4);
  cases[0].target = box({6, 1, 1});
  cases[1].target = box({4, 4, 1});
  cases[1].options.family = OrderFamily::raster;
  cases[2].target = hollow_box(4);
  cases[3].target = pyramid(2);
  cases[3].options.symmetry = Symmetry::rotations;
  cases[3].options.floor = true;
  for (const Case& c : cases) {
    const auto proof = proof_for(c.target, c.options);
    if (!proof) continue;  // one colour does
    const FewestReport claim = derive_formula(proof->problem, proof->cnf);
    CHECK_MESSAGE(claim.derived, claim.refusal);
    CHECK(claim.cells == c.target.cells.size());
    CHECK(check_drat(proof->cnf, proof->drat).refuted);
  }
}

TEST_CASE("T8: a line of five from one end is proved to need five colours") {
  const MinimalityProof proof = line_of_five();
  const FewestReport claim = derive_formula(proof.problem, proof.cnf);
  REQUIRE(claim.derived);
  CHECK(claim.colours == 4);
  CHECK(check_drat(proof.cnf, proof.drat).refuted);
}

TEST_CASE("a clause that claims more than its reason is refused") {
  const MinimalityProof proof = line_of_five();
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string cnf = proof.cnf;
    const std::size_t at = cnf.find(from);
    REQUIRE(at != std::string::npos);
    cnf.replace(at, from.size(), to);
    return derive_formula(proof.problem, cnf).refusal;
  };
  CHECK(refused("1 2 3 4 0", "1 2 3 0").find("'colour 0'") != std::string::npos);
  CHECK(refused("-1 -2 0", "-1 -5 0").find("'one 0'") != std::string::npos);
  CHECK(refused("c naming 1 0\n-2 0", "c naming 1 0\n-1 0").find("naming") != std::string::npos);
  CHECK(refused("c colour 1", "c nonsense").find("nonsense") != std::string::npos);
  CHECK(refused("c pair", "c A").find("'A") != std::string::npos);
}

TEST_CASE("a line is one clause, and rules act beside bricks") {
  const MinimalityProof proof = line_of_five();
  const FewestReport two = derive_formula(proof.problem, "p cnf 30 2\nc colour 0\n0 1 2 3 4 0\n");
  CHECK(two.refusal.find("a 0 within") != std::string::npos);
  const std::string nothing = "c A 2 2 0 0 0 -1 9 9 9 0\n0\n";
  CHECK_FALSE(derive_formula(proof.problem, nothing).derived);
  std::string level = proof.problem;
  const std::size_t at = level.find("\"rank\": 2");
  REQUIRE(at != std::string::npos);
  level.replace(at, 9, "\"rank\": 1");
  CHECK(derive_formula(level, proof.cnf).refusal.find("nothing of lower rank") !=
        std::string::npos);
}

TEST_CASE("problems that are none are refused") {
  const MinimalityProof proof = line_of_five();
  for (const char* text : {"", "{}", "[1, 2", "{\"stigc_colouring\": 1}", "null"}) {
    CHECK_FALSE(derive_formula(text, proof.cnf).derived);
  }
  std::string twisted = proof.problem;
  twisted.replace(twisted.find("\"none\""), 6, "\"rotations\"");
  CHECK(derive_formula(twisted, proof.cnf).refusal.find("another orbit") != std::string::npos);
}

}  // namespace
}  // namespace stig
