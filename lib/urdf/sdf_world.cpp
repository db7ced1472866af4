// SPDX-License-Identifier: MIT
#include "urdf/sdf_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.h"
#include "base/yaml.h"
#include "urdf/moments.h"
#include "urdf/robot_text.h"

namespace stig::urdf {

namespace {

constexpr double kUsualFriction = 0.5;
constexpr double kUsualMass = 0.1;  ///< kg, of a block that stands fast

/// A part of a file's name.
std::string plain_name(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    out += plain ? c : '-';
  }
  return out.empty() ? "model" : out;
}

class WorldReader {
 public:
  WorldReader(const XmlNode& world, const std::string& stem, const Reading& reading)
      : world_(world), stem_(stem), reading_(reading) {}

  ImportedDescription read() {
    reading_.only(world_, {"model", "include", "physics", "gravity", "light", "scene", "gui"});
    out_.scene = true;
    for (const XmlNode* include : world_.all("include")) read_include(*include);
    constexpr std::size_t kMostModels = 1000;
    if (world_.all("model").size() > kMostModels) {
      reading_.no_counterpart(world_.place, "more than 1000 models");
      return std::move(out_);
    }
    for (const XmlNode* model : world_.all("model")) read_model(*model);
    std::string text = "stigc_scene: 1\n";
    if (const XmlAttribute* name = world_.attribute("name")) {
      text += fmt::format("title: {}\n", yaml_text(name->value, false));
    }
    text += settings();
    if (!blocks_.empty()) text += "blocks:\n" + blocks_;
    if (!robots_.empty()) text += "robots:\n" + robots_;
    out_.text = std::move(text);
    return std::move(out_);
  }

 private:
  void read_include(const XmlNode& node) {
    const std::string uri = child_text(node, "uri");
    if (uri.ends_with("ground_plane") || uri.ends_with("Ground Plane")) {
      ground_ = true;
    } else if (!uri.ends_with("sun") && !uri.ends_with("Sun")) {
      reading_.no_counterpart(
          node.place, fmt::format("{} is not read: write the model itself here", in_quotes(uri)));
    }
  }

  std::string settings() const {
    std::string out;
    const XmlNode* physics = world_.child("physics");
    const XmlNode* gravity = world_.child("gravity");
    if (gravity == nullptr && physics != nullptr) gravity = physics->child("gravity");
    if (gravity != nullptr) {
      const auto g = reading_.numbers(gravity->text, gravity->text_place, 3);
      if (g && ((*g)[0] != 0 || (*g)[1] != 0 || (*g)[2] > 0)) {
        reading_.no_counterpart(gravity->text_place, "gravity pulls down, along z");
      }
      if (g) out += fmt::format("gravity: {}\n", figure(-(*g)[2]));
    }
    if (physics != nullptr && physics->child("max_step_size") != nullptr) {
      const double step = reading_.child_number(*physics, "max_step_size");
      constexpr double kMostStep = 0.02;
      if (step > 0 && step <= kMostStep) {
        out += fmt::format("step: {}\n", figure(step));
      } else {
        reading_.left_out(physics->child("max_step_size")->place,
                          "steps are at most 0.02 s: the usual one is taken");
      }
    }
    if (!ground_) out += "floor: false\n";
    return out;
  }

  void read_model(const XmlNode& node) {
    if (const XmlNode* pose = node.child("pose")) {
      const XmlAttribute* to = pose->attribute("relative_to");
      if (to != nullptr && !to->value.empty() && to->value != "world") {
        reading_.no_counterpart(to->place,
                                "a model's pose relative to another: give it in the world");
      }
    }
    SdfModel model = read_sdf_model(node, reading_);
    if (!names_.insert(model.robot.name).second) {
      reading_.wrong(node.place,
                     fmt::format("two models are called {}", in_quotes(model.robot.name)));
    }
    if (model.ground) {
      ground_ = true;
      if (model.ground_friction) {
        reading_.left_out(node.place,
                          "the floor's friction is left out: it is of pairs of materials, "
                          "in the key 'friction'");
      }
      return;
    }
    if (is_cube(model)) return add_block(model);
    if (model.fixed) {
      reading_.no_counterpart(
          node.place, fmt::format("{} stands fast: of what is no robot scenes have cubes alone",
                                  in_quotes(model.robot.name)));
      return;
    }
    add_robot(std::move(model));
  }

