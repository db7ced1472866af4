// SPDX-License-Identifier: MIT
// URDF (wiki.ros.org/urdf/XML), with the parts of SDF that <gazebo> brings.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/text.h"
#include "urdf/gazebo.h"
#include "urdf/readers.h"

namespace stig::urdf {

namespace {

class UrdfReader {
 public:
  UrdfReader(const XmlNode& root, const Reading& reading) : root_(root), reading_(reading) {}

  Description read() {
    robot_.name = reading_.name(root_);
    robot_.place = root_.place;
    reading_.only(root_, {"link", "joint", "material", "gazebo", "transmission", "ros2_control"});
    if (too_many(root_, reading_)) return std::move(robot_);
    for (const XmlNode* material : root_.all("material")) read_material(*material);
    for (const XmlNode* link : root_.all("link")) read_link(*link);
    for (const XmlNode* joint : root_.all("joint")) read_joint(*joint);
    place_links();
    if (const auto world = robot_.link("world"); world && !robot_.links[*world].massive) {
      reading_.no_counterpart(robot_.links[*world].place,
                              "robots stand freely: leave out the link 'world' and its joint");
    }
    for (const XmlNode* motor : root_.all("transmission")) read_transmission(*motor);
    for (const XmlNode* control : root_.all("ros2_control")) read_control(*control);
    for (const XmlNode* extension : root_.all("gazebo")) read_gazebo(*extension);
    return std::move(robot_);
  }

 private:
  Pose origin(const XmlNode& node) const {
    const XmlNode* found = node.child("origin");
    if (found == nullptr) return {};
    return {reading_.vector(*found, "xyz", {}), from_rpy(reading_.vector(*found, "rpy", {}))};
  }

  /// Named materials stand once, anywhere, and are referred to by name.
  std::optional<Rgb> read_material(const XmlNode& node) {
    const XmlAttribute* name = node.attribute("name");
    const XmlNode* color = node.child("color");
    const XmlAttribute* rgba = color == nullptr ? nullptr : color->attribute("rgba");
    if (rgba != nullptr) {
      const auto rgb = reading_.colour(rgba->value, rgba->place);
      if (name != nullptr && rgb) materials_[name->value] = *rgb;
      return rgb;
    }
    const auto known = name == nullptr ? materials_.end() : materials_.find(name->value);
    return known == materials_.end() ? std::nullopt : std::optional(known->second);
  }

  void read_link(const XmlNode& node) {
    Link link;
    link.name = reading_.name(node);
    link.place = node.place;
    if (robot_.link(link.name)) {
      reading_.wrong(node.place, fmt::format("two links are called {}", in_quotes(link.name)));
      return;
    }
    reading_.only(node, {"inertial", "visual", "collision"});
    for (const XmlNode* one : node.all("collision")) {
      if (auto solid = read_solid(*one, true)) link.solids.push_back(std::move(*solid));
    }
    for (const XmlNode* one : node.all("visual")) read_visual(*one, link);
    if (const XmlNode* inertial = node.child("inertial")) {
      read_inertial(*inertial, link);
    } else if (!link.solids.empty()) {
      reading_.wrong(node.place, fmt::format("the link {} has shapes and no mass: give it an "
                                             "<inertial>",
                                             in_quotes(link.name)));
      link.massive = true;
    }
    robot_.links.push_back(std::move(link));
  }

  void read_inertial(const XmlNode& node, Link& link) const {
    const XmlNode* mass = node.child("mass");
    const XmlNode* inertia = node.child("inertia");
    if (mass == nullptr || inertia == nullptr) {
      reading_.wrong(node.place, "<inertial> without <mass> and <inertia>");
      link.massive = true;
      return;
    }
    const std::size_t before = reading_.out.count(Severity::error);
    std::vector<double> six;
    for (const char* key : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
      const bool product = key[1] != key[2];
      six.push_back(reading_.number(*inertia, key, product ? std::optional(0.0) : std::nullopt));
    }
    const double kilograms = reading_.number(*mass, "value");
    const Pose X_LI = origin(node);
    link.massive = true;
    if (reading_.out.count(Severity::error) > before) return;
    set_mass(link, kilograms, X_LI, six, inertia->place, reading_);
  }

  void read_visual(const XmlNode& node, Link& link) {
    if (const XmlNode* material = node.child("material"); material != nullptr && !link.rgb) {
      link.rgb = read_material(*material);
    }
    const auto solid = read_solid(node, false);
    const auto same = [&](const Solid& one) {
      return solid && one.shape == solid->shape && one.size == solid->size &&
             one.X_LS == solid->X_LS;
    };
    if (!solid || std::any_of(link.solids.begin(), link.solids.end(), same)) return;
    reading_.left_out(node.place, fmt::format("this <visual> of {} is left out: pictures show what "
                                              "touches",
                                              in_quotes(link.name)));
  }

