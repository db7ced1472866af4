// SPDX-License-Identifier: MIT
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <fstream>
#include <new>
#include <sstream>
#include <string>

#include "model.h"

namespace stig::meshes {

namespace {

using Places = std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Faces = std::vector<std::vector<std::size_t>>;

/// CGAL's reader of .ply puts a property to the last element, whether there is one or not.
bool properties_have_elements(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line, keyword;
  while (std::getline(file, line) && keyword != "element" && keyword != "end_header") {
    keyword.clear();
    std::istringstream(line) >> keyword;
    if (keyword == "property") return false;
  }
  return true;
}

/// By the ending, whatever its case.
bool read_by_ending(const std::string& path, Places& points, Faces& faces) {
  std::string ending = path.substr(std::min(path.rfind('.'), path.size()));
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".stl") return CGAL::IO::read_STL(path, points, faces);
  if (ending == ".obj") return CGAL::IO::read_OBJ(path, points, faces);
  if (ending == ".off") return CGAL::IO::read_OFF(path, points, faces);
  return ending == ".ply" && properties_have_elements(path) &&
         CGAL::IO::read_PLY(path, points, faces);
}

/// Whether every corner that a face names is there.
bool has_corners(const Soup& soup) {
  return std::all_of(soup.faces.begin(), soup.faces.end(), [&](const auto& face) {
    return std::all_of(face.begin(), face.end(),
                       [&](std::size_t corner) { return corner < soup.points.size(); });
  });
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
  } else if (!has_corners(soup)) {
    problem = "has faces with corners that are not there";
  } else if (!std::all_of(soup.points.begin(), soup.points.end(), is_finite)) {
    problem = "has places that are not finite, or further away than 1e9";
  }
  return problem.empty();
}

}  // namespace stig::meshes
