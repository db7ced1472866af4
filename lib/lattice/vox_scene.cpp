// SPDX-License-Identifier: MIT
// Parses the scene graph of a MagicaVoxel file and flattens it with an explicit stack,
// since depth is up to the file. Rotations are signed permutations, so composing them is
// exact.
#include "lattice/vox_scene.h"

#include <algorithm>
#include <charconv>
#include <set>

namespace stig::lattice {

namespace {

constexpr std::int64_t kFarthest = std::int64_t{1} << 26;

// Not by std::abs, which the least number does not have.
bool too_far(std::int64_t value) { return value < -kFarthest || value > kFarthest; }

using Attributes = std::map<std::string, std::string>;

std::string_view read_string(ByteReader& in) {
  const std::uint32_t size = in.u32();
  return in.take(size);
}

Attributes read_attributes(ByteReader& in) {
  Attributes attributes;
  const std::uint32_t count = in.u32();
  for (std::uint32_t i = 0; i < count && in.good(); ++i) {
    const std::string_view key = read_string(in);
    const std::string_view value = read_string(in);
    attributes.emplace(key, value);
  }
  return attributes;
}

bool parse_int(std::string_view& text, std::int64_t& value) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data() + begin, end, value);
  if (result.ec != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
  return true;
}

// "x y z" in decimal. Shifts of one node are bounded, and the sums along a path are bounded
// again in flatten_scene.
bool parse_shift(std::string_view text, VoxTransform& transform) {
  for (std::int64_t& value : transform.shift) {
    if (!parse_int(text, value) || too_far(value)) return false;
  }
  return true;
}

// A byte in decimal: bits 0-1 and 2-3 the columns of the rows' entries, the third
// row having the column that is left; bits 4-6 the rows' signs.
bool parse_rotation(std::string_view text, VoxTransform& transform) {
  std::int64_t value = 0;
  if (!parse_int(text, value) || value < 0 || value > 127) return false;
  const auto bits = static_cast<unsigned>(value);
  const unsigned first = bits & 3U;
  const unsigned second = bits >> 2 & 3U;
  if (first > 2 || second > 2 || first == second) return false;
  transform.axis = {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second),
                    static_cast<std::uint8_t>(3 - first - second)};
  for (std::size_t row = 0; row < 3; ++row) {
    transform.sign[row] = (bits >> (4 + row) & 1U) != 0 ? -1 : 1;
  }
  return true;
}

bool add_node(std::uint32_t id, VoxNode node, VoxScene& scene) {
  return scene.emplace(id, std::move(node)).second;
}

}  // namespace

std::array<std::int64_t, 3> VoxTransform::rotated(const std::array<std::int64_t, 3>& v) const {
  return {sign[0] * v[axis[0]], sign[1] * v[axis[1]], sign[2] * v[axis[2]]};
}

/// A composition of matrices: first `inner`, then this.
VoxTransform VoxTransform::after(const VoxTransform& inner) const {
  VoxTransform both;
  for (std::size_t row = 0; row < 3; ++row) {
    both.axis[row] = inner.axis[axis[row]];
    both.sign[row] = static_cast<std::int8_t>(sign[row] * inner.sign[axis[row]]);
  }
  const auto turned = rotated(inner.shift);
  for (std::size_t row = 0; row < 3; ++row) both.shift[row] = turned[row] + shift[row];
  return both;
}

bool add_transform_node(ByteReader content, VoxScene& scene) {
  const std::uint32_t id = content.u32();
  read_attributes(content);
  VoxNode node;
  node.children.push_back(content.u32());
  content.take(8);  // reserved, layer
  const std::uint32_t frames = content.u32();
  // Later frames of an animation are ignored.
  if (frames > 0) {
    const Attributes frame = read_attributes(content);
    const auto rotation = frame.find("_r");
    const auto shift = frame.find("_t");
    if (rotation != frame.end() && !parse_rotation(rotation->second, node.transform)) return false;
    if (shift != frame.end() && !parse_shift(shift->second, node.transform)) return false;
  }
  return content.good() && add_node(id, std::move(node), scene);
}

bool add_group_node(ByteReader content, VoxScene& scene) {
  const std::uint32_t id = content.u32();
  read_attributes(content);
  VoxNode node;
  const std::uint32_t children = content.u32();
  if (children > content.left() / 4) return false;
  for (std::uint32_t i = 0; i < children; ++i) node.children.push_back(content.u32());
  return content.good() && add_node(id, std::move(node), scene);
}

bool add_shape_node(ByteReader content, VoxScene& scene) {
  const std::uint32_t id = content.u32();
  read_attributes(content);
  const std::uint32_t models = content.u32();
  VoxNode node;
  if (models > 0) node.model = content.u32();
  return content.good() && add_node(id, std::move(node), scene);
}

std::optional<std::vector<PlacedModel>> flatten_scene(const VoxScene& scene) {
  struct Visit {
    std::uint32_t node;
    VoxTransform outer;
  };
  std::vector<PlacedModel> models;
  std::vector<Visit> stack{{0, {}}};
  std::set<std::uint32_t> seen;  // a second visit would be a cycle, or multiply for ever
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const auto found = scene.find(visit.node);
    if (found == scene.end() || !seen.insert(visit.node).second) return std::nullopt;
    const VoxNode& node = found->second;
    const VoxTransform here = visit.outer.after(node.transform);
    for (const std::int64_t value : here.shift) {
      if (too_far(value)) return std::nullopt;
    }
    if (node.model) models.push_back({*node.model, here});
    // In reverse, so that children are visited in the order of the file.
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
      stack.push_back({*child, here});
    }
  }
  return models;
}

}  // namespace stig::lattice
