// SPDX-License-Identifier: MIT
#include "behaviour/support.h"
#include "support/uses.h"

#include <algorithm>
#include <cmath>

namespace stig::behaviour {

LoadedScene scene_of(const std::string& text, std::uint64_t seed) {
  const std::string root = STIG_SOURCE_DIR;
  Diagnostics diagnostics;
  const auto source = std::make_shared<const SourceFile>("trial.yaml", text);
  auto scene =
      read_scene(source,
                 disk_loader(root + "/scenes", {root + "/blocks", root + "/robots",
                                                root + "/programs", root + "/tests/controllers"}),
                 diagnostics);
  std::optional<PlacedScene> placed;
  if (scene) placed = place_scene(*scene, seed, diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(placed);
  return {std::move(*scene), std::move(*placed)};
}

Trial::Trial(const std::string& text, std::uint64_t seed, const ControllerFactory& controllers)
    : loaded_(scene_of(text, seed)), run_(loaded_.scene, loaded_.placed, true, controllers) {}

bool Trial::until(double seconds, const std::string& words) {
  std::atomic<bool> stop{false};
  RunHooks hooks;
  hooks.stop = &stop;
  hooks.on_line = [&](const CrewLine& line) {
    lines_.push_back(line);
    if (!words.empty() && line.text.find(words) != std::string::npos) stop = true;
  };
  const RunEnd end = run_.until(run_.world().time() + seconds, hooks);
  INFO(run_.message());
  REQUIRE(end != RunEnd::diverged);
  return end == RunEnd::interrupted;
}

bool Trial::said(const std::string& words) const {
  return std::any_of(lines_.begin(), lines_.end(), [&](const CrewLine& line) {
    return line.text.find(words) != std::string::npos;
  });
}

std::string Trial::log() const {
  std::string out;
  for (const CrewLine& line : lines_) out += line.who + ": " + line.text + "\n";
  return out;
}

Pose Trial::robot(std::size_t number) const { return run_.crew()->robot_pose(world(), number); }

std::size_t Trial::body(const std::string& name) const {
  const auto& bodies = run_.placed().bodies;
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const SceneBody& body) { return body.name == name; });
  REQUIRE(found != bodies.end());
  return static_cast<std::size_t>(found - bodies.begin());
}

Pose Trial::block(const std::string& name) const {
  return world().state(BodyId{static_cast<std::uint32_t>(body(name))}).X_WB;
}

Pose Trial::block(std::size_t number) const {
  return world().state(run_.crew()->block_body(number)).X_WB;
}

Led Trial::led(const std::string& name) const { return run_.led(body(name)); }

double heading(const Pose& pose) {
  const Vec3 x = rotate(pose.q, {1, 0, 0});
  return std::atan2(x.y, x.x);
}

double tilt(const Pose& pose) {
  const Vec3 z = rotate(pose.q, {0, 0, 1});
  return std::atan2(std::hypot(z.x, z.y), z.z);
}

double off_square(double angle) { return std::remainder(angle, 90 * kDegree); }

}  // namespace stig::behaviour
