// SPDX-License-Identifier: MIT
// A structure as a file of another kind, with the bytes that the program writes for that ending.
#include <nlohmann/json.hpp>

#include "answers.h"
#include "base/base64.h"
#include "base/text.h"
#include "lattice/mesh_files.h"
#include "lattice/picture.h"
#include "lattice/structure_json.h"
#include "lattice/text_file.h"
#include "lattice/vox.h"
#include "rules/rule_reader.h"
#include "rules_text.h"

namespace stig::playground {
namespace {

/// A drawing has a character for each cell of the box around the bricks.
constexpr std::int64_t kMostTextCells = std::int64_t{1} << 24;

bool can_be_drawn(const Structure& structure) {
  const Offset size = structure.bounds()->size();
  const std::int64_t slice = std::int64_t{size.x} * size.y;
  return slice <= kMostTextCells && slice * size.z <= kMostTextCells;
}

/// As `stigc explore -o` draws it, but for its letters.
std::string picture_of(const LoadedStructure& what, const Json& question) {
  PictureOptions options;
  options.format = PictureFormat::svg;
  const std::string palette = question.value("palette", "");
  if (palette == "okabe-ito") options.palette = Palette::okabe_ito;
  if (palette == "tol-bright") options.palette = Palette::tol_bright;
  Diagnostics ignored;  // what is drawn is the structure; of unsound rules it has no title
  if (const auto rules = read_rule_set(rules_source(question), ignored)) {
    options.title = printable(rules->title);
    options.floor = rules->floor;
  }
  return draw_structure(what.structure, what.bricks, options);
}

/// Nothing where there is no such ending, or no such file of this structure.
std::string bytes_of(const LoadedStructure& what, const Json& question) {
  const std::string ending = question.value("ending", "");
  const Structure& structure = what.structure;
  if (ending == "vox") return print_vox(structure, what.bricks);
  if (ending == "txt")
    return can_be_drawn(structure) ? print_text_file(structure, what.bricks) : "";
  // As in lib/lattice/structure_files.cpp: slicers want faces as they are.
  if (ending == "stl") return print_stl(surface(structure, Merging::none));
  if (ending == "ply") return print_ply(surface(structure, Merging::faces), what.bricks);
  if (ending == "svg") return picture_of(what, question);
  if (ending == "glb") return print_glb(surface(structure, Merging::faces), what.bricks);
  return {};
}

}  // namespace

Json structure_answer(const Json& question) {
  Json out;
  const SourceRef file = source_of(question, "target");
  Diagnostics diagnostics;
  const auto loaded = file ? read_structure_json(file, diagnostics) : std::nullopt;
  add_diagnostics(diagnostics, out);
  const std::string bytes =
      loaded && !loaded->structure.empty() ? bytes_of(*loaded, question) : std::string();
  if (bytes.empty()) {
    out["problem"] = "there is no such file of this structure";
  } else {
    out["file"] = base64(bytes);
  }
  return out;
}

}  // namespace stig::playground
