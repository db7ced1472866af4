// SPDX-License-Identifier: MIT
// What the merging of rules is checked against: every view that can occur, in every
// orientation, with the brick that belongs there. Views are compared as bytes, which makes
// sorting fast and the order of the result the same everywhere.
#include "synthesis/local_views.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <map>

namespace stig::synthesis {
namespace {

/// Byte order of states is an arbitrary order; what counts is that it is total and cheap.
bool less(const View& a, const View& b) {
  return std::memcmp(a.at.data(), b.at.data(), a.at.size()) < 0;
}
struct LessView {
  bool operator()(const View& a, const View& b) const { return less(a, b); }
};

View turned(const View& view, const Orientation& g, int size) {
  View out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    out.at[static_cast<std::size_t>(g.image[i])] = view.at[i];
  }
  return out;
}

std::vector<View> images_of(const Frame& frame, const View& view) {
  std::vector<View> images;
  for (const Orientation& g : frame.group) {
    images.push_back(turned(view, g, frame.neighbours().size));
  }
  std::sort(images.begin(), images.end(), less);
  images.erase(std::unique(images.begin(), images.end()), images.end());
  return images;
}

}  // namespace

View view_of(const Frame& frame, const Site& site, std::uint32_t mask, const Colouring& colours) {
  const Neighbourhood& n = frame.neighbours();
  View view;
  for (; mask != 0; mask &= mask - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(mask));
    view.at[i] = colours[static_cast<std::size_t>(site.beside[i])];
  }
  for (int i = n.first_below; site.on_floor && i < n.size; ++i) {
    view.at[static_cast<std::size_t>(i)] = kFloor;
  }
  return view;
}

/// Memory is one view per state and orientation: this is the largest array of a synthesis.
std::optional<std::vector<LocalView>> local_views(const Schedule& schedule,
                                                  const Colouring& colours,
                                                  const Allowance& allowance) {
  const Frame& frame = *schedule.frame;
  assert(colours.size() == frame.orbits.size());
  std::vector<LocalView> views;
  // The bare views stand for everything farther from the target than its border.
  for (const bool on_floor : {false, true}) {
    Site bare;
    bare.on_floor = on_floor;
    if (!on_floor || frame.floor) views.push_back({view_of(frame, bare, 0, colours), 0});
  }
  for (std::size_t s = 0; s < frame.sites.size(); ++s) {
    if (s % kSitesBetweenLooks == 0 && allowance.out_of_time()) return std::nullopt;
    const Site& site = frame.sites[s];
    for (const std::uint32_t mask : schedule.states.of(s)) {
      const bool intended = schedule.intended(site, mask);
      const Colour wanted = intended ? colours[static_cast<std::size_t>(site.orbit)] : Colour{0};
      const View view = view_of(frame, site, mask, colours);
      for (const Orientation& g : frame.group) {
        views.push_back({turned(view, g, frame.neighbours().size), wanted});
      }
    }
  }
  std::sort(views.begin(), views.end(),
            [](const LocalView& a, const LocalView& b) { return less(a.view, b.view); });
  // Views that are equal demand the same brick, or the colouring would have a clash.
  const auto last = std::unique(views.begin(), views.end(), [](const auto& a, const auto& b) {
    assert(!(a.view == b.view) || a.wanted == b.wanted);
    return a.view == b.view;
  });
  views.erase(last, views.end());
  return views;
}

std::vector<ExactRule> exact_rules(const Schedule& schedule, const Colouring& colours) {
  const Frame& frame = *schedule.frame;
  // Keys that are turns of each other need one rule: the least image names the class.
  std::map<View, ExactRule, LessView> classes;
  for (const Key& key : schedule.keys) {
    const Site& site = frame.sites[static_cast<std::size_t>(key.site)];
    std::vector<View> images = images_of(frame, view_of(frame, site, key.mask, colours));
    ExactRule& rule = classes[images.front()];
    const std::int32_t rank = schedule.order.rank[static_cast<std::size_t>(key.site)];
    if (rule.at.empty() || rank < rule.rank) rule.rank = rank;
    if (rule.at.empty() || rule.at.back() != key.site) rule.at.push_back(key.site);
    rule.view = images.front();
    rule.place = colours[static_cast<std::size_t>(key.site)];
    rule.images = std::move(images);
  }
  std::vector<ExactRule> rules;
  for (auto& [view, rule] : classes) rules.push_back(std::move(rule));
  std::stable_sort(rules.begin(), rules.end(),
                   [](const ExactRule& a, const ExactRule& b) { return a.rank < b.rank; });
  return rules;
}

}  // namespace stig::synthesis