  /// Of a picture that has another shape nothing is given, after a warning.
  std::optional<Solid> read_solid(const XmlNode& node, bool touches) const {
    const XmlNode* geometry = node.child("geometry");
    if (geometry == nullptr || geometry->children.size() != 1) {
      reading_.wrong(node.place, "one shape has to stand in <geometry>");
      return std::nullopt;
    }
    const XmlNode& shape = geometry->children[0];
    std::optional<Solid> out;
    if (shape.name == "box") {
      out = make_solid(ShapeType::box, reading_.vector(shape, "size", {}), shape.place, reading_);
    } else if (shape.name == "cylinder") {
      const double d = 2 * reading_.number(shape, "radius");
      out = make_solid(ShapeType::cylinder, {d, d, reading_.number(shape, "length")}, shape.place,
                       reading_);
    } else if (shape.name == "sphere") {
      const double d = 2 * reading_.number(shape, "radius");
      out = make_solid(ShapeType::sphere, {d, d, d}, shape.place, reading_);
    } else if (touches) {
      reading_.no_counterpart(
          shape.place, fmt::format("<{}> that touches: put boxes, cylinders and spheres in its "
                                   "place",
                                   printable(shape.name)));
    } else {
      reading_.left_out(shape.place, fmt::format("<{}> is left out: pictures show what touches",
                                                 printable(shape.name)));
    }
    if (out) out->X_LS = origin(node);
    return out;
  }

  std::optional<std::size_t> linked(const XmlNode& joint, std::string_view key) const {
    const XmlNode* node = joint.child(key);
    if (node == nullptr) {
      reading_.wrong(joint.place, fmt::format("a joint without <{}>", key));
      return std::nullopt;
    }
    const std::string name = reading_.needed(*node, "link");
    if (name.empty()) return std::nullopt;
    const auto link = robot_.link(name);
    if (!link) {
      reading_.wrong(node->attribute("link")->place,
                     fmt::format("there is no link {}", in_quotes(name)));
    }
    return link;
  }

