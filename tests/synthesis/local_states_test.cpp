// SPDX-License-Identifier: MIT
#include "synthesis/local_states.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <numeric>

#include "base/random.h"
#include "synthesis/shapes.h"

namespace stig {
namespace {

/// Sets of neighbours no two of which are neighbours of each other.
std::size_t independent_sets(const Neighbourhood& n, std::uint32_t left) {
  if (left == 0) return 1;
  const auto i = static_cast<std::size_t>(std::countr_zero(left));
  left &= left - 1;
  std::uint32_t apart = left;
  for (std::size_t j = 0; j < static_cast<std::size_t>(n.size); ++j) {
    if (n.index_of((Cell{} + n.offsets[j]) - (Cell{} + n.offsets[i])) >= 0) apart &= ~(1U << j);
  }
  return independent_sets(n, left) + independent_sets(n, apart);
}

std::size_t all_independent_sets(Lattice lattice) {
  const Neighbourhood& n = neighbourhood(lattice);
  return independent_sets(n, (1U << n.size) - 1);
}

TEST_CASE("T9: independent sets of neighbours bound the local states of a site") {
  CHECK(all_independent_sets(Lattice::cubic) == 2088);
  CHECK(all_independent_sets(Lattice::hexagonal) == 540);
}

/// A shell of neighbours around an empty middle, in some order of its cells.
std::size_t most_states(Lattice lattice, std::uint32_t seed) {
  const Neighbourhood& n = neighbourhood(lattice);
  Target target;
  target.lattice = lattice;
  for (int i = 0; i < n.size; ++i) {
    target.cells.push_back(Cell{} + n.offsets[static_cast<std::size_t>(i)]);
  }
  std::sort(target.cells.begin(), target.cells.end());
  target.colours.assign(target.cells.size(), StateSet::anything());
  Random random(seed, 0, Purpose::test, 0, 0);
  const Frame frame = make_frame(target, {{target.cells[random.below(target.cells.size())]}});
  const Order order = grown(frame, "random", [&](Cell) {
    return std::vector<std::int32_t>{static_cast<std::int32_t>(random.below(1000))};
  });
  BadOrder bad;
  const auto schedule = make_schedule(frame, order, bad);
  REQUIRE(schedule);
  std::size_t most = 0;
  for (std::size_t s = 0; s < frame.sites.size(); ++s) {
    most = std::max(most, schedule->states.of(s).size());
  }
  return most;
}

TEST_CASE("T9: no order without ties has more local states at a site") {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    CHECK(most_states(Lattice::cubic, seed) <= 2088);
    CHECK(most_states(Lattice::hexagonal, seed) <= 540);
  }
}

TEST_CASE("states are closed under the order and keys are among them") {
  const Target target = hollow_box(4);
  const Frame frame = make_frame(target, {{Cell{0, 0, 0}}});
  BadOrder bad;
  const auto schedule = make_schedule(frame, breadth_first(frame, Steps::faces), bad);
  REQUIRE(schedule);
  for (const Key& key : schedule->keys) {
    const auto states = schedule->states.of(static_cast<std::size_t>(key.site));
    CHECK(std::find(states.begin(), states.end(), key.mask) != states.end());
    CHECK(schedule->intended(frame.sites[static_cast<std::size_t>(key.site)], key.mask));
  }
}

TEST_CASE("an order in which a cell has nothing before it is refused") {
  const Target target = box({3, 1, 1});
  const Frame frame = make_frame(target, {{Cell{0, 0, 0}}});
  BadOrder bad;
  CHECK_FALSE(make_schedule(frame, listed(frame, "back to front", {0, 2, 1}), bad));
  CHECK(bad.kind == BadOrder::Kind::nothing_before);
  CHECK(bad.at == Cell{2, 0, 0});
}

}  // namespace
}  // namespace stig
