// SPDX-License-Identifier: MIT
// Files of solids, and bodies of robots that are such.
#include "robots/solid.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "base/hull.h"
#include "robots/robot_reader.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

std::vector<Vec3> box_corners(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> out;
  for (int i = 0; i < 8; ++i) {
    out.push_back({(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                   (i & 4) != 0 ? high.z : low.z});
  }
  return out;
}

/// Of boxes that do not overlap, each turned by q.
SolidModel solid_of(const std::vector<std::pair<Vec3, Vec3>>& boxes, const Quat& q = {}) {
  SolidModel out;
  out.name = "test";
  Vec3 first, squares, products;
  for (const auto& [low, high] : boxes) {
    std::vector<Vec3> corners = box_corners(low, high);
    for (Vec3& p : corners) p = rotate(q, p);
    const HullMass mass = hull_mass(corners);
    const Vec3& c = mass.centre;
    out.volume += mass.volume;
    first += c * mass.volume;
    squares += mass.squares + scaled(c, c) * mass.volume;
    products += mass.products + Vec3{c.y * c.z, c.z * c.x, c.x * c.y} * mass.volume;
    out.pieces.push_back(std::move(corners));
  }
  out.centre = first * (1 / out.volume);
  const Vec3& c = out.centre;
  out.squares = squares * (1 / out.volume) - scaled(c, c);
  out.products = products * (1 / out.volume) - Vec3{c.y * c.z, c.z * c.x, c.x * c.y};
  out.surface = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  return out;
}

SolidModel angle() {
  return solid_of({{{0, 0, 0}, {0.3, 0.1, 0.1}}, {{0, 0, 0.1}, {0.1, 0.1, 0.2}}});
}

RobotModel robot_with(const SolidModel& solid, const std::string& body, Diagnostics& diagnostics) {
  const std::string text = "stigc_robot: 1\nname: r\nbodies:\n  - {name: hood, solid: s.yaml, " +
                           body +
                           "}\nleds:\n  - {name: lamp, body: hood, at: [0.01, 0.02, 0.03]}\n";
  const auto robot = read_robot(std::make_shared<SourceFile>("r.yaml", text), diagnostics,
                                [&](const std::string&, std::size_t, FileError&) {
                                  return std::optional(print_solid(solid, "test"));
                                });
  INFO(to_text(diagnostics));
  REQUIRE(robot);
  return *robot;
}

/// Moments and products of inertia of all bodies together, about their middle of mass, along the
/// robot's axes.
Mat3 inertia_of_all(const RobotModel& robot) {
  Mat3 out{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  const Vec3 centre = robot.centre_of_mass();
  for (const BodyModel& body : robot.bodies) {
    const Mat3 own = rotated_diagonal(matrix(body.X_RB.q), moments_of(body));
    const Vec3 d = body.X_RB.p - centre;
    const auto add = [&](Vec3& column, const Vec3& of, const Vec3& e) {
      column += of + (e * squared(d) - d * dot(d, e)) * body.mass;
    };
    add(out.x, own.x, {1, 0, 0});
    add(out.y, own.y, {0, 1, 0});
    add(out.z, own.z, {0, 0, 1});
  }
  return out;
}

bool agree(const Vec3& a, const Vec3& b, double tolerance = 1e-12) {
  return length(a - b) <= tolerance;
}

/// The robot weighs, and resists turning, as the solid in its place.
void check_mass(const SolidModel& solid, const Quat& q, const Vec3& place, double mass,
                const std::string& body) {
  Diagnostics diagnostics;
  const RobotModel robot = robot_with(solid, body, diagnostics);
  CHECK(robot.joints.size() + 1 == robot.bodies.size());
  CHECK(robot.mass() == doctest::Approx(mass).epsilon(1e-12));
  CHECK(agree(robot.centre_of_mass(), place + rotate(q, solid.centre)));
  const Vec3& s = solid.squares;
  const Vec3& o = solid.products;
  const Mat3 r = matrix(q);
  const Mat3 i{Vec3{s.y + s.z, -o.z, -o.y} * mass, Vec3{-o.z, s.x + s.z, -o.x} * mass,
               Vec3{-o.y, -o.x, s.x + s.y} * mass};
  const Mat3 all = inertia_of_all(robot);
  for (const Vec3& e : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    CHECK(agree(all * e, r * (i * r.transposed(e)), 1e-12));
  }
  for (const BodyModel& one : robot.bodies) {
    const Vec3 m = moments_of(one);
    CHECK(2 * std::max({m.x, m.y, m.z}) <= (m.x + m.y + m.z) * (1 + 1e-9));
  }
  // Devices are measured along the file's axes from the mesh's origin, whatever the pieces' are.
  CHECK(agree(robot.bodies[0].X_RB * robot.leds[0].p_B, place + rotate(q, {0.01, 0.02, 0.03})));
}

}  // namespace

TEST_CASE("a printed solid is read as it was") {
  const SolidModel solid = solid_of({{{0, 0, 0}, {0.3, 0.1, 0.1}}}, rotation({0.3, 0.4, 0.5}));
  Diagnostics diagnostics;
  const std::string text = print_solid(solid, "made for a test");
  const auto back = read_solid(std::make_shared<SourceFile>("s.yaml", text), diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(back);
  CHECK(back->volume == solid.volume);
  CHECK(back->centre == solid.centre);
  CHECK(agree(back->squares, solid.squares, 1e-17));
  CHECK(back->products == solid.products);
  CHECK(back->pieces == solid.pieces);
  CHECK(back->surface.points == solid.surface.points);
  CHECK(back->surface.triangles == solid.surface.triangles);
  CHECK(print_solid(*back, "made for a test").size() > 0);
}

TEST_CASE("a robot's body of one piece, of several, and askew, weighs what the solid does") {
  const SolidModel plain = solid_of({{{0, 0, 0}, {0.3, 0.1, 0.1}}});
  check_mass(plain, {}, {0.1, 0.2, 0.3}, 2.1, "density: 700, base: [0.1, 0.2, 0.3]");
  check_mass(plain, {}, {0.1, 0.2, 0.3}, 5, "mass: 5, center: [0.1, 0.2, 0.3]");
  check_mass(angle(), {}, {0, 0, 0}, 5, "mass: 5, base: [0, 0, 0]");
  const Quat q = rotation({0, 0, std::acos(0.0)});
  check_mass(angle(), q, {1, 0, 0}, 5, "mass: 5, base: [1, 0, 0], turn: [90, 0, 0]");
  const SolidModel askew = solid_of({{{0, 0, 0}, {0.3, 0.1, 0.1}}}, rotation({0.3, 0.4, 0.5}));
  check_mass(askew, {}, {0, 0, 0}, 5, "mass: 5, base: [0, 0, 0]");
}

TEST_CASE("pieces are fixed to the body that the file names, and only it has the surface") {
  Diagnostics diagnostics;
  const RobotModel robot = robot_with(angle(), "mass: 5, base: [0, 0, 0]", diagnostics);
  REQUIRE(robot.bodies.size() == 2);
  CHECK(robot.bodies[0].name == "hood");
  CHECK(robot.bodies[1].name == "hood piece 2");
  CHECK(robot.root() == 0);
  CHECK(robot.bodies[0].visual->triangles.size() == 1);
  CHECK(agree(robot.bodies[0].X_RB * robot.bodies[0].visual->points[1], {1, 0, 0}));
  CHECK(robot.bodies[1].visual->triangles.empty());
  // Moments that the file gives are those of the whole.
  const RobotModel given =
      robot_with(angle(), "mass: 5, base: [0, 0, 0], inertia: [0.1, 0.1, 0.12]", diagnostics);
  const Mat3 i = inertia_of_all(given);
  CHECK(agree({i.x.x, i.y.y, i.z.z}, {0.1, 0.1, 0.12}));
}

TEST_CASE("density is of any shape") {
  Diagnostics diagnostics;
  const auto robot = read_robot(std::make_shared<SourceFile>("r.yaml", R"(stigc_robot: 1
name: r
bodies:
  - {name: a, box: [0.1, 0.2, 0.3], density: 1000, base: [0, 0, 0]}
  - {name: b, cylinder: {radius: 0.1, height: 0.2}, density: 1000, base: [0, 0, 0]}
  - {name: c, sphere: {radius: 0.1}, density: 1000, base: [0, 0, 0]}
  - {name: d, density: 1000, base: [0, 0, 0],
     hull: [{at: [0, 0, 0]}, {at: [0.1, 0, 0]}, {at: [0, 0.1, 0]}, {at: [0, 0, 0.1]}]}
joints: [{parent: a, child: b}, {parent: a, child: c}, {parent: a, child: d}]
)"),
                                diagnostics);
  REQUIRE_MESSAGE(robot, to_text(diagnostics));
  const double pi = std::acos(-1.0);
  CHECK(robot->bodies[0].mass == doctest::Approx(6));
  CHECK(robot->bodies[1].mass == doctest::Approx(2 * pi));
  CHECK(robot->bodies[2].mass == doctest::Approx(4 * pi / 3));
  CHECK(robot->bodies[3].mass == doctest::Approx(1.0 / 6));
}

TEST_CASE("what is said of files that are no solids") {
  const std::string good = print_solid(angle(), "test");
  const auto with = [&good](const std::string& from, const std::string& to) {
    std::string out = good;
    const std::size_t at = out.find(from);
    REQUIRE(at != std::string::npos);
    return out.replace(at, out.find('\n', at) - at, to);
  };
  const std::string pieces = "pieces: [{corners: [0, 0, 0, 1, 0, 0, 0, 1, 0";
  const std::string texts[] = {with("inertia:", "inertia: [1, 1, 3]"),
                               with("products:", "products: [9, 9, 9]"),
                               with("volume:", "volume: .nan"),
                               with("center:", "center: [0, 0, 1e300]"),
                               with("stigc_solid:", "stigc_solid: 2"),
                               with("  triangles:", "  triangles: [0, 1, 3]"),
                               with("  triangles:", "  triangles: [0, 1, 1.5]"),
                               good.substr(0, good.find("pieces:")) + pieces + ", 1, 1, 0]}]\n",
                               good.substr(0, good.find("pieces:")) + pieces + ", 0, 0, 1, 7]}]\n",
                               good.substr(0, good.find("pieces:")),
                               "solid of nothing\n"};
  std::string all;
  for (const std::string& text : texts) {
    Diagnostics diagnostics;
    CHECK_FALSE(read_solid(std::make_shared<SourceFile>("s.yaml", text), diagnostics));
    all += to_text(diagnostics) + "\n";
  }
  check_golden("tests/golden/solid-diagnostics.txt", all);
}

TEST_CASE("the JSON Schema of solids") {
  check_golden("tests/golden/solid-schema.json", solid_schema());
}

}  // namespace stig
