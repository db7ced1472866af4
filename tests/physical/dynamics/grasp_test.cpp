// SPDX-License-Identifier: MIT
// Forces at the points of a grasp: those that are found bear the wrench, and none are found where
// there are none.
#include "physical/dynamics/grasp.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "support/draws.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr double kFriction = 0.4;

/// A body that is pushed down by four points above it, as an effector does.
Grasp four_above() {
  Contact contact;
  contact.a = 3;
  contact.b = 7;
  contact.normal = {0, 0, 1};  // from b to a: the body, number 7, is pushed down
  contact.friction = kFriction;
  contact.count = 4;
  for (std::size_t i = 0; i < 4; ++i) {
    contact.points[i].p_W = {i % 2 == 0 ? 0.02 : -0.02, i < 2 ? 0.02 : -0.02, 0.0275};
    contact.points[i].push = 0.01;
  }
  Grasp grasp;
  grasp.body = 7;
  grasp.contacts = {contact};
  return grasp;
}

struct Borne {
  Twist sum;
  double worst = 0;  ///< N·s, by which a point pulls, or slips more than its friction gives
};

/// What the forces at the points come to, added up anew.
Borne borne(const Grasp& grasp) {
  Borne out;
  for (const Contact& contact : grasp.contacts) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.count); ++i) {
      const ContactPoint& point = contact.points[i];
      const Vec3 force = (contact.normal * point.push + point.friction) * -1;  // on the second
      out.sum.v += force;
      out.sum.w += cross(point.p_W, force);
      out.worst = std::max(
          {out.worst, -point.push, length(point.friction) - contact.friction * point.push});
    }
  }
  return out;
}

double drawn(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 10001) / 1e4;
}

}  // namespace

TEST_CASE("a wrench that forces well within the cones make is borne, by such forces") {
  rc::check([] {
    Grasp grasp = four_above(), wanted = grasp;
    RC_ASSERT(complete(grasp));
    for (ContactPoint& point : wanted.contacts[0].points) {
      point.push = drawn(0.002, 0.02);
      const double angle = drawn(0, 6.28), size = drawn(0, 0.7) * kFriction * point.push;
      point.friction = Vec3{std::cos(angle), std::sin(angle), 0} * size;
    }
    const Twist wrench = borne(wanted).sum;
    RC_ASSERT(bear(grasp, wrench));
    const Borne found = borne(grasp);
    RC_ASSERT(length(found.sum.v - wrench.v) < 1e-4 * length(wrench.v));
    RC_ASSERT(length(found.sum.w - wrench.w) < 1e-4 * 0.03 * length(wrench.v));
    RC_ASSERT(found.worst < 2.1e-4 * 0.08);
  });
}

TEST_CASE("what no such forces make is not borne, and leaves them as they were") {
  const auto refused = [](const Twist& wrench) {
    Grasp grasp = four_above();
    REQUIRE(complete(grasp));
    CHECK(!bear(grasp, wrench));
    CHECK(borne(grasp).sum.v.z == doctest::Approx(-0.04));
    CHECK(length(borne(grasp).sum.w) < 1e-12);
  };
  refused({{0, 0, 0.01}, {}});                     // pulled up, through nothing that pulls
  refused({{kFriction * 0.041, 0, -0.04}, {}});    // beyond all friction
  refused({{0, 0, -0.04}, {0.04 * 0.021, 0, 0}});  // turned over an edge
  refused({{0, 0, -0.04}, {0, 0, kFriction * 0.04 * 0.0285}});  // turned about the upright
}

TEST_CASE("points that do not touch bear nothing, and make no grasp") {
  Grasp grasp = four_above();
  for (std::size_t i = 0; i < 2; ++i) grasp.contacts[0].points[i].gap = 1e-4;
  CHECK(!complete(grasp));
}

TEST_CASE(
    "walls on both sides make no grasp, though they could clamp any load, nor steep friction") {
  const auto with = [](const Vec3& normal, double friction) {
    Grasp grasp = four_above();
    Contact wall = grasp.contacts[0];
    wall.a = 4;
    wall.normal = normal;
    for (std::size_t i = 0; i < 4; ++i) {
      ContactPoint& point = wall.points[i];
      point.p_W = {normal.x * 0.0275, i % 2 == 0 ? 0.02 : -0.02, i < 2 ? 0.02 : -0.02};
    }
    grasp.contacts.push_back(wall);
    for (Contact& contact : grasp.contacts) contact.friction = friction;
    return grasp;
  };
  Grasp one = with({1, 0, 0}, 0.4);
  CHECK(complete(one));
  Grasp steep = with({1, 0, 0}, 1.5);
  CHECK(!complete(steep));
  Grasp both = with({1, 0, 0}, 0.1);
  const Grasp other = with({-1, 0, 0}, 0.1);
  both.contacts.push_back(other.contacts[1]);
  CHECK(!complete(both));
}

TEST_CASE("points on a line make no grasp") {
  Grasp grasp = four_above();
  for (std::size_t i = 0; i < 4; ++i) grasp.contacts[0].points[i].p_W.y = 0;
  CHECK(!complete(grasp));
  grasp.contacts[0].count = 2;
  CHECK(!complete(grasp));
}
