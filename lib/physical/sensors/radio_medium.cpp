// SPDX-License-Identifier: MIT
// Only radios that send ask who is near, and most are silent at any moment. Each finds those around
// it by a grid whose cells are about a block's edge, so a tick costs about what is said.
#include "physical/sensors/radio_medium.h"

#include <algorithm>
#include <cassert>

#include "physical/sensors/place_index.h"

namespace stig::physics {

namespace {

constexpr double kRadioCell = 0.06;  ///< m

PlaceIndex index_of(const std::vector<Radio>& radios) {
  std::vector<Bounds> places;
  places.reserve(radios.size());
  for (const Radio& r : radios) places.push_back({r.p_W, r.p_W});
  return {std::move(places), kRadioCell};
}

}  // namespace

std::vector<std::vector<Message>> carry(const std::vector<Radio>& radios,
                                        const std::vector<std::vector<Message>>& sends) {
  assert(sends.size() == radios.size());
  std::vector<std::vector<Message>> heard(radios.size());
  const auto silent = [](const std::vector<Message>& m) { return m.empty(); };
  // The usual case: no index is made.
  if (std::all_of(sends.begin(), sends.end(), silent)) return heard;
  const PlaceIndex index = index_of(radios);
  std::vector<std::uint32_t> near;
  for (std::size_t s = 0; s < radios.size(); ++s) {
    if (sends[s].empty()) continue;
    const Radio& sender = radios[s];
    const Vec3 reach{sender.range, sender.range, sender.range};
    index.find({sender.p_W - reach, sender.p_W + reach}, near);
    for (const std::uint32_t r : near) {
      // Half duplex; it leaves out the sender itself as well.
      if (!sends[r].empty()) continue;
      if (squared(radios[r].p_W - sender.p_W) > sender.range * sender.range) continue;
      // Senders run upwards, so what one hears is sorted by sender whatever the grid's order.
      heard[r].insert(heard[r].end(), sends[s].begin(), sends[s].end());
    }
  }
  return heard;
}

}  // namespace stig::physics
