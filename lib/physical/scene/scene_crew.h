// SPDX-License-Identifier: MIT
// The robots and blocks of a scene with their controllers.
#pragma once

#include "physical/robots/crew.h"
#include "physical/scene/controller_factory.h"
#include "physical/scene/uses.h"

namespace stig::physics {

/// The scene must outlive the crew that is made of it.
CrewConfig crew_of(const Scene& scene, const PlacedScene& placed,
                   const ControllerFactory& controllers);
/// A block of the scene, by its body.
CrewBlock crew_block(const Scene& scene, const PlacedScene& placed, std::size_t body,
                     const ControllerFactory& controllers);

}  // namespace stig::physics
