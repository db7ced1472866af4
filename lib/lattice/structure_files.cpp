// SPDX-License-Identifier: MIT
// Dispatch by the ending of a name. Readers report by diagnostics with places in the file;
// writers by one message, since what can go wrong is the size of the structure or the disk.
// Limits here are those of the formats and of what other programs can open.
#include "lattice/structure_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "base/file_io.h"
#include "base/text_bytes.h"
#include "lattice/mesh_files.h"
#include "lattice/rgb.h"
#include "lattice/structure_json.h"
#include "lattice/text_file.h"
#include "lattice/vox.h"

namespace stig::lattice {

namespace {

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

struct ToPrint {
  const Structure& structure;
  const std::vector<Brick>& bricks;
  const StructureWriteOptions& options;
};

/// A drawing takes a character for each cell of the bounding box, empty ones too; two far
/// bricks can make it huge.
std::string print_text(const ToPrint& what, std::string& error) {
  const Structure& structure = what.structure;
  const Offset size = structure.empty() ? Offset{1, 1, 1} : structure.bounds()->size();
  const std::int64_t slice = std::int64_t{size.x} * size.y;
  if (slice > kMostTextCells || slice * size.z > kMostTextCells) {
    error = "the box around the structure is too large to be drawn as text; use .json or .vox";
    return {};
  }
  return print_text_file(structure, what.bricks);
}

/// An empty result of draw_structure has two causes; the format tells which.
template <PictureFormat format>
std::string print_picture(const ToPrint& what, std::string& error) {
  PictureOptions options = what.options.picture;
  options.format = format;
  std::string bytes = draw_structure(what.structure, what.bricks, options);
  if (!bytes.empty()) return bytes;
  error =
      format == PictureFormat::svg
          ? fmt::format("more than {} faces show, too many for an .svg; use .png", kMostSvgFaces)
          : "there is not enough memory for the picture";
  return {};
}

std::string print_json(const ToPrint& what, std::string& /*error*/) {
  return print_structure_json(what.structure, what.bricks);
}
std::string print_voxels(const ToPrint& what, std::string& /*error*/) {
  return print_vox(what.structure, what.bricks);
}

// Surfaces for slicers are unmerged, those for viewers merged (see Merging).
std::string print_for_slicers(const ToPrint& what, std::string& /*error*/) {
  return print_stl(surface(what.structure, Merging::none), what.options.scale);
}
std::string print_polygons(const ToPrint& what, std::string& /*error*/) {
  return print_ply(surface(what.structure, Merging::faces), what.bricks, what.options.scale);
}
std::string print_for_viewers(const ToPrint& what, std::string& error) {
  const Mesh mesh = surface(what.structure, Merging::faces);
  if (mesh.polygons.size() <= kMostGlbPolygons) {
    return print_glb(mesh, what.bricks, what.options.scale);
  }
  error = "the surface is too large for .glb; use .ply";
  return {};
}

struct ToRead {
  const std::string& path;
  std::string bytes;
  const StructureReadOptions& options;
};

std::optional<LoadedStructure> read_text(ToRead what, Diagnostics& diagnostics) {
  if (what.bytes.starts_with(kByteOrderMark)) what.bytes.erase(0, kByteOrderMark.size());
  const auto source = std::make_shared<SourceFile>(what.path, std::move(what.bytes));
  return read_text_file(source, what.options.lattice, what.options.bricks, diagnostics);
}
std::optional<LoadedStructure> read_json(ToRead what, Diagnostics& diagnostics) {
  const auto source = std::make_shared<SourceFile>(what.path, std::move(what.bytes));
  return on_lattice(read_structure_json(source, diagnostics), what.options.lattice, source,
                    diagnostics);
}
std::optional<LoadedStructure> read_voxels(ToRead what, Diagnostics& diagnostics) {
  return read_vox(what.path, what.bytes, diagnostics,
                  what.options.lattice.value_or(Lattice::cubic));
}

/// The one list of formats, in the order in which messages name them.
struct Format {
  std::string_view ending;
  /// The file's bytes, or none with `error` set.
  std::string (*print)(const ToPrint& what, std::string& error);
  std::optional<LoadedStructure> (*read)(ToRead what, Diagnostics& diagnostics);
};
constexpr Format kFormats[] = {
    {"txt", print_text, read_text},
    {"json", print_json, read_json},
    {"vox", print_voxels, read_voxels},
    {"stl", print_for_slicers, nullptr},
    {"ply", print_polygons, nullptr},
    {"glb", print_for_viewers, nullptr},
    {"png", print_picture<PictureFormat::png>, nullptr},
    {"svg", print_picture<PictureFormat::svg>, nullptr},
};

/// That of the path's ending, or nullptr.
const Format* format_of(std::string_view path) {
  const std::string ending = ending_of(path);
  const auto found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                  [&](const Format& format) { return format.ending == ending; });
  return found == std::end(kFormats) ? nullptr : found;
}

/// ".txt, .json and .vox"
std::string read_endings() {
  std::vector<std::string> all;
  for (const Format& format : kFormats) {
    if (format.read != nullptr) all.push_back(fmt::format(".{}", format.ending));
  }
  const std::string last = all.back();
  all.pop_back();
  return fmt::format("{} and {}", fmt::join(all, ", "), last);
}

}  // namespace

std::optional<LoadedStructure> read_structure_file(const std::string& path,
                                                   const StructureReadOptions& options,
                                                   Diagnostics& diagnostics) {
  const Format* format = format_of(path);
  if (format == nullptr || format->read == nullptr) {
    diagnostics.add(Code::F401, {std::make_shared<SourceFile>(path, ""), 0, 0},
                    fmt::format("structures are read from {} files", read_endings()));
    return std::nullopt;
  }
  // The size is bounded before reading: a limit on bricks alone would come too late.
  FileError error;
  std::optional<std::string> bytes = read_file(path, kMostFileBytes, error);
  if (!bytes) {
    diagnostics.add(Code::R001, {std::make_shared<SourceFile>(path, ""), 0, 0}, error.message);
    return std::nullopt;
  }
  return format->read({path, std::move(*bytes), options}, diagnostics);
}

bool can_write_structure(const std::string& path, std::string& error) {
  if (format_of(path) != nullptr) return true;
  std::vector<std::string_view> endings;
  for (const Format& format : kFormats) endings.push_back(format.ending);
  error = fmt::format("cannot write '{}': the ending must be one of .{}", path,
                      fmt::join(endings, " ."));
  return false;
}

/// Bytes are complete before the file is opened: a failure leaves an old file as it was.
bool write_structure_file(const std::string& path, const Structure& structure,
                          const std::vector<Brick>& bricks, const StructureWriteOptions& options,
                          std::string& error) {
  if (!can_write_structure(path, error)) return false;
  const std::string bytes = format_of(path)->print({structure, bricks, options}, error);
  if (bytes.empty()) {
    error = fmt::format("cannot write '{}': {}", path, error);
    return false;
  }
  FileError file_error;
  if (write_file(path, bytes, file_error)) return true;
  error = file_error.message;
  return false;
}

}  // namespace stig::lattice
