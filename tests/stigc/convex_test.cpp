// SPDX-License-Identifier: MIT
// From a mesh to a solid, and to robots and obstacles that are such.
#include <doctest/doctest.h>

#include <filesystem>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

bool meshes_are_read() {
  return std::filesystem::exists(std::filesystem::path(STIGC_PROGRAM).parent_path() / "stigc-mesh");
}

/// 40 x 30 x 20, without its top where `open`.
std::string box_file(bool open = false) {
  return std::string("OFF\n8 ") + (open ? "5" : "6") +
         " 0\n0 0 0\n40 0 0\n0 30 0\n40 30 0\n0 0 20\n40 0 20\n0 30 20\n40 30 20\n"
         "4 0 2 3 1\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n" +
         (open ? "" : "4 4 5 7 6\n");
}

}  // namespace

TEST_CASE("what is made and said of meshes as solids") {
  if (!meshes_are_read()) return;
  const Workplace place;
  place.write("box.off", box_file());
  place.write("open.off", box_file(true));
  // An angle of two boxes that share a face but for its corners.
  place.write("tower.txt", "1 1\n---\n1 .\n");
  REQUIRE(place.shell("stigc draw -q tower.txt -o tower.stl").exit_code == 0);
  place.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  place.write("nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  place.write("corner.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  place.write("many.off", "OFF\n3000000000 1000000000 0\n0 0 0\n");
  place.write("empty.stl", "");
  place.write("turned.off",
              "OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 2 3\n");
  hold(place, "convex", "stigc convex box.off -o box.yaml && cat box.yaml && stigc check box.yaml");
  hold(place, "convex-open",
       "stigc convex open.off --unit cm --up -x --parts 1 -o open.yaml && cat open.yaml");
  hold(place, "convex-json", "stigc convex tower.stl --unit cm -o tower.yaml --json");
  hold(place, "convex-bad",
       "for one in flat.off nan.off corner.off many.off empty.stl none.stl turned.off; do stigc "
       "convex $one -o out.yaml -q; echo $?; done; ls out.yaml");
  hold(place, "convex-usage",
       "stigc convex box.off; stigc convex box.off --parts 65 -o a.yaml; stigc convex box.yaml -o "
       "a.yaml; stigc convex box.off -o box.off; stigc convex box.off --unit m -o a.yaml");
}

TEST_CASE("a drawn part and a drawn obstacle in a scene") {
  if (!meshes_are_read()) return;
  const Workplace place;
  place.write("box.off", box_file());
  place.write(
      "sled.yaml",
      "stigc_robot: 1\nname: sled\nbodies:\n  - {name: body, solid: box.yaml, density: 500, "
      "base: [0, 0, 0.001]}\n");
  place.write(
      "yard.yaml",
      "stigc_scene: 1\nduration: 0.4\nrobots:\n  - {file: sled.yaml, at: [0.2, 0]}\nobstacles:\n"
      "  - {name: step, solid: box.yaml, base: [0, 0, 0]}\nblocks:\n  - {at: [0.02, 0.015, "
      "0.05]}\n");
  REQUIRE(place.shell("stigc convex box.off -q -o box.yaml && stigc check yard.yaml").exit_code ==
          0);
  hold(place, "describe-solid", "stigc describe sled.yaml");
  CHECK(place.shell("stigc simulate yard.yaml --trace yard.stigp -q").exit_code == 0);
  // Elsewhere, where none of the files is.
  CHECK(place.shell("mkdir far && mv yard.stigp far && cd far && stigc replay yard.stigp --verify")
            .exit_code == 0);
  CHECK(
      place
          .shell(
              "cd far && stigc replay yard.stigp -o end.png && stigc replay yard.stigp -o yard.csv")
          .exit_code == 0);
  CHECK(place.shell("grep -c '^0.000*,step,' far/yard.csv").out == "0\n");
}

}  // namespace stig
