// SPDX-License-Identifier: MIT
// The keys of robot and block files; docs/robots.md explains them one by one. Those of devices are
// with their kinds.
#pragma once

#include "base/form.h"
#include "robots/uses.h"

namespace stig::robots {

// The forms of whole files.
const Form& robot_form();
const Form& block_form();

}  // namespace stig::robots
