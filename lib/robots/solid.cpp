// SPDX-License-Identifier: MIT
// The file is lists of numbers, three by three; what a form cannot say of them is checked after it:
// that they come in threes, that pieces enclose something, that a body can have such moments.
#include "robots/solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "base/hull.h"
#include "base/yaml.h"
#include "robots/form_keys.h"
#include "robots/robot_forms.h"

namespace stig::robots {

namespace {

using namespace keys;

constexpr std::size_t kMostPieces = 64, kMostCorners = 64;
constexpr std::size_t kMostPoints = 20'000;  ///< of a surface, and triangles

const Form& piece_form() {
  static const Form kForm{"piece",
                          {required(numbers("corners", "x, y, z of each, metres.", 12,
                                            3 * kMostCorners, -kFar, kFar))}};
  return kForm;
}

const Form& surface_form() {
  static FormKey triangles = required(numbers("triangles", "Three points each, counted from 0.", 3,
                                              3 * kMostPoints, 0, kMostPoints));
  triangles.kind = FormKind::integers;
  static const Form kForm{
      "surface",
      {required(numbers("points", "x, y, z of each, metres.", 9, 3 * kMostPoints, -kFar, kFar)),
       triangles}};
  return kForm;
}

std::vector<Vec3> in_threes(const std::vector<double>& list) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i + 2 < list.size(); i += 3) {
    out.push_back({list[i], list[i + 1], list[i + 2]});
  }
  return out;
}

class SolidReader {
 public:
  SolidReader(const YamlDocument& document, const BadNodes& bad, Diagnostics& out)
      : document_(document), root_(document.root, bad), out_(out) {}

  SolidModel read() {
    solid_.name = root_.text("name");
    solid_.source = root_.text("source");
    solid_.volume = root_.number("volume");
    solid_.centre = root_.vector("center");
    read_moments();
    for (const FormView& piece : root_.forms("pieces")) read_piece(piece);
    if (root_.has("surface")) read_surface(root_.form("surface"));
    return std::move(solid_);
  }

 private:
  void refuse(const YamlNode& node, std::string what) {
    out_.add(Code::P618, document_.head(node), std::move(what));
  }

  std::vector<double> list(const FormView& view, std::string_view key) {
    std::vector<double> out = view.numbers(key);
    if (out.size() % 3 != 0) refuse(*view.find(key), fmt::format("'{}' come in threes", key));
    return out;
  }

  // Files have moments and products of inertia, which people know; sums are of squares.
  void read_moments() {
    const Vec3 i = root_.vector("inertia");
    solid_.products = root_.vector("products");
    solid_.squares = Vec3{i.y + i.z - i.x, i.x + i.z - i.y, i.x + i.y - i.z} * 0.5;
    const Vec3 least = principal_frame(solid_.squares, solid_.products).squares;
    if (!(std::min({least.x, least.y, least.z}) > 0)) {
      refuse(*root_.find("inertia"), "no solid has such moments and products of inertia");
    }
  }

  void read_piece(const FormView& piece) {
    std::vector<Vec3> corners = in_threes(list(piece, "corners"));
    // As of the hull of a robot's file: a cube of a tenth of a millimetre.
    if (corners.size() < 4 || hull_mass(corners).volume <= 1e-12) {
      refuse(piece.node(), "the corners of this piece enclose nothing");
    }
    solid_.pieces.push_back(std::move(corners));
  }

  void read_surface(const FormView& surface) {
    VisualMesh& mesh = solid_.surface;
    mesh.points = in_threes(list(surface, "points"));
    for (const Vec3& t : in_threes(list(surface, "triangles"))) {
      const auto most = static_cast<double>(mesh.points.size());
      if (std::max({t.x, t.y, t.z}) >= most) {
        refuse(*surface.find("triangles"), "a triangle has a point that is not there");
        return;
      }
      mesh.triangles.push_back({static_cast<std::uint32_t>(t.x), static_cast<std::uint32_t>(t.y),
                                static_cast<std::uint32_t>(t.z)});
    }
  }

