// SPDX-License-Identifier: MIT
// What robots make of the tags that they see.
#include <fmt/format.h>

#include <cstdio>

#include "behaviour/support.h"
#include "support/uses.h"

using namespace stig;
using namespace stig::behaviour;

namespace {

struct Sightings {
  int seen = 0, astray = 0;
};

/// What a robot that stands before a column sees of it.
Sightings before_column(const char* robot, double ahead, std::uint64_t seed) {
  Trial trial(fmt::format("stigc_scene: 1\nrobots:\n"
                          "  - {{file: {}, program: sight_probe.lua,\n"
                          "     params: {{ahead: {}, levels: 2}}}}\n"
                          "blocks: [{{at: [{}, 0, 0], column: 2, color: Q3, name: base}}]\n"
                          "noise: {{pixels: 0.5, missed_tags: 0.02, colour: 8}}\n",
                          robot, ahead, ahead),
              seed);
  const bool done = trial.until(60, "astray");
  INFO(trial.log());
  REQUIRE(done);
  const std::string log = trial.log();
  Sightings out;
  REQUIRE(std::sscanf(log.c_str() + log.rfind("seen "), "seen %d, astray %d", &out.seen,
                      &out.astray) == 2);
  return out;
}

}  // namespace

// With few pixels a tag on top looks like one in front, and the other way round.
TEST_CASE("blocks are on the levels on which they stand, whatever a tag's tilt looks like") {
  for (const char* robot : {"bebot.yaml", "builderbot.yaml"}) {
    for (const double ahead : {0.26, 0.30, 0.34}) {
      const Sightings all = before_column(robot, ahead, 1);
      CAPTURE(robot);
      CAPTURE(ahead);
      MESSAGE(
          fmt::format("{} at {:.2f} m: {} seen, {} astray", robot, ahead, all.seen, all.astray));
      CHECK(all.seen > 200);
      CHECK(all.astray == 0);
    }
  }
}
