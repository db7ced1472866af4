// SPDX-License-Identifier: MIT
// The orders that are worth a solver's time. Each family's orders are turned into
// schedules; those with a clash that no colours prevent are dropped, and the rest are
// sorted by a lower bound on their colours. Schedules are too large to be kept by the
// hundred, so a candidate is the recipe of its order, and its schedule is made anew when it
// is needed.
#include "synthesis/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/hash.h"
#include "synthesis/order_search.h"
#include "synthesis/reasons.h"

namespace stig::synthesis {
namespace {

/// Orders from which a search among orders begins.
constexpr std::size_t kBeginnings = 24;
/// Up to this many orbits beside the start every order is tried, if there are not more than …
constexpr std::size_t kFewOrbits = 8, kMostOrders = 1000, kMostOrdersWithTies = 20'000;

/// Two orders with the same masks of earlier and equal neighbours are the same to rules,
/// whatever their ranks are. A collision would lose a candidate, and costs no soundness.
std::uint64_t hash_of(const Schedule& schedule) {
  std::uint64_t h = 0;
  for (const std::uint32_t mask : schedule.before) h = combine(h, mask);
  for (const std::uint32_t mask : schedule.beside) h = combine(h, mask);
  return h;
}

}  // namespace

ScheduleLimits schedule_limits(const SynthesisOptions& options) {
  ScheduleLimits limits;
  if (options.strict_only) limits.keys_of_site = options.symmetry == Symmetry::none ? 1 : 256;
  return limits;
}

void Candidates::add_start(const std::vector<Cell>& start) {
  frames_.push_back(
      std::make_shared<Frame>(make_frame(target_, {start, options_.symmetry, options_.floor})));
}

bool Candidates::all_given() const {
  return std::all_of(target_.colours.begin(), target_.colours.end(),
                     [](StateSet colours) { return colours.is_single(); });
}

/// Families are tried plan by plan and not start by start, so that every start gets its
/// chance at the most promising plans before the effort is spent.
void Candidates::look_at_families(const Allowance& looking, const Allowance& whole) {
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    if (frames_[f]->orbits.size() > kFewOrbits + 1 || options_.family) continue;
    for (Order& order : all_orders(*frames_[f], kMostOrders)) {
      look_at(
          f, [order](const Frame&) { return order; }, whole);
    }
  }
  for (const OrderPlan& plan : order_plans()) {
    if (options_.family && plan.family != *options_.family) continue;
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      if (looking.passed() && !list.empty()) break;
      look_at(f, plan.make, whole);
    }
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.at_least < b.at_least; });
}

void Candidates::search(const Allowance& allowance) {
  tell_("searching among orders");
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    const Allowance share = allowance.within(allowance.left() / (frames_.size() - f));
    std::vector<Order> first;
    for (const OrderPlan& plan : order_plans()) {
      if (first.size() < kBeginnings) first.push_back(plan.make(*frames_[f]));
    }
    OrderSearch found = search_orders(*frames_[f], given_colours(f), first, share);
    tried_ += found.tried;
    if (found.order) {
      look_at(
          f, [order = *found.order](const Frame&) { return order; }, allowance);
    } else if (found.clash) {
      look_alike_ = describe_look_alikes(*found.nearest, *found.clash, target_);
    }
  }
}

bool Candidates::starts_are_all() const {
  return !options_.start.empty() || frames_.size() == target_.cells.size();
}

/// The basis of every claim that a target cannot be built: all starts, all orders, ties
/// included. It is affordable for up to eight orbits beside the start.
bool Candidates::look_at_every_order(const Allowance& allowance) {
  if (options_.family || options_.strict_only) return false;
  if (frames_.front()->orbits.size() > kFewOrbits + 1) return false;
  if (options_.start.empty() && options_.symmetry == Symmetry::none) {
    for (const Cell c : target_.cells) {
      const bool known = std::any_of(frames_.begin(), frames_.end(), [&](const auto& frame) {
        return std::any_of(frame->orbits.begin(), frame->orbits.end(),
                           [&](const Orbit& orbit) { return orbit.start && orbit.at == c; });
      });
      if (!known) add_start({c});
    }
  }
  // Set again by look_at when an order could not be decided, and then nothing may be
  // claimed.
  gave_up_ = false;
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    const std::vector<Order> orders = all_orders(*frames_[f], kMostOrdersWithTies, Ties::allowed);
    if (orders.empty()) return false;
    for (const Order& order : orders) {
      look_at(
          f, [order](const Frame&) { return order; }, allowance);
      if (gave_up_) return false;
    }
  }
  return starts_are_all();
}

Colouring Candidates::given_colours(std::size_t frame) const {
  assert(frame < frames_.size());
  Colouring colours;
  for (const Orbit& orbit : frames_[frame]->orbits) colours.push_back(orbit.colours.first());
  return colours;
}

void Candidates::note_look_alike(const Schedule& schedule, const Clash& clash) {
  if (!look_alike_) look_alike_ = describe_look_alikes(schedule, clash, target_);
}

bool Candidates::clashes_as_given(const Schedule& schedule, std::size_t frame) {
  if (!all_given()) return false;
  const auto clashes = find_clashes(schedule, given_colours(frame), 1, 1);
  if (!clashes.empty()) note_look_alike(schedule, clashes.front());
  return !clashes.empty();
}

void Candidates::look_at(std::size_t frame, const Maker& make, const Allowance& allowance) {
  assert(frame < frames_.size());
  gave_up_ = gave_up_ || allowance.passed();
  if (allowance.passed()) return;
  BadOrder bad;
  ScheduleLimits limits = schedule_limits(options_);
  limits.allowance = allowance;
  const std::optional<Schedule> schedule =
      make_schedule(*frames_[frame], make(*frames_[frame]), bad, limits);
  allowance.spend(schedule ? cost_of(*schedule) : bad.cost);
  if (!schedule) {
    gave_up_ = gave_up_ || bad.kind != BadOrder::Kind::nothing_before;
    return;
  }
  // The frame belongs to the identity: the same masks about another start are another
  // order.
  if (!seen_.insert(combine(frame, hash_of(*schedule))).second) return;
  ++tried_;
  const ColouringSearch search(*schedule, static_cast<int>(target_.bricks.size()), allowance);
  allowance.spend(search.cost());
  tell_(fmt::format("{} orders looked at", tried_));
  if (clashes_as_given(*schedule, frame)) return;
  if (const auto& hopeless = search.differences().hopeless()) {
    return note_look_alike(*schedule, *hopeless);
  }
  list.push_back({frame, make, search.at_least(), 0});
}

std::optional<Schedule> Candidates::schedule_of(const Candidate& candidate,
                                                const Allowance& allowance) const {
  assert(candidate.frame < frames_.size());
  const Frame& frame = *frames_[candidate.frame];
  if (allowance.out_of_time()) return std::nullopt;
  BadOrder bad;
  ScheduleLimits limits = schedule_limits(options_);
  limits.allowance = allowance;
  std::optional<Schedule> schedule = make_schedule(frame, candidate.make(frame), bad, limits);
  assert(schedule || allowance.out_of_time());
  if (schedule) allowance.spend(cost_of(*schedule));
  return schedule;
}

}  // namespace stig::synthesis
