// SPDX-License-Identifier: MIT
#include "physical/solver/robot_rows.h"

#include <cassert>
#include <optional>

#include "physical/solver/mechanism_rows.h"
#include "physical/solver/row_runs.h"

namespace stig::physics {

namespace {

// W's numbers of one direction: eleven degrees of freedom, made even.
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

/// J times velocities. The sums of product(); nothing is added to zero first, since along() does.
template <RowKind kKind>
double product(const double* j, const RobotMotion& v) {
  Two sum = row_two(j) * v.a;
  sum += row_two(j + 2) * v.b;
  sum += row_two(j + 4) * v.c;
  if constexpr (kKind == RowKind::first_wheels) sum += row_two(j + 6) * v.first_wheels;
  if constexpr (kKind == RowKind::last_wheels) sum += row_two(j + 6) * v.last_wheels;
  // The last of an odd number stands after the pairs that J has.
  return sum[0] + sum[1] + j[kKind == RowKind::first_wheels ? 10 : 8] * v.lift;
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

/// The velocities that a run is about, while it is gone through.
template <RowKind kKind>
class RunMotion {
 public:
  template <class Of>
  RunMotion(const RowPoint& first, const double* numbers, Of /*which*/)
      : numbers_(numbers), robot_(robot_at(Of::of(first.holds[0]))) {
    if constexpr (kLoose) loose_ = loose_at(Of::of(first.loose[0]));
  }
  template <class Of>
  void finish(const RowPoint& first, Of /*which*/) const {
    keep(Of::of(first.holds[0]), robot_);
    if constexpr (kLoose) keep(Of::of(first.loose[0]), loose_);
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

/// The code for a run that is not of any kind.
RunCode code_of(const RowPoint& first) {
  switch (first.kind) {
    case RowKind::robot:
      return run_code<RunMotion<RowKind::robot>>();
    case RowKind::robot_on_loose:
      return run_code<RunMotion<RowKind::robot_on_loose>>();
    case RowKind::first_wheels:
      return run_code<RunMotion<RowKind::first_wheels>>();
    case RowKind::last_wheels:
      return run_code<RunMotion<RowKind::last_wheels>>();
    case RowKind::mechanism:
    case RowKind::mechanism_on_loose:
    case RowKind::any:
      break;
  }
  return mechanism_code(first.holds[0].dofs, first.kind == RowKind::mechanism_on_loose);
}

/// Whether the point is one of a robot's, and of which kind. That is told by the number of degrees
/// of freedom and which of them move the link, not by any name: a robot that is built alike gets
/// the same code.
std::optional<RowKind> robot_kind(const RowPoint& point) {
  const Hold& hold = point.holds[0];
  if (hold.dofs != kRobotDofs) return std::nullopt;
  if (same(hold.reach, kBody)) {
    return point.looses == 0 ? RowKind::robot : RowKind::robot_on_loose;
  }
  if (point.looses > 0) return std::nullopt;
  if (same(hold.reach, kFirstWheels)) return RowKind::first_wheels;
  if (same(hold.reach, kLastWheels)) return RowKind::last_wheels;
  return std::nullopt;
}

}  // namespace

RowKind kind_of(const RowPoint& point) {
  if (point.held != 1 || point.looses > 1) return RowKind::any;
  if (const auto robot = robot_kind(point)) return *robot;
  return point.looses == 0 ? RowKind::mechanism : RowKind::mechanism_on_loose;
}

void apply_last_run(std::span<const RowPoint> run, const double* numbers) {
  assert(!run.empty() && run[0].kind != RowKind::any);
  code_of(run[0]).apply_last(run, numbers);
}

double relax_run(std::span<RowPoint> run, const double* numbers, double inverse_dt) {
  assert(!run.empty() && run[0].kind != RowKind::any);
  return code_of(run[0]).relax(run, numbers, inverse_dt);
}

void follow_run_gaps(std::span<RowPoint> run, const double* numbers, double dt) {
  code_of(run[0]).follow_gaps(run, numbers, dt);
}

void shift_run(std::span<RowPoint> run, const double* numbers) {
  code_of(run[0]).shift(run, numbers);
}

}  // namespace stig::physics
