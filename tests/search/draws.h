// SPDX-License-Identifier: MIT
// Random genomes of every kind for laws; call inside rc::check.
#pragma once

#include <rapidcheck.h>

#include "search/draw.h"
#include "search/uses.h"
#include "support/uses.h"

namespace stig {
using namespace search;

inline DrawSettings random_settings() {
  DrawSettings settings;
  settings.lattice = *rc::gen::element(Lattice::cubic, Lattice::hexagonal);
  settings.floor = *rc::gen::arbitrary<bool>();
  settings.colours = *rc::gen::inRange(1, kMostGenomeColours + 1);
  settings.rules = *rc::gen::inRange(1, 30);
  settings.wildcards = *rc::gen::inRange(0, 10) / 10.0;
  settings.heights = *rc::gen::inRange(0, 5) / 10.0;
  return settings;
}

inline DrawnGenome random_genome(const DrawSettings& settings) {
  Random random(*rc::gen::arbitrary<std::uint64_t>(), 0, kDrawing, 0, 0);
  DrawnGenome drawn;
  draw_genome(settings, random, drawn);
  return drawn;
}

}  // namespace stig
