// SPDX-License-Identifier: MIT
// The keys of files of robots, blocks and solids; docs/robots.md explains them one by one. Those of
// devices are with their kinds.
#pragma once

#include "base/form.h"
#include "robots/uses.h"

namespace stig::robots {

// The forms of whole files.
const Form& robot_form();
const Form& block_form();
const Form& solid_form();

}  // namespace stig::robots
