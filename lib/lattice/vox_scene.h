// SPDX-License-Identifier: MIT
// The scene of a MagicaVoxel file: a tree of transforms, groups and shapes, as
// parsed from its chunks, and its flattening into placed models.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "lattice/uses.h"

namespace stig::lattice {

inline constexpr std::uint32_t kVoxVersion = 150;   ///< of the format, as it is written here
inline constexpr std::int32_t kVoxModelSide = 256;  ///< the most cells of a model along x, y or z

struct VoxTransform {
  /// Row i of the rotation is sign[i] at column axis[i].
  std::array<std::uint8_t, 3> axis{0, 1, 2};
  std::array<std::int8_t, 3> sign{1, 1, 1};
  std::array<std::int64_t, 3> shift{};

  std::array<std::int64_t, 3> rotated(const std::array<std::int64_t, 3>& v) const;
  /// This transform after `inner`.
  VoxTransform after(const VoxTransform& inner) const;
};

/// One node; a transform has one child, a shape none but a model.
struct VoxNode {
  VoxTransform transform;
  std::vector<std::uint32_t> children;
  std::optional<std::uint32_t> model;
};

/// A model and where it stands.
struct PlacedModel {
  std::uint32_t model = 0;
  VoxTransform transform;
};

using VoxScene = std::map<std::uint32_t, VoxNode>;

/// Parse the content of a chunk nTRN, nGRP or nSHP and add its node. False when it
/// is malformed or the node's number is taken.
bool add_transform_node(ByteReader content, VoxScene& scene);
bool add_group_node(ByteReader content, VoxScene& scene);
bool add_shape_node(ByteReader content, VoxScene& scene);

/// Models in the order of the tree from node 0. Nothing when the graph is no tree,
/// names a node that is not there, or places anything further out than 2^26.
std::optional<std::vector<PlacedModel>> flatten_scene(const VoxScene& scene);

}  // namespace stig::lattice
