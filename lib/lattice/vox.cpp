// SPDX-License-Identifier: MIT
// Reads MagicaVoxel files. Sizes, counts and nesting come from the file and are checked
// against what is left of it before they are used (ByteReader). A small file can place one
// model many times, so the sum of placed voxels is bounded before any is read.
#include "lattice/vox.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "lattice/rgb.h"
#include "lattice/vox_scene.h"

namespace stig::lattice {

namespace {

constexpr std::uint32_t kNewestVersion = 200;

struct Voxel {
  std::array<std::uint8_t, 3> at{};
  std::uint8_t index = 0;  // into the palette, 1..255
};

struct Model {
  std::array<std::uint32_t, 3> size{};
  std::string_view voxels;  // 4 bytes each, of the file
};

using Palette = std::array<Rgb, 256>;  // entry 0 is not used

// What a file without a palette means: the web-safe colours by falling blue, green and red,
// black left out, then ramps of red, green, blue and grey. Computed and not stored as a
// table of 256: the standard palette is regular.
Palette standard_palette() {
  Palette palette{};
  std::size_t next = 1;
  for (int i = 0; i < 215; ++i) {
    const auto level = [](int step) { return static_cast<std::uint8_t>(255 - 51 * step); };
    palette[next++] = {level(i / 36), level(i / 6 % 6), level(i % 6)};
  }
  for (int ramp = 0; ramp < 4; ++ramp) {
    for (const int step : {14, 13, 11, 10, 8, 7, 5, 4, 2, 1}) {
      const auto value = static_cast<std::uint8_t>(17 * step);
      const auto on = [&](int channel) {
        return ramp == 3 || ramp == channel ? value : std::uint8_t{0};
      };
      palette[next++] = {on(0), on(1), on(2)};
    }
  }
  return palette;
}

class VoxReader {
 public:
  VoxReader(const std::string& path, std::string_view bytes, Diagnostics& diagnostics)
      : source_(std::make_shared<SourceFile>(path, "")),
        bytes_(bytes),
        diagnostics_(diagnostics),
        palette_(standard_palette()) {}

  std::optional<LoadedStructure> read(Lattice lattice);

 private:
  bool read_chunks();
  bool read_chunk(std::string_view id, ByteReader content);
  bool read_size(ByteReader content);
  bool read_voxels(ByteReader content);
  bool read_palette(ByteReader content);
  std::optional<std::vector<PlacedModel>> place_models();
  bool check_placed(const std::vector<PlacedModel>& placed);
  bool collect(const PlacedModel& placed);
  bool number_colours(std::vector<Brick>& bricks);
  void keep_first();
  bool error(std::string message, Code code = Code::F407) {
    diagnostics_.add(code, {source_, 0, 0}, std::move(message));
    return false;
  }

