// SPDX-License-Identifier: MIT
// Inner loops for mechanisms of any size, written out by the compiler for the common sizes: with a
// known number of degrees of freedom velocities stay in registers from point to point. All of them
// add in the same order as row_numbers.h, so which one runs does not show in any bit.
#include "physical/solver/mechanism_rows.h"

#include <cassert>
#include <utility>

namespace stig::physics {

namespace {

// A floating body alone has six.
constexpr std::uint32_t kLeastWrittenOutDofs = 6;

/// How many degrees of freedom there are: known to the compiler, or to the point.
template <std::uint32_t kDofs>
struct KnownDofs {
  static constexpr std::size_t kMost = kDofs;
  static constexpr std::size_t of(const Hold& /*hold*/) { return kDofs; }
};
struct SomeDofs {
  static constexpr std::size_t kMost = kMostMechanismDofs;
  static std::size_t of(const Hold& hold) { return hold.dofs; }
};

// See row_runs.h for what a Motion is: taken at the beginning, put back at the end.
template <class Dofs, bool kLoose>
class MechanismMotion {
 public:
  template <class Of>
  MechanismMotion(const RowPoint& first, const double* numbers, Of /*which*/) : numbers_(numbers) {
    const double* v = Of::of(first.holds[0]);
    const std::size_t n = Dofs::of(first.holds[0]);
    for (std::size_t k = 0; k < n / 2; ++k) pairs_[k] = two_at(v + 2 * k);
    if (n % 2 != 0) last_ = v[n - 1];
    if constexpr (kLoose) loose_ = loose_at(Of::of(first.loose[0]));
  }
  template <class Of>
  void finish(const RowPoint& first, Of /*which*/) const {
    double* v = Of::of(first.holds[0]);
    const std::size_t n = Dofs::of(first.holds[0]);
    for (std::size_t k = 0; k < n / 2; ++k) put(v + 2 * k, pairs_[k]);
    if (n % 2 != 0) v[n - 1] = last_;
    if constexpr (kLoose) keep(Of::of(first.loose[0]), loose_);
  }

  double along(const RowPoint& point, std::size_t direction) const {
    const Hold& hold = point.holds[0];
    const double speed = product(numbers_ + hold.at + direction * hold.reach.width(), hold);
    // 0 + keeps the sum as the general code has it, also for -0.
    if constexpr (!kLoose) return 0 + speed;
    return 0 + physics::product(point.loose[0].j[direction], loose_) + speed;
  }
  void push(const RowPoint& point, std::size_t direction, double impulse) {
    if constexpr (kLoose) add(point.loose[0], direction, impulse, loose_);
    const Hold& hold = point.holds[0];
    const std::size_t n = Dofs::of(hold);
    // W follows the three directions' J.
    const double* w = numbers_ + hold.at + 3 * hold.reach.width() + direction * (n + n % 2);
    const Two pushes = both(impulse);
    for (std::size_t k = 0; k < n / 2; ++k) pairs_[k] += row_two(w + 2 * k) * pushes;
    if (n % 2 != 0) last_ += w[n - 1] * impulse;
  }

 private:
  /// J times velocities: the sums of product() for holds. Whether J has a pair is asked of each,
  /// so that none need be looked for by its number.
  double product(const double* j, const Hold& hold) const {
    const std::size_t n = Dofs::of(hold), begin = hold.reach.begin, extra = hold.reach.extra;
    Two sum{};
    for (std::size_t k = 0; k < n / 2; ++k) {
      if (k < begin) {
        sum += row_two(j + 2 * k) * pairs_[k];
      } else if (k == extra && k > 0) {
        // `extra` is 0 when there is none, and pair 0 always belongs to the first ones.
        sum += row_two(j + 2 * begin) * pairs_[k];
      }
    }
    const double most = sum[0] + sum[1];
    return n % 2 == 0 ? most : most + j[2 * begin + 2] * last_;
  }

  const double* numbers_;
  std::array<Two, Dofs::kMost / 2> pairs_;
  double last_ = 0;
  LooseMotion loose_;
};

// An array over all sizes, filled at compile time.
template <bool kLoose, std::uint32_t... kNumber>
constexpr auto written_out(std::integer_sequence<std::uint32_t, kNumber...> /*numbers*/) {
  return std::array{
      run_code<MechanismMotion<KnownDofs<kLeastWrittenOutDofs + kNumber>, kLoose>>()...};
}

using Numbers =
    std::make_integer_sequence<std::uint32_t, kMostWrittenOutDofs - kLeastWrittenOutDofs + 1>;
constexpr auto kOnFixed = written_out<false>(Numbers{}), kOnLoose = written_out<true>(Numbers{});

}  // namespace

RunCode mechanism_code(std::uint32_t dofs, bool on_loose) {
  assert(dofs <= kMostMechanismDofs);
  if (dofs < kLeastWrittenOutDofs || dofs > kMostWrittenOutDofs) {
    return on_loose ? run_code<MechanismMotion<SomeDofs, true>>()
                    : run_code<MechanismMotion<SomeDofs, false>>();
  }
  return (on_loose ? kOnLoose : kOnFixed)[dofs - kLeastWrittenOutDofs];
}

}  // namespace stig::physics
