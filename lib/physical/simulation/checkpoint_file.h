// SPDX-License-Identifier: MIT
// A run that stopped, as a file: the scene's texts, the seed and the state.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physical/scene/scene.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

struct Checkpoint {
  std::vector<SceneFile> files;
  std::uint64_t seed = 1;
  std::string state;
};

std::string checkpoint_bytes(const Checkpoint& checkpoint);
/// Nothing when the bytes are damaged or something else; `problem` says what.
std::optional<Checkpoint> read_checkpoint_file(std::string_view bytes, std::string& problem);

}  // namespace stig::physics
