// SPDX-License-Identifier: MIT
// The keys of scene files, for their reader and their schema.
#pragma once

#include "base/form.h"

namespace stig {

const Form& scene_keys();

}  // namespace stig
