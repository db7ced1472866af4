// SPDX-License-Identifier: MIT
#include "physical/sensors/camera_sensor.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "physical/sensors/line_of_sight.h"
#include "physical/sensors/sensor_support.h"
#include "sensing/tag_pose.h"
#include "support/draws.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr double kSide = 0.024;
constexpr double kHair = 1e-6;  ///< m
constexpr double kWide = 75 * kDegree;

/// A tag that faces the camera.
SensorScene tag_at(const Vec3& p, double side = kSide) {
  return one_tag({p, kFacing}, side, kWide);
}
SensorScene led_at(const Vec3& p) { return one_led({p, kFacing}, kWide); }

Pose some_pose(double spread) {
  const Vec3 p = some_vector() * spread;
  return {p, rotation(some_vector() * 3)};
}

/// The rule with neither index nor tiles: each line against each body.
bool free_line(const SensorScene& scene, const Vec3& from, const Vec3& to, std::uint32_t owner) {
  for (const SightObstacle& o : scene.obstacles) {
    if (o.owner == owner) continue;
    const Pose X_SW = inverse(o.X_WS);
    const auto c = cut(scene.shapes[o.shape], X_SW * from, rotate(X_SW.q, to - from));
    if (c && c->in > 0 && c->in <= 1) return false;
  }
  return true;
}

bool is_seen(const SensorScene& scene, const CameraView& view, const Pose& X_WC,
             const std::vector<Vec3>& points, const Vec3& centre, const Vec3& normal, double widest,
             std::uint32_t owner) {
  const Vec3 way = X_WC.p - centre;
  if (std::acos(std::clamp(dot(way, normal) / length(way), -1.0, 1.0)) > widest) return false;
  for (const Vec3& p : points) {
    if (!image_of(view, inverse(X_WC) * p) || !free_line(scene, X_WC.p, p, owner)) return false;
  }
  return true;
}

