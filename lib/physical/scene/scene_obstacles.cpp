// SPDX-License-Identifier: MIT
// Obstacles of a scene file: bodies as robots have them, by themselves.
#include <fmt/format.h>

#include "physical/scene/scene_parts.h"
#include "robots/body_reader.h"

namespace stig::physics {

void read_obstacles(const FormView& root, SceneParts& parts) {
  const FileLoader load = parts.files.loader_from({});
  for (const FormView& entry : root.forms("obstacles")) {
    ObstacleSpawn spawn;
    spawn.range = parts.document.head(entry.node());
    spawn.bodies = read_body(entry, {parts.document, parts.out, load}, {"obstacle", true});
    spawn.fixed = !(spawn.bodies.front().mass > 0);
    if (spawn.bodies.front().name.empty()) {
      spawn.bodies.front().name = fmt::format("obstacle {}", parts.scene.obstacles.size() + 1);
    }
    // The world wants every body to have a mass; of one that nothing moves it is not asked.
    for (BodyModel& body : spawn.bodies) {
      if (!spawn.fixed) continue;
      body.mass = 1;
      body.inertia = Vec3{1, 1, 1};
    }
    parts.scene.obstacles.push_back(std::move(spawn));
  }
}

}  // namespace stig::physics
