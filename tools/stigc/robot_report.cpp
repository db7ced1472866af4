// SPDX-License-Identifier: MIT
// The tables of stigc describe and the same as JSON. Places are in the robot's frame, as somebody
// would measure them on the robot, and not in those of its bodies.
#include "robot_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app.h"
#include "report.h"

namespace stig::cli {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;
constexpr std::string_view kShapes[] = {"box", "cylinder", "sphere", "hull"};
constexpr std::string_view kModes[] = {"free", "velocity", "position", "force"};
constexpr std::string_view kCalibrations[] = {"metres", "power", "quadratic"};

/// To a tenth of a micrometre, without a sign before zero. So that poses which were composed do not
/// show their last digits.
double rounded(double x) { return std::round(x * 1e7) / 1e7 + 0.0; }
std::string number(double x) { return fmt::format("{:.6g}", rounded(x)); }
std::string point(const Vec3& p) {
  return fmt::format("({}, {}, {})", number(p.x), number(p.y), number(p.z));
}
std::string millimetres(double x) { return fmt::format("{:.6g}", rounded(x) * 1000); }

std::string shape(const BodyModel& body) {
  const std::string x = millimetres(body.size.x), y = millimetres(body.size.y),
                    z = millimetres(body.size.z);
  switch (body.shape) {
    case ShapeType::sphere:
      return fmt::format("sphere, diameter {}", x);
    case ShapeType::cylinder:
      return fmt::format("cylinder, diameter {}, height {}", x, z);
    case ShapeType::hull:
      return fmt::format("hull of {} corners, {} x {} x {}", body.points.size(), x, y, z);
    case ShapeType::box:
      break;
  }
  return fmt::format("box {} x {} x {}", x, y, z);
}

std::string axis_words(const AxisModel& axis) {
  std::string out =
      fmt::format("{} {}", axis.angular ? "turns about" : "slides along", point(axis.axis));
  const auto shown = [&](double x) {
    return axis.angular ? fmt::format("{:.6g}", x * kDegrees) : millimetres(x);
  };
  if (axis.lower && axis.upper) {
    out += fmt::format(", {} to {} {}", shown(*axis.lower), shown(*axis.upper),
                       axis.angular ? "degrees" : "mm");
  }
  if (axis.actuator == ActuatorMode::none) return out + ", free";
  return out + fmt::format(", {} up to {} {}", kModes[static_cast<std::size_t>(axis.actuator)],
                           number(axis.most_force), axis.angular ? "N·m" : "N");
}

/// Two columns, the first as wide as its widest entry.
class Table {
 public:
  void add(std::string name, std::string text) {
    width_ = std::max(width_, name.size());
    rows_.emplace_back(std::move(name), std::move(text));
  }
  std::string text() const {
    std::string out;
    for (const auto& [name, text] : rows_) out += fmt::format("  {:<{}}  {}\n", name, width_, text);
    return out;
  }

 private:
  std::size_t width_ = 0;
  std::vector<std::pair<std::string, std::string>> rows_;
};

class TextReport {
 public:
  TextReport(const RobotModel& robot, bool color) : robot_(robot), color_(color) {}

  std::string print() {
    out_ = bold(printable(robot_.name), color_) +
           (robot_.title.empty() ? "" : ": " + printable(robot_.title)) + "\n";
    out_ += fmt::format("{} kg, centre of mass {} m, a control step every {} s\n",
                        number(robot_.mass()), point(robot_.centre_of_mass()),
                        number(robot_.control_period));
    print_bodies();
    print_joints();
    print_devices();
    return out_;
  }

 private:
  // A section without rows is left out.
  void section(std::string_view title, const Table& table) {
    const std::string text = table.text();
    if (!text.empty()) out_ += "\n" + bold(title, color_) + "\n" + text;
  }
  std::string body(std::size_t i) const { return printable(robot_.bodies[i].name); }
  std::string in_robot(std::size_t on, const Vec3& p_B) const {
    return point(robot_.bodies[on].X_RB * p_B);
  }

  void print_bodies() {
    Table table;
    for (const BodyModel& one : robot_.bodies) {
      table.add(printable(one.name),
                fmt::format("{} kg at {}, {}", number(one.mass), point(one.X_RB.p), shape(one)));
    }
    section(fmt::format("{} bodies: mass, middle in the robot's frame (m), shape (mm)",
                        robot_.bodies.size()),
            table);
  }

