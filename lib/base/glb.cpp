// SPDX-License-Identifier: MIT
// Writes binary glTF: a JSON chunk that describes, and a binary chunk with all numbers.
// Each primitive has an accessor for positions, normals and indices; bounds of positions
// are mandatory in the format. Everything is in the order of the nodes, so equal input
// gives equal bytes.
#include "base/glb.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/bytes.h"

namespace stig {

namespace {

using nlohmann::json;

// Numbers of the glTF specification. A chunk's type and the magic number are ASCII read as
// little-endian words.
constexpr std::uint32_t kMagic = 0x46546c67;  // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125, kVertices = 34962, kIndices = 34963;
constexpr int kLines = 1;
constexpr int kNoTarget = 0;  // of numbers that are no vertices

std::string bytes_of(const std::vector<float>& values) {
  std::string out;
  for (const float value : values) put(out, value);
  return out;
}
template <std::size_t N>
std::string bytes_of(const std::vector<std::array<float, N>>& values) {
  std::string out;
  for (const auto& value : values) {
    for (const float part : value) put(out, part);
  }
  return out;
}

class Document {
 public:
  Document() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "stigc"}};
    json_["scene"] = 0;
    json_["scenes"] = json::array({json::object()});
  }

  // Nodes are listed in the order in which they were given, so numbers of parents are right
  // as they are.
  void add(const std::vector<GlbNode>& nodes, std::size_t number) {
    const GlbNode& node = nodes[number];
    assert(node.parent < static_cast<int>(number));
    json out = {{"name", node.name}};
    if (!node.primitives.empty()) {
      out["mesh"] = json_.contains("meshes") ? json_["meshes"].size() : 0;
      json mesh = {{"primitives", json::array()}};
      for (const GlbPrimitive& primitive : node.primitives) {
        mesh["primitives"].push_back(add(primitive));
      }
      json_["meshes"].push_back(std::move(mesh));
    }
    if (node.X_PN != Pose{}) {
      const Pose& X = node.X_PN;
      out["translation"] = {X.p.x, X.p.y, X.p.z};
      out["rotation"] = {X.q.x, X.q.y, X.q.z, X.q.w};
    }
    for (std::size_t i = number + 1; i < nodes.size(); ++i) {
      if (nodes[i].parent == static_cast<int>(number)) out["children"].push_back(i);
    }
    json_["nodes"].push_back(std::move(out));
    if (node.parent < 0) json_["scenes"][0]["nodes"].push_back(number);
  }

  void add(const std::vector<GlbMotion>& motions, const std::string& name) {
    if (motions.empty()) return;
    json animation = {{"name", name}, {"channels", json::array()}, {"samplers", json::array()}};
    for (const GlbMotion& motion : motions) {
      assert(!motion.times.empty() && std::is_sorted(motion.times.begin(), motion.times.end()));
      json& times =
          accessor(bytes_of(motion.times), kNoTarget, kFloat, motion.times.size(), "SCALAR");
      // The format demands the bounds of times alone.
      times["min"] = {motion.times.front()};
      times["max"] = {motion.times.back()};
      const std::size_t input = last();
      const auto channel = [&](const auto& values, const char* shape, const char* path) {
        if (values.empty()) return;
        assert(values.size() == motion.times.size());
        accessor(bytes_of(values), kNoTarget, kFloat, values.size(), shape);
        animation["channels"].push_back({{"sampler", animation["samplers"].size()},
                                         {"target", {{"node", motion.node}, {"path", path}}}});
        animation["samplers"].push_back({{"input", input},
                                         {"output", last()},
                                         {"interpolation", motion.stepped ? "STEP" : "LINEAR"}});
      };
      channel(motion.translations, "VEC3", "translation");
      channel(motion.rotations, "VEC4", "rotation");
      channel(motion.scales, "VEC3", "scale");
    }
    json_["animations"] = json::array({std::move(animation)});
  }

  std::string finish() {
    if (!binary_.empty()) json_["buffers"] = json::array({{{"byteLength", binary_.size()}}});
    std::string text = json_.dump(-1, ' ', false, json::error_handler_t::replace);
    // Chunks are padded to four bytes, JSON with spaces.
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t total = 12 + 8 + text.size() + (binary_.empty() ? 0 : 8 + binary_.size());
    assert(total <= std::numeric_limits<std::uint32_t>::max());
    std::string out;
    for (const std::size_t value : {std::size_t{kMagic}, std::size_t{2}, total, text.size()}) {
      put(out, static_cast<std::uint32_t>(value));
    }
    put(out, kJsonChunk);
    out += text;
    if (binary_.empty()) return out;
    put(out, static_cast<std::uint32_t>(binary_.size()));
    put(out, kBinaryChunk);
    return out + binary_;
  }

 private:
  json add(const GlbPrimitive& primitive) {
    json& positions = accessor(primitive.positions, kVertices, kFloat, primitive.vertices, "VEC3");
    positions["min"] = primitive.low;
    positions["max"] = primitive.high;
    json out = {{"attributes", {{"POSITION", last()}}}};
    if (!primitive.lines) {
      accessor(primitive.normals, kVertices, kFloat, primitive.vertices, "VEC3");
      out["attributes"]["NORMAL"] = last();
    }
    accessor(primitive.indices, kIndices, kUnsignedInt, primitive.corners, "SCALAR");
    out["indices"] = last();
    out["material"] = json_.contains("materials") ? json_["materials"].size() : 0;
    if (primitive.lines) out["mode"] = kLines;
    json_["materials"].push_back(material(primitive));
    return out;
  }

  std::size_t last() const { return json_["accessors"].size() - 1; }

  // All parts are of whole 4-byte numbers, so every view starts aligned. `target` tells
  // viewers whether a view holds vertices or indices.
  json& accessor(const std::string& bytes, int target, int type, std::size_t count,
                 const char* shape) {
    json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
    if (target != kNoTarget) view["target"] = target;
    json_["bufferViews"].push_back(std::move(view));
    binary_ += bytes;
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", type},
                                  {"count", count},
                                  {"type", shape}});
    return json_["accessors"].back();
  }

  // glTF's base colours are linear; the palette's are sRGB.
  static json material(const GlbPrimitive& of) {
    return {{"name", of.material},
            {"pbrMetallicRoughness",
             {{"baseColorFactor",
               {linear_light(of.rgb.r), linear_light(of.rgb.g), linear_light(of.rgb.b), 1.0}},
              {"metallicFactor", 0.0},
              {"roughnessFactor", 0.8}}}};
  }

  json json_;
  std::string binary_;
};

}  // namespace

/// The bounds are taken from the values as stored, in single precision: validators compare
/// them exactly.
std::uint32_t GlbPrimitive::add_vertex(const std::array<float, 3>& at,
                                       const std::array<float, 3>& normal) {
  assert(lines || normals.size() == positions.size());
  if (vertices == 0) low = high = at;
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], at[i]);
    high[i] = std::max(high[i], at[i]);
    put(positions, at[i]);
    if (!lines) put(normals, normal[i]);
  }
  return vertices++;
}

void GlbPrimitive::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  assert(!lines && a < vertices && b < vertices && c < vertices);
  for (const std::uint32_t corner : {a, b, c}) put(indices, corner);
  corners += 3;
}

void GlbPrimitive::add_line(std::uint32_t a, std::uint32_t b) {
  assert(lines && a < vertices && b < vertices);
  put(indices, a);
  put(indices, b);
  corners += 2;
}

std::string glb_file(const std::vector<GlbNode>& nodes, const std::vector<GlbMotion>& motions,
                     const std::string& name) {
  Document document;
  for (std::size_t i = 0; i < nodes.size(); ++i) document.add(nodes, i);
  document.add(motions, name);
  return document.finish();
}

}  // namespace stig
