// SPDX-License-Identifier: MIT
// The robots and blocks of a scene with their programs.
#pragma once

#include "physical/robots/crew.h"
#include "physical/scene/scene.h"

namespace stig {

/// The scene must outlive the crew that is made of it.
CrewConfig crew_of(const Scene& scene, const PlacedScene& placed);
/// A block of the scene, by its body.
CrewBlock crew_block(const Scene& scene, const PlacedScene& placed, std::size_t body);

}  // namespace stig
