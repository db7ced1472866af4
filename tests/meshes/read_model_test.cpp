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

constexpr const char* kRefused = "is no .stl, .obj, .off or .ply file that can be read";

std::string problem_of(const std::string& ending, const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("stig-read-model-" + std::to_string(getpid()) + ending);
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
  const auto problem_of_ply = [](const std::string& text) { return problem_of(".ply", text); };
  CHECK(problem_of_ply(begin + vertex + corner + face + places + triangle).empty());
  CHECK(problem_of_ply(begin + corner + vertex + face + places + triangle) == kRefused);
  CHECK(problem_of_ply(begin + "comment of nothing\n" + corner + "end_header\n") == kRefused);
  const std::string many = "element vertex 30000000000\n";
  CHECK(problem_of_ply(begin + many + corner + face + places + triangle) == kRefused);
}

TEST_CASE("faces have a thousand corners at most") {
  const auto polygon = [](int corners) {
    std::string places, face;
    for (int i = 0; i < corners; ++i) {
      places += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
      face += " " + std::to_string(i + 1);
    }
    return places + "f" + face + "\n";
  };
  CHECK(problem_of(".obj", polygon(1000)).empty());
  CHECK(problem_of(".obj", polygon(1001)) == "has a face with more than 1000 corners");
}

TEST_CASE("an .off speaks of no more than it can hold") {
  const std::string rest = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  CHECK(problem_of(".off", "OFF\n# of something\n3 1 0\n" + rest).empty());
  CHECK(problem_of(".off", "OFF 3 1 0 # of something\n" + rest).empty());
  CHECK(problem_of(".off", "OFF\n3 5555555500 0\n" + rest) == kRefused);
  CHECK(problem_of(".off", "OFF 300000 1 0\n" + rest) == kRefused);
  CHECK(problem_of(".off", "OFF BINARY\n" + std::string(40, '\1')) == kRefused);
  const std::string corners = "OFF\n3 1 0\n0 0 0\n-1 0 0\n\n0 -1 0\n";
  CHECK(problem_of(".off", corners + "3 0 1 2\n").empty());
  CHECK(problem_of(".off", corners + "3 0 1 -2\n") == kRefused);
  CHECK(problem_of(".off", corners + "3 0 1 2 255 128 0\n").empty());
  CHECK(problem_of(".off", corners + "3 0 1-2\n") == kRefused);
  CHECK(problem_of(".off", corners + "300000 0 1 2\n") == kRefused);
  CHECK(problem_of(".off", corners + "3 0 1 4e40\n") == kRefused);
}

}  // namespace
}  // namespace stig::meshes
