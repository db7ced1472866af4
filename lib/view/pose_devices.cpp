// SPDX-License-Identifier: MIT
// A trace that others have made may carry any text for a scene: what cannot be read, or has other
// bodies than the trace, is passed over without a word, since all else can still be shown.
#include "view/pose_devices.h"

#include <nlohmann/json.hpp>

#include "base/text.h"
#include "physical/simulation/loaded_scene.h"
#include "sensing/camera_view.h"
#include "view/robot_program.h"

namespace stig::view {

namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

// The page's frames have quaternions in the order x, y, z, w.
Json camera_device_json(const CameraDevice& camera, std::uint32_t body) {
  Json out{{"name", printable(camera.name)},
           {"body", body},
           {"p", vector_json(camera.X_BC.p)},
           {"q", {camera.X_BC.q.x, camera.X_BC.q.y, camera.X_BC.q.z, camera.X_BC.q.w}},
           {"size", {camera.intrinsics.width, camera.intrinsics.height}},
           {"focal", {camera.intrinsics.fx, camera.intrinsics.fy}},
           {"centre", {camera.intrinsics.cx, camera.intrinsics.cy}},
           {"corners", Json::array()}};
  const auto view = make_view(camera.intrinsics, camera.near, camera.far);
  if (!view) return out;
  for (const Vec3& corner : frustum_corners(*view)) out["corners"].push_back(vector_json(corner));
  return out;
}

/// The coefficients of what it tells: none, metres; two, power; three, quadratic.
Json calibration_json(const RangeDevice& range) {
  using Calibration = RangeDevice::Calibration;
  const auto& c = range.coefficients;
  if (range.calibration == Calibration::metres) return Json::array();
  if (range.calibration == Calibration::power) return Json::array({c[0], c[1]});
  return Json::array({c[0], c[1], c[2]});
}

Json robot_json(const Scene& scene, const PlacedScene& placed, std::size_t number) {
  const RobotSpawn& spawn = scene.robots[number];
  const RobotModel& model = scene.robot_models[spawn.model];
  const auto body = [&](std::size_t place) {
    return static_cast<std::uint32_t>(placed.robots[number].bodies[place]);
  };
  const bool has = spawn.program < scene.programs.size();
  Json out{
      {"name", printable(spawn.name)},  {"root", body(model.root())},
      {"period", model.control_period}, {"program", has ? static_cast<int>(spawn.program) : -1},
      {"cameras", Json::array()},       {"ranges", Json::array()},
      {"radios", Json::array()}};
  for (const CameraDevice& camera : model.cameras) {
    out["cameras"].push_back(camera_device_json(camera, body(camera.body)));
  }
  for (const RangeDevice& range : model.rangefinders) {
    out["ranges"].push_back({{"name", printable(range.name)},
                             {"body", body(range.body)},
                             {"from", vector_json(range.p_B)},
                             {"way", vector_json(range.direction)},
                             {"range", range.range},
                             {"calibration", calibration_json(range)}});
  }
  for (const RadioDevice& radio : model.radios) {
    out["radios"].push_back({{"name", printable(radio.name)},
                             {"body", body(radio.body)},
                             {"at", vector_json(radio.p_B)},
                             {"range", radio.range}});
  }
  return out;
}

}  // namespace

Json devices_json(const PoseTrace& trace) {
  Json out{{"robots", Json::array()},
           {"programs", Json::array()},
           {"magnets", Json::array()},
           {"blocks", Json::array()}};
  Diagnostics ignored;
  const auto loaded = load_scene(trace.header.files, trace.header.seed, ignored);
  if (!loaded || loaded->placed.bodies.size() != trace.header.bodies.size()) return out;
  const auto& [scene, placed] = *loaded;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    out["robots"].push_back(robot_json(scene, placed, i));
  }
  for (const LuaProgram& program : scene.programs) {
    out["programs"].push_back(program_json(program.text));
  }
  for (const BlockModel& model : scene.models) {
    Json places = Json::array();
    if (scene.magnets) {
      for (const Vec3& place : model.magnet_places()) places.push_back(vector_json(place));
    }
    out["magnets"].push_back(std::move(places));
  }
  for (std::size_t i = 0; i < placed.bodies.size(); ++i) {
    out["blocks"].push_back(placed.bodies[i].block ? static_cast<int>(block_model(scene, placed, i))
                                                   : -1);
  }
  return out;
}

}  // namespace stig::view
