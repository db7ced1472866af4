// SPDX-License-Identifier: MIT
// What a robot shows travels as JSON in a trace's frames, and is read back when a picture of the
// trace is drawn. The trace may be somebody else's, so nothing in it is believed: other shapes than
// those written here are passed over.
#include "physical/render/show_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace stig::physics {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kWidth = 3;     ///< pixels
constexpr double kHead = 0.25;   ///< of the arrow's length
constexpr double kNearer = 0.3;  ///< seen through bodies, as a mind's picture may be
constexpr std::size_t kMostArrows = 256;

Json json_of(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

/// Whatever is no vector is 0.
Vec3 vector_of(const Json& json) {
  const auto part = [&](std::size_t i) {
    return json.is_array() && i < json.size() && json[i].is_number() ? json[i].get<double>() : 0;
  };
  return {part(0), part(1), part(2)};
}

void add_arrow(const Vec3& from, const Vec3& to, Rgb colour, std::vector<PictureLine>& lines) {
  lines.push_back({from, to, kWidth, colour, kNearer});
  const Vec3 way = to - from;
  // The arrow's head lies flat, unless the arrow is upright.
  const Vec3 up = std::abs(way.z) < 0.9 * length(way) ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 side = cross(way, up);
  if (length(side) < 1e-12) return;
  const Vec3 half = side * (kHead / 2 * length(way) / length(side));
  for (const double sign : {1.0, -1.0}) {
    lines.push_back({to, to - way * kHead + half * sign, kWidth, colour, kNearer});
  }
}

}  // namespace

std::string show_json(const UserData& shown, const Pose& X_BR) {
  Json out = Json::object();
  for (const auto& [name, number] : shown.numbers) out["numbers"][name] = number;
  for (const auto& [name, text] : shown.texts) out["texts"][name] = text;
  // Arrows are in the robot's frame; kept in that of its root body, which a trace has poses of.
  for (const Arrow& arrow : shown.arrows) {
    out["arrows"].push_back(
        {json_of(X_BR * arrow.from), json_of(X_BR * arrow.to), to_color(arrow.rgb)});
  }
  // Texts of programs need not be UTF-8; what is not is replaced.
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<PictureLine> show_lines(std::string_view json, const Pose& X_WB) {
  // `false`: no exception, but a value that is no object.
  const Json shown = Json::parse(json, nullptr, false);
  std::vector<PictureLine> out;
  if (!shown.is_object() || !shown.contains("arrows")) return out;
  const Json& arrows = shown["arrows"];
  for (std::size_t i = 0; i < std::min(arrows.size(), kMostArrows); ++i) {
    const Json& arrow = arrows[i];
    if (!arrow.is_array() || arrow.size() != 3 || !arrow[2].is_string()) continue;
    const Rgb colour = parse_color(arrow[2].get<std::string>()).value_or(Rgb{});
    add_arrow(X_WB * vector_of(arrow[0]), X_WB * vector_of(arrow[1]), colour, out);
  }
  return out;
}

}  // namespace stig::physics
