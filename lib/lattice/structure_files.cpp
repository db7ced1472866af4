// SPDX-License-Identifier: MIT
// Dispatch by the ending of a name. Readers report by diagnostics with places in the file;
// writers by one message, since what can go wrong is the size of the structure or the disk.
// Limits here are those of the formats and of what other programs can open.
#include "lattice/structure_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/file_io.h"
#include "lattice/mesh_files.h"
#include "lattice/rgb.h"
#include "lattice/structure_json.h"
#include "lattice/text_file.h"
#include "lattice/vox.h"

namespace stig::lattice {

namespace {

constexpr std::array<std::string_view, 8> kWritten = {"txt", "json", "vox", "stl",
                                                      "ply", "glb",  "png", "svg"};
constexpr std::int64_t kMostTextCells = std::int64_t{1} << 28;
constexpr std::size_t kMostGlbPolygons = 25'000'000;  // 4 GB is the format's limit

// What stands behind the last dot of the last part of the path, in lower case. Endings of
// names from other systems come in capitals.
std::string ending_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  const std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.rfind('.');
  std::string ending(dot == std::string_view::npos ? "" : name.substr(dot + 1));
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

// A structure on the lattice that is wanted, or a diagnostic. Only .json states a lattice
// that may contradict what is wanted; the other readers are told it.
std::optional<LoadedStructure> on_lattice(std::optional<LoadedStructure> loaded,
                                          std::optional<Lattice> wanted, const SourceRef& source,
                                          Diagnostics& diagnostics) {
  if (!loaded || !wanted || loaded->structure.lattice() == *wanted) return loaded;
  diagnostics.add(Code::F411, {source, 0, 0},
                  fmt::format("the structure is {}, {} is wanted",
                              to_string(loaded->structure.lattice()), to_string(*wanted)));
  return std::nullopt;
}

/// A drawing takes a character for each cell of the bounding box, empty ones too; two far
/// bricks can make it huge.
bool print_text(const Structure& structure, const std::vector<Brick>& bricks, std::string& bytes,
                std::string& error) {
  const Offset size = structure.empty() ? Offset{1, 1, 1} : structure.bounds()->size();
  const std::int64_t slice = std::int64_t{size.x} * size.y;
  if (slice > kMostTextCells || slice * size.z > kMostTextCells) {
    error = "the box around the structure is too large to be drawn as text; use .json or .vox";
    return false;
  }
  bytes = print_text_file(structure, bricks);
  return true;
}

/// An empty result of draw_structure has two causes; the format tells which.
bool print_picture(const Structure& structure, const std::vector<Brick>& bricks,
                   const PictureOptions& options, std::string& bytes, std::string& error) {
  bytes = draw_structure(structure, bricks, options);
  if (!bytes.empty()) return true;
  error =
      options.format == PictureFormat::svg
          ? fmt::format("more than {} faces show, too many for an .svg; use .png", kMostSvgFaces)
          : "there is not enough memory for the picture";
  return false;
}

/// Surfaces for slicers are unmerged, those for viewers merged (see Merging).
bool print_kind(const std::string& ending, const Structure& structure,
                const std::vector<Brick>& bricks, const StructureWriteOptions& options,
                std::string& bytes, std::string& error) {
  if (ending == "txt") return print_text(structure, bricks, bytes, error);
  if (ending == "png" || ending == "svg") {
    PictureOptions picture = options.picture;
    picture.format = ending == "png" ? PictureFormat::png : PictureFormat::svg;
    return print_picture(structure, bricks, picture, bytes, error);
  }
  if (ending == "json") bytes = print_structure_json(structure, bricks);
  if (ending == "vox") bytes = print_vox(structure, bricks);
  if (ending == "stl") bytes = print_stl(surface(structure, Merging::none), options.scale);
  if (ending == "ply") bytes = print_ply(surface(structure, Merging::faces), bricks, options.scale);
  if (ending == "glb") {
    const Mesh mesh = surface(structure, Merging::faces);
    if (mesh.polygons.size() > kMostGlbPolygons) {
      error = "the surface is too large for .glb; use .ply";
      return false;
    }
    bytes = print_glb(mesh, bricks, options.scale);
  }
  return true;
}

}  // namespace

std::optional<LoadedStructure> read_structure_file(const std::string& path,
                                                   const StructureReadOptions& options,
                                                   Diagnostics& diagnostics) {
  const std::string ending = ending_of(path);
  if (ending != "txt" && ending != "json" && ending != "vox") {
    diagnostics.add(Code::F401, {std::make_shared<SourceFile>(path, ""), 0, 0},
                    "structures are read from .txt, .json and .vox files");
    return std::nullopt;
  }
  // The size is bounded before reading: a limit on bricks alone would come too late.
  FileError error;
  std::optional<std::string> bytes = read_file(path, kMostFileBytes, error);
  if (!bytes) {
    diagnostics.add(Code::R001, {std::make_shared<SourceFile>(path, ""), 0, 0}, error.message);
    return std::nullopt;
  }
  if (ending == "vox") {
    return read_vox(path, *bytes, diagnostics, options.lattice.value_or(Lattice::cubic));
  }
  const auto source = std::make_shared<SourceFile>(path, std::move(*bytes));
  if (ending == "txt") {
    return read_text_file(source, options.lattice, options.bricks, diagnostics);
  }
  return on_lattice(read_structure_json(source, diagnostics), options.lattice, source, diagnostics);
}

bool can_write_structure(const std::string& path, std::string& error) {
  const std::string ending = ending_of(path);
  if (std::find(kWritten.begin(), kWritten.end(), ending) != kWritten.end()) return true;
  error = fmt::format("cannot write '{}': the ending must be one of .{}", path,
                      fmt::join(kWritten, " ."));
  return false;
}

/// Bytes are complete before the file is opened: a failure leaves an old file as it was.
bool write_structure_file(const std::string& path, const Structure& structure,
                          const std::vector<Brick>& bricks, const StructureWriteOptions& options,
                          std::string& error) {
  if (!can_write_structure(path, error)) return false;
  std::string bytes;
  if (!print_kind(ending_of(path), structure, bricks, options, bytes, error)) {
    error = fmt::format("cannot write '{}': {}", path, error);
    return false;
  }
  FileError file_error;
  if (write_file(path, bytes, file_error)) return true;
  error = file_error.message;
  return false;
}

}  // namespace stig::lattice
