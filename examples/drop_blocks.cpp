// SPDX-License-Identifier: MIT
// Two blocks fall upon a third; where do they come to rest, and is what they form a structure on a
// lattice? stig::physical_dynamics and stig::physical_readout.
#include <cstdio>
#include <iostream>

#include "physical/dynamics/world.h"
#include "physical/readout/lattice_reading.h"
#include "robots/block.h"

namespace {

/// Where the blocks are, and which of them form a lattice.
void describe(const stig::physics::World& world, double side) {
  std::vector<stig::physics::PlacedBlock> blocks;
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    blocks.push_back({world.state(stig::physics::BodyId{i}).X_WB});
    const stig::Vec3 p = blocks.back().X_WB.p;
    std::printf("block %u at (%.1f, %.1f, %.1f) mm\n", i, 1e3 * p.x, 1e3 * p.y, 1e3 * p.z);
  }
  for (const stig::physics::ReadLattice& lattice :
       stig::physics::read_lattices(blocks, side).lattices) {
    std::printf("a lattice with a pitch of %.1f mm:", 1e3 * lattice.pitch);
    for (const stig::physics::ReadBlock& read : lattice.blocks) {
      std::printf(" (%d, %d, %d)", read.cell.x, read.cell.y, read.cell.z);
    }
    std::puts("");
  }
}

}  // namespace

int main() {
  stig::Diagnostics diagnostics;
  const auto block =
      stig::robots::read_block_file(STIG_DATA "/blocks/stigmergic.yaml", diagnostics);
  std::cerr << stig::to_text(diagnostics);
  if (!block) return 1;

  // One block on the floor (its centre is half its side above it), one 5 mm beside it, one that
  // falls from 2 cm above, 4 mm off. Free magnets in the blocks' corners do the rest.
  const double side = block->side;
  stig::physics::WorldConfig config;
  config.bodies.push_back(stig::physics::block_body(*block, {{0, 0, side / 2}, {}}));
  config.bodies.push_back(stig::physics::block_body(*block, {{side + 0.005, 0, side / 2}, {}}));
  config.bodies.push_back(stig::physics::block_body(*block, {{0.004, 0, 1.5 * side + 0.02}, {}}));
  for (const std::string& problem : stig::physics::problems_of(config))
    std::cerr << problem << '\n';

  // Steps of 5 ms, for 2 s or until all are asleep.
  stig::physics::World world(config);
  while (world.time() < 2 && world.awake_count() > 0) {
    if (!world.step().ok) return 1;
    for (const stig::physics::WorldEvent& event : world.events()) {
      if (event.kind == stig::physics::EventKind::snapped) {
        std::printf("%.3f s: blocks %u and %u snap together\n", world.time(),
                    static_cast<unsigned>(event.body), static_cast<unsigned>(event.other));
      }
    }
  }

  describe(world, side);
}
