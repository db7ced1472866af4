// SPDX-License-Identifier: MIT
#include "view/foxglove_schema.h"

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

namespace stig::view {

namespace {

using Schema = nlohmann::ordered_json;
using Field = std::pair<const char*, Schema>;

/// Every field is there in every message.
Schema message(const char* title, std::initializer_list<Field> fields) {
  Schema out{{"title", title}, {"type", "object"}};
  for (const auto& [name, schema] : fields) {
    out["properties"][name] = schema;
    out["required"].push_back(name);
  }
  return out;
}

Schema of_type(const char* type) { return {{"type", type}}; }
Schema text() { return of_type("string"); }
Schema number() { return of_type("number"); }
Schema flag() { return of_type("boolean"); }
Schema count() { return {{"type", "integer"}, {"minimum", 0}}; }
Schema list(Schema items) { return {{"type", "array"}, {"items", std::move(items)}}; }

/// "time" or "duration".
Schema seconds(const char* title) {
  Schema out{{"type", "object"}, {"title", title}};
  out["properties"]["sec"] = of_type("integer");
  // Spans may be negative.
  if (std::string_view(title) == "time") out["properties"]["sec"]["minimum"] = 0;
  out["properties"]["nsec"] = {{"type", "integer"}, {"minimum", 0}, {"maximum", 999'999'999}};
  return out;
}

/// Numbered from 0.
Schema words(const char* title, std::initializer_list<const char*> names) {
  Schema out{{"title", title}};
  int value = 0;
  for (const char* name : names) out["oneOf"].push_back({{"title", name}, {"const", value++}});
  return out;
}

Schema vector3() {
  return message("foxglove.Vector3", {{"x", number()}, {"y", number()}, {"z", number()}});
}
Schema point3() {
  return message("foxglove.Point3", {{"x", number()}, {"y", number()}, {"z", number()}});
}
Schema quaternion() {
  return message("foxglove.Quaternion",
                 {{"x", number()}, {"y", number()}, {"z", number()}, {"w", number()}});
}
Schema pose() {
  return message("foxglove.Pose", {{"position", vector3()}, {"orientation", quaternion()}});
}
Schema color() {
  return message("foxglove.Color",
                 {{"r", number()}, {"g", number()}, {"b", number()}, {"a", number()}});
}

Schema arrow() {
  return message("foxglove.ArrowPrimitive", {{"pose", pose()},
                                             {"shaft_length", number()},
                                             {"shaft_diameter", number()},
                                             {"head_length", number()},
                                             {"head_diameter", number()},
                                             {"color", color()}});
}
Schema cube() {
  return message("foxglove.CubePrimitive",
                 {{"pose", pose()}, {"size", vector3()}, {"color", color()}});
}
Schema sphere() {
  return message("foxglove.SpherePrimitive",
                 {{"pose", pose()}, {"size", vector3()}, {"color", color()}});
}
Schema cylinder() {
  return message("foxglove.CylinderPrimitive", {{"pose", pose()},
                                                {"size", vector3()},
                                                {"bottom_scale", number()},
                                                {"top_scale", number()},
                                                {"color", color()}});
}
Schema line() {
  return message("foxglove.LinePrimitive",
                 {{"type", words("foxglove.LineType", {"LINE_STRIP", "LINE_LOOP", "LINE_LIST"})},
                  {"pose", pose()},
                  {"thickness", number()},
                  {"scale_invariant", flag()},
                  {"points", list(point3())},
                  {"color", color()},
                  {"colors", list(color())},
                  {"indices", list(count())}});
}
Schema triangles() {
  return message("foxglove.TriangleListPrimitive", {{"pose", pose()},
                                                    {"points", list(point3())},
                                                    {"color", color()},
                                                    {"colors", list(color())},
                                                    {"indices", list(count())}});
}
Schema label() {
  return message("foxglove.TextPrimitive", {{"pose", pose()},
                                            {"billboard", flag()},
                                            {"font_size", number()},
                                            {"scale_invariant", flag()},
                                            {"color", color()},
                                            {"text", text()}});
}
Schema model() {
  Schema bytes = text();
  bytes["contentEncoding"] = "base64";
  return message("foxglove.ModelPrimitive", {{"pose", pose()},
                                             {"scale", vector3()},
                                             {"color", color()},
                                             {"override_color", flag()},
                                             {"url", text()},
                                             {"media_type", text()},
                                             {"data", bytes}});
}

Schema entity() {
  const Schema pair = message("foxglove.KeyValuePair", {{"key", text()}, {"value", text()}});
  return message("foxglove.SceneEntity", {{"timestamp", seconds("time")},
                                          {"frame_id", text()},
                                          {"id", text()},
                                          {"lifetime", seconds("duration")},
                                          {"frame_locked", flag()},
                                          {"metadata", list(pair)},
                                          {"arrows", list(arrow())},
                                          {"cubes", list(cube())},
                                          {"spheres", list(sphere())},
                                          {"cylinders", list(cylinder())},
                                          {"lines", list(line())},
                                          {"triangles", list(triangles())},
                                          {"texts", list(label())},
                                          {"models", list(model())}});
}

}  // namespace

std::string frame_transforms_schema() {
  const Schema transform = message("foxglove.FrameTransform", {{"timestamp", seconds("time")},
                                                               {"parent_frame_id", text()},
                                                               {"child_frame_id", text()},
                                                               {"translation", vector3()},
                                                               {"rotation", quaternion()}});
  return message("foxglove.FrameTransforms", {{"transforms", list(transform)}}).dump();
}

std::string scene_update_schema() {
  const Schema deletion =
      message("foxglove.SceneEntityDeletion",
              {{"timestamp", seconds("time")},
               {"type", words("foxglove.SceneEntityDeletionType", {"MATCHING_ID", "ALL"})},
               {"id", text()}});
  return message("foxglove.SceneUpdate",
                 {{"deletions", list(deletion)}, {"entities", list(entity())}})
      .dump();
}

std::string log_schema() {
  return message("foxglove.Log",
                 {{"timestamp", seconds("time")},
                  {"level", words("foxglove.LogLevel",
                                  {"UNKNOWN", "DEBUG", "INFO", "WARNING", "ERROR", "FATAL"})},
                  {"message", text()},
                  {"name", text()},
                  {"file", text()},
                  {"line", count()}})
      .dump();
}

}  // namespace stig::view