  void read_joint(const XmlNode& node) {
    Joint joint;
    joint.name = reading_.name(node);
    joint.place = node.place;
    if (robot_.joint(joint.name)) {
      reading_.wrong(node.place, fmt::format("two joints are called {}", in_quotes(joint.name)));
      return;
    }
    reading_.only(node, {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"});
    if (const XmlNode* mimic = node.child("mimic")) {
      reading_.no_counterpart(mimic->place, "joints follow no others: let its program move both");
    }
    const auto parent = linked(node, "parent"), child = linked(node, "child");
    const std::string type = reading_.needed(node, "type");
    if (type == "revolute" || type == "continuous" || type == "prismatic") {
      joint.axes.push_back(read_axis(node, type));
    } else if (!type.empty() && type != "fixed") {
      reading_.no_counterpart(node.attribute("type")->place,
                              fmt::format("joints of the type {}: robots have fixed ones, and "
                                          "axes that turn or slide",
                                          in_quotes(type)));
    }
    if (!parent || !child) {
      complete_ = false;
      return;
    }
    joint.parent = *parent;
    joint.child = *child;
    origins_.push_back(origin(node));
    robot_.joints.push_back(std::move(joint));
  }

  /// Along the joint's frame until links are placed.
  Axis read_axis(const XmlNode& node, const std::string& type) const {
    Axis axis;
    axis.angular = type != "prismatic";
    axis.direction = {1, 0, 0};
    if (const XmlNode* found = node.child("axis")) {
      axis.direction = reading_.direction(reading_.vector(*found, "xyz", {1, 0, 0}), found->place);
    }
    if (const XmlNode* limit = node.child("limit")) {
      if (type != "continuous") {
        axis.lower = reading_.number(*limit, "lower", 0);
        axis.upper = reading_.number(*limit, "upper", 0);
      }
      axis.effort = reading_.number(*limit, "effort", 0);
      axis.speed = reading_.number(*limit, "velocity", 0);
    } else if (type != "continuous") {
      reading_.wrong(node.place, fmt::format("a {} joint without <limit>", type));
    }
    if (const XmlNode* dynamics = node.child("dynamics")) {
      axis.damping = reading_.number(*dynamics, "damping", 0);
      if (reading_.number(*dynamics, "friction", 0) != 0) {
        reading_.left_out(dynamics->attribute("friction")->place,
                          "the joint's dry friction is left out: joints have 'damping' alone");
      }
    }
    return axis;
  }

  /// From the root on. Where the joints are no tree, fold_frames says so.
  void place_links() {
    if (!complete_ || robot_.links.empty()) return;
    std::vector<bool> done(robot_.links.size(), true);
    for (const Joint& joint : robot_.joints) done[joint.child] = false;
    for (bool again = true; again;) {
      again = false;
      for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
        Joint& joint = robot_.joints[i];
        if (!done[joint.parent] || done[joint.child]) continue;
        done[joint.child] = again = true;
        const Pose X_MC = robot_.links[joint.parent].X_ML * origins_[i];
        robot_.links[joint.child].X_ML = {X_MC.p, normalised(X_MC.q)};
        joint.p_M = X_MC.p;
        for (Axis& axis : joint.axes) axis.direction = rotate(normalised(X_MC.q), axis.direction);
      }
    }
  }

  void set_motor(const XmlNode& place, const std::string& name, std::string_view interface) {
    const auto joint = robot_.joint(name);
    if (!joint) {
      reading_.wrong(place.place, fmt::format("there is no joint {}", in_quotes(name)));
      return;
    }
    const ActuatorMode mode = interface.find("elocity") != interface.npos   ? ActuatorMode::velocity
                              : interface.find("osition") != interface.npos ? ActuatorMode::position
                              : interface.find("ffort") != interface.npos   ? ActuatorMode::force
                                                                            : ActuatorMode::none;
    for (Axis& axis : robot_.joints[*joint].axes) {
      if (axis.motor == ActuatorMode::none) axis.motor = mode;
    }
  }

  void read_transmission(const XmlNode& node) {
    for (const XmlNode* joint : node.all("joint")) {
      set_motor(*joint, reading_.name(*joint), child_text(*joint, "hardwareInterface"));
      for (const XmlNode* motor : node.all("actuator")) check_reduction(*motor);
    }
  }
  void check_reduction(const XmlNode& motor) const {
    if (motor.child("mechanicalReduction") == nullptr) return;
    if (reading_.child_number(motor, "mechanicalReduction", 1) == 1) return;
    reading_.left_out(motor.child("mechanicalReduction")->place,
                      "gears are left out: motors are those of the joints");
  }

  void read_control(const XmlNode& node) {
    reading_.only(node, {"joint", "hardware"});
    for (const XmlNode* joint : node.all("joint")) {
      for (const XmlNode* command : joint->all("command_interface")) {
        set_motor(*joint, reading_.name(*joint), reading_.name(*command));
      }
    }
  }

  void read_gazebo(const XmlNode& node) {
    for (const XmlNode* plugin : node.all("plugin")) read_plugin(*plugin, robot_, reading_);
    const XmlAttribute* reference = node.attribute("reference");
    if (reference == nullptr) {
      reading_.only(node, {"plugin"});
      return;
    }
    const auto link = robot_.link(reference->value);
    if (!link && !robot_.joint(reference->value)) {
      reading_.wrong(reference->place,
                     fmt::format("there is no link or joint {}", in_quotes(reference->value)));
    }
    if (!link) return;
    reading_.only(node, {"plugin", "sensor", "mu1", "mu2", "material"});
    for (const XmlNode* sensor : node.all("sensor")) {
      read_sensor(*sensor, *link, pose_of(*sensor, reading_), robot_, reading_);
    }
    if (node.child("mu1") == nullptr) return;
    const double friction = reading_.child_number(node, "mu1");
    for (Solid& solid : robot_.links[*link].solids) solid.friction = friction;
  }

  const XmlNode& root_;
  const Reading& reading_;
  Description robot_;
  std::map<std::string, Rgb> materials_;
  std::vector<Pose> origins_;  ///< of joints, in their parents' frames
  bool complete_ = true;       ///< every joint's links are known
};

}  // namespace

bool too_many(const XmlNode& robot, const Reading& reading) {
  constexpr std::size_t kMostParts = 500, kMostWithin = 5000;
  std::size_t within = 0;
  for (const XmlNode& part : robot.children) within += part.children.size();
  const auto many = [&](const char* name) { return robot.all(name).size() > kMostParts; };
  if (!many("link") && !many("joint") && !many("frame") && within <= kMostWithin) return false;
  reading.no_counterpart(robot.place, "more than 500 links or joints, or 5000 elements in them");
  return true;
}

std::optional<Solid> make_solid(ShapeType shape, const Vec3& size, const SourceRange& place,
                                const Reading& reading) {
  if (size.x > 0 && size.y > 0 && size.z > 0) return Solid{shape, size, {}, {}, place};
  reading.wrong(place, "the size of a shape is not above zero");
  return std::nullopt;
}

Description read_urdf(const XmlNode& robot, const Reading& reading) {
  return UrdfReader(robot, reading).read();
}

}  // namespace stig::urdf
