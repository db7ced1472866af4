// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "base/bytes.h"
#include "lattice/mesh_files.h"
#include "lattice/rgb.h"

namespace stig {

namespace {

using nlohmann::json;

// Numbers of the glTF specification.
constexpr std::uint32_t kMagic = 0x46546c67;  // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125, kVertices = 34962, kIndices = 34963;

struct Primitive {
  std::string positions, normals, indices;
  std::uint32_t vertices = 0, corners = 0;
  std::array<float, 3> low, high;
};

std::array<float, 3> y_up(Point p, double scale) {
  return {static_cast<float>(p.x * scale), static_cast<float>(p.z * scale),
          static_cast<float>(-p.y * scale)};
}

void add_vertex(Primitive& to, const std::array<float, 3>& at, const std::array<float, 3>& normal) {
  if (to.vertices++ == 0) to.low = to.high = at;
  for (std::size_t i = 0; i < 3; ++i) {
    to.low[i] = std::min(to.low[i], at[i]);
    to.high[i] = std::max(to.high[i], at[i]);
    put(to.positions, at[i]);
    put(to.normals, normal[i]);
  }
}

std::map<Colour, Primitive> primitives_of(const Mesh& mesh, double scale) {
  std::map<Colour, Primitive> primitives;
  for (const Polygon& polygon : mesh.polygons) {
    Primitive& to = primitives[polygon.colour];
    const std::uint32_t first = to.vertices;
    const auto normal = y_up(cell_faces(mesh.lattice)[polygon.face].normal, 1);
    for (std::size_t i = 0; i < polygon.corners; ++i) {
      add_vertex(to, y_up(position(mesh.lattice, polygon.corner[i]), scale), normal);
    }
    for (std::uint32_t i = 2; i < polygon.corners; ++i) {
      for (const std::uint32_t corner : {0U, i - 1, i}) put(to.indices, first + corner);
      to.corners += 3;
    }
  }
  return primitives;
}

class Document {
 public:
  explicit Document(const std::vector<Brick>& bricks) : bricks_(bricks) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "stigc"}};
    json_["scene"] = 0;
    json_["scenes"] = json::array({json::object()});
  }

  void add(Colour colour, const Primitive& primitive) {
    json& positions = accessor(primitive.positions, kVertices, kFloat, primitive.vertices, "VEC3");
    positions["min"] = primitive.low;
    positions["max"] = primitive.high;
    accessor(primitive.normals, kVertices, kFloat, primitive.vertices, "VEC3");
    accessor(primitive.indices, kIndices, kUnsignedInt, primitive.corners, "SCALAR");
    const std::size_t last = json_["accessors"].size();
    json_["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", last - 3}, {"NORMAL", last - 2}}},
         {"indices", last - 1},
         {"material", json_["materials"].size()}});
    json_["materials"].push_back(material(colour));
  }

  std::string finish() {
    if (!binary_.empty()) {
      json_["buffers"] = json::array({{{"byteLength", binary_.size()}}});
      json_["nodes"] = json::array({{{"mesh", 0}, {"name", "structure"}}});
      json_["scenes"][0]["nodes"] = json::array({0});
    }
    std::string text = json_.dump(-1, ' ', false, json::error_handler_t::replace);
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
  // All parts are of whole 4-byte numbers, so every view starts aligned.
  json& accessor(const std::string& bytes, int target, int type, std::uint32_t count,
                 const char* shape) {
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", binary_.size()},
                                    {"byteLength", bytes.size()},
                                    {"target", target}});
    binary_ += bytes;
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", type},
                                  {"count", count},
                                  {"type", shape}});
    return json_["accessors"].back();
  }

  json material(Colour colour) const {
    const Rgb rgb = rgb_of(bricks_, colour);
    const bool named = colour <= bricks_.size() && !bricks_[colour - 1U].name.empty();
    return {
        {"name", named ? bricks_[colour - 1U].name : symbol_of(bricks_, colour)},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {linear_light(rgb.r), linear_light(rgb.g), linear_light(rgb.b), 1.0}},
          {"metallicFactor", 0.0},
          {"roughnessFactor", 0.8}}}};
  }

  const std::vector<Brick>& bricks_;
  json json_;
  std::string binary_;
};

}  // namespace

std::string print_glb(const Mesh& mesh, const std::vector<Brick>& bricks, double scale) {
  Document document(bricks);
  for (const auto& [colour, primitive] : primitives_of(mesh, scale)) {
    document.add(colour, primitive);
  }
  return document.finish();
}

}  // namespace stig
