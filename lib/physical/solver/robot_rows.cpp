// SPDX-License-Identifier: MIT
#include "physical/solver/robot_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physical/solver/row_numbers.h"

namespace stig {

namespace {

constexpr std::size_t kHeight = 12;  ///< Hold::height() of so many

// Which pairs move a link: those of the floating body, and none or one of the wheels'.
constexpr Reach kBody{3, 0}, kFirstWheels{4, 0}, kLastWheels{3, 4};

bool same(const Reach& a, const Reach& b) { return a.begin == b.begin && a.extra == b.extra; }

/// Generalised velocities.
struct RobotMotion {
  Two a, b, c, first_wheels, last_wheels;
  double lift;
};

RobotMotion robot_at(const double* v) {
  return {two_at(v), two_at(v + 2), two_at(v + 4), two_at(v + 6), two_at(v + 8), v[10]};
}
void keep(double* v, const RobotMotion& motion) {
  put(v, motion.a);
  put(v + 2, motion.b);
  put(v + 4, motion.c);
  put(v + 6, motion.first_wheels);
  put(v + 8, motion.last_wheels);
  v[10] = motion.lift;
}

/// A free body's velocity and spin, along each axis.
struct LooseMotion {
  Two x, y, z;
};

LooseMotion loose_at(const double* v) {
  return {Two{v[0], v[3]}, Two{v[1], v[4]}, Two{v[2], v[5]}};
}
void keep(double* v, const LooseMotion& motion) {
  put(v, Two{motion.x[0], motion.y[0]});
  put(v + 2, Two{motion.z[0], motion.x[1]});
  put(v + 4, Two{motion.y[1], motion.z[1]});
}

/// J times velocities. The sums of product(); nothing is added to zero first, since along() does.
template <RowKind kKind>
double product(const double* j, const RobotMotion& v) {
  Two sum = row_two(j) * v.a;
  sum += row_two(j + 2) * v.b;
  sum += row_two(j + 4) * v.c;
  if constexpr (kKind == RowKind::first_wheels) sum += row_two(j + 6) * v.first_wheels;
  if constexpr (kKind == RowKind::last_wheels) sum += row_two(j + 6) * v.last_wheels;
  return sum[0] + sum[1] + j[kKind == RowKind::first_wheels ? 10 : 8] * v.lift;
}
double product(const std::array<double, 6>& j, const LooseMotion& v) {
  Two sum = row_two(&j[0]) * v.x;
  sum += row_two(&j[2]) * v.y;
  sum += row_two(&j[4]) * v.z;
  return sum[0] + sum[1];
}

/// Adds W times an impulse.
void add(const double* w, double impulse, RobotMotion& v) {
  const Two push = both(impulse);
  v.a += row_two(w) * push;
  v.b += row_two(w + 2) * push;
  v.c += row_two(w + 4) * push;
  v.first_wheels += row_two(w + 6) * push;
  v.last_wheels += row_two(w + 8) * push;
  v.lift += w[10] * impulse;
}
void add(const LooseSide& side, std::size_t direction, double impulse, LooseMotion& v) {
  const double* w = side.w[direction].data();
  const Two push{impulse * side.inverse_mass, impulse};
  v.x += row_two(w) * push;
  v.y += row_two(w + 2) * push;
  v.z += row_two(w + 4) * push;
}

/// The velocities that a run is about, while it is gone through.
template <RowKind kKind>
class RunMotion {
 public:
  RunMotion(const RowPoint& first, const double* numbers)
      : numbers_(numbers), robot_(robot_at(first.holds[0].v)) {
    if constexpr (kLoose) loose_ = loose_at(first.loose[0].v);
  }
  void finish(const RowPoint& first) const {
    keep(first.holds[0].v, robot_);
    if constexpr (kLoose) keep(first.loose[0].v, loose_);
  }

  double along(const RowPoint& point, std::size_t direction) const {
    const double* j = numbers_ + point.holds[0].at + direction * kWidth;
    if constexpr (!kLoose) return 0 + product<kKind>(j, robot_);
    return 0 + product(point.loose[0].j[direction], loose_) + product<kKind>(j, robot_);
  }
  void push(const RowPoint& point, std::size_t direction, double impulse) {
    if constexpr (kLoose) add(point.loose[0], direction, impulse, loose_);
    add(numbers_ + point.holds[0].at + 3 * kWidth + direction * kHeight, impulse, robot_);
  }

 private:
  static constexpr bool kLoose = kKind == RowKind::robot_on_loose;
  static constexpr std::size_t kWidth =
      (kKind == RowKind::first_wheels ? kFirstWheels : kBody).width();

  const double* numbers_;
  RobotMotion robot_;
  LooseMotion loose_;
};

template <class Motion>
double relax_points(std::span<RowPoint> run, const double* numbers, double inverse_dt) {
  Motion motion(run[0], numbers);
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
  motion.finish(run[0]);
  return most;
}

template <class Motion>
void apply_last_points(std::span<const RowPoint> run, const double* numbers) {
  Motion motion(run[0], numbers);
  for (const RowPoint& point : run) {
    if (carries_nothing(point)) continue;
    motion.push(point, kNormal, point.push);
    motion.push(point, kFirst, point.slide[0]);
    motion.push(point, kSecond, point.slide[1]);
  }
  motion.finish(run[0]);
}

template <class Motion>
void follow_point_gaps(std::span<RowPoint> run, const double* numbers, double dt) {
  const Motion motion(run[0], numbers);
  for (RowPoint& point : run) point.gap += motion.along(point, kNormal) * dt;
}

/// Calls with the kind of motion.
template <class Motion>
struct MotionKind {
  using type = Motion;
};
template <class Call>
auto with_motion(RowKind kind, const Call& call) {
  switch (kind) {
    case RowKind::robot_on_loose:
      return call(MotionKind<RunMotion<RowKind::robot_on_loose>>{});
    case RowKind::first_wheels:
      return call(MotionKind<RunMotion<RowKind::first_wheels>>{});
    case RowKind::last_wheels:
      return call(MotionKind<RunMotion<RowKind::last_wheels>>{});
    case RowKind::robot:
    case RowKind::any:
      break;
  }
  return call(MotionKind<RunMotion<RowKind::robot>>{});
}

}  // namespace

RowKind kind_of(const RowPoint& point) {
  const Hold& hold = point.holds[0];
  if (point.held != 1 || hold.dofs != kRobotDofs || point.looses > 1) return RowKind::any;
  if (same(hold.reach, kBody)) {
    return point.looses == 0 ? RowKind::robot : RowKind::robot_on_loose;
  }
  if (point.looses > 0) return RowKind::any;
  if (same(hold.reach, kFirstWheels)) return RowKind::first_wheels;
  return same(hold.reach, kLastWheels) ? RowKind::last_wheels : RowKind::any;
}

void apply_last_run(std::span<const RowPoint> run, const double* numbers) {
  with_motion(run[0].kind,
              [&](auto kind) { apply_last_points<typename decltype(kind)::type>(run, numbers); });
}

double relax_run(std::span<RowPoint> run, const double* numbers, double inverse_dt) {
  return with_motion(run[0].kind, [&](auto kind) {
    return relax_points<typename decltype(kind)::type>(run, numbers, inverse_dt);
  });
}

void follow_run_gaps(std::span<RowPoint> run, const double* numbers, double dt) {
  with_motion(run[0].kind, [&](auto kind) {
    follow_point_gaps<typename decltype(kind)::type>(run, numbers, dt);
  });
}

}  // namespace stig
