// SPDX-License-Identifier: MIT
// Surfaces of triangles as files have them, and as they are once they bound something.
//
// Built with CGAL's Polygon_mesh_processing, which comes under the GPL: so does the program
// stigc-mesh, and nothing else of the project links what stands in this folder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace stig::meshes {

using Point = std::array<double, 3>;

/// Polygons by the numbers of their corners, without any order among them.
struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
};

/// Closed surfaces of triangles, counter-clockwise as seen from outside of what is solid: the
/// walls of a hollow are oriented towards the hollow.
struct Model {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What of a soup was not as it should be. Counts; 0: nothing to do.
struct Repairs {
  std::size_t duplicate_points = 0;  ///< corners that were merged with others in the same place
  std::size_t degenerate_faces = 0;  ///< without area, or twice there
  std::size_t split_points = 0;      ///< corners at which surfaces met that do not belong together
  std::size_t turned_surfaces = 0;   ///< inside out
  std::size_t holes = 0;             ///< closed with new triangles
  std::size_t flat_surfaces = 0;     ///< parts that bound no volume, left out
  std::size_t crossing_faces =
      0;  ///< pairs that cross or touch without being neighbours; left as they are
  std::size_t solids = 0, hollows = 0;  ///< surfaces that bound a solid, or a hollow in one
  double volume = 0;                    ///< of solids less hollows, in the file's unit cubed
};

inline constexpr std::size_t kMostFaces = 5'000'000;
inline constexpr std::size_t kMostFaceCorners = 1000;  ///< of a face

/// Reads .stl, .obj, .off or .ply. False with `problem` set: unreadable, no faces, too many, places
/// that are not finite.
bool read_model(const std::string& path, Soup& soup, std::string& problem);

/// Makes closed, oriented surfaces of a soup. False with `problem` set: nothing is left that bounds
/// a volume, or a hole cannot be closed.
bool repair(Soup soup, Model& model, Repairs& repairs, std::string& problem);

}  // namespace stig::meshes
