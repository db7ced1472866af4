// SPDX-License-Identifier: MIT
// The numbers of the solver's rows, two at once: J times velocities, W times impulses, and what a
// point asks for. The order of additions is the result's last bits: robot_rows.cpp keeps to it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "physical/solver/solver_rows.h"

namespace stig::physics {

/// Two numbers at once, as every processor of this width computes them.
using Two = double __attribute__((vector_size(16)));

/// Anywhere, as of bodies.
inline Two two_at(const double* p) {
  Two out;
  std::memcpy(&out, p, sizeof out);
  return out;
}
/// At a multiple of 16 bytes, as of rows.
inline Two row_two(const double* p) {
  Two out;
  std::memcpy(&out, __builtin_assume_aligned(p, sizeof out), sizeof out);
  return out;
}
inline void put(double* p, const Two& two) { std::memcpy(p, &two, sizeof two); }
inline Two both(double x) { return Two{x, x}; }

/// Which numbers rows are about: velocities, or the shift that undoes overlaps. The type chooses,
/// without a test at run time.
struct OfVelocities {
  template <class Side>
  static double* of(const Side& side) {
    return side.v;
  }
};
struct OfShifts {
  template <class Side>
  static double* of(const Side& side) {
    return side.way;
  }
};

/// J times v. In two sums, of which neither waits for the other.
inline double product(const double* j, const Hold& hold, const double* v) {
  const std::size_t begin = hold.reach.begin, dofs = hold.dofs;
  Two sum{};
  for (std::size_t k = 0; k < begin; ++k) sum += row_two(j + 2 * k) * two_at(v + 2 * k);
  if (hold.reach.extra > 0) {
    sum += row_two(j + 2 * begin) * two_at(v + 2 * std::size_t{hold.reach.extra});
  }
  const double most = sum[0] + sum[1];
  return dofs % 2 == 0 ? most : most + j[2 * begin + 2] * v[dofs - 1];
}

inline const double* rows_j(const Rows& rows, const Hold& hold, std::size_t direction) {
  return &rows.numbers[hold.at + direction * hold.reach.width()];
}
inline const double* rows_w(const Rows& rows, const Hold& hold, std::size_t direction) {
  return &rows.numbers[hold.at + 3 * hold.reach.width() + direction * hold.height()];
}

/// Takes the normal impulse that a point needs at this speed; returns by how much it changes.
inline double next_push(RowPoint& point, double speed, double inverse_dt) {
  const double lacking = -std::max(0.0, point.gap) * inverse_dt - speed;
  const double impulse = std::max(0.0, point.push + lacking * point.mass[kNormal]);
  const double change = impulse - point.push;
  point.push = impulse;
  return change;
}

/// Friction within an ellipse whose half axis along the axle is a part of the other. The
/// wheel slips so that friction takes the most power from it, as one with rollers on its rim
/// would: the step along the axle is shorter by the square of that part.
inline std::array<double, 2> next_slide(RowPoint& point, double mass, double first, double second) {
  const double part = point.axle_friction;
  double x = (first + point.bend[0]) * mass, across = 0;
  // Most points have no axle, and others wait for this one's numbers.
  if (part == 1) {
    x = across = point.slide[0] - x;
  } else {
    x = part == 0 ? 0 : point.slide[0] - x * part * part;
    across = part > 0 ? x / part : 0;
  }
  double y = point.slide[1] - (second + point.bend[1]) * mass;
  const double most = point.friction * point.push;
  const double size = across * across + y * y;
  if (size > most * most) {
    const double less = most / std::sqrt(size);
    x *= less;
    y *= less;
  }
  const std::array change{x - point.slide[0], y - point.slide[1]};
  point.slide = {x, y};
  return change;
}

/// Takes the impulse along the normal that undoes an overlap; returns by how much it changes.
/// Shifts are along normals only: overlaps know no friction.
inline double next_shift(RowPoint& point, double speed) {
  const double impulse =
      std::max(0.0, point.shift + (point.shift_target - speed) * point.mass[kNormal]);
  const double change = impulse - point.shift;
  point.shift = impulse;
  return change;
}

/// The same for both tangents, so that sliding does not depend on how they lie.
inline double slide_mass(const RowPoint& point) {
  return std::min(point.mass[kFirst], point.mass[kSecond]);
}

/// The change of velocity that was asked for.
inline double asked(double change, double mass) { return mass > 0 ? std::abs(change) / mass : 0; }
inline double asked(const std::array<double, 2>& change, double mass) {
  return mass > 0 ? std::max(std::abs(change[0]), std::abs(change[1])) / mass : 0;
}

/// Most points of a heap carry nothing.
inline bool carries_nothing(const RowPoint& point) {
  return point.push == 0 && point.slide[0] == 0 && point.slide[1] == 0;
}

}  // namespace stig::physics
