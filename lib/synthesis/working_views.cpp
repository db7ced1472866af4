// SPDX-License-Identifier: MIT
#include "synthesis/working_views.h"

#include <algorithm>
#include <cassert>

namespace stig::synthesis {
namespace {

/// At most about so many views are worked on at first.
constexpr std::size_t kWorkingViews = 20'000;
constexpr std::size_t kViolatedAtOnce = 500;

}  // namespace

WorkingViews::WorkingViews(const std::vector<LocalView>& every, std::size_t size)
    : every_(every), size_(size) {
  assert(size <= kMaxNeighbours);
  // A sample of every n-th view is worked on; when a finished rule violates others, those
  // join the sample. So soundness is against all views, at the cost of the sample.
  const std::size_t step = std::max<std::size_t>(1, every.size() / kWorkingViews);
  for (std::size_t i = 0; i < every.size(); i += step) work_on(every[i]);
}

void WorkingViews::work_on(const LocalView& view) {
  views_.push_back(view);
  for (std::size_t i = 0; i < size_; ++i) {
    ++of_colour_[view.wanted].showing[i][view.view.at[i]];
    ++all_.showing[i][view.view.at[i]];
  }
}

bool WorkingViews::add_violated(const Pattern& pattern, Colour place, const Allowance& allowance) {
  if (views_.size() >= every_.size()) return false;
  const std::vector<std::size_t> asked = asked_cells(pattern, size_);
  allowance.spend(every_.size() * kStepsOfGlance);
  std::size_t added = 0;
  for (const LocalView& v : every_) {
    if (v.wanted == place || !shows(v.view, asked, pattern)) continue;
    work_on(v);
    if (++added == kViolatedAtOnce) break;
  }
  return added > 0;
}

std::vector<std::size_t> asked_cells(const Pattern& pattern, std::size_t size) {
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < size; ++i) {
    if (!(pattern.allowed[i] == StateSet::anything())) asked.push_back(i);
  }
  return asked;
}

}  // namespace stig::synthesis
