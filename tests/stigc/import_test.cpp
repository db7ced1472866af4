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

}  // namespace
}  // namespace stig
