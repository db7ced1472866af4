// SPDX-License-Identifier: MIT
// The keys of scene files, for their reader and their schema.
#pragma once

#include "base/yaml_shape.h"

namespace stig {

const YamlObject& scene_keys();

}  // namespace stig
