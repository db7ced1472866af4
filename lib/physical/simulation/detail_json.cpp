// SPDX-License-Identifier: MIT
// Numbers are rounded to what can be told apart on a screen: detailed traces are long.
#include "physical/simulation/detail_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace stig::physics {

namespace {

using Json = nlohmann::ordered_json;

/// Adding zero takes the sign off a zero.
double rounded(double value, double parts) { return std::round(value * parts) / parts + 0.0; }

Json pixels(const ImagePoint& point) {
  return Json::array({rounded(point.x, 10), rounded(point.y, 10)});
}

Json camera_json(const CameraReading& camera) {
  Json out = Json::object();
  for (const TagReading& tag : camera.tags) {
    Json corners = Json::array();
    for (const ImagePoint& corner : tag.corners) {
      for (const Json& part : pixels(corner)) corners.push_back(part);
    }
    const Vec3& p = tag.p_CT;
    out["tags"].push_back(
        {tag.id, corners, {rounded(p.x, 1e4), rounded(p.y, 1e4), rounded(p.z, 1e4)}});
  }
  for (const LedReading& led : camera.leds) {
    Json one = pixels(led.centre);
    for (const double part : {led.y, led.u, led.v}) one.push_back(std::round(part));
    out["leds"].push_back(std::move(one));
  }
  return out;
}

constexpr double kPlaces = 1e4;  ///< of a metre
constexpr double kForces = 100;  ///< of a newton

void put_whole(Json& out, const Vec3& v, double parts) {
  for (const double part : {v.x, v.y, v.z}) {
    out.push_back(static_cast<std::int64_t>(std::llround(part * parts)));
  }
}

/// Writes every message of every radio, with the radio's number.
void put_messages(Json& out, const char* name, const std::vector<std::vector<Message>>& radios) {
  for (std::size_t i = 0; i < radios.size(); ++i) {
    for (const Message& message : radios[i]) out[name].push_back({i, message});
  }
}

}  // namespace

std::string senses_json(const RobotModel& model, const RobotReadings& readings,
                        const RobotCommands& commands) {
  Json out = Json::object();
  for (const RangeReading& range : readings.rangefinders) {
    out["ranges"].push_back(rounded(range.proximity, 1e4));
  }
  if (model.drive) {
    out["wheels"] = {rounded(readings.left_encoder, 1e4), rounded(readings.right_encoder, 1e4)};
  }
  if (model.lift) out["lift"] = rounded(readings.lift.position, 1e4);
  if (model.magnets) out["charge"] = rounded(readings.magnet_voltage, 100);
  for (const CameraReading& camera : readings.cameras) {
    out["cameras"].push_back(camera_json(camera));
  }
  put_messages(out, "heard", readings.radios);
  put_messages(out, "sent", commands.sends);
  // Messages need not be UTF-8; what is not is replaced.
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string magnets_json(const World& world, BodyId body, std::size_t magnets) {
  const Quat q_BW = conjugate(world.state(body).X_WB.q);
  Json out = Json::array();
  for (std::size_t i = 0; i < magnets; ++i) {
    const Vec3 direction = rotate(q_BW, world.magnet_direction(body, i));
    for (const double part : {direction.x, direction.y, direction.z}) {
      out.push_back(static_cast<int>(std::lround(part * 100)));
    }
  }
  return out.dump();
}

std::string contacts_json(std::span<const ContactForce> contacts) {
  Json out = Json::array();
  for (const ContactForce& one : contacts) {
    Json row = Json::array();
    row.push_back(one.b == kFloorId ? -1 : static_cast<std::int64_t>(one.b));
    put_whole(row, one.p_W, kPlaces);
    put_whole(row, one.force, kForces);
    out.push_back(std::move(row));
  }
  return out.dump();
}

std::string force_json(const Vec3& force) {
  Json out = Json::array();
  put_whole(out, force, kForces);
  return out.dump();
}

}  // namespace stig::physics
