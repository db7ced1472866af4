// SPDX-License-Identifier: MIT
// Stochastic hill climbing over orders, for targets with all colours given. An order is a
// place for each orbit, realised by growing along the frontier; a step moves one orbit that
// takes part in a clash. Steps that do not increase the number of clashes are kept, so
// plateaus are crossed; when none helps for a while, the next beginning is tried.
#include "synthesis/order_search.h"

#include <algorithm>
#include <cassert>

#include "base/random.h"

namespace stig::synthesis {
namespace {

/// Changes without gain after which the next beginning is tried.
constexpr int kPatience = 400;
/// Enough to compare orders; counting all clashes of a hopeless order would take most of
/// the time.
constexpr std::size_t kMostClashes = 5000;

struct Evaluated {
  std::optional<Schedule> schedule;
  std::vector<Clash> clashes;
};

class Searcher {
 public:
  Searcher(const Frame& frame, const Colouring& colours, const Allowance& allowance)
      : frame_(frame), colours_(colours), allowance_(allowance) {}

  /// True when an order without a clash was found.
  bool climb(const Order& first, std::uint32_t number) {
    Random random(number, 0, Purpose::order, 0, 0);
    places_.assign(first.rank.begin(), first.rank.end());
    for (std::int32_t& place : places_) place *= kSpread;
    Evaluated now = evaluate();
    for (int idle = 0; idle < kPatience && !allowance_.passed(); ++idle) {
      if (!now.schedule) return false;
      if (now.clashes.empty()) return true;
      const std::vector<std::int32_t> before = places_;
      move_one(now, random);
      Evaluated next = evaluate();
      if (!next.schedule || next.clashes.size() > now.clashes.size()) {
        places_ = before;
        continue;
      }
      if (next.clashes.size() < now.clashes.size()) idle = 0;
      now = std::move(next);
    }
    return now.schedule && now.clashes.empty();
  }

  OrderSearch result;

 private:
  // Gaps between places leave room to move an orbit between two others.
  static constexpr std::int32_t kSpread = 4;

  Evaluated evaluate() {
    ++result.tried;
    const Order order = grown(frame_, "search among orders", [&](Cell c) {
      const auto cell = static_cast<std::size_t>(index_in(frame_.cells, c));
      return std::vector<std::int32_t>{places_[static_cast<std::size_t>(frame_.orbit_of[cell])]};
    });
    BadOrder bad;
    Evaluated evaluated{make_schedule(frame_, order, bad), {}};
    allowance_.spend(evaluated.schedule ? 2 * cost_of(*evaluated.schedule) : places_.size());
    if (!evaluated.schedule) return evaluated;
    evaluated.clashes = find_clashes(*evaluated.schedule, colours_, 4, kMostClashes);
    if (evaluated.clashes.empty()) {
      result.order = order;
    } else if (evaluated.clashes.size() < fewest_) {
      fewest_ = evaluated.clashes.size();
      result.nearest = evaluated.schedule;
      result.clash = evaluated.clashes.front();
    }
    return evaluated;
  }

  /// Moves a cell of a clash, or one beside it, to somewhere else.
  void move_one(const Evaluated& now, Random& random) {
    const Clash& clash = now.clashes[random.below(now.clashes.size())];
    const std::int32_t from = now.schedule->keys[static_cast<std::size_t>(clash.key)].site;
    std::int32_t site = random.below(2) == 0 ? from : clash.site;
    std::int32_t orbit = frame_.sites[static_cast<std::size_t>(site)].orbit;
    if (orbit < 0 || random.below(3) == 0) {
      const Site& around = frame_.sites[static_cast<std::size_t>(site)];
      const auto i = random.below(static_cast<std::uint64_t>(frame_.neighbours().size));
      if (around.beside[i] >= 0) orbit = around.beside[i];
    }
    if (orbit < 0) orbit = from;
    const std::uint64_t places = places_.size() * kSpread;
    places_[static_cast<std::size_t>(orbit)] = static_cast<std::int32_t>(random.below(places));
  }

  const Frame& frame_;
  const Colouring& colours_;
  Allowance allowance_;
  std::vector<std::int32_t> places_;
  std::size_t fewest_ = kMostClashes + 1;
};

}  // namespace

OrderSearch search_orders(const Frame& frame, const Colouring& colours,
                          const std::vector<Order>& first, const Allowance& allowance) {
  assert(colours.size() == frame.orbits.size());
  Searcher searcher(frame, colours, allowance);
  for (std::uint32_t number = 1; !allowance.passed() && number <= 16 * first.size(); ++number) {
    if (searcher.climb(first[number % first.size()], number)) break;
  }
  return std::move(searcher.result);
}

}  // namespace stig::synthesis
