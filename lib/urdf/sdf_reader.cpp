// SPDX-License-Identifier: MIT
// A model of SDF (sdformat.org/spec), versions 1.5 to 1.11.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "urdf/gazebo.h"
#include "urdf/readers.h"
#include "urdf/sdf_frames.h"

namespace stig::urdf {

namespace {

class SdfReader {
 public:
  SdfReader(const XmlNode& model, const Reading& reading)
      : model_(model), reading_(reading), frames_(model, reading) {}

  SdfModel read() {
    Description& robot = out_.robot;
    robot.name = reading_.name(model_);
    robot.place = model_.place;
    out_.fixed = reading_.child_flag(model_, "static");
    out_.X_WM = pose_of(model_, reading_);
    reading_.only(model_, {"link", "joint", "frame", "pose", "static", "plugin", "model", "include",
                           "allow_auto_disable", "self_collide"});
    if (too_many(model_, reading_)) return std::move(out_);
    for (const char* nested : {"model", "include"}) {
      for (const XmlNode* one : model_.all(nested)) {
        reading_.no_counterpart(one->place,
                                "a model within a model: write its links into this one");
      }
    }
    if (reading_.child_flag(model_, "self_collide"))
      say_of_collisions(*model_.child("self_collide"));
    for (const XmlNode* link : model_.all("link")) read_link(*link);
    for (const XmlNode* joint : model_.all("joint")) read_joint(*joint);
    for (const XmlNode* plugin : model_.all("plugin")) read_plugin(*plugin, robot, reading_);
    return std::move(out_);
  }

 private:
  void say_of_collisions(const XmlNode& node) const {
    reading_.left_out(node.place, "parts of one robot never collide with each other");
  }

  void read_link(const XmlNode& node) {
    Link link;
    link.name = reading_.name(node);
    link.place = node.place;
    if (link.name.empty() || out_.robot.link(link.name)) return;  // said by SdfFrames
    link.X_ML = frames_.pose(link.name);
    reading_.only(node,
                  {"pose", "inertial", "visual", "collision", "sensor", "gravity", "self_collide",
                   "kinematic", "enable_wind", "velocity_decay", "must_be_base_link"});
    if (node.child("gravity") != nullptr && !reading_.child_flag(node, "gravity")) {
      reading_.no_counterpart(node.child("gravity")->place, "gravity pulls at everything");
    }
    if (reading_.child_flag(node, "self_collide")) say_of_collisions(*node.child("self_collide"));
    if (const XmlNode* decay = node.child("velocity_decay")) {
      reading_.left_out(decay->place, "<velocity_decay> is left out: damping is of scenes");
    }
    for (const XmlNode* one : node.all("collision")) read_collision(*one, link);
    for (const XmlNode* one : node.all("visual")) read_visual(*one, link);
    read_inertial(node, link);
    const std::size_t number = out_.robot.links.size();
    const Pose X_ML = link.X_ML;
    out_.robot.links.push_back(std::move(link));
    for (const XmlNode* one : node.all("sensor")) {
      const Pose X_LS = inverse(X_ML) * frames_.pose_within(*one, out_.robot.links[number].name);
      read_sensor(*one, number, X_LS, out_.robot, reading_);
    }
  }

  void read_inertial(const XmlNode& node, Link& link) const {
    const XmlNode* inertial = node.child("inertial");
    const XmlNode* inertia = inertial == nullptr ? nullptr : inertial->child("inertia");
    if (inertia == nullptr || inertial->child("mass") == nullptr) {
      link.massive = true;
      // What stands still has no use for it; SDF takes 1 kg and 1 kg·m², which few can mean.
      if (out_.fixed) return;
      reading_.wrong(inertial == nullptr ? node.place : inertial->place,
                     fmt::format("the link {} has no <inertial> with <mass> and <inertia>",
                                 in_quotes(link.name)));
      return;
    }
    reading_.only(*inertial, {"pose", "mass", "inertia"});
    const std::size_t before = reading_.out.count(Severity::error);
    std::vector<double> six;
    for (const char* key : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
      const bool product = key[1] != key[2];
      six.push_back(
          reading_.child_number(*inertia, key, product ? std::optional(0.0) : std::nullopt));
    }
    const Pose X_LI = inverse(link.X_ML) * frames_.pose_within(*inertial, link.name);
    const double mass = reading_.child_number(*inertial, "mass");
    link.massive = true;
    if (reading_.out.count(Severity::error) > before) return;
    set_mass(link, mass, X_LI, six, inertia->place, reading_);
  }

