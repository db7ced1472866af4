// SPDX-License-Identifier: MIT
#include "urdf/import_robot.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "robots/robot_reader.h"
#include "support/golden.h"
#include "support/uses.h"
#include "urdf/moments.h"
#include "urdf/reading.h"

namespace stig {
namespace {

using urdf::import_description;
using urdf::ImportedDescription;

ImportedDescription imported(const std::string& name, const std::string& text) {
  Diagnostics diagnostics;
  auto out = import_description(std::make_shared<SourceFile>(name, text), "yard", diagnostics);
  REQUIRE_MESSAGE(out, to_text(diagnostics));
  CHECK_MESSAGE(diagnostics.all().empty(), to_text(diagnostics));
  return std::move(*out);
}

RobotModel robot_in(const std::string& text) {
  Diagnostics diagnostics;
  auto robot = read_robot(std::make_shared<SourceFile>("robot.yaml", text), diagnostics);
  REQUIRE_MESSAGE(robot, to_text(diagnostics));
  return std::move(*robot);
}

/// Mass, middle and moments about it, along the axes of frame R: xx, yy, zz, xy, xz, yz.
struct Whole {
  double mass = 0;
  std::array<double, 3> middle{};
  std::array<double, 6> moments{};
};

using Plain = std::array<std::array<double, 3>, 3>;

Plain product(const Plain& a, const Plain& b) {
  Plain out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) out[i][j] += a[i][k] * b[k][j];
    }
  }
  return out;
}
Plain turned_over(const Plain& a) {
  Plain out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = a[j][i];
  }
  return out;
}

/// About fixed x, then y, then z, in radians.
Plain from_rpy(double roll, double pitch, double yaw) {
  const double cr = std::cos(roll), sr = std::sin(roll), cp = std::cos(pitch), sp = std::sin(pitch);
  const double cy = std::cos(yaw), sy = std::sin(yaw);
  const Plain x{{{1, 0, 0}, {0, cr, -sr}, {0, sr, cr}}};
  const Plain y{{{cp, 0, sp}, {0, 1, 0}, {-sp, 0, cp}}};
  const Plain z{{{cy, -sy, 0}, {sy, cy, 0}, {0, 0, 1}}};
  return product(z, product(y, x));
}

/// A link as its file has it, and where its frame is in R.
struct Written {
  double mass = 0;
  std::array<double, 3> at{}, rpy{};  ///< of the link
  std::array<double, 3> middle{};     ///< in it
  std::array<double, 6> six{};        ///< xx, yy, zz, xy, xz, yz about that, along its axes
};

Whole whole_of(const Written& link) {
  const Plain r = from_rpy(link.rpy[0], link.rpy[1], link.rpy[2]);
  Whole out;
  out.mass = link.mass;
  for (std::size_t i = 0; i < 3; ++i) {
    out.middle[i] = link.at[i];
    for (std::size_t k = 0; k < 3; ++k) out.middle[i] += r[i][k] * link.middle[k];
  }
  const auto& s = link.six;
  const Plain t{{{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}}};
  const Plain w = product(r, product(t, turned_over(r)));
  out.moments = {w[0][0], w[1][1], w[2][2], w[0][1], w[0][2], w[1][2]};
  return out;
}

/// A link's bodies together: those whose names begin with its.
Whole whole_of(const RobotModel& robot, const std::string& link) {
  Whole out;
  std::vector<const BodyModel*> bodies;
  for (const BodyModel& body : robot.bodies) {
    if (body.name == link || body.name.starts_with(link + " shape ")) bodies.push_back(&body);
  }
  REQUIRE(!bodies.empty());
  for (const BodyModel* body : bodies) {
    out.mass += body->mass;
    const Vec3& p = body->X_RB.p;
    const std::array<double, 3> at{p.x, p.y, p.z};
    for (std::size_t i = 0; i < 3; ++i) out.middle[i] += body->mass * at[i];
  }
  for (double& x : out.middle) x /= out.mass;
  for (const BodyModel* body : bodies) {
    const Mat3 r = matrix(body->X_RB.q);
    const Vec3 own = moments_of(*body), p = body->X_RB.p;
    const double m = body->mass, dx = p.x - out.middle[0], dy = p.y - out.middle[1],
                 dz = p.z - out.middle[2];
    const auto along = [&](double Vec3::*i, double Vec3::*k) {
      return own.x * (r.x.*i) * (r.x.*k) + own.y * (r.y.*i) * (r.y.*k) +
             own.z * (r.z.*i) * (r.z.*k);
    };
    const std::array<double, 6> more{along(&Vec3::x, &Vec3::x) + m * (dy * dy + dz * dz),
                                     along(&Vec3::y, &Vec3::y) + m * (dx * dx + dz * dz),
                                     along(&Vec3::z, &Vec3::z) + m * (dx * dx + dy * dy),
                                     along(&Vec3::x, &Vec3::y) - m * dx * dy,
                                     along(&Vec3::x, &Vec3::z) - m * dx * dz,
                                     along(&Vec3::y, &Vec3::z) - m * dy * dz};
    for (std::size_t i = 0; i < 6; ++i) out.moments[i] += more[i];
  }
  return out;
}

