// SPDX-License-Identifier: MIT
#include "physical/sensors/range_sensor.h"

#include <doctest/doctest.h>

#include "physical/sensors/sensor_support.h"
#include "support/uses.h"

using namespace stig;

namespace {

RangeDevice device(RangeDevice::Calibration calibration, std::array<double, 3> coefficients,
                   double range = 0.2) {
  return {"1", 0, {}, {1, 0, 0}, range, calibration, coefficients};
}
const RangeDevice kManipulator = device(RangeDevice::Calibration::power, {5432.4, 87.70362, 0});
const RangeDevice kChassis =
    device(RangeDevice::Calibration::quadratic, {1253.394, -5493.967, 7164.404});
const RangeDevice kMetres = device(RangeDevice::Calibration::metres, {}, 0.05);

/// A block whose near face is this far ahead along x, well above the floor.
SensorScene block_ahead(double distance, std::uint32_t owner = 2) {
  SensorScene scene;
  hide_behind(scene, sight_box({0.055, 0.055, 0.055}), {{distance + 0.0275, 0, 1}, {}}, owner);
  return scene;
}
const Pose kSensor{{0, 0, 1}, {}};

double reading(const RangeDevice& d, const SensorScene& scene, const RangeNoise& noise = {},
               const NoiseAddress& address = {}) {
  return read_range(SensorIndex(scene), d, kSensor, 1, noise, address);
}

}  // namespace

TEST_CASE("counts of the paper's robot") {
  const auto counts = [](const RangeDevice& d, double mm) {
    return std::lround(reading(d, block_ahead(mm / 1000)));
  };
  CHECK(counts(kManipulator, 0) == 5432);
  CHECK(counts(kManipulator, 5) == 3504);
  CHECK(counts(kManipulator, 10) == 2260);
  CHECK(counts(kChassis, 0) == 2924);
  // Thresholds of the published controller, whose distances are rounded: 8 counts a millimetre.
  CHECK(std::abs(counts(kChassis, 29) - 2675) <= 4);
  CHECK(std::abs(counts(kChassis, 51) - 2500) <= 4);
  CHECK(counts(kChassis, 199.999) == 1558);
  CHECK(counts(kChassis, 200.001) == 0);
  CHECK(counts(kManipulator, 201) == 0);
}

TEST_CASE("metres of the later robot, at most its range") {
  CHECK(reading(kMetres, block_ahead(0.03)) == doctest::Approx(0.03));
  CHECK(reading(kMetres, block_ahead(0.051)) == 0.05);
}

TEST_CASE("the closest body counts, the own robot does not") {
  SensorScene scene = block_ahead(0.15);
  hide_behind(scene, sight_sphere(0.01), {{0.06, 0, 1}, {}}, 3);
  hide_behind(scene, sight_cylinder(0.01, 0.5), {{0.11, 0, 1}, {}}, 4);
  hide_behind(scene, sight_box({0.02, 0.02, 0.02}), {{0.02, 0, 1}, {}}, 1);
  const SensorIndex index(scene);
  CHECK(*closest_hit(index, {0, 0, 1}, {1, 0, 0}, 0.2, 1) == doctest::Approx(0.05));
  CHECK(*closest_hit(index, {0, 0, 1}, {1, 0, 0}, 0.2, 3) == doctest::Approx(0.01));
  CHECK(*closest_hit(index, {0.08, 0, 1}, {1, 0, 0}, 0.2, 1) == doctest::Approx(0.02));
  CHECK(!closest_hit(index, {0, 0.2, 1}, {1, 0, 0}, 0.2, 1));
  CHECK(!closest_hit(index, {0, 0, 1}, {-1, 0, 0}, 0.2, 1));
}

TEST_CASE("a sensor pressed into a body reads nought metres") {
  CHECK(reading(kMetres, block_ahead(-1e-5)) == 0);
}

TEST_CASE("the floor is seen, unless there is none") {
  SensorScene scene;
  const Vec3 down{0, 0, -1};
  CHECK(*closest_hit(SensorIndex(scene), {0, 0, 0.058}, down, 0.2, 1) == doctest::Approx(0.058));
  CHECK(!closest_hit(SensorIndex(scene), {0, 0, 0.21}, down, 0.2, 1));
  CHECK(*closest_hit(SensorIndex(scene), {0, 0, -0.01}, down, 0.2, 1) == 0);
  scene.floor = false;
  CHECK(!closest_hit(SensorIndex(scene), {0, 0, 0.058}, down, 0.2, 1));
}

TEST_CASE("direction and place turn with the body") {
  const SensorScene scene = block_ahead(0.05);
  RangeDevice d = kMetres;
  d.range = 0.2;
  d.p_B = {0, 0.02, 0};
  d.direction = {0, 2, 0};
  const Pose X_WB{{0, 0, 1}, rotation({0, 0, -90 * kDegree})};
  CHECK(read_range(SensorIndex(scene), d, X_WB, 1, {}, {}) == doctest::Approx(0.03));
}

TEST_CASE("noise is of the distance") {
  const SensorScene scene = block_ahead(0.03);
  double square = 0;
  for (std::uint64_t tick = 0; tick < 4000; ++tick) {
    const double d = reading(kMetres, scene, {0.002, 0}, {1, 0, 0, tick}) - 0.03;
    square += d * d / 4000;
  }
  CHECK(std::sqrt(square) == doctest::Approx(0.002).epsilon(0.05));
  CHECK(reading(kChassis, SensorScene{}, {0.002, 0}, {}) == 0);
}