  void read_collision(const XmlNode& node, Link& link) {
    const XmlNode* shape = shape_of(node);
    if (shape == nullptr) return;
    if (shape->name == "plane") {
      read_ground(*shape, node, link);
      return;
    }
    auto solid = read_solid(*shape, node, link);
    if (!solid) {
      reading_.no_counterpart(
          shape->place, fmt::format("<{}> that touches: put boxes, cylinders and spheres in its "
                                    "place",
                                    printable(shape->name)));
      return;
    }
    solid->friction = friction_of(node);
    link.solids.push_back(std::move(*solid));
  }

  std::optional<double> friction_of(const XmlNode& node) const {
    const XmlNode* at = &node;
    for (const char* name : {"surface", "friction", "ode"}) {
      at = at->child(name);
      if (at == nullptr) return std::nullopt;
    }
    if (at->child("mu") == nullptr) return std::nullopt;
    return reading_.child_number(*at, "mu", 1);
  }

  /// The floor, as worlds have it.
  void read_ground(const XmlNode& plane, const XmlNode& node, const Link& link) {
    Vec3 normal{0, 0, 1};
    if (const XmlNode* text = plane.child("normal")) {
      if (const auto v = reading_.numbers(text->text, text->text_place, 3)) {
        normal = reading_.direction({(*v)[0], (*v)[1], (*v)[2]}, text->text_place);
      }
    }
    const Pose X_WP = out_.X_WM * frames_.pose_within(node, link.name);
    const bool level = length(rotate(X_WP.q, normal) - Vec3{0, 0, 1}) < 1e-6;
    if (!out_.fixed || !level || std::abs(X_WP.p.z) > 1e-9) {
      reading_.no_counterpart(plane.place,
                              "a plane that is not the floor: level, static and at z = 0");
    }
    out_.ground = true;
    out_.ground_friction = friction_of(node);
  }

  const XmlNode* shape_of(const XmlNode& node) const {
    const XmlNode* geometry = node.child("geometry");
    if (geometry != nullptr && geometry->children.size() == 1) return &geometry->children[0];
    reading_.wrong(node.place, "one shape has to stand in <geometry>");
    return nullptr;
  }

  std::optional<Solid> read_solid(const XmlNode& shape, const XmlNode& node,
                                  const Link& link) const {
    std::optional<Solid> out;
    if (shape.name == "box") {
      const XmlNode* size = shape.child("size");
      const auto v =
          size == nullptr ? std::nullopt : reading_.numbers(size->text, size->text_place, 3);
      if (size == nullptr) reading_.wrong(shape.place, "<box> without <size>");
      const Vec3 edges = v ? Vec3{(*v)[0], (*v)[1], (*v)[2]} : Vec3{1, 1, 1};
      out = make_solid(ShapeType::box, edges, shape.place, reading_).value_or(Solid{});
    } else if (shape.name == "cylinder" || shape.name == "sphere") {
      const bool round = shape.name == "sphere";
      const double d = 2 * reading_.child_number(shape, "radius");
      const Vec3 size{d, d, round ? d : reading_.child_number(shape, "length")};
      out = make_solid(round ? ShapeType::sphere : ShapeType::cylinder, size, shape.place, reading_)
                .value_or(Solid{});
    }
    if (out) out->X_LS = inverse(link.X_ML) * frames_.pose_within(node, link.name);
    return out;
  }

  void read_visual(const XmlNode& node, Link& link) {
    if (const XmlNode* material = node.child("material"); material != nullptr && !link.rgb) {
      const XmlNode* colour = material->child("diffuse");
      if (colour == nullptr) colour = material->child("ambient");
      if (colour != nullptr) link.rgb = reading_.colour(colour->text, colour->text_place);
    }
    const XmlNode* shape = shape_of(node);
    if (shape == nullptr || shape->name == "plane") return;
    const auto solid = read_solid(*shape, node, link);
    const auto same = [&](const Solid& one) {
      return solid && one.shape == solid->shape && one.size == solid->size &&
             one.X_LS == solid->X_LS;
    };
    if (std::any_of(link.solids.begin(), link.solids.end(), same)) return;
    reading_.left_out(node.place, fmt::format("this <visual> of {} is left out: pictures show what "
                                              "touches",
                                              in_quotes(link.name)));
  }

  std::optional<std::size_t> linked(const XmlNode& joint, const char* key) const {
    const XmlNode* node = joint.child(key);
    if (node == nullptr || node->text.empty()) {
      reading_.wrong(joint.place, fmt::format("a joint without <{}>", key));
      return std::nullopt;
    }
    if (node->text == "world") {
      reading_.no_counterpart(node->text_place,
                              "robots stand freely: no joint holds them to the world");
      return std::nullopt;
    }
    const auto name = frames_.link_of(node->text);
    const auto link = name ? out_.robot.link(*name) : std::nullopt;
    if (!link) {
      reading_.wrong(node->text_place, fmt::format("there is no link {}", in_quotes(node->text)));
    }
    return link;
  }

