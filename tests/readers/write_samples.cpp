// SPDX-License-Identifier: MIT
// Writes sample structures in every form that others read, and manifest.json with
// what their readers should find, computed cell by cell.
//
//   write_reader_samples FOLDER
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "lattice/growth_glb.h"
#include "lattice/mesh.h"
#include "lattice/rgb.h"
#include "lattice/solid_surface.h"
#include "lattice/structure_files.h"
#include "lattice/structure_text.h"
#include "support/uses.h"

namespace {

using namespace stig;
using nlohmann::json;

Structure nest() {
  Structure s(Lattice::hexagonal);
  for (int z = 0; z < 4; ++z) {
    for (int q = -3; q <= 3; ++q) {
      for (int r = -3; r <= 3; ++r) {
        const int radius = std::max({std::abs(q), std::abs(r), std::abs(q + r)});
        if (radius == 3 || (radius < 3 && z == 2)) s.place({q, r, z}, radius == 3 ? 1 : 2);
      }
    }
  }
  return s;
}

// Columns of random height, which touch at edges too.
Structure heap() {
  Structure s;
  for (int x = -6; x < 6; ++x) {
    for (int y = -6; y < 6; ++y) {
      const auto height = static_cast<int>(hash_text(fmt::format("{} {}", x, y)) % 6);
      for (int z = 0; z < height; ++z)
        s.place({x, y, z}, static_cast<Colour>(1 + (x + y + z + 24) % 5));
    }
  }
  return s;
}

// Longer than one MagicaVoxel model.
Structure wall() {
  Structure s;
  for (int x = -150; x < 250; ++x) {
    for (int z = 0; z < 3; ++z) s.place({x, 4, z}, static_cast<Colour>(1 + z));
  }
  return s;
}

// Whether no two bricks touch at an edge alone: there four faces meet, and .stl files part the
// bricks by a gap.
bool two_faces_an_edge(const Mesh& mesh) {
  std::map<std::pair<Corner, Corner>, int> faces;
  for (const Polygon& polygon : mesh.polygons) {
    for (std::size_t i = 0; i < polygon.corners; ++i) {
      const Corner a = polygon.corner[i], b = polygon.corner[(i + 1) % polygon.corners];
      if (++faces[std::minmax(a, b)] > 2) return false;
    }
  }
  return true;
}

json expectation(const Structure& s, const std::vector<Brick>& bricks) {
  Point low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  std::map<std::string, int> colours;
  json cells = json::array();
  for (const PlacedBrick& brick : s.bricks()) {
    ++colours[to_color(rgb_of(bricks, brick.brick))];
    cells.push_back({brick.at.x, brick.at.y, brick.at.z, to_color(rgb_of(bricks, brick.brick))});
    for (const CellFace& face : cell_faces(s.lattice())) {
      for (int i = 0; i < face.corners; ++i) {
        const Point p = position(
            s.lattice(), foot_of(s.lattice(), brick.at) + face.corner[static_cast<std::size_t>(i)]);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    }
  }
  const double cell = s.lattice() == Lattice::cubic ? 1 : std::sqrt(0.75);
  return {{"bricks", s.size()},
          {"volume", static_cast<double>(s.size()) * cell},
          {"low", {low.x, low.y, low.z}},
          {"high", {high.x, high.y, high.z}},
          {"colours", colours},
          {"cells", cells},
          {"two_faces_an_edge", two_faces_an_edge(surface(s, Merging::none))},
          {"triangles", solid_surface(surface(s, Merging::none)).triangles.size()},
          {"merged_triangles", surface(s, Merging::faces).triangles()}};
}

/// One brick every tenth of a second, in the order of cells.
std::string growth(const Structure& s, const std::vector<Brick>& bricks) {
  std::vector<GrowthStep> steps;
  for (const PlacedBrick& brick : s.bricks()) {
    steps.push_back({static_cast<double>(steps.size()) / 10, {brick}});
  }
  return print_growth_glb(s.lattice(), steps, bricks);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const std::map<std::string, Structure> samples = {
      {"staircase", structure_literal("3 . .\n---\n3 2 .\n---\n3 2 1\n")},
      {"nest", nest()},
      {"heap", heap()},
      {"wall", wall()}};
  const std::vector<Brick> bricks = numbered_bricks(5);
  json manifest;
  for (const auto& [name, structure] : samples) {
    manifest[name] = expectation(structure, bricks);
    for (const char* kind : {"stl", "ply", "glb", "vox", "png"}) {
      std::string error;
      const std::string path = (folder / (name + "." + kind)).string();
      if (!write_structure_file(path, structure, bricks, {}, error)) {
        fmt::print(stderr, "{}\n", error);
        return 1;
      }
    }
    std::ofstream(folder / (name + "-growth.glb"), std::ios::binary) << growth(structure, bricks);
  }
  std::ofstream(folder / "manifest.json") << manifest.dump(1) << '\n';
  return 0;
}
