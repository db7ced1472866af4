// SPDX-License-Identifier: MIT
// The views that a rule in the making is held to. Of very many only some are worked on at first,
// and those that it then turns out to violate.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "synthesis/effort.h"
#include "synthesis/local_views.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// Steps for looking at one cell of one view or pattern.
inline constexpr std::uint64_t kStepsOfGlance = 2;

/// How many views show which state in which cell.
struct ViewTally {
  std::array<std::array<std::uint32_t, 64>, kMaxNeighbours> showing{};
};

class WorkingViews {
 public:
  /// `every`, of which it keeps a reference; neighbourhoods have `size` cells.
  WorkingViews(const std::vector<LocalView>& every, std::size_t size);

  /// Those that are worked on.
  const std::vector<LocalView>& all() const { return views_; }
  /// How many of them show this and do not want the colour.
  std::uint32_t of_others(Colour place, std::size_t cell, State state) const {
    return all_.showing[cell][state] - of_colour_[place].showing[cell][state];
  }
  /// Adds some that a rule must not match, and does. False: there are none.
  bool add_violated(const Pattern& pattern, Colour place, const Allowance& allowance);

 private:
  void work_on(const LocalView& view);

  const std::vector<LocalView>& every_;
  std::size_t size_;
  std::vector<LocalView> views_;
  ViewTally all_;
  std::array<ViewTally, 64> of_colour_;
};

/// The cells of which a pattern asks something.
std::vector<std::size_t> asked_cells(const Pattern& pattern, std::size_t size);
/// Does a view show in these cells what a pattern allows?
inline bool shows(const View& view, const std::vector<std::size_t>& asked, const Pattern& pattern) {
  for (const std::size_t i : asked) {
    if (!pattern.allowed[i].contains(view.at[i])) return false;
  }
  return true;
}

}  // namespace stig::synthesis