void check_same(const Whole& is, const Whole& should) {
  CHECK(is.mass == doctest::Approx(should.mass).epsilon(1e-9));
  const double most = std::max({should.moments[0], should.moments[1], should.moments[2]});
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(is.middle[i] - should.middle[i]) < 1e-9);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(std::abs(is.moments[i] - should.moments[i]) < 1e-8 * most);
  }
}

const JointModel& joint_of(const RobotModel& robot, const std::string& name) {
  for (const JointModel& joint : robot.joints) {
    if (joint.name == name) return joint;
  }
  FAIL("no such joint");
  return robot.joints[0];
}

bool close(const Vec3& a, const Vec3& b) { return length(a - b) < 1e-8; }

TEST_CASE("a rover in URDF has its masses, places and moments, its lift, drive and camera") {
  const std::string text = project_file("robots/rover.urdf");
  const ImportedDescription rover = imported("rover.urdf", text);
  CHECK(!rover.scene);
  check_golden("tests/golden/urdf-rover.yaml", rover.text);
  const RobotModel robot = robot_in(rover.text);
  const double quarter = -1.5707963267948966;
  // base_footprint is on the floor, and so is frame R.
  const std::map<std::string, Written> links = {
      {"base_link",
       {2.5, {0, 0, 0.05}, {}, {0.01, 0, 0.02}, {0.012, 0.02, 0.025, 0.0004, -0.0003, 0.0002}}},
      {"left_wheel", {0.2, {0.05, 0.12, 0.05}, {quarter, 0, 0}, {}, {1.6e-4, 1.6e-4, 2.5e-4}}},
      {"right_wheel", {0.2, {0.05, -0.12, 0.05}, {quarter, 0, 0}, {}, {1.6e-4, 1.6e-4, 2.5e-4}}},
      {"caster", {0.05, {-0.12, 0, 0.02}, {}, {}, {8e-6, 8e-6, 8e-6}}},
      {"mast", {0.4, {0.1, 0, 0.09}, {0, 0, 0.5}, {0, 0, 0.1}, {0.0014, 0.0014, 0.0001}}}};
  for (const auto& [name, link] : links) {
    CAPTURE(name);
    check_same(whole_of(robot, name), whole_of(link));
  }
  CHECK(robot.mass() == doctest::Approx(3.35).epsilon(1e-9));
  CHECK(robot.bodies[robot.root()].name == "base_link");

  const JointModel& lift = joint_of(robot, "lift");
  CHECK(!lift.axes.at(0).angular);
  CHECK(close(lift.axes[0].axis, {0, 0, 1}));
  CHECK(*lift.axes[0].upper == doctest::Approx(0.15));
  CHECK(lift.axes[0].actuator == ActuatorMode::position);
  CHECK(lift.axes[0].most_force == 40);
  CHECK(lift.axes[0].most_speed == doctest::Approx(0.1));
  CHECK(lift.axes[0].damping == 0.5);
  CHECK(close(joint_of(robot, "left_wheel_joint").axes.at(0).axis, {0, 1, 0}));
  REQUIRE(robot.drive);
  CHECK(robot.drive->wheel_radius == 0.05);
  CHECK(robot.drive->track == 0.24);
  CHECK(robot.drive->most_speed == doctest::Approx(12 * 0.05));

  REQUIRE(robot.cameras.size() == 1);
  const auto& eye = robot.cameras[0];
  const BodyModel& mast = robot.bodies[eye.body];
  CHECK(mast.name == "mast");
  // On the link camera_link, which has no mass: 0.03 ahead of and 0.18 above the mast's frame,
  // 0.5 rad down, both turned by the mast's 0.5 rad.
  const Pose X_RC = mast.X_RB * eye.X_BC;
  CHECK(close(X_RC.p, {0.1 + 0.03 * std::cos(0.5), 0.03 * std::sin(0.5), 0.27}));
  const Vec3 look = rotate(X_RC.q, {0, 0, 1});
  CHECK(
      close(look, {std::cos(0.5) * std::cos(0.5), std::cos(0.5) * std::sin(0.5), -std::sin(0.5)}));
  CHECK(eye.intrinsics.fx == doctest::Approx(320 / std::tan(0.5)));
}

