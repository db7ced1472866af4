// SPDX-License-Identifier: MIT
// Meshes on the command line: what comes out of them, and what is said of those that are none.
#include <doctest/doctest.h>

#include <filesystem>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

bool has_meshes() {
  return std::filesystem::exists(std::filesystem::path(STIGC_PROGRAM).parent_path() / "stigc-mesh");
}

constexpr const char* kBox =
    "OFF\n8 6 0\n0 0 0\n40 0 0\n0 30 0\n40 30 0\n0 0 20\n40 0 20\n0 30 20\n40 30 20\n"
    "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
/// The same without its top.
constexpr const char* kOpen =
    "OFF\n8 5 0\n0 0 0\n40 0 0\n0 30 0\n40 30 0\n0 0 20\n40 0 20\n0 30 20\n40 30 20\n"
    "4 0 2 3 1\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";

TEST_CASE("a mesh becomes bricks, and comes back as it was drawn") {
  if (!has_meshes()) return;
  const Workplace place;
  place.write("tower.txt", "1 1\n1 .\n---\n1 .\n. .\n");
  REQUIRE(place.shell("stigc draw tower.txt -o tower.stl -o tower.ply").exit_code == 0);
  for (const std::string ending : {"stl", "ply"}) {
    const Outcome outcome =
        place.shell("stigc voxelise tower." + ending + " --side 1 -o back.txt && cat back.txt");
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.find("1 1\n1 .\n") != std::string::npos);
    CHECK(place.shell("stigc measure back.txt --json | grep '\"bricks\": 4'").exit_code == 0);
  }
}

TEST_CASE("surfaces of bricks that merely touch need no repair") {
  if (!has_meshes()) return;
  const Workplace place;
  place.write("touching.txt", "1 .\n. 1\n---\n. 1\n. .\n");
  REQUIRE(place.shell("stigc draw touching.txt -o touching.stl").exit_code == 0);
  const Outcome outcome = place.shell("stigc voxelise touching.stl --side 1 -o back.txt --json");
  REQUIRE(outcome.exit_code == 0);
  for (const std::string count :
       {"\"split_points\": 0", "\"turned_surfaces\": 0", "\"holes\": 0", "\"degenerate_faces\": 0",
        "\"crossing_faces\": 0", "\"solids\": 3"}) {
    CAPTURE(count);
    CHECK(outcome.out.find(count) != std::string::npos);
  }
}

TEST_CASE("what is said of meshes") {
  if (!has_meshes()) return;
  const Workplace place;
  place.write("box.off", kBox);
  place.write("open.off", kOpen);
  place.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  place.write("nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  place.write("corner.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  place.write("many.off", "OFF\n3000000000 1000000000 0\n0 0 0\n");
  place.write("empty.stl", "");
  place.write("noise.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n1\n");
  place.write("noise.obj", "v 0 0 0\nf 1 2 -99\n");
  hold(place, "voxelise", "stigc voxelise box.off --side 1cm -o box.txt && cat box.txt");
  hold(place, "voxelise-open", "stigc voxelise open.off --side 10 -o open.txt");
  hold(place, "voxelise-json",
       "stigc voxelise open.off --side 2cm --unit mm --up -x --shell -o o.txt --json");
  hold(place, "voxelise-bad",
       "for one in flat.off nan.off corner.off many.off empty.stl noise.ply noise.obj none.stl "
       "box.txt; do stigc voxelise $one -o out.txt; echo $?; done; ls out.txt");
  hold(place, "voxelise-usage",
       "stigc voxelise box.off -o box.off; stigc voxelise box.off -o a.doc; stigc voxelise box.off "
       "--side 0 -o a.txt; stigc voxelise box.off --side 1 --bricks 5 -o a.txt; stigc voxelise "
       "box.off --shell --solid -o a.txt; stigc measure box.off --lattice hexagonal");
}

TEST_CASE("commands take meshes as they take drawings") {
  if (!has_meshes()) return;
  const Workplace place;
  place.write("box.off", kBox);
  CHECK(place.shell("stigc measure box.off --bricks 24 --json | grep '\"bricks\": 24'").exit_code ==
        0);
  CHECK(place.shell("stigc synth box.off --bricks 24 -o box.yaml && stigc verify box.yaml")
            .exit_code == 0);
  CHECK(place.shell("stigc draw box.off --bricks 24 -o box.vox").exit_code == 0);
}

TEST_CASE("--bricks is refused where there is no mesh that it could be about") {
  const Workplace place;
  place.write("wall.txt", "1 1\n");
  for (const std::string line :
       {"stigc measure wall.txt", "stigc draw wall.txt -o wall.png", "stigc synth wall.txt",
        "stigc synth wall.txt --robot robots/bebot.yaml", "stigc build wall.txt -o built",
        "stigc view wall.txt --target wall.txt -o page.html"}) {
    CAPTURE(line);
    const Outcome outcome = place.shell(line + " --bricks 24");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("--bricks is about meshes") != std::string::npos);
  }
  CHECK(place.shell("stigc view --live sets/line.yaml --bricks 24").exit_code == 2);
  CHECK(place.files() == std::vector<std::string>{"wall.txt"});
}

TEST_CASE("without stigc-mesh it is said what to do") {
  const Workplace place;
  place.write("box.off", kBox);
  // A copy of the program that stands alone.
  REQUIRE(place.shell("mkdir alone && cp " STIGC_PROGRAM " alone/stigc").exit_code == 0);
  const Outcome outcome = place.shell("alone/stigc measure box.off");
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.err.find("install libcgal-dev") != std::string::npos);
}

}  // namespace
}  // namespace stig
