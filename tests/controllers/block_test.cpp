// SPDX-License-Identifier: MIT
#include "robots/block.h"
#include "support/uses.h"

#include <doctest/doctest.h>

using namespace stig;

namespace {

constexpr const char* kGood =
    "stigc_block: 1\nname: x\nbody: {side: 0.1, mass: 1, friction: 0.5}\n"
    "magnets: {offset: 0.04, radius: 0.003, mass: 0.001, field: 75, cutoff: 0.04}\n";

/// What the reader says of kGood with one text replaced by another.
std::string complaints(std::string_view from, std::string_view to) {
  std::string text = kGood;
  text.replace(text.find(from), from.size(), to);
  Diagnostics diagnostics;
  const auto block = read_block(std::make_shared<const SourceFile>("b.yaml", text), diagnostics);
  CHECK(block.has_value() != diagnostics.has_errors());
  std::string out;
  for (const Diagnostic& d : diagnostics.all()) {
    out += std::string(info(d.code).name) + " " + d.message + "\n";
  }
  return out;
}

}  // namespace

TEST_CASE("the paper's block: mass, inertia, magnets") {
  Diagnostics diagnostics;
  const auto block = read_block_file(STIG_SOURCE_DIR "/blocks/stigmergic.yaml", diagnostics);
  REQUIRE(block);
  CHECK(diagnostics.all().empty());
  CHECK(block->side == 0.055);
  CHECK(block->friction == 0.5);
  CHECK(block->mass() == doctest::Approx(0.110).epsilon(1e-12));
  // 0.102 · 0.055² / 6 + 8 · 0.001 · 2 · 0.0225²
  CHECK(block->inertia() == doctest::Approx(5.1425e-5 + 8.1e-6).epsilon(1e-12));
  CHECK(block->magnet_inertia() == doctest::Approx(3.6e-9).epsilon(1e-12));
  CHECK(block->magnet_moment() == doctest::Approx(0.19914).epsilon(1e-4));
  const auto places = block->magnet_places();
  REQUIRE(places.size() == 8);
  CHECK(places[0] == Vec3{-0.0225, -0.0225, -0.0225});
  CHECK(places[1] == Vec3{0.0225, -0.0225, -0.0225});
  CHECK(places[7] == Vec3{0.0225, 0.0225, 0.0225});
  CHECK(block->tags.side == 0.024);
  CHECK(block->tags.widest == doctest::Approx(1.3089969389957472));  // 75 degrees
  CHECK(block->leds.offset == 0.02);
  CHECK(block->radios.depth == 0.005);
  CHECK(block->radios.range == 0.02);
  CHECK(block->radios.answers);
  CHECK(block->program == "stigmergic.lua");
  const auto later = read_block_file(STIG_SOURCE_DIR "/blocks/stigmergic-2021.yaml", diagnostics);
  REQUIRE(later);
  CHECK(later->mass() == doctest::Approx(0.110));
  CHECK(later->tags.side == 0.0235);
  CHECK(later->radios.depth == 0);
}

TEST_CASE("a block without magnets") {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const SourceFile>(
      "b.yaml", "stigc_block: 1\nname: x\nbody: {side: 0.1, mass: 1.2, friction: 0}\n");
  const auto block = read_block(source, diagnostics);
  REQUIRE(block);
  CHECK(block->mass() == 1.2);
  CHECK(block->inertia() == doctest::Approx(0.002).epsilon(1e-12));
  CHECK(block->magnet_places().empty());
}

TEST_CASE("what is wrong with a block file is said") {
  CHECK(complaints("name: x", "name: x") == "");
  CHECK(complaints("stigc_block: 1", "stigc_block: 2") ==
        "R108 version 2 of the file format is not known; this program reads version 1\n");
  CHECK(complaints("name: x\n", "") == "R102 a block file without the key 'name'\n");
  CHECK(complaints("name: x", "name: [x]") == "R103 expected a name, found a list\n");
  CHECK(complaints("side: 0.1", "sides: 0.1") == "R101 unknown key 'sides' in a block's body\n");
  CHECK(complaints("side: 0.1", "side: wide") ==
        "R103 expected a number from 0.001 to 10, found 'wide'\n");
  CHECK(complaints("side: 0.1", "side: \"0.1\"") ==
        "R103 expected a number from 0.001 to 10, found the quoted text '0.1'\n");
  CHECK(complaints("side: 0.1", "side: nan") ==
        "R103 expected a number from 0.001 to 10, found 'nan'\n");
  CHECK(complaints("mass: 1,", "mass: -1,") ==
        "R105 'mass' takes a number from 1e-06 to 100000, not '-1'\n");
  CHECK(complaints("field: 75", "field: 1e9") ==
        "R105 'field' takes a number from 0 to 1000000, not '1e9'\n");
  CHECK(complaints("offset: 0.04", "offset: 0.048").rfind("R105 the magnets stick out", 0) == 0);
  CHECK(complaints("cutoff: 0.04", "cutoff: 0.09").rfind("R105 a block's own magnets", 0) == 0);
  CHECK(complaints("body: {side: 0.1, mass: 1, friction: 0.5}", "body: 3") ==
        "R103 expected a block's body as a mapping of keys, found '3'\n");
  const auto with = [](const char* more) {
    return complaints("name: x", std::string("name: x\n") + more);
  };
  CHECK(with("tags: {side: 0.02, widest: 75}") == "");
  CHECK(with("tags: {side: 0.2, widest: 75}").starts_with("R105 the tag is larger"));
  CHECK(with("leds: {offset: 0.06, widest: 75}").starts_with("R105 the LEDs are beyond"));
  CHECK(with("radios: {depth: 0.06, range: 0.02}").starts_with("R105 the radios are beyond"));
  CHECK(with("tags: {side: 0.02}").starts_with("R102"));
  CHECK(complaints("name: x", "name: x\nname: y").rfind("R012", 0) == 0);
}

TEST_CASE("files that cannot be read") {
  Diagnostics diagnostics;
  CHECK_FALSE(read_block_file("/nowhere/block.yaml", diagnostics));
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].code == Code::R001);
  for (const char* text : {"", "- 1", "{", "\x01"}) {
    Diagnostics more;
    CHECK_FALSE(read_block(std::make_shared<const SourceFile>("b", text), more));
    CHECK(more.has_errors());
  }
}
