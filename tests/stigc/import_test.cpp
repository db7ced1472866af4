// SPDX-License-Identifier: MIT
// stigc import: tables in, rule sets out, and what is said of others.
#include <doctest/doctest.h>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

TEST_CASE("a table becomes a rule set that can be run") {
  const Workplace place;
  for (const std::string name : {"4n", "4c", "4d", "4c-matrices", "4c-lines"}) {
    place.write(name + ".txt", project_file("tests/rules/tables/architecture-" + name + ".txt"));
  }
  CHECK(place.shell("stigc import 4n.txt -o n.yaml && stigc fmt --check n.yaml").exit_code == 0);
  CHECK(place.shell("stigc import 4d.txt | stigc check -").exit_code == 0);
  CHECK(place
            .shell("stigc import 4c.txt --inversion -o c.yaml && stigc explore c.yaml "
                   "--motion event --box 9,9,9 --json | grep '\"terminated\": \"saturated\"'")
            .exit_code == 0);
  // The same rules, under names and comments of their own.
  const std::string rules = "; sed -n '/^rules/,$p' ";
  const std::string slices = place.shell("stigc import 4c.txt -o a.yaml" + rules + "a.yaml").out;
  CHECK(slices.starts_with("rules:\n"));
  CHECK(place.shell("stigc import 4c-lines.txt --format lines -o b.yaml" + rules + "b.yaml").out ==
        slices);
  CHECK(place.shell("stigc import 4c-matrices.txt --lattice hexagonal -o d.yaml" + rules + "d.yaml")
            .out == slices);
}

TEST_CASE("what import prints and says") {
  const Workplace place;
  place.write("mast.txt",
              "# A mast.\n// step 1\n0,0,0,0,0,0,1 0,0,0,0,0,0 0,0,0,0,0,0,0 2 0.5\n"
              "0,0,0,0,0,0,2 0,0,0,0,0,0 0,0,0,0,0,0,0 1 1.0\n");
  place.write("bad.txt", "0 0 -   0 0 0   0 0 0\n0 1 0   0 0 0   0 0 0\n=> 2\n");
  place.write("both.txt",
              "0 0 0 0 0 0 1\n0 0 0 0 0 0\n0 0 0 0 0 0 0\n=> 2\n"
              "0 0 0 0 0 0 1\n0 0 0 0 0 0\n0 0 0 0 0 0 0\n=> 1\n");
  hold(place, "import", "stigc import mast.txt --symmetry rotations+mirrors");
  hold(
      place, "import-bad",
      "stigc import bad.txt; stigc import both.txt -o both.yaml; stigc import none.txt; ls *.yaml");
  hold(place, "import-usage",
       "stigc import mast.txt -o mast.txt; stigc import mast.txt --format lines --lattice "
       "hexagonal; stigc import mast.txt --format line");
}

TEST_CASE("a robot in URDF and a world in SDF become files that are described and simulated") {
  const Workplace place;
  hold(place, "import-urdf",
       "stigc import robots/rover.urdf -o rover.yaml -q && stigc check rover.yaml && "
       "stigc describe rover.yaml");
  hold(place, "import-sdf",
       "stigc import scenes/yard.sdf -o yard.yaml -q && stigc check yard.yaml yard-*.yaml && "
       "stigc simulate yard.yaml --duration 1 | sed '/speed/d; /hash/d'");
  CHECK(place.stigc({"import", "robots/rover.urdf"}).out == place.file("rover.yaml"));
}

TEST_CASE("what import says of XML, and that nothing is written then") {
  const Workplace place;
  place.write("cut.urdf", project_file("robots/rover.urdf").substr(0, 900));
  place.write("mesh.urdf",
              "<robot name=\"m\"><link name=\"a\"><inertial><mass value=\"1\"/>\n"
              "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/></inertial>\n"
              "<collision><geometry><mesh filename=\"a.stl\"/></geometry></collision>\n"
              "</link></robot>\n");
  place.write("warned.urdf",
              "<robot name=\"m\"><link name=\"a\"><inertial><mass value=\"1\"/>\n"
              "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/></inertial>\n"
              "<collision><geometry><sphere radius=\"1\"/></geometry></collision>\n"
              "<contact/></link></robot>\n");
  // Its bodies overlap, which placing the scene finds.
  std::string yard = project_file("scenes/yard.sdf");
  yard.replace(yard.find("0.6 0.1 0.1"), 11, "-.5 0.2 0.1");
  place.write("on-top.sdf", yard);
  hold(
      place, "import-xml-bad",
      "for f in cut.urdf mesh.urdf on-top.sdf; do stigc import $f -o out.yaml; echo $?; done; "
      "stigc import warned.urdf -W error -o out.yaml; echo $?; stigc import warned.urdf | head -2; "
      "stigc import scenes/yard.sdf -q; echo $?; stigc import none.urdf; echo $?; ls *.yaml");
}

}  // namespace
}  // namespace stig