  const YamlDocument& document_;
  FormView root_;
  Diagnostics& out_;
  SolidModel solid_;
};

std::string in_text(const Vec3& v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }

/// A list over several lines.
template <class List, class Print>
std::string lines_of(const List& list, std::string_view indent, Print print) {
  constexpr std::size_t kInLine = 4;
  std::string out;
  for (std::size_t i = 0; i < list.size(); ++i) {
    out += i == 0 ? "" : i % kInLine == 0 ? fmt::format(",\n{}", indent) : ", ";
    out += print(list[i]);
  }
  return out;
}

}  // namespace

const Form& solid_form() {
  static const Form kForm{
      "file of a solid",
      {version("stigc_solid", "Version of the format: 1.", 1),
       required(words("name", FormKind::name, "A short name.")),
       words("source", FormKind::text, "Where it is from."),
       required(above_zero("volume", "m³.", 1e3)),
       required(vector("center", "Of mass, metres.", kFar)),
       required(numbers("inertia", "Moments of 1 kg about the axes through the center, m².", 3, 3,
                        1e-12, 1e3)),
       vector("products", "Of inertia, of 1 kg: means of yz, zx and xy, m² (default: 0).", 1e3),
       required(parts("pieces", "Convex; what touches others.", piece_form(), 1, kMostPieces)),
       part("surface", "Triangles to look at (default: the pieces).", surface_form())}};
  return kForm;
}

std::optional<SolidModel> read_solid(SourceRef source, Diagnostics& diagnostics) {
  assert(source != nullptr);
  Diagnostics own;
  std::optional<SolidModel> solid;
  if (const auto document = parse_yaml(std::move(source), {kMaxSolidFileBytes, 6, 200'000}, own)) {
    const BadNodes bad = check_form(*document, solid_form(), own);
    if (!own.has_errors()) solid = SolidReader(*document, bad, own).read();
  }
  diagnostics.append(own);
  return own.has_errors() ? std::nullopt : solid;
}

std::string print_solid(const SolidModel& solid, const std::string& comment) {
  const Vec3& q = solid.squares;
  std::string out = fmt::format("# {}\nstigc_solid: 1\nname: {}\n", comment, yaml_text(solid.name));
  if (!solid.source.empty()) out += fmt::format("source: {}\n", yaml_text(solid.source));
  out += fmt::format("volume: {}\ncenter: [{}]\ninertia: [{}]\nproducts: [{}]\npieces:\n",
                     solid.volume, in_text(solid.centre),
                     in_text({q.y + q.z, q.x + q.z, q.x + q.y}), in_text(solid.products));
  for (const std::vector<Vec3>& piece : solid.pieces) {
    out += fmt::format("  - corners: [{}]\n", lines_of(piece, "              ", in_text));
  }
  if (solid.surface.triangles.empty()) return out;
  out += fmt::format("surface:\n  points: [{}]\n",
                     lines_of(solid.surface.points, "           ", in_text));
  return out + fmt::format("  triangles: [{}]\n",
                           lines_of(solid.surface.triangles, "              ", [](const auto& t) {
                             return fmt::format("{}, {}, {}", t[0], t[1], t[2]);
                           }));
}

FileLoader loader_beside(const std::string& path) {
  return [folder = std::filesystem::path(path).parent_path()](const std::string& name,
                                                              std::size_t most, FileError& error) {
    return read_file((folder / name).string(), most, error);
  };
}

std::string solid_schema() {
  return form_schema(solid_form(), "stigc solid, version 1",
                     "A solid of any form: convex pieces, mass properties, a surface. Metres.");
}

bool is_mesh_name(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::string_view kEndings[] = {".stl", ".obj", ".off", ".ply"};
  return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

}  // namespace stig::robots
