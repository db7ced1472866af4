// SPDX-License-Identifier: MIT
// Any bytes as a scene, as a block and as a file of poses: diagnostics, or a scene that can
// be placed or says why not.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "physical/scene/poses_file.h"
#include "physical/scene/scene.h"
#include "support/uses.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

constexpr const char* kBlock =
    "stigc_block: 1\nname: b\nbody: {side: 0.055, mass: 0.102, friction: 0.5}\n"
    "magnets: {offset: 0.0225, radius: 0.003, mass: 0.001, field: 75, cutoff: 0.04}\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const auto source = std::make_shared<const stig::SourceFile>("input", text);
  stig::Diagnostics diagnostics;
  const auto load = stig::memory_loader(
      {{"stigmergic.yaml", kBlock}, {"p.csv", "0,0,1,0,0,0\n"}, {"self", text}});
  const auto scene = stig::read_scene(source, load, diagnostics);
  require(scene.has_value() != diagnostics.has_errors());
  stig::to_text(diagnostics);
  stig::Diagnostics others;
  stig::read_block(source, others);
  stig::read_poses_file(source, others);
  stig::to_json(others);
  if (!scene) return 0;
  std::size_t blocks = 0;
  for (const stig::BlockSpawn& spawn : scene->blocks) {
    std::size_t count = 1;
    for (const int n : spawn.count) count *= static_cast<std::size_t>(n);
    blocks += count;
  }
  // Thousands of blocks take seconds to place, and say nothing that few do not.
  if (blocks > 2000 && blocks < 50'000) return 0;
  stig::Diagnostics placing;
  const auto placed = stig::place_scene(*scene, scene->seed, placing);
  require(placed.has_value() != placing.has_errors());
  if (placed) require(stig::problems_of(placed->config).empty());
  return 0;
}
