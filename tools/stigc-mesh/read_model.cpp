// SPDX-License-Identifier: MIT
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>
#include <string>
#include <utility>

#include "model.h"

namespace stig::meshes {

namespace {

using Places = std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Faces = std::vector<std::vector<std::size_t>>;

/// CGAL's readers put a property of a .ply to the last element, whether there is one or not, and
/// make room for as many elements as a header speaks of: each takes a byte of the file at least.
bool plausible_ply(std::ifstream file, std::uintmax_t bytes) {
  bool has_element = false;
  for (std::string line, keyword; std::getline(file, line) && keyword != "end_header";) {
    std::istringstream words(line);
    keyword.clear();
    words >> keyword;
    if (keyword == "property" && !has_element) return false;
    std::string name;
    std::uintmax_t count = 0;
    if (keyword != "element" || !(words >> name >> count)) continue;
    has_element = true;
    if (count > bytes) return false;
  }
  return true;
}

/// The numbers of corners, faces and edges stand behind a word such as OFF or STOFF, then a line
/// for each corner and each face. CGAL makes room for that many, and unsigned numbers of what it
/// reads.
class OffLines {
 public:
  explicit OffLines(std::uintmax_t bytes) : most_(static_cast<double>(bytes)) {}

  /// Whether the line, without its comment, can be the next.
  bool take(const std::string& line) {
    std::istringstream words(line);
    bool empty = true;
    std::string other;
    for (double value = 0; !words.eof();) {
      if (words >> value) {
        empty = false;
        if (!plausible(value)) return false;
      } else {
        words.clear();
        words >> other;
      }
    }
    if (!empty && numbers_ > kCounts) ++lines_;
    if (numbers_ == kCounts) ++numbers_;
    return true;
  }

 private:
  static constexpr int kCounts = 3;
  static constexpr double kMostShade = 255;  ///< of a face's colour, which may stand behind it

  bool plausible(double value) {
    if (numbers_ > kCounts && lines_ < corners_) return true;  // a place
    if (numbers_ > kCounts) return value >= 0 && value <= std::max(most_, kMostShade);
    if (++numbers_ == 1) corners_ = value;
    return value >= 0 && value <= most_;
  }

  double most_;         ///< bytes of the file
  double corners_ = 0;  ///< that it speaks of
  int numbers_ = 0;     ///< of the header that were read; one more behind its last line
  double lines_ = 0;    ///< of corners and faces
};

/// Those of binary numbers, which hardly anybody writes, are not taken.
bool plausible_off(std::ifstream file, std::uintmax_t bytes) {
  OffLines lines(bytes);
  for (std::string line; std::getline(file, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find("BINARY") != std::string::npos) return false;
    if (!lines.take(line)) return false;
  }
  return true;
}

/// By the ending, whatever its case.
bool read_by_ending(const std::string& path, Places& points, Faces& faces) {
  std::string ending = path.substr(std::min(path.rfind('.'), path.size()));
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".stl") return CGAL::IO::read_STL(path, points, faces);
  if (ending == ".obj") return CGAL::IO::read_OBJ(path, points, faces);
  const std::uintmax_t bytes = std::filesystem::file_size(path);
  std::ifstream file(path, std::ios::binary);
  if (ending == ".off") {
    return plausible_off(std::move(file), bytes) && CGAL::IO::read_OFF(path, points, faces);
  }
  return ending == ".ply" && plausible_ply(std::move(file), bytes) &&
         CGAL::IO::read_PLY(path, points, faces);
}

/// Whether every corner that a face names is there.
bool has_corners(const Soup& soup) {
  return std::all_of(soup.faces.begin(), soup.faces.end(), [&](const auto& face) {
    return std::all_of(face.begin(), face.end(),
                       [&](std::size_t corner) { return corner < soup.points.size(); });
  });
}

/// Whether faces have few enough corners to be cut into triangles.
bool has_small_faces(const Soup& soup) {
  return std::all_of(soup.faces.begin(), soup.faces.end(),
                     [](const auto& face) { return face.size() <= kMostFaceCorners; });
}

bool is_finite(const Point& p) {
  // Beyond 1e9 a coordinate's last digits would be of the size of parts.
  return std::all_of(p.begin(), p.end(), [](double x) { return std::abs(x) <= 1e9; });
}

}  // namespace

bool read_model(const std::string& path, Soup& soup, std::string& problem) {
  if (!std::ifstream(path)) {
    problem = "cannot be opened";
    return false;
  }
  try {
    Places points;
    if (!read_by_ending(path, points, soup.faces)) {
      problem = "is no .stl, .obj, .off or .ply file that can be read";
      return false;
    }
    for (const auto& p : points) soup.points.push_back({p.x(), p.y(), p.z()});
  } catch (const std::bad_alloc&) {
    problem = "speaks of more than fits into memory";
    return false;
  } catch (const std::exception&) {
    problem = "is no .stl, .obj, .off or .ply file that can be read";
    return false;
  }
  if (soup.faces.empty()) {
    problem = "has no faces";
  } else if (soup.faces.size() > kMostFaces) {
    problem = "has more than " + std::to_string(kMostFaces) + " faces";
  } else if (!has_small_faces(soup)) {
    problem = "has a face with more than " + std::to_string(kMostFaceCorners) + " corners";
  } else if (!has_corners(soup)) {
    problem = "has faces with corners that are not there";
  } else if (!std::all_of(soup.points.begin(), soup.points.end(), is_finite)) {
    problem = "has places that are not finite, or further away than 1e9";
  }
  return problem.empty();
}

}  // namespace stig::meshes