  void print_joints() {
    Table table;
    for (const JointModel& one : robot_.joints) {
      std::string text = one.axes.empty() ? fmt::format("fixed to {}", body(one.parent))
                                          : fmt::format("on {}", body(one.parent));
      for (const AxisModel& axis : one.axes) text += "; " + axis_words(axis);
      table.add(printable(one.name), text);
    }
    section(fmt::format("{} joints", robot_.joints.size()), table);
  }

  void print_devices() {
    Table table;
    DeviceKinds::each([&](auto kind) {
      using Kind = decltype(kind);
      if constexpr (ListedKind<Kind>) {
        for (const auto& one : Kind::devices(robot_)) {
          table.add(fmt::format("{} {}", Kind::noun, printable(one.name)), words_of(one));
        }
      } else if (Kind::devices(robot_)) {
        add(table, *Kind::devices(robot_));
      }
    });
    section("devices, places in the robot's frame (m)", table);
  }

  static void add(Table& table, const DriveModel& drive) {
    table.add("differential drive",
              fmt::format("{} + {} wheels of radius {} mm, track {} mm, up to {} m/s and {} m/s²",
                          drive.left.size(), drive.right.size(), millimetres(drive.wheel_radius),
                          millimetres(drive.track), number(drive.most_speed),
                          number(drive.most_acceleration)));
  }

  void add(Table& table, const LiftModel& lift) const {
    std::string speeds;
    for (const auto& [above, speed] : lift.speeds) {
      speeds += fmt::format(", {} m/s above {} mm", number(speed), millimetres(above));
    }
    table.add("lift", fmt::format("{}, switches at {} and {} mm{}",
                                  printable(robot_.joints[lift.axis.joint].name),
                                  millimetres(lift.low), millimetres(lift.high), speeds));
  }

  static void add(Table& table, const MagnetCircuitModel& magnets) {
    table.add("electromagnets", fmt::format("{} poles, field {} + {} x current, charge up to {}",
                                            magnets.poles.size(), number(magnets.passive),
                                            number(magnets.active), number(magnets.charge_limit)));
  }

  std::string words_of(const CameraDevice& one) const {
    // The camera's z axis is what it looks along.
    const Pose X_RC = robot_.bodies[one.body].X_RB * one.X_BC;
    const CameraIntrinsics& c = one.intrinsics;
    return fmt::format("on {} at {}, looks {}, {} x {} pixels, f {} {}, sees {} to {} m",
                       body(one.body), point(X_RC.p), point(rotate(X_RC.q, {0, 0, 1})), c.width,
                       c.height, number(c.fx), number(c.fy), number(one.near), number(one.far));
  }
  std::string words_of(const RangeDevice& one) const {
    const Vec3 way = rotate(robot_.bodies[one.body].X_RB.q, one.direction);
    return fmt::format("on {} at {}, looks {}, {} mm, {}", body(one.body),
                       in_robot(one.body, one.p_B), point(way), millimetres(one.range),
                       kCalibrations[static_cast<std::size_t>(one.calibration)]);
  }
  std::string words_of(const RadioDevice& one) const {
    return fmt::format("on {} at {}, reaches {} mm", body(one.body), in_robot(one.body, one.p_B),
                       millimetres(one.range));
  }
  std::string words_of(const LedDevice& one) const {
    return fmt::format("on {} at {}", body(one.body), in_robot(one.body, one.p_B));
  }
  std::string words_of(const ActuatorDevice& one) const {
    // Axes count from 1 for people.
    return fmt::format("axis {} of {}", one.axis.axis + 1,
                       printable(robot_.joints[one.axis.joint].name));
  }
  template <class Device>
  requires HasFigures<Device> std::string words_of(const Device& one)
  const {
    std::string out = fmt::format("on {}", body(one.body));
    const auto add_figure = [&](const char* name, const auto& value, std::string_view unit) {
      out += fmt::format(", {} {}{}{}", name, number(value), unit.empty() ? "" : " ", unit);
    };
    Device::fields(add_figure, one);
    return out;
  }

  const RobotModel& robot_;
  bool color_;
  std::string out_;
};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

Json json_of(const Vec3& v) { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }
Json json_of(const Quat& q) { return {rounded(q.w), rounded(q.x), rounded(q.y), rounded(q.z)}; }

class JsonReport {
 public:
  explicit JsonReport(const RobotModel& robot) : robot_(robot) {}

