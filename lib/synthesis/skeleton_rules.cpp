// SPDX-License-Identifier: MIT
// The rules of a skeleton. Rays look behind themselves for a colour; a fill asks for the
// colours that its bricks actually have beside them. Rules that place different bricks must
// not match together anywhere, so a draft that meets an earlier one is parted from it by a
// cell's states or by heights. Whether the result builds the target is decided by
// presence_check.h, so nothing here has to be proved.
#include "synthesis/skeleton_rules.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace stig::synthesis {
namespace {

constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

/// A rule on its way: heights as numbers.
struct Draft {
  MergedRule rule;
  std::int32_t low = kLowest, high = kHighest;
  std::uint32_t needs = 0;  ///< neighbours at which it asks for bricks, by bit
};

class SkeletonDrafts {
 public:
  SkeletonDrafts(const SolidGrid& grid, const Skeleton& skeleton, bool floor)
      : grid_(grid),
        skeleton_(skeleton),
        floor_(floor),
        count_(skeleton.colours),
        colours_(grid.solid.size(), 0),
        shown_(skeleton.fills.size()) {
    if (skeleton.rays.empty()) {
      for (const std::int32_t cell : grid.cells) colours_[static_cast<std::size_t>(cell)] = 1;
      for (auto& states : shown_) states.assign(grid.step.size(), StateSet::of(1));
    } else {
      count_ += static_cast<int>(std::max<std::size_t>(1, skeleton.fills.size())) - 1;
      if (count_ <= kMaxColours) paint();
    }
  }

  int colour_count() const { return count_; }

  std::vector<Draft> make() {
    for (const Ray& ray : skeleton_.rays) add_ray(ray);
    for (std::size_t f = 0; f < skeleton_.fills.size(); ++f) add_fill(f);
    std::vector<Draft> apart;
    for (const Draft& draft : drafts_) add_apart(draft, apart);
    apart.erase(
        std::remove_if(apart.begin(), apart.end(),
                       [this](const Draft& draft) { return asks_for_bricks_in_floor(draft); }),
        apart.end());
    return apart;
  }

  const PlaceColours& colours() const { return colours_; }

 private:
  StateSet bricks() const { return StateSet::bricks(count_); }
  Colour colour(std::int32_t at) const { return colours_[static_cast<std::size_t>(at)]; }

  Colour colour_of_fill(std::size_t fill) const {
    assert(fill < skeleton_.fills.size());
    if (skeleton_.rays.empty() || fill == 0) return 1;
    return static_cast<Colour>(skeleton_.colours + static_cast<int>(fill));
  }

  /// The rays, and then what each fill places, one fill after the other, in a colour of its
  /// own: so a fill's rule can ask for the colours that its bricks have beside them, and
  /// matches where these are and nowhere else. Fills are painted in turn until nothing
  /// changes; the colours a fill sees depend on which fill came first, and that order is
  /// fixed.
  void paint() {
    colours_[static_cast<std::size_t>(skeleton_.start)] = skeleton_.rays.front().from_colour;
    for (const Ray& ray : skeleton_.rays) {
      for (const std::int32_t at : ray.places) {
        colours_[static_cast<std::size_t>(at)] = ray.colour;
      }
    }
    for (auto& states : shown_) states.assign(grid_.step.size(), StateSet());
    bool more = true;
    while (more) {
      more = false;
      for (std::size_t f = 0; f < skeleton_.fills.size(); ++f) more |= paint_fill(f);
    }
  }

  bool can_paint(const Fill& fill, std::int32_t cell) const {
    if (!grid_.is_solid(cell) || colour(cell) != 0) return false;
    std::uint32_t there = 0;
    for (std::uint32_t m = fill.needs; m != 0; m &= m - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(m));
      if (colour(cell + grid_.step[i]) != 0) there |= 1U << i;
    }
    return fill.holds(there, grid_.height(cell));
  }

