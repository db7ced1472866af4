// SPDX-License-Identifier: MIT
// Meshes of any format, which the first byte chooses: what is accepted has its corners, and what is
// repaired is closed. CGAL's own checks throw, which stigc-mesh takes for a model it cannot work
// on.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "model.h"

namespace {

using namespace stig::meshes;

void hold(bool good) {
  if (!good) std::abort();
}

/// Whether lists have lengths of 32 bits: such a one asks for up to 16 GB, which stigc-mesh's own
/// limit of memory refuses, and not the fuzzer's, which is lower.
bool has_long_lists(std::string_view text) {
  for (const std::string_view type : {"list int", "list uint"}) {
    for (auto at = text.find(type); at != text.npos; at = text.find(type, at + 1)) {
      const std::string_view rest = text.substr(at + type.size());
      if (!rest.starts_with("8") && !rest.starts_with("16")) return true;
    }
  }
  return false;
}

/// Each edge is run through as often both ways.
void hold_closed(const Model& model) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& triangle : model.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
      hold(a < model.points.size());
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  for (const auto& [edge, sum] : balance) hold(sum == 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0 || has_long_lists({reinterpret_cast<const char*>(data), size})) return 0;
  constexpr const char* kEndings[] = {".stl", ".obj", ".off", ".ply"};
  const auto path = std::filesystem::temp_directory_path() /
                    ("stigc-fuzz-" + std::to_string(getpid()) + kEndings[data[0] % 4]);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  Soup soup;
  std::string problem;
  const bool good = read_model(path.string(), soup, problem);
  std::filesystem::remove(path);
  hold(good == problem.empty());
  if (!good) return 0;
  for (const Point& p : soup.points) {
    for (const double x : p) hold(std::isfinite(x));
  }
  for (const auto& face : soup.faces) {
    for (const std::size_t corner : face) hold(corner < soup.points.size());
  }
  Model model;
  Repairs repairs;
  try {
    if (repair(std::move(soup), model, repairs, problem)) hold_closed(model);
  } catch (const std::exception&) {
  }
  return 0;
}
