// SPDX-License-Identifier: MIT
// A block's file in the numbers that the compiler asks for.
#pragma once

#include "compiler/abilities.h"
#include "compiler/uses.h"
#include "robots/block.h"

namespace stig::compiler {

/// The file has one friction, taken for what blocks stand on as well; tags and LEDs have an
/// angle each, of which the compiler takes the narrower.
BlockFigures figures_of(const BlockModel& block);

}  // namespace stig::compiler
