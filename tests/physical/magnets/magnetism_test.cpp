// SPDX-License-Identifier: MIT
#include "physical/magnets/magnetism.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>

#include "robots/block.h"
#include "support/draws.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// A multiple of 1/1000 from -1 to 1.
Vec3 some_moment() { return some_direction() * (0.01 + 0.2 * std::abs(unit_value())); }
Vec3 some_distance() { return some_direction() * (0.008 + 0.04 * std::abs(unit_value())); }

bool near(const Vec3& a, const Vec3& b, double tolerance) { return length(a - b) <= tolerance; }

/// Two magnets of two owners, at rest.
std::vector<Magnet> two_magnets(double distance, const Vec3& u0, const Vec3& u1) {
  return {{0, true, {}, u0, 0.2}, {1, true, {distance, 0, 0}, u1, 0.2}};
}
const std::vector<MagnetOwner> kTwoOwners = {{0, 1, {}, true}, {1, 2, {}, true}};

void relax(std::vector<Magnet>& magnets, int steps) {
  const std::vector<MagnetPair> pairs = {{0, 1, magnets[0].p_W - magnets[1].p_W}};
  for (int i = 0; i < steps; ++i) relax_magnets(magnets, pairs, kTwoOwners, 0.005, {});
}

}  // namespace

TEST_CASE("axial pull of the paper's magnets, within one per cent") {
  const struct {
    double distance, equal, electro;
  } table[] = {{0.010, 2.38, 5.23},  {0.0125, 0.97, 2.14},  {0.015, 0.47, 1.03},
               {0.0175, 0.25, 0.56}, {0.020, 0.149, 0.327}, {0.030, 0.029, 0.065}};
  const Vec3 own{75 * kMomentPerField, 0, 0}, other{165 * kMomentPerField, 0, 0};
  for (const auto& row : table) {
    CAPTURE(row.distance);
    const Vec3 r{row.distance, 0, 0};
    // The table is rounded to its last digit as well.
    CHECK(-dipole_wrench(own, own, r).force.x == doctest::Approx(row.equal).epsilon(0.016));
    CHECK(-dipole_wrench(own, other, r).force.x == doctest::Approx(row.electro).epsilon(0.01));
  }
  CHECK(-dipole_wrench(own, own, {0.01, 0, 0}).force.x == doctest::Approx(2.3794).epsilon(1e-4));
}

TEST_CASE("Newton's third law, for torques too") {
  CHECK(rc::check("forces opposite, angular momentum kept", [] {
    const Vec3 m0 = some_moment(), m1 = some_moment(), r = some_distance();
    const DipoleWrench a = dipole_wrench(m0, m1, r), b = dipole_wrench(m1, m0, -r);
    const double scale = length(a.force) + 1e-9;
    RC_ASSERT(near(a.force, -b.force, 1e-12 * scale));
    RC_ASSERT(near(a.torque_on_other, b.torque, 1e-12 * scale));
    // About the second magnet: both torques, and the first's force at its arm.
    RC_ASSERT(near(a.torque + a.torque_on_other + cross(r, a.force), {}, 1e-9 * scale));
  }));
}

TEST_CASE("force is the energy's slope, torque its change with direction") {
  CHECK(rc::check("central differences", [] {
    const Vec3 m0 = some_moment(), m1 = some_moment(), r = some_distance();
    const Vec3 way = some_direction();
    const DipoleWrench wrench = dipole_wrench(m0, m1, r);
    const double h = 1e-6;
    const double slope =
        (dipole_energy(m0, m1, r + way * h) - dipole_energy(m0, m1, r - way * h)) / (2 * h);
    const double strength = length(m0) * length(m1) * kDipoleConstant / std::pow(length(r), 4);
    RC_ASSERT(std::abs(dot(wrench.force, way) + slope) < 1e-5 * strength);
    const auto turned = [&](double angle) { return matrix(rotation(way * angle)) * m0; };
    const double bend =
        (dipole_energy(turned(h), m1, r) - dipole_energy(turned(-h), m1, r)) / (2 * h);
    RC_ASSERT(std::abs(dot(wrench.torque, way) + bend) < 1e-5 * strength * length(r));
  }));
}

TEST_CASE("work done along a path is the energy lost") {
  const Vec3 m0{0.1, 0.05, 0.1}, m1{-0.02, 0.15, 0.1};
  const Vec3 from{0.035, 0.01, -0.01}, to{-0.005, 0.02, 0.012};
  double work = 0;
  const int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    const Vec3 r = from + (to - from) * ((i + 0.5) / steps);
    work += dot(dipole_wrench(m0, m1, r).force, (to - from) * (1.0 / steps));
  }
  const double lost = dipole_energy(m0, m1, from) - dipole_energy(m0, m1, to);
  CHECK(work == doctest::Approx(lost).epsilon(1e-5));
}

TEST_CASE("free magnets align and attract, wherever they pointed") {
  CHECK(rc::check("pair ends in its deepest energy", [] {
    auto magnets = two_magnets(0.012, some_direction(), some_direction());
    relax(magnets, 60);
    const Vec3 m0 = magnets[0].direction * 0.2, m1 = magnets[1].direction * 0.2;
    const double deepest = -2 * kDipoleConstant * 0.04 / std::pow(0.012, 3);
    RC_ASSERT(dipole_energy(m0, m1, {-0.012, 0, 0}) < 0.999 * deepest);
  }));
}