  static bool is_cube(const SdfModel& model) {
    const Description& robot = model.robot;
    if (robot.links.size() != 1 || robot.links[0].solids.size() != 1 || robot.drive ||
        !robot.cameras.empty() || !robot.rays.empty()) {
      return false;
    }
    const Solid& solid = robot.links[0].solids[0];
    return solid.shape == ShapeType::box && solid.size.x == solid.size.y &&
           solid.size.y == solid.size.z;
  }

  void add_block(const SdfModel& model) {
    const Link& link = model.robot.links[0];
    const Solid& cube = link.solids[0];
    if (!model.fixed && link.mass > 0) check_cube(link);
    const double side = cube.size.x, mass = link.mass > 0 ? link.mass : kUsualMass;
    const std::string file = part(
        "block",
        fmt::format("stigc_block: 1\nname: block\nbody: {{side: {}, mass: {}, friction: {}}}\n",
                    figure(side), figure(mass), figure(cube.friction.value_or(kUsualFriction))));
    const Pose X_WB = model.X_WM * link.X_ML * cube.X_LS;
    blocks_ +=
        fmt::format("  - {{name: {}, file: {}, at: {}, turn: {}{}}}\n",
                    yaml_text(model.robot.name, true), yaml_text(file, true), figures(X_WB.p),
                    figures(degrees_zyx(normalised(X_WB.q))), model.fixed ? ", fixed: true" : "");
  }

  /// Blocks have their mass in their middle, and the moments of a solid.
  void check_cube(const Link& link) const {
    const Solid& cube = link.solids[0];
    const double solid = link.mass * cube.size.x * cube.size.x / 6;
    const Principal is = principal_moments(link.moments);
    const double off = std::max({std::abs(is.moments.x - solid), std::abs(is.moments.y - solid),
                                 std::abs(is.moments.z - solid)});
    constexpr double kSlack = 0.01;
    if (off <= kSlack * solid && length(link.p_LC - cube.X_LS.p) <= kSlack * cube.size.x) return;
    reading_.no_counterpart(link.place,
                            fmt::format("the cube {} has not the moments of a solid, {} "
                                        "kg·m², about its middle, as blocks have them",
                                        in_quotes(link.name), figure(solid)));
  }

  void add_robot(SdfModel model) {
    Description& robot = model.robot;
    // After an error a link may have no mass.
    if (reading_.out.has_errors() || !fold_frames(robot, reading_)) return;
    const RobotText text = robot_text(robot, file_name(robot.place), reading_);
    const Mat3 r = matrix(model.X_WM.q);
    if (r.z.z < 1 - 1e-9) {
      reading_.no_counterpart(robot.place,
                              fmt::format("{} does not stand upright: robots begin on the "
                                          "floor",
                                          in_quotes(robot.name)));
    }
    const double above = model.X_WM.p.z + text.lowest;
    if (std::abs(above) > 1e-3) {
      reading_.left_out(robot.place, fmt::format("{} begins {:.4g} m {} the floor: it is put on it",
                                                 in_quotes(robot.name), std::abs(above),
                                                 above > 0 ? "above" : "below"));
    }
    const std::string file = part(plain_name(robot.name), text.text);
    robots_ +=
        fmt::format("  - {{file: {}, name: {}, at: [{}, {}], heading: {}}}\n",
                    yaml_text(file, true), yaml_text(robot.name, true), figure(model.X_WM.p.x),
                    figure(model.X_WM.p.y), figure(degrees_zyx(model.X_WM.q).x));
  }

  /// The name of the part that has this text; a new one where there is none.
  std::string part(const std::string& kind, const std::string& text) {
    const auto known = std::find_if(out_.parts.begin(), out_.parts.end(),
                                    [&](const ImportedFile& one) { return one.text == text; });
    if (known != out_.parts.end()) return known->name;
    std::string name = fmt::format("{}-{}.yaml", stem_, kind);
    for (int i = 2; !files_.insert(name).second; ++i)
      name = fmt::format("{}-{}-{}.yaml", stem_, kind, i);
    out_.parts.push_back({name, text});
    return name;
  }

  const XmlNode& world_;
  std::string stem_;
  const Reading& reading_;
  ImportedDescription out_;
  std::set<std::string> names_, files_;
  std::string blocks_, robots_;
  bool ground_ = false;
};

}  // namespace

ImportedDescription import_world(const XmlNode& world, const std::string& stem,
                                 const Reading& reading) {
  return WorldReader(world, stem, reading).read();
}

}  // namespace stig::urdf
