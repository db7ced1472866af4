// SPDX-License-Identifier: MIT
// The keys of scene files, for their reader and their schema.
#pragma once

#include "base/form.h"
#include "physical/scene/uses.h"

namespace stig::physics {

const Form& scene_keys();

}  // namespace stig::physics
