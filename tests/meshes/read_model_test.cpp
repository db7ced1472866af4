// SPDX-License-Identifier: MIT
// Files of meshes that are damaged are refused, before a reader of CGAL's stumbles over them.
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "model.h"

namespace stig::meshes {
namespace {

std::string problem_of_ply(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("stig-read-model-" + std::to_string(getpid()) + ".ply");
  std::ofstream(path, std::ios::binary) << text;
  Soup soup;
  std::string problem;
  const bool good = read_model(path.string(), soup, problem);
  CHECK(good == problem.empty());
  std::filesystem::remove(path);
  return problem;
}

TEST_CASE("a property of a .ply belongs to an element") {
  const std::string begin = "ply\nformat ascii 1.0\n", triangle = "3 0 1 2\n";
  const std::string corner = "property float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string places = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string vertex = "element vertex 3\n";
  CHECK(problem_of_ply(begin + vertex + corner + face + places + triangle).empty());
  const std::string refused = "is no .stl, .obj, .off or .ply file that can be read";
  CHECK(problem_of_ply(begin + corner + vertex + face + places + triangle) == refused);
  CHECK(problem_of_ply(begin + "comment of nothing\n" + corner + "end_header\n") == refused);
}

}  // namespace
}  // namespace stig::meshes