TEST_CASE("magnets that face each other exactly do not stay so") {
  auto magnets = two_magnets(0.012, {1, 0, 0}, {-1, 0, 0});
  relax(magnets, 60);
  CHECK(dot(magnets[0].direction, magnets[1].direction) > 0.999);
  CHECK(std::abs(magnets[0].direction.x) > 0.999);
}

TEST_CASE("relaxing never raises the energy") {
  CHECK(rc::check("each step", [] {
    auto magnets = two_magnets(0.015, some_direction(), some_direction());
    const Vec3 r{-0.015, 0, 0};
    const auto energy = [&] {
      return dipole_energy(magnets[0].direction * 0.2, magnets[1].direction * 0.2, r);
    };
    for (int i = 0; i < 20; ++i) {
      const double before = energy();
      relax(magnets, 1);
      // The nudge away from an exact balance may cost a little.
      RC_ASSERT(energy() <= before + 1e-3 * std::abs(before) + 1e-12);
    }
  }));
}

TEST_CASE("magnets that are fixed, asleep or without moment keep their direction") {
  auto magnets = two_magnets(0.012, {0, 1, 0}, {1, 0, 0});
  magnets[0].free = false;
  relax(magnets, 5);
  CHECK(magnets[0].direction == Vec3{0, 1, 0});
  auto owners = kTwoOwners;
  owners[1].awake = false;
  const Vec3 before = magnets[1].direction;
  relax_magnets(magnets, {{0, 1, {-0.012, 0, 0}}}, owners, 0.005, {});
  CHECK(magnets[1].direction == before);
}

TEST_CASE("facing spheres at contact swing with a period of 3.46 ms, until bearings stop them") {
  // Both tilted alike: 3 · 10⁻⁷ m²/d³ of torque for a radian.
  const double stiffness = 3 * kDipoleConstant * 0.04 / 1e-6;
  const Bearing smooth;
  const double period = 2 * 3.14159265358979 * std::sqrt(smooth.inertia / stiffness);
  CHECK(period == doctest::Approx(3.44e-3).epsilon(0.01));
  const double small = 0.01, dt = period / 1000;
  for (const double damping : {0.0, 2e-6}) {
    const Bearing bearing{smooth.inertia, damping};
    auto magnets = two_magnets(0.01, {1, small, 0}, {1, small, 0});
    double highest = 0;
    for (int i = 0; i < 1000; ++i) {
      const DipoleWrench wrench =
          dipole_wrench(magnets[0].direction * 0.2, magnets[1].direction * 0.2, {-0.01, 0, 0});
      spin_magnet(magnets[0], wrench.torque, {}, bearing, dt);
      spin_magnet(magnets[1], wrench.torque_on_other, {}, bearing, dt);
      if (i > 800) highest = std::max(highest, magnets[0].direction.y);
      if (i == 499) CHECK(magnets[1].direction.y < -0.3 * small);
    }
    // Amplitudes decay by exp(-c t / 2I).
    const double expected = small * std::exp(-damping * period / (2 * smooth.inertia));
    CHECK(highest == doctest::Approx(expected).epsilon(0.05));
  }
}

TEST_CASE("a bearing's friction turns the block as it slows the sphere") {
  Magnet magnet{0, true, {}, {0, 0, 1}, 0.2, {5, 0, 0}};
  const Bearing bearing{3.6e-9, 1e-6};
  const double before = magnet.spin.x * bearing.inertia, dt = 1e-3;
  const Vec3 torque = spin_magnet(magnet, {}, {1, 0, 0}, bearing, dt);
  CHECK(magnet.spin.x > 1);
  CHECK(magnet.spin.x < 5);
  CHECK(torque.x * dt == doctest::Approx(before - magnet.spin.x * bearing.inertia));
}

TEST_CASE("the grid finds the pairs that trying all of them finds") {
  CHECK(rc::check("against all pairs", [] {
    const auto count = *rc::gen::inRange<std::uint32_t>(0, 40);
    std::vector<Magnet> magnets;
    std::vector<MagnetOwner> owners;
    const double radius = 0.03, cutoff = 0.04;
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3 centre = some_vector() * 0.2;
      owners.push_back({2 * i, 2 * i + 2, centre, *rc::gen::arbitrary<bool>()});
      for (int k = 0; k < 2; ++k) {
        magnets.push_back({i, true, centre + some_direction() * radius, {0, 0, 1}, 0.2});
      }
    }
    const auto pairs = magnet_pairs(magnets, owners, radius, cutoff);
    std::vector<std::array<std::uint32_t, 4>> expected;
    for (std::uint32_t i = 0; i < magnets.size(); ++i) {
      for (std::uint32_t j = i + 1; j < magnets.size(); ++j) {
        if (magnets[i].owner == magnets[j].owner) continue;
        if (!owners[magnets[i].owner].awake && !owners[magnets[j].owner].awake) continue;
        const Vec3 r = magnets[i].p_W - magnets[j].p_W;
        if (!(squared(r) < cutoff * cutoff) || squared(r) == 0) continue;
        expected.push_back({magnets[i].owner, magnets[j].owner, i, j});
      }
    }
    std::sort(expected.begin(), expected.end());
    RC_ASSERT(pairs.size() == expected.size());
    for (std::size_t at = 0; at < pairs.size(); ++at) {
      const auto& [i, j, r] = pairs[at];
      RC_ASSERT(i == expected[at][2]);
      RC_ASSERT(j == expected[at][3]);
      RC_ASSERT(near(r, magnets[i].p_W - magnets[j].p_W, 1e-15));
    }
  }));
}
