// SPDX-License-Identifier: MIT
#include "paper_robot.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "compiler/block_figures.h"
#include "robots/block.h"
#include "robots/robot_reader.h"
#include "support/uses.h"

namespace stig::bench {

namespace {

SourceRef source(const std::string& path) {
  std::ifstream file(std::string(STIG_SOURCE_DIR) + "/" + path);
  return std::make_shared<const SourceFile>(path,
                                            std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace

const Abilities& paper_robot() {
  static const Abilities robot = [] {
    Diagnostics diagnostics;
    const auto read = read_robot(source("robots/bebot.yaml"), diagnostics);
    const auto block = read_block(source("blocks/stigmergic.yaml"), diagnostics);
    if (!read || !block) std::abort();
    return abilities_of(*read, figures_of(*block));
  }();
  return robot;
}

}  // namespace stig::bench
