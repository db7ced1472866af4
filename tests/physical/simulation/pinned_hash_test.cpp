// SPDX-License-Identifier: MIT
// Hashes of whole states after some seconds of shipped scenes. Contraction is off, so that they
// should hold for every compiler and build type. Whoever changes physics, sensing, a robot's file
// or a program on purpose changes them here, and says so.
#include <doctest/doctest.h>

#include <string>

#include "base/hash.h"
#include "physical/simulation/simulation.h"
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

std::string hash_after(const std::string& name, double seconds) {
  const std::string root = STIG_SOURCE_DIR;
  FileError error;
  const auto text = read_file(root + "/scenes/" + name, kMaxSceneBytes, error);
  REQUIRE_MESSAGE(text, error.message);
  Diagnostics diagnostics;
  const auto scene = read_scene(
      std::make_shared<const SourceFile>(name, *text),
      disk_loader(root + "/scenes", {root + "/blocks", root + "/robots", root + "/programs"}),
      diagnostics);
  REQUIRE_MESSAGE(scene, to_text(diagnostics));
  const auto placed = place_scene(*scene, 1, diagnostics);
  REQUIRE_MESSAGE(placed, to_text(diagnostics));
  Simulation run(*scene, *placed, false);
  run.until(seconds, {});
  CHECK(run.world().time() == doctest::Approx(seconds));
  return to_hex(run.hash());
}

}  // namespace

TEST_CASE("falling blocks come to the same last digit everywhere") {
  CHECK(hash_after("drop.yaml", 0.75) == "1f51743c9f7886fb");
  CHECK(hash_after("stack.yaml", 0.5) == "3f4b773b998d461e");
}

TEST_CASE("robots, cameras and programs come to the same last digit") {
#if defined(__x86_64__)
  // The C library's sines differ in their last digit where there is no fused multiply-add.
  if (!__builtin_cpu_supports("fma")) return;
  CHECK(hash_after("fetch-and-stack.yaml", 5) == "55ff442443976583");
#endif
}
