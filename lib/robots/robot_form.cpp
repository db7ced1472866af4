// SPDX-License-Identifier: MIT
// What a robot file may say: one table for the checker, its messages and the JSON Schema;
// docs/robots.md explains the keys. Bounds keep out what cannot be meant, such as grams for
// kilograms, and what the solver could not take.
#include "robots/body_reader.h"
#include "robots/form_keys.h"
#include "robots/robot_forms.h"
#include "robots/robot_model.h"

namespace stig::robots {

namespace {

using namespace keys;

constexpr double kHeavy = 1e5;      ///< kg
constexpr std::size_t kMany = 200;  ///< bodies, joints, devices of a kind

const Form& cylinder_form() {
  static const Form kForm{
      "cylinder",
      {required(above_zero("radius", "Metres.", kFar)),
       required(above_zero("height", "Metres, along the body's z axis.", kFar))}};
  return kForm;
}

const Form& sphere_form() {
  static const Form kForm{"sphere", {required(above_zero("radius", "Metres.", kFar))}};
  return kForm;
}

// A mapping with one key rather than a bare list of three numbers, so that entries can be given
// more keys later without a new version of the format.
const Form& point_form() {
  static const Form kForm{"corner", {required(vector("at", "Metres, body's frame.", kFar))}};
  return kForm;
}

const Form& body_form() {
  static const Form kForm = [] {
    Form form{"body", shape_keys(kFar)};
    form.keys.push_back(
        vector("axle", "Direction in which a wheel slides sideways, body's frame.", kFar));
    form.keys.push_back(number(
        "axle_friction", "Part of the friction that acts along the axle (default: 1).", 0, 1));
    form.keys.push_back(
        words("rolls_as_sphere", FormKind::boolean,
              "A cylinder that touches others as a ball of its radius: one point of contact."));
    form.keys.front().required = true;  // its name
    return form;
  }();
  return kForm;
}

const Form& axis_form() {
  static const Form kForm{
      "axis",
      {vector("turn", "Turns about this direction, robot's frame.", kFar),
       vector("slide", "Slides along this direction instead.", kFar),
       numbers("limits", "Lowest and highest position: degrees, or metres.", 2, 2, -1e6, 1e6),
       choice("actuator", "What its motor is given (default: none, it moves freely).",
              {"none", "velocity", "position", "force"}),
       above_zero("most_force", "Of the motor, N·m or N.", 1e6),
       above_zero("most_speed", "Of a position actuator, degrees or metres a second.", 1e6),
       number("damping", "Viscous friction, N·m·s/rad or N·s/m (default: 0).", 0, 1e6)}};
  return kForm;
}

const Form& joint_form() {
  static const Form kForm{
      "joint",
      {words("name", FormKind::name, "What devices call it (default: its child's name)."),
       required(words("parent", FormKind::name, "The body that carries.")),
       required(words("child", FormKind::name, "The body that is carried.")),
       vector("at", "Where it is, metres, robot's frame (default: where the child is placed).",
              kFar),
       parts("axes", "How the child can move; without any it is fixed.", axis_form(), 1, 6)}};
  return kForm;
}

/// A key for each kind of device.
void add_device_keys(std::vector<FormKey>& out) {
  DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (ListedKind<Kind>) {
      out.push_back(parts(Kind::key, Kind::doc, Kind::form(), 0, kMany));
    } else {
      out.push_back(part(Kind::key, Kind::doc, Kind::form()));
    }
  });
}

Form make_robot_form() {
  Form out{"robot file",
           {version("stigc_robot", "Version of this format: 1.", 1),
            required(words("name", FormKind::name, "Short, for reports.")),
            words("title", FormKind::text, "One line."),
            words("source", FormKind::text, "Where its figures come from."),
            above_zero("control_period", "Seconds between two steps of its program (default: 0.2).",
                       100),
            words("program", FormKind::name, "Its Lua program, unless the scene names another."),
            required(parts("bodies", "Its rigid parts.", body_form(), 1, kMany)),
            parts("joints", "How they hang together: a tree.", joint_form(), 0, kMany)}};
  add_device_keys(out.keys);
  return out;
}

}  // namespace

std::vector<FormKey> shape_keys(double far) {
  return {
      words("name", FormKind::name, "What joints, devices and reports call it."),
      numbers("box", "Its edges along x, y and z, metres.", 3, 3, 1e-6, kFar),
      part("cylinder", "Round about the body's z axis.", cylinder_form()),
      part("sphere", "A ball.", sphere_form()),
      parts("hull", "Corners of a convex body; its hull is taken.", point_form(), 4, 64),
      words("solid", FormKind::name, "File of a solid, which stigc convex makes of a mesh."),
      above_zero("mass", "Kilograms.", kHeavy),
      above_zero("density", "kg/m³, in place of the mass.", 1e5),
      numbers("inertia", "Principal moments about the body's axes, kg·m² (default: a solid's).", 3,
              3, 1e-12, 1e9),
      vector("base",
             "Where the middle of its lower face is, metres, robot's frame; of a hull and a solid: "
             "the origin.",
             far),
      vector("center", "Where its middle is instead.", far),
      vector("turn", "Degrees about z, then about the new y, then about the new x.", 360),
      words("material", FormKind::name,
            "Kind of surface, of the scene's table of friction (default: robot; of obstacles: "
            "obstacle)."),
      words("color", FormKind::colour, "For pictures, \"#rrggbb\".")};
}

const Form& robot_form() {
  static const Form kForm = make_robot_form();
  return kForm;
}

}  // namespace stig::robots