/// Numbers of all that is seen: body · 100 + mark, LEDs negative.
std::vector<int> slow_sight(const SensorScene& scene, const CameraView& view, const Pose& X_WC) {
  std::vector<int> out;
  for (std::size_t b = 0; b < scene.marked.size(); ++b) {
    const MarkedBody& m = scene.marked[b];
    const MarkedKind& kind = scene.kinds[m.kind];
    for (std::size_t i = 0; i < kind.tags.size(); ++i) {
      const Pose X_WT = m.X_WB * kind.tags[i].X_BT;
      std::vector<Vec3> points;
      for (const Vec3& p : tag_corners(kind.tags[i].side)) points.push_back(X_WT * p);
      if (is_seen(scene, view, X_WC, points, X_WT.p, rotate(X_WT.q, {0, 0, 1}), kind.tags[i].widest,
                  m.owner)) {
        out.push_back(int(b * 100 + i));
      }
    }
    for (std::size_t i = 0; i < kind.leds.size(); ++i) {
      const Vec3 p = m.X_WB * kind.leds[i].p_B;
      if (m.leds[i] != Rgb{} &&
          is_seen(scene, view, X_WC, {p}, p, rotate(m.X_WB.q, kind.leds[i].normal_B),
                  kind.leds[i].widest, m.owner)) {
        out.push_back(-int(b * 100 + i));
      }
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<int> numbers(const CameraSight& sight) {
  std::vector<int> out;
  for (const SeenTag& t : sight.tags) out.push_back(int(t.body * 100 + t.tag));
  for (const SeenLed& l : sight.leds) out.push_back(-int(l.body * 100 + l.led));
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE("tags and LEDs: the angle to the camera, just within and just beyond") {
  for (const double widest : {75 * kDegree, 60 * kDegree}) {
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0.6, -0.8, 0}}) {
      const auto turned = [&](double angle) {
        return Pose{{0, 0, 0.2}, kFacing * rotation(axis * angle)};
      };
      CHECK(sees_tag(one_tag(turned(widest - 1e-6), kSide, widest)));
      CHECK(!sees_tag(one_tag(turned(widest + 1e-6), kSide, widest)));
      CHECK(sees_led(one_led(turned(widest - 1e-6), widest)));
      CHECK(!sees_led(one_led(turned(widest + 1e-6), widest)));
    }
  }
  // It is the line to the camera that counts, not the camera's axis.
  const Vec3 aside{0.05, 0, 0.2};
  CHECK(!sees_led(one_led({aside, kFacing}, std::atan2(0.05, 0.2) - 1e-6)));
  CHECK(sees_led(one_led({aside, kFacing}, std::atan2(0.05, 0.2) + 1e-6)));
  CHECK(sees_led(one_led({aside, {}}, std::numbers::pi)));  // shines all around
}

TEST_CASE("tags: every corner inside each border of the image") {
  const double z = 0.3;
  const double right = 320 / 883.961 * z - kSide / 2, down = 180 / 883.961 * z - kSide / 2;
  for (const double sign : {1.0, -1.0}) {
    CHECK(sees_tag(tag_at({sign * (right - kHair), 0, z})));
    CHECK(!sees_tag(tag_at({sign * (right + kHair), 0, z})));
    CHECK(sees_tag(tag_at({0, sign * (down - kHair), z})));
    CHECK(!sees_tag(tag_at({0, sign * (down + kHair), z})));
  }
}

TEST_CASE("LEDs: inside each border of the image") {
  const double z = 0.3, right = 320 / 883.961 * z, down = 180 / 883.961 * z;
  for (const double sign : {1.0, -1.0}) {
    CHECK(sees_led(led_at({sign * (right - kHair), 0, z})));
    CHECK(!sees_led(led_at({sign * (right + kHair), 0, z})));
    CHECK(sees_led(led_at({0, sign * (down - kHair), z})));
    CHECK(!sees_led(led_at({0, sign * (down + kHair), z})));
  }
}

TEST_CASE("near and far plane, which a single corner can miss") {
  CHECK(sees_tag(tag_at({0, 0, 0.05 + kHair}, 0.012)));
  CHECK(!sees_tag(tag_at({0, 0, 0.05 - kHair}, 0.012)));
  CHECK(sees_tag(tag_at({0, 0, 0.5 - kHair})));
  CHECK(!sees_tag(tag_at({0, 0, 0.5 + kHair})));
  CHECK(sees_led(led_at({0, 0, 0.05 + kHair})));
  CHECK(!sees_led(led_at({0, 0, 0.05 - kHair})));
  CHECK(sees_led(led_at({0, 0, 0.5 - kHair})));
  CHECK(!sees_led(led_at({0, 0, 0.5 + kHair})));
  // Tilted by 30 degrees, the far edge lies 6 mm behind the middle.
  const Quat tilted = kFacing * rotation({30 * kDegree, 0, 0});
  CHECK(sees_tag(one_tag({{0, 0, 0.494 - kHair}, tilted}, kSide, kWide)));
  CHECK(!sees_tag(one_tag({{0, 0, 0.494 + kHair}, tilted}, kSide, kWide)));
}

TEST_CASE("dark LEDs are not seen") {
  SensorScene scene = led_at({0, 0, 0.2});
  CHECK(sees_led(scene));
  scene.marked[0].leds = {Rgb{}};
  CHECK(!sees_led(scene));
  scene.marked[0].leds.clear();
  CHECK(!sees_led(scene));
}

TEST_CASE("bodies that graze the line to a corner") {
  // Lines to the right corners leave a 10 mm thick wall, halfway, 6.2 mm beside the axis.
  const double line = kSide / 2 * 0.155 / 0.3;
  const auto with = [&](const SightShape& shape, double x, double y, double z) {
    SensorScene scene = tag_at({0, 0, 0.3});
    hide_behind(scene, shape, {{x, y, z}, {}});
    return sees_tag(scene);
  };
  const SightShape wall = sight_box({0.1, 0.1, 0.01});
  CHECK(with(wall, line + 0.05 + kHair, 0, 0.15));
  CHECK(!with(wall, line + 0.05 - kHair, 0, 0.15));
  CHECK(with(wall, -line - 0.05 - kHair, 0, 0.15));
  CHECK(!with(wall, -line - 0.05 + kHair, 0, 0.15));
  CHECK(with(wall, 0, line + 0.05 + kHair, 0.15));
  CHECK(!with(wall, 0, line + 0.05 - kHair, 0.15));
  // Small ones between the lines hide the middle of the tag, but no corner.
  CHECK(with(sight_sphere(0.004), 0, 0, 0.15));
  CHECK(with(sight_box({0.008, 0.008, 0.008}), 0, 0, 0.15));
  // A ball and a standing cylinder near the corner's line.
  const Vec3 at = Vec3{kSide / 2, kSide / 2, 0.3} * 0.5;
  const Vec3 aside = normalised(cross(cross(at, {1, 1, 0}), at));  // away from the axis
  const Vec3 out = at + aside * 0.01, in = at + aside * 0.002;
  CHECK(with(sight_sphere(0.01 - kHair), out.x, out.y, out.z));
  CHECK(!with(sight_sphere(0.01 + kHair), out.x, out.y, out.z));
  CHECK(!with(sight_cylinder(0.003, 0.02), in.x, in.y, in.z));
  const SightShape hull = sight_hull({{{1, 0, 0}, 0.05},
                                      {{-1, 0, 0}, 0.05},
                                      {{0, 1, 0}, 0.05},
                                      {{0, -1, 0}, 0.05},
                                      {{0, 0, 1}, 0.005},
                                      {{0, 0, -1}, 0.005}},
                                     {{0.05, 0.05, 0.005}});
  CHECK(with(hull, line + 0.05 + kHair, 0, 0.15));
  CHECK(!with(hull, line + 0.05 - kHair, 0, 0.15));
}

TEST_CASE("what hides and what does not") {
  const SightShape box = sight_box({0.055, 0.055, 0.055});
  const auto with = [&](const SightShape& shape, const Pose& X_WS, std::uint32_t owner) {
    SensorScene tag = tag_at({0, 0, 0.3}), led = led_at({0, 0, 0.3});
    hide_behind(tag, shape, X_WS, owner);
    hide_behind(led, shape, X_WS, owner);
    CHECK(sees_tag(tag) == sees_led(led));
    return sees_tag(tag);
  };
  CHECK(!with(box, {{0, 0, 0.2}, {}}, 2));
  CHECK(with(box, {{0, 0, 0.2}, {}}, 1));                              // its own block
  CHECK(with(box, {{0, 0, 0.3275 + kHair}, {}}, 2));                   // right behind it
  CHECK(!with(box, {{0, 0, 0.3275 - kHair}, {}}, 2));                  // the mark is inside it
  CHECK(with(box, {{0, 0, -0.05}, {}}, 2));                            // behind the camera
  CHECK(with(box, {{0, 0, 0}, {}}, 2));                                // the camera is inside it
  CHECK(!with(sight_box({0.01, 0.01, 0.01}), {{0, 0, 0.02}, {}}, 2));  // before the near plane
  CHECK(!with(sight_box({3, 3, 0.01}), {{0, 0, 0.1}, {}}, 2));         // a wall
}

TEST_CASE("pixels are those of the projection, in the order of the corners") {
  const SensorScene scene = tag_at({0.01, -0.02, 0.25});
  const CameraSight sight = sight_of(scene);
  REQUIRE(sight.tags.size() == 1);
  const auto& c = sight.tags[0].corners;
  CHECK(c[0].x == doctest::Approx(319.5 + 883.961 * (0.01 - 0.012) / 0.25));
  CHECK(c[0].y == doctest::Approx(179.5 + 883.961 * (-0.02 + 0.012) / 0.25));
  CHECK(c[1].x > c[0].x);
  CHECK(c[2].y < c[1].y);
  CHECK(c[3].x == doctest::Approx(c[0].x));
}

TEST_CASE("a block shows at most three faces, each with a tag and four LEDs") {
  SensorScene scene;
  add_block(scene, {{0.22, 0, 0.0275}, rotation({0, 0, 0.6})}, 1);
  const Pose X_WC = tilted_camera({0, 0, 0.25}, 0);
  const CameraSight sight = look(SensorIndex(scene), paper_view(), X_WC);
  CHECK(sight.tags.size() == 3);
  CHECK(sight.leds.size() == 12);
  for (const SeenTag& t : sight.tags) CHECK(t.tag != 5);  // the face below
}

TEST_CASE("index and tiles change nothing of what is seen") {
  CHECK(rc::check("as each line against each body", [] {
    SensorScene scene;
    const Pose X_WC = some_pose(0.2), ahead = X_WC * Pose{{0, 0, 0.3}, {}};
    const auto blocks = *rc::gen::inRange<std::uint32_t>(1, 40);
    for (std::uint32_t i = 0; i < blocks; ++i) add_block(scene, ahead * some_pose(0.25), i + 1);
    hide_behind(scene, sight_sphere(0.03), some_pose(0.2), 100);
    hide_behind(scene, sight_cylinder(0.02, 0.2), some_pose(0.2), 101);
    hide_behind(scene, sight_box({1.5, 0.01, 0.05}), some_pose(0.4), 102);
    CameraView view = paper_view();
    if (*rc::gen::arbitrary<bool>()) {
      CameraIntrinsics bent = view.intrinsics;
      bent.k1 = -0.3;
      bent.k2 = 0.1;
      bent.fx = bent.fy = 400;
      view = *make_view(bent, 0.05, 0.5);
    }
    const CameraSight sight = look(SensorIndex(scene), view, X_WC);
    RC_ASSERT(numbers(sight) == slow_sight(scene, view, X_WC));
    RC_CLASSIFY(sight.tags.size() > 3, "more than three tags");
    RC_CLASSIFY(sight.leds.size() > 20, "more than twenty LEDs");
  }));
}
