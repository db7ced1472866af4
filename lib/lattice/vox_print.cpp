// SPDX-License-Identifier: MIT
// Writes MagicaVoxel files: the structure is cut into blocks of 256 cells a side, each a
// model, and a scene of transforms puts them in place. A structure that fits one model has
// a scene too, since without one its place would be lost.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <string_view>

#include "base/bytes.h"
#include "lattice/rgb.h"
#include "lattice/vox.h"
#include "lattice/vox_scene.h"

namespace stig::lattice {

namespace {

/// Chunks without children; only MAIN has any.
void put_chunk(std::string& out, std::string_view id, std::string_view content) {
  out += id;
  put(out, static_cast<std::uint32_t>(content.size()));
  put(out, std::uint32_t{0});
  out += content;
}

void put_attribute(std::string& out, std::string_view key, std::string_view value) {
  for (const std::string_view text : {key, value}) {
    put(out, static_cast<std::uint32_t>(text.size()));
    out += text;
  }
}

/// The reserved field is -1, as in the files of other programs; so is the layer of the
/// root.
std::string transform_node(std::uint32_t id, std::uint32_t child, std::int32_t layer,
                           const std::string& shift) {
  std::string out;
  for (const std::uint32_t value : {id, 0U, child, ~0U}) put(out, value);
  put(out, layer);
  put(out, std::uint32_t{1});  // frames
  put(out, shift.empty() ? std::uint32_t{0} : std::uint32_t{1});
  if (!shift.empty()) put_attribute(out, "_t", shift);
  return out;
}

// The bricks of one model: a block of 256³ cells cut from the structure's lowest
// corner on, trimmed to what it holds.
struct Block {
  CellBounds bounds{};
  std::string voxels;
};

/// The sort is stable, so voxels of a model stay in cell order and files are reproducible.
std::vector<PlacedBrick> sorted_by_block(const Structure& structure, Cell low) {
  std::vector<PlacedBrick> bricks = structure.bricks();
  const auto block = [low](const PlacedBrick& b) {
    const Offset from = b.at - low;
    return Offset{from.x / kVoxModelSide, from.y / kVoxModelSide, from.z / kVoxModelSide};
  };
  std::stable_sort(bricks.begin(), bricks.end(),
                   [&](const PlacedBrick& a, const PlacedBrick& b) { return block(a) < block(b); });
  return bricks;
}

/// Trimmed bounds keep models small where a block is mostly empty.
CellBounds bounds_of(const PlacedBrick* begin, const PlacedBrick* end) {
  assert(begin != end);
  CellBounds bounds{begin->at, begin->at};
  for (const PlacedBrick* b = begin; b != end; ++b) {
    bounds.low = {std::min(bounds.low.x, b->at.x), std::min(bounds.low.y, b->at.y),
                  std::min(bounds.low.z, b->at.z)};
    bounds.high = {std::max(bounds.high.x, b->at.x), std::max(bounds.high.y, b->at.y),
                   std::max(bounds.high.z, b->at.z)};
  }
  return bounds;
}

/// Two passes of division are cheaper than a map of blocks, and keep blocks in a fixed
/// order.
std::vector<Block> blocks_of(const Structure& structure) {
  std::vector<Block> blocks;
  if (structure.empty()) return blocks;
  const Cell low = structure.bounds()->low;
  const std::vector<PlacedBrick> bricks = sorted_by_block(structure, low);
  const auto same_block = [low](const PlacedBrick& a, const PlacedBrick& b) {
    const Offset p = a.at - low, q = b.at - low;
    return p.x / kVoxModelSide == q.x / kVoxModelSide &&
           p.y / kVoxModelSide == q.y / kVoxModelSide && p.z / kVoxModelSide == q.z / kVoxModelSide;
  };
  for (std::size_t begin = 0; begin < bricks.size();) {
    std::size_t end = begin;
    while (end < bricks.size() && same_block(bricks[begin], bricks[end])) ++end;
    Block block{bounds_of(&bricks[begin], bricks.data() + end), {}};
    for (; begin < end; ++begin) {
      const Offset at = bricks[begin].at - block.bounds.low;
      for (const std::int32_t value : {at.x, at.y, at.z, std::int32_t{bricks[begin].brick}}) {
        put(block.voxels, static_cast<std::uint8_t>(value));
      }
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::string size_content(Offset size) {
  std::string out;
  for (const std::int32_t side : {size.x, size.y, size.z}) put(out, side);
  return out;
}

std::string palette_content(const std::vector<Brick>& bricks) {
  std::string out;
  // All 62 colours are written, used or not: the palette is the rule set's.
  for (int i = 1; i <= 256; ++i) {
    const Rgb rgb = i <= kMaxColours ? rgb_of(bricks, static_cast<Colour>(i)) : Rgb{128, 128, 128};
    for (const std::uint8_t value : {rgb.r, rgb.g, rgb.b, std::uint8_t{255}}) put(out, value);
  }
  return out;
}

// Node 0 places the group 1; nodes 2k + 2 and 2k + 3 place and show model k.
void put_scene(std::string& out, const std::vector<Block>& blocks) {
  put_chunk(out, "nTRN", transform_node(0, 1, -1, ""));
  std::string group;
  for (const std::uint32_t value : {1U, 0U, static_cast<std::uint32_t>(blocks.size())}) {
    put(group, value);
  }
  for (std::uint32_t k = 0; k < blocks.size(); ++k) put(group, 2 * k + 2);
  put_chunk(out, "nGRP", group);
  for (std::uint32_t k = 0; k < blocks.size(); ++k) {
    const CellBounds& b = blocks[k].bounds;
    const Offset size = b.size();
    // A transform places the middle of its model, rounded down (see VoxReader::collect).
    const std::string shift =
        fmt::format("{} {} {}", b.low.x + size.x / 2, b.low.y + size.y / 2, b.low.z + size.z / 2);
    put_chunk(out, "nTRN", transform_node(2 * k + 2, 2 * k + 3, 0, shift));
    std::string shape;
    for (const std::uint32_t value : {2 * k + 3, 0U, 1U, k, 0U}) put(shape, value);
    put_chunk(out, "nSHP", shape);
  }
}

}  // namespace

std::string print_vox(const Structure& structure, const std::vector<Brick>& bricks) {
  std::vector<Block> blocks = blocks_of(structure);
  if (blocks.empty()) blocks.push_back({});  // a model of one empty cell
  std::string children;
  for (const Block& block : blocks) {
    put_chunk(children, "SIZE", size_content(block.bounds.size()));
    std::string voxels;
    put(voxels, static_cast<std::uint32_t>(block.voxels.size() / 4));
    put_chunk(children, "XYZI", voxels + block.voxels);
  }
  put_scene(children, blocks);
  put_chunk(children, "RGBA", palette_content(bricks));
  std::string out = "VOX ";
  put(out, kVoxVersion);
  out += "MAIN";
  put(out, std::uint32_t{0});
  put(out, static_cast<std::uint32_t>(children.size()));
  return out + children;
}

}  // namespace stig::lattice