  bool paint_fill(std::size_t f) {
    const Fill& fill = skeleton_.fills[f];
    std::vector<std::int32_t> open;
    for (const std::int32_t cell : grid_.cells) {
      if (can_paint(fill, cell)) open.push_back(cell);
    }
    const bool any = !open.empty();
    while (!open.empty()) {
      const std::int32_t cell = open.back();
      open.pop_back();
      if (!can_paint(fill, cell)) continue;
      for (std::uint32_t m = fill.needs; m != 0; m &= m - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(m));
        shown_[f][i] = shown_[f][i] | StateSet::of(colour(cell + grid_.step[i]));
      }
      colours_[static_cast<std::size_t>(cell)] = colour_of_fill(f);
      for (const std::int32_t step : grid_.step) open.push_back(cell - step);
    }
    return any;
  }

  /// A fill's rule asks for the very colours that its bricks have beside them, the union
  /// over all of them.
  void add_fill(std::size_t f) {
    Draft draft;
    draft.rule.place = colour_of_fill(f);
    for (std::uint32_t m = skeleton_.fills[f].needs; m != 0; m &= m - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(m));
      draft.rule.pattern.allowed[i] = shown_[f][i];
    }
    draft.low = skeleton_.fills[f].low;
    draft.high = skeleton_.fills[f].high;
    draft.needs = skeleton_.fills[f].needs;
    drafts_.push_back(draft);
  }

  bool is_single(Colour of) const { return std::count(colours_.begin(), colours_.end(), of) == 1; }

  Draft behind(const Ray& ray, Colour shows) const {
    Draft draft;
    const Neighbourhood& n = grid_.neighbours();
    const auto cell = static_cast<std::size_t>(n.opposite(static_cast<int>(ray.along)));
    draft.needs = 1U << cell;
    draft.rule.pattern.allowed[cell] = StateSet::of(shows);
    draft.rule.place = ray.colour;
    return draft;
  }

  void add_ray(const Ray& ray) {
    const bool from_start = ray.from_colour == ray.colour;
    if (!from_start) {
      Draft first = behind(ray, ray.from_colour);
      // A colour that occurs once identifies its brick; otherwise the height says where on
      // the older ray this one begins.
      if (!is_single(ray.from_colour)) first.low = first.high = grid_.height(ray.places.front());
      drafts_.push_back(first);
    }
    if (ray.places.size() < 2 && !from_start) return;
    Draft on = behind(ray, ray.colour);
    const std::int32_t last = grid_.height(ray.places.back());
    const bool rises = grid_.neighbours().offsets[ray.along].z > 0;
    if (rises) on.high = last;
    if (!rises && !(floor_ && last == 0)) on.low = last;
    drafts_.push_back(on);
  }

  /// Is this a part for the lowest level alone, where all that is below is floor, that has
  /// something else below? It never matches.
  bool asks_for_bricks_in_floor(const Draft& draft) const {
    if (!floor_ || draft.high > 0) return false;
    for (std::size_t i = 0; i < grid_.step.size(); ++i) {
      const bool below = grid_.neighbours().offsets[i].z < 0;
      if (below && (draft.rule.pattern.allowed[i] & StateSet::floor()).none()) return true;
    }
    return false;
  }

  /// Two drafts meet if some height and, at each neighbour, some state satisfies both; cells
  /// are independent of each other, so this is exact.
  bool meet(const Draft& a, const Draft& b) const {
    if (a.low > b.high || b.low > a.high) return false;
    for (std::size_t i = 0; i < grid_.step.size(); ++i) {
      if ((a.rule.pattern.allowed[i] & b.rule.pattern.allowed[i]).none()) return false;
    }
    return true;
  }

  /// Adds a draft, in parts if need be, so that no earlier one that places another brick
  /// matches where it does.
  void add_apart(const Draft& draft, std::vector<Draft>& apart) const {
    std::vector<Draft> parts{draft};
    for (const Draft& other : std::vector<Draft>(apart)) {
      if (other.rule.place == draft.rule.place) continue;
      std::vector<Draft> next;
      for (const Draft& part : parts) part_from(part, other, next);
      parts = std::move(next);
    }
    apart.insert(apart.end(), parts.begin(), parts.end());
  }

  void part_from(const Draft& part, const Draft& other, std::vector<Draft>& out) const {
    if (!meet(part, other)) return out.push_back(part);
    Draft without = part;
    for (std::uint32_t m = other.needs; m != 0; m &= m - 1) {
      const auto at = static_cast<std::size_t>(std::countr_zero(m));
      const StateSet shows = other.rule.pattern.allowed[at];
      without = part;
      StateSet& allowed = without.rule.pattern.allowed[at];
      allowed = StateSet(allowed.bits() & all_states().bits() & ~shows.bits());
      if (!needed_beside(part, at, shows)) return out.push_back(without);
    }
    Draft below = part, above = part;
    below.high = other.low == kLowest ? kLowest : std::min(part.high, other.low - 1);
    above.low = other.high == kHighest ? kHighest : std::max(part.low, other.high + 1);
    without.low = std::max(part.low, other.low);
    without.high = std::min(part.high, other.high);
    out.push_back(without);
    if (other.low != kLowest && below.low <= below.high) out.push_back(below);
    if (other.high != kHighest && above.low <= above.high) out.push_back(above);
  }

  /// The states that can occur here; a set of other bits would be no pattern that can be
  /// written.
  StateSet all_states() const {
    const StateSet all = StateSet::empty_cell() | bricks();
    return floor_ ? all | StateSet::floor() : all;
  }

  /// Is there a cell that the draft may have to place where the neighbour `at` shows this?
  bool needed_beside(const Draft& draft, std::size_t at, StateSet shows) const {
    return std::any_of(grid_.cells.begin(), grid_.cells.end(), [&](std::int32_t cell) {
      const std::int32_t z = grid_.height(cell);
      return colour(cell) == draft.rule.place && z >= draft.low && z <= draft.high &&
             colour(cell + grid_.step[at]) != 0 && shows.contains(colour(cell + grid_.step[at]));
    });
  }

  const SolidGrid& grid_;
  const Skeleton& skeleton_;
  bool floor_;
  int count_;
  PlaceColours colours_;
  std::vector<std::vector<StateSet>> shown_;  ///< by fill and neighbour: what its bricks see
  std::vector<Draft> drafts_;
};

