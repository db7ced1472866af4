// SPDX-License-Identifier: MIT
// Numbers are rounded to what can be told apart on a screen: detailed traces are long.
#include "physical/simulation/detail_json.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
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

constexpr double kPlaces = 1e3;  ///< of a metre
constexpr double kForces = 10;   ///< of a newton
constexpr double kDirections = 100;

/// Whole numbers are written as they are: there are a thousand such lists a second.
void put_whole(std::string& out, const Vec3& v, double parts) {
  const auto whole = [parts](double part) { return std::llround(part * parts); };
  fmt::format_to(std::back_inserter(out), "{},{},{}", whole(v.x), whole(v.y), whole(v.z));
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
  std::string out = "[";
  for (std::size_t i = 0; i < magnets; ++i) {
    if (i > 0) out += ',';
    put_whole(out, rotate(q_BW, world.magnet_direction(body, i)), kDirections);
  }
  return out + "]";
}

std::string contacts_json(std::span<const ContactForce> contacts) {
  std::string out = "[";
  for (const ContactForce& one : contacts) {
    const bool floor = one.b == kFloorId;
    out += out.size() > 1 ? ",[" : "[";
    out += floor ? "-1" : std::to_string(static_cast<std::uint32_t>(one.b));
    out += ',';
    put_whole(out, one.p_W, kPlaces);
    out += ',';
    put_whole(out, one.force, kForces);
    out += ']';
  }
  return out + "]";
}

std::string force_json(const Vec3& force) {
  std::string out = "[";
  put_whole(out, force, kForces);
  return out + "]";
}

}  // namespace stig::physics
