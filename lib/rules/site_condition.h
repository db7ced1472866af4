// SPDX-License-Identifier: MIT
// What a rule asks of a site besides the states around it: its height, and the stage.
//
// One answer serves the table that worlds run on, explanations, the search for views, the
// verifier's index and its proof that a set builds without end. The checker of certificates
// answers for itself (certify/acting_rules.cpp), and so does the tests' oracle.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "rules/rule.h"

namespace stig::rules {

/// Whole numbers low..high; the extremes of 32 bits stand for no bound.
struct Interval {
  std::int32_t low = INT32_MIN, high = INT32_MAX;
  /// Without branches: the engines ask this of every match, and a tenth of an event's time
  /// hangs on it.
  constexpr bool contains(std::int64_t value) const { return (value >= low) & (value <= high); }
  constexpr bool empty() const { return low > high; }
  constexpr bool operator==(const Interval&) const = default;
};

constexpr Interval both(const Interval& a, const Interval& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// What a rule can ask of a site.
struct SiteState {
  std::int64_t height = 0;  ///< z
  std::int64_t stage = 1;
};

struct SiteCondition {
  Interval height, stage;
  constexpr bool operator==(const SiteCondition&) const = default;
};

constexpr SiteCondition site_condition(const Rule& rule) {
  SiteCondition condition;
  if (rule.height_min) condition.height.low = *rule.height_min;
  if (rule.height_max) condition.height.high = *rule.height_max;
  if (rule.stage != 0) condition.stage = {rule.stage, rule.stage};
  return condition;
}

/// visit(key, what is asked, what the site has), for each part of the condition.
template <class Visit>
constexpr void for_each_part(const SiteCondition& condition, const SiteState& site,
                             const Visit& visit) {
  visit(std::string_view("stage"), condition.stage, site.stage);
  visit(std::string_view("height"), condition.height, site.height);
}

constexpr bool allows(const SiteCondition& condition, const SiteState& site) {
  bool all = true;
  for_each_part(condition, site, [&](std::string_view, const Interval& asked, std::int64_t value) {
    all &= asked.contains(value);
  });
  return all;
}

/// Is it all the same how high the site lies?
constexpr bool allows_every_height(const SiteCondition& condition) {
  return condition.height == Interval();
}

/// At this height, in some stage?
constexpr bool allows_height(const SiteCondition& condition, std::int64_t height) {
  return allows(condition, {height, std::max(condition.stage.low, 1)});
}

/// The height nearest to 0 in `range` that the condition allows in some stage.
constexpr std::optional<std::int64_t> allowed_height(const SiteCondition& condition,
                                                     const Interval& range) {
  const Interval within = both(condition.height, range);
  if (within.empty() || condition.stage.empty()) return std::nullopt;
  return std::clamp<std::int64_t>(0, within.low, within.high);
}

/// Does a condition that allows a site allow all that lie above it, or below, for ever?
constexpr bool allows_for_ever(const SiteCondition& condition, bool upwards) {
  const Interval free;
  return upwards ? condition.height.high == free.high : condition.height.low == free.low;
}

/// What two rules ask together; no site allows it when some part is empty.
constexpr SiteCondition both(const SiteCondition& a, const SiteCondition& b) {
  return {both(a.height, b.height), both(a.stage, b.stage)};
}

}  // namespace stig::rules
