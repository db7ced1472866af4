// SPDX-License-Identifier: MIT
// Blocks are put down where a structure is to grow: in front of it, and on columns.
#include <fmt/format.h>

#include <cmath>

#include "behaviour/support.h"
#include "support/uses.h"

using namespace stig;
using namespace stig::behaviour;

namespace {

struct Place {
  int column;         ///< height of what is there
  const char* where;  ///< as Placement:place has it
  int level;          ///< of the block when it is placed
};

void place(const Place& to) {
  CAPTURE(to.column);
  CAPTURE(to.where);
  Trial trial(
      fmt::format("stigc_scene: 1\nrobots:\n"
                  "  - {{file: bebot.yaml, program: place_probe.lua,\n"
                  "     params: {{where: {}, verbose: true}}}}\n"
                  "blocks:\n  - {{name: load, at: [0.33, 0.02, 0.0275], turn: [10, 0, 0]}}\n"
                  "  - {{at: [-0.35, 0, 0], column: {}, color: Q3, name: base}}\n",
                  to.where, to.column));
  const bool done = trial.until(300, "done");
  INFO(trial.log());
  REQUIRE(done);
  trial.until(1);
  const Pose load = trial.block("load");
  const Pose base = trial.block(to.column == 1 ? "base" : "base 1");
  const Vec3 apart = load.p - base.p;
  const double far = std::hypot(apart.x, apart.y);
  const double wanted = to.where == std::string("extend") ? 0.055 : 0;
  MESSAGE(fmt::format("{} of a column of {}: {:.2f} mm and {:.2f} degrees off", to.where, to.column,
                      std::abs(far - wanted) * 1e3,
                      std::abs(off_square(heading(load) - heading(base))) / kDegree));
  CHECK(std::abs(far - wanted) < 2e-3);
  CHECK(std::abs(off_square(heading(load) - heading(base))) < 2 * kDegree);
  CHECK(load.p.z == doctest::Approx(0.0275 + 0.055 * to.level).epsilon(0.01));
  CHECK(trial.led("load") == Led::q1);
}

}  // namespace

TEST_CASE("in front of a block, and of columns") {
  for (const int column : {1, 2}) place({column, "extend", 0});
}

TEST_CASE("on top of columns") {
  for (const int column : {1, 2}) place({column, "raise", column});
}
