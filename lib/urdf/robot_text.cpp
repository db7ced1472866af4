// SPDX-License-Identifier: MIT
// Frame R of a robot file lies on the floor, the model's frame M anywhere: all is lifted so that
// the lowest point of the shapes is at 0.
#include "urdf/robot_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "base/degree.h"
#include "base/text.h"
#include "base/yaml.h"
#include "robots/robot_reader.h"
#include "urdf/moments.h"

namespace stig::urdf {

namespace {

constexpr double kMostForce = 1e6;   ///< as robot files have it
constexpr double kSlippery = 0.05;   ///< friction up to which what touches is a caster
constexpr double kUsualTorque = 5;   ///< N·m, of wheels whose drive says none, as in Gazebo
constexpr double kUsualSpeed = 0.5;  ///< m/s

/// How far a solid reaches along z of the model's frame, from its middle.
double half_height(const Solid& solid, const Quat& q_MS) {
  const Vec3 up = rotate(conjugate(q_MS), {0, 0, 1});
  const Vec3 half = solid.size * 0.5;
  if (solid.shape == ShapeType::sphere) return half.x;
  if (solid.shape == ShapeType::cylinder) {
    return half.z * std::abs(up.z) + half.x * std::hypot(up.x, up.y);
  }
  return half.x * std::abs(up.x) + half.y * std::abs(up.y) + half.z * std::abs(up.z);
}

class RobotWriter {
 public:
  RobotWriter(const Description& robot, const Reading& reading) : robot_(robot), reading_(reading) {
    for (const Link& link : robot.links) pieces_.push_back(pieces_of(link, reading));
    find_lowest();
    find_motors();
  }

  RobotText write(const std::string& source) {
    out_ = "stigc_robot: 1\n";
    put_line("name", robot_.name);
    if (!source.empty()) put_line("source", source);
    out_ += "\nbodies:\n";
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (const Piece& piece : pieces_[i]) put_body(i, piece);
    }
    put_joints();
    if (robot_.drive) put_drive(*robot_.drive);
    put_actuators();
    put_cameras();
    put_rays();
    check();
    return {std::move(out_), lowest_};
  }

 private:
  void find_lowest() {
    lowest_ = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (const Piece& piece : pieces_[i]) {
        const Pose X_MB = robot_.links[i].X_ML * piece.X_LB;
        lowest_ = std::min(lowest_, X_MB.p.z - half_height(piece.solid, X_MB.q));
      }
    }
  }

  /// Wheels turn by velocity, as a drive has it.
  void find_motors() {
    wheel_.resize(robot_.links.size());
    motor_.resize(robot_.joints.size());
    if (!robot_.drive) return;
    for (const auto* side : {&robot_.drive->left, &robot_.drive->right}) {
      for (const std::string& name : *side) {
        const auto joint = robot_.joint(name);
        if (!joint) {
          reading_.wrong(
              robot_.drive->place,
              fmt::format("the drive's joint {} is none of the robot's", in_quotes(name)));
          continue;
        }
        motor_[*joint] = true;
        wheel_[robot_.joints[*joint].child] = true;
      }
    }
  }

  void put_line(std::string_view key, const std::string& text) {
    out_ += fmt::format("{}: {}\n", key, yaml_text(text, false));
  }
  static std::string in_flow(const std::string& text) { return yaml_text(text, true); }
  std::string lifted(const Vec3& p_M) const { return figures(p_M - Vec3{0, 0, lowest_}); }

  void put_body(std::size_t number, const Piece& piece) {
    const Link& link = robot_.links[number];
    const Pose X_MB = link.X_ML * piece.X_LB;
    const Vec3 turn = degrees_zyx(X_MB.q);
    const Vec3& size = piece.solid.size;
    out_ += fmt::format("  - name: {}\n", yaml_text(piece.name, false));
    if (piece.solid.shape == ShapeType::box) {
      out_ += fmt::format("    box: {}\n", figures(size));
    } else if (piece.solid.shape == ShapeType::sphere) {
      out_ += fmt::format("    sphere: {{radius: {}}}\n", figure(size.x / 2));
    } else {
      out_ += fmt::format("    cylinder: {{radius: {}, height: {}}}\n", figure(size.x / 2),
                          figure(size.z));
    }
    out_ += fmt::format("    mass: {:.12g}\n    inertia: [{:.12g}, {:.12g}, {:.12g}]\n", piece.mass,
                        piece.moments.x, piece.moments.y, piece.moments.z);
    out_ += fmt::format("    center: {}\n", lifted(X_MB.p));
    if (length(turn) > 1e-6) out_ += fmt::format("    turn: {}\n", figures(turn));
    if (!piece.kernel) put_surface(number, piece);
    if (link.rgb) out_ += fmt::format("    color: \"{}\"\n", to_color(*link.rgb));
  }

