// SPDX-License-Identifier: MIT
#include "synthesis/remedies.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "synthesis/emit.h"
#include "synthesis/recolour.h"
#include "synthesis/scaffold.h"
#include "synthesis/shapes.h"
#include "verify/verify.h"

namespace stig {
namespace {

std::vector<std::string> remedies_for(const Target& target, const SynthesisOptions& options) {
  const Synthesis result = synthesise(target, options);
  REQUIRE(result.obstacle);
  return find_remedies(target, options, *result.obstacle, {});
}

bool offers(const std::vector<std::string>& remedies, std::string_view what) {
  return std::any_of(remedies.begin(), remedies.end(),
                     [&](const std::string& r) { return r.starts_with(what); });
}

TEST_CASE("parts that are not connected are offered a start each") {
  const auto remedies = remedies_for(drawn("1 1 . 1 1", ColourUse::free), {});
  CHECK(offers(remedies, "--start 0,0,0 --start 3,0,0 ("));
}

TEST_CASE("a symmetry that the target lacks: a smaller group") {
  SynthesisOptions options;
  options.symmetry = Symmetry::rotations_mirrors;
  options.start = {{0, 0, 0}};
  CHECK(offers(remedies_for(staircase(ColourUse::free), options), "--symmetry none ("));
}

TEST_CASE("a straight run with too few colours: more of them, another start, a scaffold") {
  SynthesisOptions options;
  options.start = {{0, 0, 0}};
  options.most_colours = 5;
  const auto remedies = remedies_for(box({9, 1, 1}), options);
  CHECK(offers(remedies, "--colours 9, 4 more"));
  CHECK(offers(remedies, "--start 4,0,0 (5 colours"));
  CHECK(offers(remedies, "--scaffold "));
}

TEST_CASE("given colours that cannot be: others, or a few cells recoloured") {
  const Target target = drawn("1 2 2 3", ColourUse::given);
  SynthesisOptions options;
  options.start = {{0, 0, 0}};
  REQUIRE_FALSE(synthesise(target, options).best);
  CHECK(offers(remedies_for(target, options), "--colours free ("));
  const Target line = drawn("1 1 2", ColourUse::given);
  CHECK_FALSE(find_recolouring(line, {{{0, 0, 0}}}, {}));  // three cells, two colours
  const Target other = drawn("1 1 2 . . . 3", ColourUse::given);
  Target three = line;
  three.bricks = other.bricks;
  const auto found = find_recolouring(three, {{{0, 0, 0}}}, {});
  REQUIRE(found);
  CHECK(found->changes.size() == 1);
  options.start = {{0, 0, 0}};
  CHECK(synthesise(found->target, options).best);
}

TEST_CASE("a run of 20 needs 11 colours at best, and a few with a second row") {
  const Target target = box({20, 1, 1});
  const Synthesis plain = synthesise(target, {});
  REQUIRE(plain.best);
  CHECK(plain.best->colour_count == 11);
  SynthesisOptions options;
  const auto found = find_scaffold(target, counting_cells(*plain.best, 0), 20, 11, options, 1, {});
  REQUIRE(found);
  CHECK(found->cells.size() == 20);
  CHECK(found->result.best->colour_count <= 4);
}

TEST_CASE("a line too long for all colours there are: slopes that end by their heights") {
  const Target line = box({130, 1, 1});
  SynthesisOptions options;
  for (const bool floor : {false, true}) {
    options.floor = floor;
    const auto found =
        find_scaffold(line, longest_run(line), 390, kMaxColours + 1, options, 0.02, {});
    REQUIRE(found);
    const Solution& s = *found->result.best;
    CHECK(found->cells.size() <= 390);
    const VerifyResult proof =
        verify::verify(make_rule_set(*s.frame, s.colours, s.colour_count, {}, s.rules, {}), {});
    CHECK(proof.verdict == ProofVerdict::proved);
    REQUIRE(proof.structure);
    CHECK(proof.structure->size() == 130 + found->cells.size());
  }
  // On cells of one level rules with heights have nothing to ask for.
  options.heights = false;
  CHECK_FALSE(find_scaffold(line, longest_run(line), 100, kMaxColours + 1, options, 0.02, {}));
}

}  // namespace
}  // namespace stig
