// SPDX-License-Identifier: MIT
// Translates the block's file into the compiler's figures, so that everything else in this
// layer depends on figures and not on the form of a file.
#include "compiler/block_figures.h"

#include <algorithm>

namespace stig::compiler {

BlockFigures figures_of(const BlockModel& block) {
  BlockFigures out;
  out.look.side = block.side;
  out.look.tag_side = block.tags.side;
  out.look.proud = block.tags.proud;
  out.look.led_place = block.leds.offset;
  // The narrower of two viewing angles counts: a brick is known only when tag and an LED
  // are seen.
  out.look.most_angle = std::min(block.tags.widest, block.leds.widest);
  out.mass = block.mass();
  out.magnet_offset = block.magnet_offset;
  out.magnet_moment = block.magnet_moment();
  out.magnet_cutoff = block.magnet_cutoff;
  out.block_friction = out.floor_friction = block.friction;
  out.answers = block.radios.answers;
  return out;
}

}  // namespace stig::compiler
