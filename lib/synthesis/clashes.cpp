// SPDX-License-Identifier: MIT
// Finds where a key looks like a wrong local state, conditions A and B of
// docs/synthesis.md. All keys in all orientations go into a hash table; every local state
// is one look-up. So a check is linear in keys x group + states, and not in their product.
// Hashes are sums over bricks: turning a key permutes its terms, and a state's hash is
// accumulated bit by bit.
#include "synthesis/clashes.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "base/hash.h"

namespace stig::synthesis {
namespace {

/// What one brick adds to the hash of a view: a sum, so that turning is re-indexing. A
/// colour takes six bits, so neighbour and colour together are one small number before
/// mixing.
std::uint64_t term(std::size_t neighbour, Colour colour) {
  return mix(0x9e3779b97f4a7c15ULL * (neighbour * 64 + colour + 1));
}
constexpr std::uint64_t kOnFloor = 0x632be59bd9b4e019ULL;

struct Image {
  std::uint64_t hash;
  std::int32_t key, orientation;
  std::int32_t next;  ///< with the same hash; -1: none
};

/// Keys in every orientation, by the hash of what they show.
class KeyIndex {
 public:
  KeyIndex(const Schedule& schedule, const Colouring& colours) {
    const Frame& frame = *schedule.frame;
    images_.reserve(schedule.keys.size() * frame.group.size());
    // At most half full, plus a little for targets of a few cells.
    slots_.assign(std::bit_ceil(schedule.keys.size() * frame.group.size() * 2 + 16), -1);
    last_.assign(slots_.size(), -1);
    for (std::size_t k = 0; k < schedule.keys.size(); ++k) {
      const Key& key = schedule.keys[k];
      const Site& site = frame.sites[static_cast<std::size_t>(key.site)];
      for (std::size_t g = 0; g < frame.group.size(); ++g) {
        std::uint64_t hash = site.on_floor ? kOnFloor : 0;
        for (std::uint32_t m = key.mask; m != 0; m &= m - 1) {
          const auto i = static_cast<std::size_t>(std::countr_zero(m));
          hash += term(static_cast<std::size_t>(frame.group[g].image[i]),
                       colours[static_cast<std::size_t>(site.beside[i])]);
        }
        add({hash, static_cast<std::int32_t>(k), static_cast<std::int32_t>(g), -1});
      }
    }
  }

  /// The first image with this hash, or -1.
  std::int32_t find(std::uint64_t hash) const {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t s = mix(hash) & mask; slots_[s] >= 0; s = (s + 1) & mask) {
      if (image(slots_[s]).hash == hash) return slots_[s];
    }
    return -1;
  }
  const Image& image(std::int32_t i) const { return images_[static_cast<std::size_t>(i)]; }

 private:
  void add(const Image& image) {
    const auto number = static_cast<std::int32_t>(images_.size());
    images_.push_back(image);
    const std::size_t mask = slots_.size() - 1;
    std::size_t s = mix(image.hash) & mask;
    while (slots_[s] >= 0 && images_[static_cast<std::size_t>(slots_[s])].hash != image.hash) {
      s = (s + 1) & mask;
    }
    if (slots_[s] < 0) {
      slots_[s] = number;
    } else {
      images_[static_cast<std::size_t>(last_[s])].next = number;
    }
    last_[s] = number;
  }

  std::vector<Image> images_;
  std::vector<std::int32_t> slots_, last_;
};

/// Not the hash alone: cell by cell. Equal sums are only a hint; clauses must rest on real
/// likeness.
bool looks_alike(const Schedule& schedule, const Colouring& colours, const Clash& clash) {
  const Frame& frame = *schedule.frame;
  const Key& key = schedule.keys[static_cast<std::size_t>(clash.key)];
  const Site& from = frame.sites[static_cast<std::size_t>(key.site)];
  const Site& to = frame.sites[static_cast<std::size_t>(clash.site)];
  const Orientation& g = frame.group[static_cast<std::size_t>(clash.orientation)];
  if (from.on_floor != to.on_floor || turned(key.mask, g) != clash.mask) return false;
  for (std::uint32_t m = key.mask; m != 0; m &= m - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(m));
    const auto a = static_cast<std::size_t>(from.beside[i]);
    const auto b = static_cast<std::size_t>(to.beside[static_cast<std::size_t>(g.image[i])]);
    if (colours[a] != colours[b]) return false;
  }
  return true;
}