  Json report() const {
    Json out{{"name", robot_.name},
             {"title", robot_.title},
             {"mass", robot_.mass()},
             {"center_of_mass", json_of(robot_.centre_of_mass())},
             {"control_period", robot_.control_period},
             {"bodies", Json::array()},
             {"joints", Json::array()},
             {"devices", Json::array()}};
    for (const BodyModel& one : robot_.bodies) out["bodies"].push_back(body(one));
    for (const JointModel& one : robot_.joints) out["joints"].push_back(joint(one));
    add_devices(out["devices"]);
    return out;
  }

 private:
  static Json body(const BodyModel& one) {
    return {{"name", one.name},
            {"shape", kShapes[static_cast<std::size_t>(one.shape)]},
            {"size", json_of(one.size)},
            {"mass", one.mass},
            {"center", json_of(one.X_RB.p)},
            {"rotation", json_of(one.X_RB.q)},
            {"material", one.material}};
  }

  Json joint(const JointModel& one) const {
    Json out{{"name", one.name},
             {"parent", robot_.bodies[one.parent].name},
             {"child", robot_.bodies[one.child].name},
             {"at", json_of(one.X_RJ.p)},
             {"axes", Json::array()}};
    for (const AxisModel& axis : one.axes) {
      Json json{{"turns", axis.angular},
                {"axis", json_of(axis.axis)},
                {"actuator", kModes[static_cast<std::size_t>(axis.actuator)]},
                {"most_force", axis.most_force},
                {"lower", nullptr},
                {"upper", nullptr}};
      if (axis.lower) json["lower"] = *axis.lower;
      if (axis.upper) json["upper"] = *axis.upper;
      out["axes"].push_back(std::move(json));
    }
    return out;
  }

  void add_devices(Json& out) const {
    DeviceKinds::each([&](auto kind) {
      using Kind = decltype(kind);
      if constexpr (ListedKind<Kind>) {
        for (const auto& one : Kind::devices(robot_)) {
          Json json{{"kind", lower_case(Kind::noun)}, {"name", one.name}};
          add_figures(json, one);
          out.push_back(std::move(json));
        }
      } else if (Kind::devices(robot_)) {
        Json json{{"kind", Kind::key}};
        add_figures(json, *Kind::devices(robot_));
        out.push_back(std::move(json));
      }
    });
  }

  static void add_figures(Json& json, const DriveModel& drive) { json["track"] = drive.track; }
  static void add_figures(Json& json, const LiftModel& lift) {
    json["switches"] = {lift.low, lift.high};
  }
  static void add_figures(Json& json, const MagnetCircuitModel& magnets) {
    json["poles"] = magnets.poles.size();
  }
  void add_figures(Json& json, const CameraDevice& one) const {
    const Pose X_RC = robot_.bodies[one.body].X_RB * one.X_BC;
    add_place(json, one.body, X_RC.p);
    json["rotation"] = json_of(X_RC.q);
    json["resolution"] = {one.intrinsics.width, one.intrinsics.height};
    json["focal_length"] = {one.intrinsics.fx, one.intrinsics.fy};
    json["near"] = one.near;
    json["far"] = one.far;
  }
  void add_figures(Json& json, const RangeDevice& one) const {
    add_place(json, one.body, in_robot(one));
    json["look"] = json_of(rotate(robot_.bodies[one.body].X_RB.q, one.direction));
    json["range"] = one.range;
  }
  void add_figures(Json& json, const RadioDevice& one) const {
    add_place(json, one.body, in_robot(one));
    json["range"] = one.range;
  }
  void add_figures(Json& json, const LedDevice& one) const {
    add_place(json, one.body, in_robot(one));
  }
  void add_figures(Json& json, const ActuatorDevice& one) const {
    json["joint"] = robot_.joints[one.axis.joint].name;
    json["axis"] = one.axis.axis + 1;
  }
  template <class Device>
  requires HasFigures<Device>
  void add_figures(Json& json, const Device& one) const {
    json["body"] = robot_.bodies[one.body].name;
    const auto add_figure = [&](const char* name, const auto& value, const char* /*unit*/) {
      json[name] = value;
    };
    Device::fields(add_figure, one);
  }

  template <class Device>
  Vec3 in_robot(const Device& one) const {
    return robot_.bodies[one.body].X_RB * one.p_B;
  }
  void add_place(Json& json, std::size_t body, const Vec3& at) const {
    json["body"] = robot_.bodies[body].name;
    json["at"] = json_of(at);
  }

  const RobotModel& robot_;
};

}  // namespace

std::string to_text(const RobotModel& robot, bool color) {
  return TextReport(robot, color).print();
}

std::string to_json(const RobotModel& robot) { return dump(JsonReport(robot).report()); }

}  // namespace stig::cli
