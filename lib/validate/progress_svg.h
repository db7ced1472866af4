// SPDX-License-Identifier: MIT
// How a structure grew, drawn: every run thin, the mean and one deviation about it; the phases of
// the work; below, where they are known, the sites that were open and the robots that were idle.
#pragma once

#include <string>
#include <vector>

#include "validate/uses.h"
#include "validate/work_summary.h"

namespace stig::validate {

std::string progress_svg(const std::vector<ProgressCurve>& curves, const ProgressBand& band,
                         int bricks);

}  // namespace stig::validate
