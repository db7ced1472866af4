// SPDX-License-Identifier: MIT
// Enumerates the conditions under which a brick can be placed wherever they are met: sets
// of up to three neighbours, with the ranges of heights in which no empty site beside the
// target meets them. Only neighbourhoods that differ are looked at, by height; a solid has
// few of them, so the search hardly depends on its size.
#include "synthesis/fills.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>
#include <set>

namespace stig::synthesis {
namespace {

/// Steps of asking one fill at one kind of site.
constexpr std::uint64_t kStepsOfFillAsked = 2;

/// The different neighbourhoods at each height.
using Kinds = std::map<std::int32_t, std::set<std::uint32_t>>;

Kinds kinds_of(const SolidGrid& grid, const std::vector<std::int32_t>& places) {
  Kinds kinds;
  for (const std::int32_t p : places) kinds[grid.height(p)].insert(grid.solid_beside(p));
  return kinds;
}

/// Heights at which some site meets the needs.
std::vector<std::int32_t> heights_of(const Kinds& kinds, std::uint32_t needs) {
  std::vector<std::int32_t> heights;
  for (const auto& [z, masks] : kinds) {
    const auto met = [&](std::uint32_t mask) { return (mask & needs) == needs; };
    if (std::any_of(masks.begin(), masks.end(), met)) heights.push_back(z);
  }
  return heights;
}

class FillSearch {
 public:
  FillSearch(const SolidGrid& grid, const Allowance& allowance)
      : grid_(grid),
        allowance_(allowance),
        inside_(kinds_of(grid, grid.cells)),
        outside_(kinds_of(grid, grid.beside)) {
    for (const Kinds* kinds : {&inside_, &outside_}) {
      for (const auto& [z, masks] : *kinds) steps_ += masks.size() * kStepsOfFillAsked;
    }
  }

  /// Looks at every set of so many more neighbours from `from` on, together with those chosen.
  void look(std::uint32_t chosen, std::size_t from, int more) {
    if (more == 0) return add(chosen);
    for (std::size_t i = from; i < grid_.step.size() && !allowance_.passed(); ++i) {
      look(chosen | (1U << i), i + 1, more - 1);
    }
  }

  std::vector<Fill> found;

 private:
  void add(std::uint32_t needs) {
    allowance_.spend(steps_);
    const std::vector<std::int32_t> good = heights_of(inside_, needs);
    if (good.empty()) return;
    std::vector<std::int32_t> bad = heights_of(outside_, needs);
    Fill fill{needs};
    const auto close = [&] {
      const bool used = std::any_of(good.begin(), good.end(),
                                    [&](auto z) { return z >= fill.low && z <= fill.high; });
      if (used && !says_nothing_new(fill)) found.push_back(fill);
    };
    // Heights at which an outside site meets the needs divide the rest into ranges; each is
    // a fill of its own if some cell of the target can use it.
    for (const std::int32_t z : bad) {
      fill.high = z - 1;
      close();
      fill.low = z + 1;
    }
    fill.high = std::numeric_limits<std::int32_t>::max();
    close();
  }

  bool says_nothing_new(const Fill& fill) const {
    return std::any_of(found.begin(), found.end(), [&](const Fill& f) {
      return (fill.needs & f.needs) == f.needs && f.low <= fill.low && f.high >= fill.high;
    });
  }

  const SolidGrid& grid_;
  Allowance allowance_;
  Kinds inside_, outside_;
  std::uint64_t steps_ = 0;
};

}  // namespace

std::vector<Fill> safe_fills(const SolidGrid& grid, int most_needs, const Allowance& allowance) {
  FillSearch search(grid, allowance);
  for (int needs = 1; needs <= most_needs; ++needs) search.look(0, 0, needs);
  const Neighbourhood& n = grid.neighbours();
  // Plain means few needs, faces before edges before corners, and a wide range.
  const auto rank = [&](const Fill& fill) {
    int behind = 0;
    for (std::uint32_t m = fill.needs; m != 0; m &= m - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(m));
      behind += n.is_face[i] ? 0 : n.is_edge[i] ? 1 : 2;
    }
    const std::int64_t range = std::int64_t{fill.high} - fill.low;
    return std::tuple(std::popcount(fill.needs), behind, -range);
  };
  std::stable_sort(search.found.begin(), search.found.end(),
                   [&](const Fill& a, const Fill& b) { return rank(a) < rank(b); });
  return std::move(search.found);
}

FilledGrid::FilledGrid(const SolidGrid& grid, const std::vector<Fill>& fills, std::int32_t never)
    : grid_(&grid),
      fills_(&fills),
      never_(never),
      by_need_(grid.step.size()),
      placed_(grid.solid.size(), 0),
      beside_(grid.solid.size(), 0) {
  for (std::uint32_t f = 0; f < fills.size(); ++f) {
    for (std::uint32_t m = fills[f].needs; m != 0; m &= m - 1) {
      by_need_[static_cast<std::size_t>(std::countr_zero(m))].push_back(f);
    }
  }
}

void FilledGrid::add(std::int32_t at) {
  assert(static_cast<std::size_t>(at) < placed_.size());
  if (at == never_ || placed_[static_cast<std::size_t>(at)] != 0) return;
  placed_[static_cast<std::size_t>(at)] = 1;
  ++count_;
  open_.push_back(at);
}

void FilledGrid::place(std::int32_t at) {
  add(at);
  while (!open_.empty()) {
    const std::int32_t from = open_.back();
    open_.pop_back();
    for (std::size_t i = 0; i < grid_->step.size(); ++i) {
      // `from` is neighbour i of `site`, the step taken backwards.
      const std::int32_t site = from - grid_->step[i];
      std::uint32_t& there = beside_[static_cast<std::size_t>(site)];
      there |= 1U << i;
      if (!grid_->is_solid(site) || has(site)) continue;
      for (const std::uint32_t f : by_need_[i]) {
        if (!(*fills_)[f].holds(there, grid_->height(site))) continue;
        add(site);
        break;
      }
    }
  }
}

}  // namespace stig::synthesis
