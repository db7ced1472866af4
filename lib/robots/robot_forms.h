// SPDX-License-Identifier: MIT
// The keys of robot files; docs/robots.md explains them one by one. Those of devices are with
// their kinds.
#pragma once

#include "base/form.h"
#include "robots/uses.h"

namespace stig::robots {

/// The whole file.
const Form& robot_form();

}  // namespace stig::robots