TEST_CASE("a world in SDF is a scene with a block and a robot in files of their own") {
  const ImportedDescription yard = imported("yard.sdf", project_file("scenes/yard.sdf"));
  CHECK(yard.scene);
  REQUIRE(yard.parts.size() == 2);
  CHECK(yard.parts[0].name == "yard-block.yaml");
  CHECK(yard.parts[1].name == "yard-cart.yaml");
  check_golden("tests/golden/sdf-yard.yaml",
               yard.text + "---\n" + yard.parts[0].text + "---\n" + yard.parts[1].text);
  const RobotModel cart = robot_in(yard.parts[1].text);
  check_same(whole_of(cart, "deck"),
             whole_of(Written{1.5, {0, 0, 0.04}, {}, {}, {0.004, 0.01, 0.012}}));
  const double quarter = -1.5707963267948966;
  check_same(whole_of(cart, "right"),
             whole_of(Written{0.1, {-0.05, -0.09, 0.04}, {quarter, 0, 0}, {}, {5e-5, 5e-5, 8e-5}}));
  CHECK(close(joint_of(cart, "left_joint").axes.at(0).axis, {0, 1, 0}));
  CHECK(close(joint_of(cart, "right_joint").axes.at(0).axis, {0, 1, 0}));
  CHECK(cart.cameras.at(0).intrinsics.p1 == 0.001);
  CHECK(cart.rangefinders.size() == 1);
}

std::string link_text(const std::string& name, const std::string& inside) {
  return "<link name=\"" + name + "\">" + inside + "</link>";
}

TEST_CASE("any link keeps its mass, its middle of mass and its moments") {
  CHECK(rc::check([] {
    const auto within = [](double low, double high) {
      return low + (high - low) * *rc::gen::inRange(0, 100'000) / 100'000.0;
    };
    Written link;
    link.mass = within(0.01, 5);
    // Moments of any body: the principal ones are sums of squares.
    const double x = within(1e-4, 1e-2), y = within(1e-4, 1e-2), z = within(1e-4, 1e-2);
    const Plain q = from_rpy(within(-3, 3), within(-1.5, 1.5), within(-3, 3));
    const Plain d{{{y + z, 0, 0}, {0, x + z, 0}, {0, 0, x + y}}};
    const Plain t = product(q, product(d, turned_over(q)));
    link.six = {t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]};
    for (double& p : link.middle) p = within(-0.2, 0.2);
    for (double& a : link.rpy) a = within(-1.5, 1.5);
    const bool first = *rc::gen::arbitrary<bool>();
    // The robot's lowest point is that of the ball, at 0.
    std::string text = "<robot name=\"r\">";
    text +=
        link_text("ball",
                  "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/></inertial>"
                  "<collision><geometry><sphere radius=\"2\"/></geometry></collision>");
    std::string shapes =
        "<collision><origin xyz=\"0.1 0 0\"/><geometry><box size=\"0.1 0.2 0.3\"/>"
        "</geometry></collision>";
    if (first) {
      shapes +=
          "<collision><origin xyz=\"0 0.1 0\" rpy=\"0.1 0.2 0.3\"/><geometry>"
          "<cylinder radius=\"0.1\" length=\"0.2\"/></geometry></collision>";
    }
    text += link_text(
        "any",
        fmt::format("<inertial><origin xyz=\"{} {} {}\"/><mass value=\"{}\"/><inertia ixx=\"{}\" "
                    "iyy=\"{}\" izz=\"{}\" ixy=\"{}\" ixz=\"{}\" iyz=\"{}\"/></inertial>{}",
                    link.middle[0], link.middle[1], link.middle[2], link.mass, link.six[0],
                    link.six[1], link.six[2], link.six[3], link.six[4], link.six[5], shapes));
    text += fmt::format(
        "<joint name=\"j\" type=\"fixed\"><parent link=\"ball\"/><child link=\"any\"/>"
        "<origin xyz=\"0.3 0.2 0.1\" rpy=\"{} {} {}\"/></joint></robot>",
        link.rpy[0], link.rpy[1], link.rpy[2]);
    link.at = {0.3, 0.2, 2.1};
    Diagnostics diagnostics;
    const auto out =
        import_description(std::make_shared<SourceFile>("r.urdf", text), "r", diagnostics);
    REQUIRE_MESSAGE(out, to_text(diagnostics));
    check_same(whole_of(robot_in(out->text), "any"), whole_of(link));
  }));
}

TEST_CASE("angles about fixed axes come back as those about turned ones") {
  CHECK(rc::check([] {
    const auto angle = [](double most) { return most * *rc::gen::inRange(-1000, 1001) / 1000.0; };
    // Straight up and down among them.
    const Vec3 rpy{angle(3.14), *rc::gen::element(angle(1.5), 1.5707963267948966), angle(3.14)};
    const Quat q = urdf::from_rpy(rpy);
    const Vec3 back = urdf::degrees_zyx(q) * (3.14159265358979 / 180);
    const Mat3 a = matrix(q), b = matrix(urdf::from_rpy({back.z, back.y, back.x}));
    for (int i = 0; i < 3; ++i) RC_ASSERT(length(a.column(i) - b.column(i)) < 1e-6);
  }));
}

}  // namespace
}  // namespace stig