using Counts = std::function<bool(const Clash&)>;

class ClashFinder {
 public:
  ClashFinder(const Schedule& schedule, const Colouring& colours, std::size_t most_of_state,
              const Counts& counts)
      : schedule_(schedule),
        colours_(colours),
        most_(most_of_state),
        counts_(counts),
        keys_(schedule, colours) {}

  void look_at(std::size_t number, std::vector<Clash>& out) const {
    const Site& site = schedule_.frame->sites[number];
    std::array<std::uint64_t, kMaxNeighbours> terms{};
    for (std::uint32_t m = site.present; m != 0; m &= m - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(m));
      terms[i] = term(i, colours_[static_cast<std::size_t>(site.beside[i])]);
    }
    for (const std::uint32_t mask : schedule_.states.of(number)) {
      std::uint64_t hash = site.on_floor ? kOnFloor : 0;
      for (std::uint32_t m = mask; m != 0; m &= m - 1) {
        hash += terms[static_cast<std::size_t>(std::countr_zero(m))];
      }
      const std::int32_t first = keys_.find(hash);
      if (first >= 0) add_clashes(number, site, mask, first, out);
    }
  }

 private:
  void add_clashes(std::size_t number, const Site& site, std::uint32_t mask, std::int32_t first,
                   std::vector<Clash>& out) const {
    const bool intended = schedule_.intended(site, mask);
    std::size_t found = 0;
    // Several keys may look like one state, and each is a demand of its own; some of each
    // state suffice for a solver that is asked again.
    for (std::int32_t i = first; i >= 0 && found < most_; i = keys_.image(i).next) {
      const Clash clash{keys_.image(i).key, keys_.image(i).orientation,
                        static_cast<std::int32_t>(number), mask, intended};
      const auto from =
          static_cast<std::size_t>(schedule_.keys[static_cast<std::size_t>(clash.key)].site);
      if (intended && colours_[from] == colours_[static_cast<std::size_t>(site.orbit)]) continue;
      if (!looks_alike(schedule_, colours_, clash)) continue;
      // Before the bounds: what does not count must not take the place of what does.
      if (counts_ && !counts_(clash)) continue;
      out.push_back(clash);
      ++found;
    }
  }

  const Schedule& schedule_;
  const Colouring& colours_;
  std::size_t most_;
  const Counts& counts_;
  KeyIndex keys_;
};

}  // namespace

/// Bit i of the mask moves to the index at which the turned neighbourhood shows neighbour
/// i.
std::uint32_t turned(std::uint32_t mask, const Orientation& orientation) {
  std::uint32_t out = 0;
  for (; mask != 0; mask &= mask - 1) {
    out |= 1U << orientation.image[static_cast<std::size_t>(std::countr_zero(mask))];
  }
  return out;
}

std::vector<Clash> find_clashes(const Schedule& schedule, const Colouring& colours,
                                std::size_t most_of_state, std::size_t most,
                                const Allowance& allowance,
                                const std::function<bool(const Clash&)>& counts) {
  assert(colours.size() == schedule.frame->orbits.size());
  std::vector<Clash> out;
  const ClashFinder finder(schedule, colours, most_of_state, counts);
  for (std::size_t s = 0; s < schedule.frame->sites.size() && out.size() < most; ++s) {
    // The clock ends the search; so callers ask whether the time was over before they take
    // an empty result for an answer.
    if (s % kSitesBetweenLooks == 0 && allowance.out_of_time()) break;
    finder.look_at(s, out);
  }
  return out;
}

std::vector<std::pair<int, int>> compared_orbits(const Schedule& schedule, const Clash& clash) {
  const Frame& frame = *schedule.frame;
  assert(static_cast<std::size_t>(clash.key) < schedule.keys.size());
  const Key& key = schedule.keys[static_cast<std::size_t>(clash.key)];
  const Site& from = frame.sites[static_cast<std::size_t>(key.site)];
  const Site& to = frame.sites[static_cast<std::size_t>(clash.site)];
  const Orientation& g = frame.group[static_cast<std::size_t>(clash.orientation)];
  std::vector<std::pair<int, int>> pairs;
  for (std::uint32_t m = key.mask; m != 0; m &= m - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(m));
    const int a = from.beside[i], b = to.beside[static_cast<std::size_t>(g.image[i])];
    if (a != b) pairs.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace stig::synthesis