  SourceRef source_;
  std::string_view bytes_;
  Diagnostics& diagnostics_;
  Palette palette_;
  std::vector<std::array<std::uint32_t, 3>> sizes_;
  std::vector<Model> models_;
  VoxScene scene_;
  std::vector<PlacedBrick> bricks_;  // colours are palette indices until the end
};

bool VoxReader::read_chunks() {
  ByteReader in(bytes_);
  if (in.take(4) != "VOX ") return error("the file does not start with 'VOX '");
  const std::uint32_t version = in.u32();
  if (in.good() && version != kVoxVersion && version != kNewestVersion) {
    return error(fmt::format("version {} of the format is not known", version));
  }
  if (in.take(4) != "MAIN") return error("the chunk 'MAIN' is missing");
  const std::uint32_t content = in.u32();
  in.u32();  // size of the children: the rest, whatever it says
  in.take(content);
  while (in.good() && in.left() > 0) {
    const std::string_view id = in.take(4);
    const std::uint32_t size = in.u32();
    const std::uint32_t children = in.u32();
    const ByteReader chunk(in.take(size));
    in.take(children);
    if (!in.good()) break;
    if (!read_chunk(id, chunk)) return false;
  }
  return in.good() || error("the file ends inside of a chunk");
}

bool VoxReader::read_chunk(std::string_view id, ByteReader content) {
  const auto node = [&](bool good) {
    return good || error(fmt::format("damaged node in the scene (chunk '{}')", id));
  };
  if (id == "SIZE") return read_size(content);
  if (id == "XYZI") return read_voxels(content);
  if (id == "RGBA") return read_palette(content);
  if (id == "nTRN") return node(add_transform_node(content, scene_));
  if (id == "nGRP") return node(add_group_node(content, scene_));
  if (id == "nSHP") return node(add_shape_node(content, scene_));
  return true;
}

/// SIZE and XYZI come in pairs; nothing else links a model's size to its cells.
bool VoxReader::read_size(ByteReader content) {
  std::array<std::uint32_t, 3> size{};
  for (std::uint32_t& side : size) {
    side = content.u32();
    if (!content.good() || std::cmp_greater(side, kVoxModelSide)) {
      return error(fmt::format("model {} is not within 256 cells a side", sizes_.size() + 1));
    }
  }
  if (sizes_.size() > models_.size()) return error("chunk 'SIZE' without 'XYZI'");
  sizes_.push_back(size);
  return true;
}

bool VoxReader::read_voxels(ByteReader content) {
  if (sizes_.size() != models_.size() + 1) return error("chunk 'XYZI' without 'SIZE'");
  const std::uint32_t count = content.u32();
  // Four bytes a voxel: the count is checked by division, which cannot overflow.
  if (!content.good() || count > content.left() / 4) {
    return error(fmt::format("model {} has fewer cells than it says", sizes_.size()));
  }
  models_.push_back({sizes_.back(), content.take(std::size_t{4} * count)});
  return true;
}

bool VoxReader::read_palette(ByteReader content) {
  for (std::size_t i = 1; i <= 256; ++i) {
    // The file lists 256 entries from index 1 on. A voxel's index is a byte, and 0 means
    // empty, so the last entry cannot be named.
    const Rgb rgb{content.u8(), content.u8(), content.u8()};
    content.u8();
    if (i < 256) palette_[i] = rgb;  // the last one is never used
  }
  return content.good() || error("the palette is too short");
}

// Without a scene there is one model. Its pivot is undone here, so that its lowest corner is
// the origin.
std::optional<std::vector<PlacedModel>> VoxReader::place_models() {
  if (models_.empty()) {
    error("the file has no model");
    return std::nullopt;
  }
  if (scene_.empty()) {
    if (models_.size() > 1) {
      diagnostics_.add(Code::F409, {source_, 0, 0},
                       fmt::format("{} models and no scene; the first is read", models_.size()));
    }
    PlacedModel only;
    for (std::size_t i = 0; i < 3; ++i) only.transform.shift[i] = models_[0].size[i] / 2;
    return std::vector<PlacedModel>{only};
  }
  auto placed = flatten_scene(scene_);
  if (!placed) error("the scene is no tree, or reaches too far");
  return placed;
}

// One model may be placed many times, and all its cells be read each time, those of
// index 0 too, which come to nothing: the sum is what has to be bounded.
bool VoxReader::check_placed(const std::vector<PlacedModel>& placed) {
  std::size_t cells = 0;
  for (const PlacedModel& model : placed) {
    if (model.model >= models_.size()) {
      return error(fmt::format("the scene places model {}, but there are {}", model.model + 1,
                               models_.size()));
    }
    cells += models_[model.model].voxels.size() / 4;
    if (cells > kMostFileBricks) {
      return error(fmt::format("more than {} cells", kMostFileBricks), Code::F406);
    }
  }
  return true;
}

// A model turns about the corner of cells at half its size, rounded down, and that
// corner is what its transform places. Twice the centres of cells are odd, so the
// turned cell is the half, rounded down.
bool VoxReader::collect(const PlacedModel& placed) {
  const Model& model = models_[placed.model];
  ByteReader in(model.voxels);
  while (in.left() > 0) {
    std::array<std::int64_t, 3> twice{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint8_t at = in.u8();
      if (at >= model.size[i]) {
        return error(fmt::format("model {} has a cell outside of its size", placed.model + 1));
      }
      // Twice the centre of a cell relative to the pivot is odd, so rotations stay
      // integral.
      twice[i] = 2 * at + 1 - 2 * static_cast<std::int64_t>(model.size[i] / 2);
    }
    const std::uint8_t index = in.u8();
    if (index == 0) continue;  // empty
    const auto turned = placed.transform.rotated(twice);
    const auto cell = [&](std::size_t i) {
      return static_cast<std::int32_t>((turned[i] - 1) / 2 + placed.transform.shift[i]);
    };
    bricks_.push_back({{cell(0), cell(1), cell(2)}, index});
  }
  return true;
}

// Cells that several models fill: the first keeps it. MagicaVoxel shows overlapping models;
// a structure has one brick in a cell. A warning is enough, and the order of the file
// decides.
void VoxReader::keep_first() {
  const auto by_cell = [](const PlacedBrick& a, const PlacedBrick& b) { return a.at < b.at; };
  std::stable_sort(bricks_.begin(), bricks_.end(), by_cell);
  std::size_t differing = 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < bricks_.size(); ++i) {
    if (kept > 0 && bricks_[kept - 1].at == bricks_[i].at) {
      if (bricks_[kept - 1].brick != bricks_[i].brick) ++differing;
    } else {
      bricks_[kept++] = bricks_[i];
    }
  }
  bricks_.resize(kept);
  if (differing > 0) {
    diagnostics_.add(Code::F410, {source_, 0, 0},
                     fmt::format("{} cells of different colours overlap", differing));
  }
}

bool VoxReader::number_colours(std::vector<Brick>& bricks) {
  std::array<bool, 256> used{};
  for (const PlacedBrick& brick : bricks_) used[brick.brick] = true;
  std::vector<std::size_t> indices;
  for (std::size_t i = 1; i < used.size(); ++i) {
    if (used[i]) indices.push_back(i);
  }
  if (indices.size() > kMaxColours) {
    return error(
        fmt::format("the models use {} colours, the most is {}", indices.size(), kMaxColours),
        Code::F408);
  }
  // Low indices are kept as they are, so that files written by this program give back their
  // colours.
  if (!indices.empty() && indices.back() <= kMaxColours) {
    const std::size_t last = indices.back();
    indices.clear();
    for (std::size_t i = 1; i <= last; ++i) indices.push_back(i);
  }
  std::array<Colour, 256> colour_of{};
  bricks = numbered_bricks(static_cast<int>(indices.size()));
  for (std::size_t i = 0; i < indices.size(); ++i) {
    colour_of[indices[i]] = static_cast<Colour>(i + 1);
    bricks[i].color = to_color(palette_[indices[i]]);
  }
  for (PlacedBrick& brick : bricks_) brick.brick = colour_of[brick.brick];
  return true;
}

std::optional<LoadedStructure> VoxReader::read(Lattice lattice) {
  if (!read_chunks()) return std::nullopt;
  const auto placed = place_models();
  if (!placed || !check_placed(*placed)) return std::nullopt;
  for (const PlacedModel& model : *placed) {
    if (!collect(model)) return std::nullopt;
  }
  keep_first();
  std::vector<Brick> bricks;
  if (!number_colours(bricks)) return std::nullopt;
  if (const auto problem = find_problem(bricks_)) {
    error(to_string(*problem), Code::F406);
    return std::nullopt;
  }
  return LoadedStructure{Structure(lattice, bricks_), std::move(bricks), !scene_.empty()};
}

}  // namespace

std::optional<LoadedStructure> read_vox(const std::string& path, std::string_view bytes,
                                        Diagnostics& diagnostics, Lattice lattice) {
  return VoxReader(path, bytes, diagnostics).read(lattice);
}

}  // namespace stig::lattice
