// SPDX-License-Identifier: MIT
#include "search/repeated_parts.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "lattice/structure.h"
#include "rules/symmetry.h"

namespace stig::search {
namespace {

constexpr int kContacts = 2;  ///< from a part's brick to its farthest
constexpr std::size_t kFewestBricks = 3;
constexpr int kSide = 2 * kContacts + 1;  ///< of the box around a part

/// Cells of the box around a part's brick, as numbers.
constexpr std::size_t box_index(Offset o) {
  return static_cast<std::size_t>(((o.x + kContacts) * kSide + o.y + kContacts) * kSide + o.z +
                                  kContacts);
}

/// What a brick of each colour adds to a part's hash, by its place and the turn.
class Terms {
 public:
  explicit Terms(Lattice lattice) {
    for (const Orientation& turn : rules::orientations(lattice, Symmetry::rotations, false)) {
      auto& terms = of_turn_.emplace_back();
      for (int x = -kContacts; x <= kContacts; ++x) {
        for (int y = -kContacts; y <= kContacts; ++y) {
          for (int z = -kContacts; z <= kContacts; ++z) {
            const Cell turned = Cell{} + turn.apply({x, y, z});
            for (Colour colour = 1; colour <= kMaxColours; ++colour) {
              terms[box_index({x, y, z})][colour] = placement_hash(turned, colour);
            }
          }
        }
      }
    }
  }
  std::size_t turns() const { return of_turn_.size(); }
  std::uint64_t of(std::size_t turn, Offset at, Colour colour) const {
    return of_turn_[turn][box_index(at)][colour];
  }

 private:
  std::vector<std::array<std::array<std::uint64_t, kMaxColours + 1>, kSide * kSide * kSide>>
      of_turn_;
};

const Terms& terms_of(Lattice lattice) {
  static const Terms cubic(Lattice::cubic), hexagonal(Lattice::hexagonal);
  return lattice == Lattice::cubic ? cubic : hexagonal;
}

/// Bricks by number, and for each those that share a face with it.
struct Contacts {
  std::vector<std::vector<std::uint32_t>> of;

  Contacts(Lattice lattice, const std::vector<PlacedBrick>& bricks) : of(bricks.size()) {
    const Neighbourhood& n = neighbourhood(lattice);
    const auto before = [](const PlacedBrick& brick, Cell cell) { return brick.at < cell; };
    for (std::uint32_t b = 0; b < bricks.size(); ++b) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
        if (!n.is_face[i]) continue;
        const Cell cell = bricks[b].at + n.offsets[i];
        const auto found = std::lower_bound(bricks.begin(), bricks.end(), cell, before);
        if (found == bricks.end() || found->at != cell) continue;
        of[b].push_back(static_cast<std::uint32_t>(found - bricks.begin()));
      }
    }
  }
};

/// Numbers of its bricks, rising.
std::vector<std::uint32_t> part_of(std::uint32_t brick, const Contacts& contacts) {
  std::vector<std::uint32_t> part{brick};
  for (int step = 0; step < kContacts; ++step) {
    for (std::size_t k = 0, end = part.size(); k < end; ++k) {
      const auto& next = contacts.of[part[k]];
      part.insert(part.end(), next.begin(), next.end());
    }
    std::sort(part.begin(), part.end());
    part.erase(std::unique(part.begin(), part.end()), part.end());
  }
  return part;
}

/// Equal for parts of one kind, and but by the chance of a 64-bit hash for these alone.
std::uint64_t kind_of(const std::vector<std::uint32_t>& part, Cell centre,
                      const std::vector<PlacedBrick>& bricks, const Terms& terms) {
  std::uint64_t least = ~std::uint64_t{0};
  for (std::size_t turn = 0; turn < terms.turns(); ++turn) {
    std::uint64_t sum = 0;
    for (const std::uint32_t b : part)
      sum += terms.of(turn, bricks[b].at - centre, bricks[b].brick);
    least = std::min(least, sum);
  }
  return least;
}

bool apart(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  auto i = a.begin(), j = b.begin();
  while (i != a.end() && j != b.end()) {
    if (*i == *j) return false;
    *i < *j ? ++i : ++j;
  }
  return true;
}

/// Have some two of these no brick in common? Where they reach farther than a part is wide it is
/// plain; else there are few.
bool some_apart(const std::vector<std::uint32_t>& centres,
                const std::vector<std::vector<std::uint32_t>>& parts,
                const std::vector<PlacedBrick>& bricks) {
  for (const auto along : {&Cell::x, &Cell::y, &Cell::z}) {
    const auto [low, high] =
        std::minmax_element(centres.begin(), centres.end(), [&](std::uint32_t a, std::uint32_t b) {
          return bricks[a].at.*along < bricks[b].at.*along;
        });
    if (bricks[*high].at.*along - bricks[*low].at.*along >= kSide) return true;
  }
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (std::size_t j = i + 1; j < centres.size(); ++j) {
      if (apart(parts[centres[i]], parts[centres[j]])) return true;
    }
  }
  return false;
}

}  // namespace

int repeated_parts(Lattice lattice, const std::vector<PlacedBrick>& bricks) {
  const Contacts contacts(lattice, bricks);
  const Terms& terms = terms_of(lattice);
  std::vector<std::vector<std::uint32_t>> parts;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> kinds;
  for (std::uint32_t b = 0; b < bricks.size(); ++b) {
    parts.push_back(part_of(b, contacts));
    if (parts[b].size() < kFewestBricks) continue;
    kinds[kind_of(parts[b], bricks[b].at, bricks, terms)].push_back(b);
  }
  // A sum of ones: the order of kinds does not matter.
  return static_cast<int>(std::count_if(kinds.begin(), kinds.end(), [&](const auto& kind) {
    return some_apart(kind.second, parts, bricks);
  }));
}

}  // namespace stig::search