  void put_surface(std::size_t number, const Piece& piece) {
    if (wheel_[number] && piece.solid.shape != ShapeType::box) {
      const Joint* joint = joint_above(number);
      const Vec3 axis_M = joint->axes.empty() ? Vec3{0, 1, 0} : joint->axes[0].direction;
      const Pose X_MB = robot_.links[number].X_ML * piece.X_LB;
      out_ += fmt::format("    material: wheel\n    axle: {}\n",
                          figures(rotate(conjugate(X_MB.q), axis_M)));
      if (piece.solid.shape == ShapeType::cylinder) out_ += "    rolls_as_sphere: true\n";
    } else if (piece.solid.friction && *piece.solid.friction <= kSlippery) {
      out_ += "    material: caster\n";
    } else if (piece.solid.friction) {
      reading_.left_out(
          piece.solid.place,
          fmt::format("the friction of {} is left out: it is of pairs of materials, in "
                      "the key 'friction' of scenes",
                      in_quotes(robot_.links[number].name)));
    }
  }

  const Joint* joint_above(std::size_t link) const {
    const auto found = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&](const Joint& joint) { return joint.child == link; });
    return found == robot_.joints.end() ? nullptr : &*found;
  }

  void put_joints() {
    bool begun = false;
    const auto put = [&](const std::string& line) {
      out_ += begun ? "" : "\njoints:\n";
      begun = true;
      out_ += line;
    };
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (std::size_t k = 1; k < pieces_[i].size(); ++k) {
        put(fmt::format("  - {{parent: {}, child: {}}}\n", in_flow(pieces_[i][0].name),
                        in_flow(pieces_[i][k].name)));
      }
    }
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const Joint& joint = robot_.joints[i];
      put(fmt::format("  - name: {}\n    parent: {}\n    child: {}\n    at: {}\n",
                      yaml_text(joint.name, false),
                      yaml_text(robot_.links[joint.parent].name, false),
                      yaml_text(robot_.links[joint.child].name, false), lifted(joint.p_M)));
      if (!joint.axes.empty()) out_ += "    axes:\n";
      for (const Axis& axis : joint.axes) put_axis(joint, axis, motor_[i]);
    }
  }

  void put_axis(const Joint& joint, const Axis& axis, bool drives) {
    const double unit = axis.angular ? kDegree : 1;
    out_ +=
        fmt::format("      - {{{}: {}", axis.angular ? "turn" : "slide", figures(axis.direction));
    if (axis.lower && axis.upper) {
      if (*axis.lower > 0 || *axis.upper < 0) {
        reading_.no_counterpart(
            joint.place, fmt::format("the limits of {} do not hold 0, where every joint of a robot "
                                     "begins: turn its <origin> or <pose> so that they do",
                                     in_quotes(joint.name)));
      }
      out_ +=
          fmt::format(", limits: [{}, {}]", figure(*axis.lower / unit), figure(*axis.upper / unit));
    }
    const ActuatorMode motor = drives ? ActuatorMode::velocity : axis.motor;
    if (motor != ActuatorMode::none) put_motor(joint, axis, motor, drives);
    if (axis.damping > 0) out_ += fmt::format(", damping: {}", figure(axis.damping));
    out_ += "}\n";
  }

  void put_motor(const Joint& joint, const Axis& axis, ActuatorMode motor, bool drives) {
    constexpr std::string_view kWords[] = {"none", "velocity", "position", "force"};
    std::optional<double> force = drives ? robot_.drive->torque : std::nullopt;
    if (!force || !(*force > 0)) force = axis.effort;
    if (!force || !(*force > 0)) {
      force = drives ? kUsualTorque : kMostForce;
      reading_.left_out(
          joint.place,
          fmt::format("the motor of {} has no limit of effort: {} {} are taken",
                      in_quotes(joint.name), figure(*force), axis.angular ? "N·m" : "N"));
    }
    out_ += fmt::format(", actuator: {}, most_force: {}", kWords[static_cast<std::size_t>(motor)],
                        figure(std::min(*force, kMostForce)));
    if (motor == ActuatorMode::position && axis.speed && *axis.speed > 0) {
      out_ += fmt::format(", most_speed: {}",
                          figure(std::min(*axis.speed / (axis.angular ? kDegree : 1), kMostForce)));
    }
  }

  std::string names(const std::vector<std::string>& list) const {
    std::string out;
    for (const std::string& name : list) out += (out.empty() ? "" : ", ") + in_flow(name);
    return "[" + out + "]";
  }

  /// Of the first wheel that has a round shape.
  std::optional<double> wheel_radius() const {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (const Piece& piece : pieces_[i]) {
        if (wheel_[i] && piece.solid.shape != ShapeType::box) return piece.solid.size.x / 2;
      }
    }
    return std::nullopt;
  }
  std::optional<Vec3> place_of(const std::vector<std::string>& side) const {
    const auto joint = side.empty() ? std::nullopt : robot_.joint(side[0]);
    return joint ? std::optional(robot_.joints[*joint].p_M) : std::nullopt;
  }
  std::optional<double> wheel_speed(double radius) const {
    const auto joint =
        robot_.drive->left.empty() ? std::nullopt : robot_.joint(robot_.drive->left[0]);
    if (!joint || robot_.joints[*joint].axes.empty()) return std::nullopt;
    const auto speed = robot_.joints[*joint].axes[0].speed;
    return speed && *speed > 0 ? std::optional(*speed * radius) : std::nullopt;
  }

  void put_drive(const Drive& drive) {
    const double radius = drive.radius.value_or(wheel_radius().value_or(0));
    const auto left = place_of(drive.left), right = place_of(drive.right);
    const double apart = left && right ? length(*left - *right) : 0;
    const double track = drive.track.value_or(apart);
    std::optional<double> speed = drive.speed ? drive.speed : wheel_speed(radius);
    if (!speed) {
      speed = kUsualSpeed;
      reading_.left_out(drive.place,
                        "the drive says no speed, nor do its joints: 0.5 m/s is taken");
    }
    out_ += fmt::format(
        "\ndifferential_drive:\n  left: {}\n  right: {}\n  wheel_radius: {}\n"
        "  track: {}\n  most_speed: {}\n",
        names(drive.left), names(drive.right), figure(radius), figure(track),
        figure(std::min(*speed, 100.0)));
    if (drive.acceleration && *drive.acceleration > 0) {
      out_ +=
          fmt::format("  most_acceleration: {}\n", figure(std::min(*drive.acceleration, 1000.0)));
    }
  }

  void put_actuators() {
    bool begun = false;
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const Joint& joint = robot_.joints[i];
      for (std::size_t k = 0; k < joint.axes.size(); ++k) {
        if (motor_[i] || joint.axes[k].motor == ActuatorMode::none) continue;
        out_ += begun ? "" : "\nactuators:\n";
        begun = true;
        const std::string name = k == 0 ? joint.name : fmt::format("{} {}", joint.name, k + 1);
        out_ += fmt::format("  - {{name: {}, joint: {}, axis: {}}}\n", in_flow(name),
                            in_flow(joint.name), k + 1);
      }
    }
  }

  /// Where a device is on its link's first body, and along which axes.
  std::string placed(std::size_t link, const Pose& X_LD, bool up) const {
    const Pose X_BD = inverse(pieces_[link][0].X_LB) * X_LD;
    const Mat3 r = matrix(X_BD.q);
    std::string out =
        fmt::format("    body: {}\n    at: {}\n    look: {}\n",
                    yaml_text(pieces_[link][0].name, false), figures(X_BD.p), figures(r.x));
    if (up) out += fmt::format("    up: {}\n", figures(r.z));
    return out;
  }

  void put_cameras() {
    if (!robot_.cameras.empty()) out_ += "\ncameras:\n";
    for (const Camera& one : robot_.cameras) {
      // The picture's middle is that of its pixels, which are whole numbers in the middle of each.
      const double focal = one.width / (2 * std::tan(one.angle / 2));
      const std::vector<double> f =
          one.intrinsics.size() == 4
              ? one.intrinsics
              : std::vector{focal, focal, (one.width - 1) / 2, (one.height - 1) / 2};
      out_ += fmt::format(
          "  - name: {}\n{}    resolution: [{}, {}]\n    focal_length: [{}, {}]\n"
          "    principal_point: [{}, {}]\n",
          yaml_text(one.name, false), placed(one.link, one.X_LC, true), figure(one.width),
          figure(one.height), figure(f[0]), figure(f[1]), figure(f[2]), figure(f[3]));
      if (!one.distortion.empty()) {
        std::string list;
        for (const double k : one.distortion) list += (list.empty() ? "" : ", ") + figure(k);
        out_ += fmt::format("    distortion: [{}]\n", list);
      }
      out_ += fmt::format("    near: {}\n    far: {}\n", figure(one.near), figure(one.far));
    }
  }

  void put_rays() {
    if (!robot_.rays.empty()) out_ += "\nrangefinders:\n";
    for (const SingleRay& one : robot_.rays) {
      out_ += fmt::format("  - name: {}\n{}    range: {}\n", yaml_text(one.name, false),
                          placed(one.link, one.X_LR, false), figure(one.range));
    }
  }

  /// What was said of the file already needs no second word.
  void check() const {
    if (reading_.out.has_errors()) return;
    Diagnostics own;
    read_robot(std::make_shared<SourceFile>("robot", out_), own);
    for (const Diagnostic& one : own.all()) {
      if (one.severity != Severity::error) continue;
      reading_.no_counterpart(
          robot_.place, fmt::format("as a robot file it would not be taken: {} ({})", one.message,
                                    info(one.code).name));
    }
  }

  const Description& robot_;
  const Reading& reading_;
  std::vector<std::vector<Piece>> pieces_;  ///< of each link
  std::vector<bool> wheel_;                 ///< links
  std::vector<bool> motor_;                 ///< joints of the drive
  double lowest_ = 0;
  std::string out_;
};

}  // namespace

RobotText robot_text(const Description& robot, const std::string& source, const Reading& reading) {
  return RobotWriter(robot, reading).write(source);
}

}  // namespace stig::urdf
