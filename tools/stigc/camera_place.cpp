// SPDX-License-Identifier: MIT
// A camera is named ROBOT:CAMERA, or ROBOT alone for its first one.
#include "camera_place.h"

#include <cassert>

#include <fmt/format.h>

#include "physical/render/scene_picture.h"
#include "physical/render/sensor_picture.h"

namespace stig::cli {

namespace {

constexpr int kSamples = 3;  ///< squared lines a pixel

}  // namespace

std::optional<CameraPlace> camera_named(const Simulation& run, const std::string& name,
                                        std::string& problem) {
  std::vector<std::string> names;
  const std::size_t robots = run.crew() == nullptr ? 0 : run.crew()->robots();
  for (std::size_t i = 0; i < robots; ++i) {
    const auto& cameras = run.crew()->model(i).cameras;
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      // All names are collected for the message, should none fit.
      const std::string& robot = run.crew()->robot_name(i);
      names.push_back(robot + ":" + cameras[k].name);
      if (name == names.back() || (k == 0 && name == robot)) return CameraPlace{i, k};
    }
  }
  problem = names.empty() ? "no robot of the scene has a camera"
                          : fmt::format("no camera is called '{}', but there are {}", name,
                                        fmt::join(names, ", "));
  return std::nullopt;
}

std::string view_png(const Simulation& run, const CameraPlace& place) {
  assert(run.crew() != nullptr && place.robot < run.crew()->robots());
  const Crew& crew = *run.crew();
  const CameraDevice& device = crew.model(place.robot).cameras[place.camera];
  const Pose X_WC = crew.camera_pose(run.world(), place.robot, place.camera);
  // From the same snapshot that the robot's own sensors see, line of sight by line of sight.
  return png_of(whole_numbers(camera_picture(crew.sensor_scene(run.world()), device.intrinsics,
                                             X_WC, kSamples)),
                "");
}

}  // namespace stig::cli
