// SPDX-License-Identifier: MIT
// The JSON in a pose trace's header. As the file may be anybody's, every number is checked, and
// nothing is made of a list before its length is.
#include "physical/trace/pose_trace_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "physical/trace/pose_trace_format.h"

namespace stig::physics {

namespace {

constexpr std::size_t kMostBodies = 1'000'000;

/// A whole number from 0; throws on anything else. Such exceptions, and those of the JSON library,
/// end in read_header_json.
std::uint64_t whole(const nlohmann::json& json) {
  if (!json.is_number_unsigned()) throw std::range_error("whole number");
  return json.get<std::uint64_t>();
}

ShapeKind shape_from(const std::string& name) {
  for (std::size_t i = 0; i < kShapeNames.size(); ++i) {
    if (kShapeNames[i] == name) return static_cast<ShapeKind>(i);
  }
  throw std::range_error("shape");
}

Shape shape_from(const nlohmann::json& json, const Vec3& half) {
  const ShapeKind kind = shape_from(json.at("shape").get<std::string>());
  if (kind == ShapeKind::cylinder) return Shape::cylinder(half.x, half.z * 2);
  if (kind != ShapeKind::hull) return {kind, half, {}};
  // Checked before the hull is made: that takes time with the square of the points.
  if (json.at("points").size() > kMostHullPoints) throw std::range_error("points");
  std::vector<Vec3> points;
  for (const auto& p : json.at("points").get<std::vector<std::array<double, 3>>>()) {
    points.push_back({p[0], p[1], p[2]});
  }
  Shape hull = Shape::hull(points);
  if (!hull.convex || !(hull.radius() <= 1000)) throw std::range_error("points");
  return hull;
}

std::shared_ptr<const VisualMesh> visual_from(const nlohmann::json& json) {
  auto out = std::make_shared<VisualMesh>();
  for (const auto& p : json.at("points").get<std::vector<std::array<double, 3>>>()) {
    if (!(std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) <= 1000)) {
      throw std::range_error("points");
    }
    out->points.push_back({p[0], p[1], p[2]});
  }
  for (const auto& corners : json.at("triangles")) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t corner = whole(corners.at(i));
      if (corner >= out->points.size()) throw std::range_error("triangles");
      triangle[i] = static_cast<std::uint32_t>(corner);
    }
    out->triangles.push_back(triangle);
  }
  return out;
}

TraceBody body_from(const nlohmann::json& json) {
  TraceBody body;
  body.name = json.at("name").get<std::string>();
  const auto half = json.at("half").get<std::array<double, 3>>();
  const auto led = led_of(json.at("led").get<std::string>());
  const auto rgb = parse_color(json.at("color").get<std::string>());
  if (!led || !rgb) throw std::range_error("colour");
  for (const double x : half) {
    if (!(x > 0 && x <= 1000)) throw std::range_error("half");
  }
  body.shape = shape_from(json, {half[0], half[1], half[2]});
  body.led = *led;
  body.rgb = *rgb;
  body.block = json.at("block").get<bool>();
  body.fixed = json.at("fixed").get<bool>();
  if (json.contains("surface")) body.visual = visual_from(json["surface"]);
  return body;
}

/// Throws on anything that is not a header.
void fill_header(std::string_view text, PoseTraceHeader& header) {
  const auto json = nlohmann::json::parse(text);
  header.title = json.at("title").get<std::string>();
  header.seed = whole(json.at("seed"));
  header.step = json.at("step").get<double>();
  header.frame_every = whole(json.at("frame_every"));
  header.hash_every = whole(json.at("hash_every"));
  header.channels = json.at("channels").get<std::vector<std::string>>();
  if (!(header.step > 0 && header.step <= 1) || header.frame_every == 0 || header.hash_every == 0 ||
      json.at("bodies").size() > kMostBodies) {
    throw std::range_error("header");
  }
  for (const auto& body : json.at("bodies")) header.bodies.push_back(body_from(body));
}

}  // namespace

bool read_header_json(std::string_view text, PoseTraceHeader& header) {
  try {
    fill_header(text, header);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace stig::physics