/// Numbers the colours from 1 when nothing is left to fill, since a file's colours must be
/// numbered without a gap.
void close_gap(const SolidGrid& grid, SkeletonRules& out) {
  const auto filled = [&](std::int32_t cell) {
    return out.colours[static_cast<std::size_t>(cell)] == 1;
  };
  if (std::any_of(grid.cells.begin(), grid.cells.end(), filled)) return;
  --out.colour_count;
  for (const std::int32_t cell : grid.cells) --out.colours[static_cast<std::size_t>(cell)];
  const StateSet bricks = StateSet::bricks(out.colour_count + 1);
  for (MergedRule& rule : out.rules) {
    --rule.place;
    for (std::size_t i = 0; i < grid.step.size(); ++i) {
      StateSet& states = rule.pattern.allowed[i];
      if (states == StateSet::anything()) continue;
      const StateSet lower((states & bricks).bits() >> 1 & bricks.bits());
      states = StateSet(states.bits() & ~bricks.bits()) | lower;
    }
  }
}

}  // namespace

std::optional<SkeletonRules> make_skeleton_rules(const SolidGrid& grid, const Skeleton& skeleton,
                                                 bool floor, const Allowance& allowance) {
  SkeletonDrafts drafts(grid, skeleton, floor);
  if (drafts.colour_count() > kMaxColours) return std::nullopt;
  SkeletonRules out;
  for (Draft& draft : drafts.make()) {
    if (draft.low != kLowest) draft.rule.height_min = draft.low;
    if (draft.high != kHighest) draft.rule.height_max = draft.high;
    out.rules.push_back(std::move(draft.rule));
  }
  out.colours = drafts.colours();
  out.colour_count = drafts.colour_count();
  close_gap(grid, out);
  auto order = order_of_growth(grid, out.colours, skeleton.start, out.rules, allowance);
  if (!order) return std::nullopt;
  out.order = std::move(*order);
  return out;
}

}  // namespace stig::synthesis