  void read_joint(const XmlNode& node) {
    Joint joint;
    joint.name = reading_.name(node);
    joint.place = node.place;
    if (joint.name.empty() || out_.robot.joint(joint.name)) return;  // said by SdfFrames
    reading_.only(node, {"pose", "parent", "child", "axis", "axis2", "physics"});
    const auto parent = linked(node, "parent"), child = linked(node, "child");
    const std::string type = reading_.needed(node, "type");
    const Pose X_MJ = frames_.pose(joint.name);
    joint.p_M = X_MJ.p;
    const bool one = type == "revolute" || type == "continuous" || type == "prismatic";
    if (one || type == "universal") {
      read_axis(node, "axis", type, X_MJ.q, joint);
      if (!one) read_axis(node, "axis2", type, X_MJ.q, joint);
    } else if (!type.empty() && type != "fixed") {
      reading_.no_counterpart(node.attribute("type")->place,
                              fmt::format("joints of the type {}: robots have fixed ones, and axes "
                                          "that turn or slide",
                                          in_quotes(type)));
    }
    if (!parent || !child) return;
    joint.parent = *parent;
    joint.child = *child;
    out_.robot.joints.push_back(std::move(joint));
  }

  /// SDF writes limits that are none as infinity or 1e16.
  std::optional<double> bound(const XmlNode& limit, const char* name) const {
    const XmlNode* node = limit.child(name);
    if (node == nullptr) return std::nullopt;
    constexpr double kNoBound = 1e9;
    const double value = std::strtod(node->text.c_str(), nullptr);
    if (std::abs(value) >= kNoBound) return std::nullopt;
    return reading_.child_number(limit, name);
  }

  void read_axis(const XmlNode& joint, const char* key, const std::string& type, const Quat& q_MJ,
                 Joint& out) const {
    const XmlNode* node = joint.child(key);
    if (node == nullptr) {
      reading_.wrong(joint.place, fmt::format("a {} joint without <{}>", type, key));
      return;
    }
    Axis axis;
    axis.angular = type != "prismatic";
    axis.direction = axis_direction(*node, q_MJ);
    if (const XmlNode* limit = node->child("limit")) {
      if (type != "continuous") {
        axis.lower = bound(*limit, "lower");
        axis.upper = bound(*limit, "upper");
      }
      axis.effort = bound(*limit, "effort");
      axis.speed = bound(*limit, "velocity");
      if (axis.lower.has_value() != axis.upper.has_value()) {
        reading_.no_counterpart(limit->place, "a limit on one side alone: give both");
      }
    }
    if (const XmlNode* dynamics = node->child("dynamics")) {
      axis.damping = reading_.child_number(*dynamics, "damping", 0);
      if (reading_.child_number(*dynamics, "friction", 0) != 0) {
        reading_.left_out(dynamics->child("friction")->place,
                          "the joint's dry friction is left out: joints have 'damping' alone");
      }
      if (reading_.child_number(*dynamics, "spring_stiffness", 0) != 0) {
        reading_.no_counterpart(dynamics->child("spring_stiffness")->place,
                                "joints have no springs");
      }
    }
    if (const XmlNode* mimic = node->child("mimic")) {
      reading_.no_counterpart(mimic->place, "joints follow no others: let its program move both");
    }
    out.axes.push_back(axis);
  }

  Vec3 axis_direction(const XmlNode& axis, const Quat& q_MJ) const {
    const XmlNode* xyz = axis.child("xyz");
    if (xyz == nullptr) return rotate(q_MJ, {0, 0, 1});
    const auto v = reading_.numbers(xyz->text, xyz->text_place, 3);
    if (!v) return {0, 0, 1};
    const Vec3 direction = reading_.direction({(*v)[0], (*v)[1], (*v)[2]}, xyz->text_place);
    const XmlAttribute* in = xyz->attribute("expressed_in");
    // Older files have a flag instead.
    if (reading_.child_flag(axis, "use_parent_model_frame")) return direction;
    if (in == nullptr || in->value.empty()) return rotate(q_MJ, direction);
    return rotate(in->value == "__model__" ? Quat{} : frames_.pose(in->value).q, direction);
  }

  const XmlNode& model_;
  const Reading& reading_;
  SdfFrames frames_;
  SdfModel out_;
};

}  // namespace

SdfModel read_sdf_model(const XmlNode& model, const Reading& reading) {
  return SdfReader(model, reading).read();
}

}  // namespace stig::urdf
