// SPDX-License-Identifier: MIT
// Runs of points, gone through with their velocities at hand: a Motion takes them (or shifts, which
// are the same to it) from where they are kept, knows how fast a point is along a direction and
// what an impulse does to it, and puts them back.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "physical/solver/row_numbers.h"

namespace stig::physics {

/// A free body's velocity and spin, along each axis.
struct LooseMotion {
  Two x, y, z;
};

inline LooseMotion loose_at(const double* v) {
  return {Two{v[0], v[3]}, Two{v[1], v[4]}, Two{v[2], v[5]}};
}
inline void keep(double* v, const LooseMotion& motion) {
  put(v, Two{motion.x[0], motion.y[0]});
  put(v + 2, Two{motion.z[0], motion.x[1]});
  put(v + 4, Two{motion.y[1], motion.z[1]});
}

inline double product(const std::array<double, 6>& j, const LooseMotion& v) {
  Two sum = row_two(&j[0]) * v.x;
  sum += row_two(&j[2]) * v.y;
  sum += row_two(&j[4]) * v.z;
  return sum[0] + sum[1];
}

inline void add(const LooseSide& side, std::size_t direction, double impulse, LooseMotion& v) {
  const double* w = side.w[direction].data();
  const Two push{impulse * side.inverse_mass, impulse};
  v.x += row_two(w) * push;
  v.y += row_two(w + 2) * push;
  v.z += row_two(w + 4) * push;
}

template <class Motion>
double relax_points(std::span<RowPoint> run, const double* numbers, double inverse_dt) {
  Motion motion(run[0], numbers, OfVelocities{});
  double most = 0;
  for (RowPoint& point : run) {
    const double change = next_push(point, motion.along(point, kNormal), inverse_dt);
    if (change != 0) motion.push(point, kNormal, change);
    most = std::max(most, asked(change, point.mass[kNormal]));
    if (carries_nothing(point)) continue;
    const double mass = slide_mass(point);
    const std::array slide =
        next_slide(point, mass, motion.along(point, kFirst), motion.along(point, kSecond));
    if (slide[0] != 0 || slide[1] != 0) {
      motion.push(point, kFirst, slide[0]);
      motion.push(point, kSecond, slide[1]);
    }
    most = std::max(most, asked(slide, mass));
  }
  motion.finish(run[0], OfVelocities{});
  return most;
}

template <class Motion>
void apply_last_points(std::span<const RowPoint> run, const double* numbers) {
  Motion motion(run[0], numbers, OfVelocities{});
  for (const RowPoint& point : run) {
    if (carries_nothing(point)) continue;
    motion.push(point, kNormal, point.push);
    motion.push(point, kFirst, point.slide[0]);
    motion.push(point, kSecond, point.slide[1]);
  }
  motion.finish(run[0], OfVelocities{});
}

template <class Motion>
void follow_point_gaps(std::span<RowPoint> run, const double* numbers, double dt) {
  const Motion motion(run[0], numbers, OfVelocities{});
  for (RowPoint& point : run) point.gap += motion.along(point, kNormal) * dt;
}

template <class Motion>
void shift_points(std::span<RowPoint> run, const double* numbers) {
  Motion motion(run[0], numbers, OfShifts{});
  for (RowPoint& point : run) {
    const double change = next_shift(point, motion.along(point, kNormal));
    if (change != 0) motion.push(point, kNormal, change);
  }
  motion.finish(run[0], OfShifts{});
}

/// What is done with a run.
struct RunCode {
  double (*relax)(std::span<RowPoint> run, const double* numbers, double inverse_dt);
  void (*apply_last)(std::span<const RowPoint> run, const double* numbers);
  void (*follow_gaps)(std::span<RowPoint> run, const double* numbers, double dt);
  void (*shift)(std::span<RowPoint> run, const double* numbers);
};

template <class Motion>
constexpr RunCode run_code() {
  return {&relax_points<Motion>, &apply_last_points<Motion>, &follow_point_gaps<Motion>,
          &shift_points<Motion>};
}

}  // namespace stig::physics
