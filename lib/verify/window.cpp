// SPDX-License-Identifier: MIT
// Breadth-first enumeration of the fillings of a window: from each known filling, every
// brick that can come next is added. Group bricks come when a rule acts in the filling;
// context bricks as soon as their known predecessors are there, unless the whole of their
// surroundings lies in the window, in which case the rules decide too. The result is closed
// under these steps, which is condition 4 of docs/proofs.md. Time is O(fillings x bricks x
// rules of a brick), memory one bit per brick and filling.
#include "verify/window.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>

#include "base/hash.h"

namespace stig::verify {
namespace {

/// A neighbour of a brick: its bit in the brick's local state and in the filling.
struct Seen {
  Mask mask;
  std::size_t at;
};

/// A brick of the window with what is needed to say when it may come.
struct WindowCell {
  StageSite site;
  std::vector<Seen> around;         ///< its neighbours in the window
  std::vector<std::size_t> before;  ///< context: what is known to be there first
  bool exact = false;               ///< all its neighbours are in the window
};

class Exploration {
 public:
  Exploration(const StageModel& model, const Invariant& invariant, const Budget& budget,
              Window& window)
      : model_(model), invariant_(invariant), budget_(budget), window_(window) {
    collect_context();
    window_.words = (window_.size() + 63) / 64;
    for (std::size_t i = 0; i < window_.size(); ++i) positions_[window_.brick(i)] = i;
    for (std::size_t i = 0; i < window_.size(); ++i) cells_.push_back(cell_view(i));
    for (std::size_t i = 0; i < window_.size(); ++i) by_run_.push_back(i);
    // Group and context have separate positions; the order of the run is needed to find the
    // first missing brick.
    std::sort(by_run_.begin(), by_run_.end(),
              [&](std::size_t a, std::size_t b) { return window_.brick(a) < window_.brick(b); });
  }

  std::optional<WindowFailure> explore() {
    window_.fillings.assign(window_.words, 0);
    window_.from.assign(1, 0);
    window_.added.assign(1, 0);
    // Slot values are one more than a filling's number, so that 0 can mean free.
    slots_.assign(1024, 0);
    insert(0);
    // `window_.fillings` grows during the loop; numbers stay valid where pointers would
    // not.
    for (std::size_t f = 0; f < window_.count(); ++f) {
      if (window_.count() > budget_.states || budget_.spent_at(f)) {
        return WindowFailure{WindowFailure::Kind::too_many, f, 0};
      }
      budget_.spend(window_.size() * kStepsOfCell);
      if (auto failure = expand(f)) return failure;
    }
    return std::nullopt;
  }

 private:
  /// The context is all bricks of the stage around the group. It is sorted, so that the
  /// certificate is the same whatever the order of discovery.
  void collect_context() {
    window_.context.clear();
    std::vector<std::uint32_t> found;
    StageSite site;
    for (const std::uint32_t brick : window_.group) {
      model_.look(brick, site);
      for (Mask left = site.bricks; left != 0; left &= left - 1) {
        found.push_back(site.brick[static_cast<std::size_t>(std::countr_zero(left))]);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const std::uint32_t brick : found) {
      if (!std::binary_search(window_.group.begin(), window_.group.end(), brick)) {
        window_.context.push_back(brick);
      }
    }
  }

  WindowCell cell_view(std::size_t i) {
    WindowCell cell;
    const std::uint32_t brick = window_.brick(i);
    model_.look(brick, cell.site);
    cell.exact = true;
    for (Mask left = cell.site.bricks; left != 0; left &= left - 1) {
      const int index = std::countr_zero(left);
      const auto found = positions_.find(cell.site.brick[static_cast<std::size_t>(index)]);
      if (found == positions_.end()) {
        cell.exact = false;
        continue;
      }
      cell.around.push_back({bit(index), found->second});
      if ((invariant_.before[brick] & bit(index)) != 0) cell.before.push_back(found->second);
    }
    return cell;
  }

  Mask state(const WindowCell& cell, std::size_t filling) const {
    Mask mask = 0;
    for (const Seen& seen : cell.around) mask |= window_.has(filling, seen.at) ? seen.mask : 0;
    return mask;
  }

  std::optional<WindowFailure> expand(std::size_t filling) {
    // The stage is over here; see Invariant::over_at.
    if (invariant_.over_at > 0 && window_.bricks_in(filling) >= invariant_.over_at) {
      return std::nullopt;
    }
    bool group_opens = false;
    for (std::size_t i = 0; i < window_.size(); ++i) {
      if (window_.has(filling, i)) continue;
      const WindowCell& cell = cells_[i];
      const bool in_group = i < window_.group.size();
      bool comes = std::all_of(cell.before.begin(), cell.before.end(),
                               [&](std::size_t at) { return window_.has(filling, at); });
      if (comes && cell.exact) {
        // A wrong colour at a context brick is no failure of this window: the brick's own
        // site is looked at by local_proof.cpp.
        const std::uint64_t placed =
            colours_placed(model_, cell.site, state(cell, filling), cell.site.beside);
        if ((placed & ~(std::uint64_t{1} << cell.site.colour)) != 0 && in_group) {
          return WindowFailure{WindowFailure::Kind::wrong, filling, cell.site.number};
        }
        comes = placed != 0;
      }
      if (!comes) continue;
      group_opens = group_opens || in_group;
      add(filling, i);
    }
    // Dead end: the run would place a group brick next, and no group brick can come in this
    // filling.
    if (!group_opens && group_brick_is_next(filling)) {
      return WindowFailure{WindowFailure::Kind::stuck, filling, 0};
    }
    return std::nullopt;
  }

  /// Is the first missing brick, in the order of the run, one of the group?
  bool group_brick_is_next(std::size_t filling) const {
    const auto missing = std::find_if(by_run_.begin(), by_run_.end(),
                                      [&](std::size_t i) { return !window_.has(filling, i); });
    return missing != by_run_.end() && *missing < window_.group.size();
  }

  // The fillings, each once.

  void add(std::size_t filling, std::size_t i) {
    const std::size_t number = window_.count();
    for (std::size_t w = 0; w < window_.words; ++w) {
      const std::uint64_t word = window_.fillings[filling * window_.words + w];
      window_.fillings.push_back(word | (w == i / 64 ? std::uint64_t{1} << (i % 64) : 0));
    }
    if (!insert(number)) {
      // The filling was appended provisionally to be hashed in place, and is taken back if
      // it is known.
      window_.fillings.resize(number * window_.words);
      return;
    }
    window_.from.push_back(static_cast<std::uint32_t>(filling));
    window_.added.push_back(static_cast<std::uint32_t>(i));
    if (window_.count() * 2 > slots_.size()) grow();
  }
  const std::uint64_t* words(std::size_t filling) const {
    return window_.fillings.data() + filling * window_.words;
  }
  std::size_t home(std::size_t filling) const {
    std::uint64_t hash = 0;
    for (std::size_t w = 0; w < window_.words; ++w) hash = combine(hash, words(filling)[w]);
    return static_cast<std::size_t>(hash) & (slots_.size() - 1);
  }
  bool insert(std::size_t filling) {
    std::size_t slot = home(filling);
    for (; slots_[slot] != 0; slot = (slot + 1) & (slots_.size() - 1)) {
      if (std::equal(words(filling), words(filling) + window_.words, words(slots_[slot] - 1))) {
        return false;
      }
    }
    slots_[slot] = static_cast<std::uint32_t>(filling + 1);
    return true;
  }
  /// Fillings keep their numbers; only the slots are recomputed.
  void grow() {
    slots_.assign(slots_.size() * 2, 0);
    for (std::size_t f = 0; f < window_.count(); ++f) insert(f);
  }

  const StageModel& model_;
  const Invariant& invariant_;
  const Budget& budget_;
  Window& window_;
  std::map<std::uint32_t, std::size_t> positions_;  ///< of bricks in the window
  std::vector<WindowCell> cells_;
  std::vector<std::size_t> by_run_;   ///< positions in the order of the run
  std::vector<std::uint32_t> slots_;  ///< open addressing: 1 + number of a filling
};

}  // namespace

std::optional<WindowFailure> explore_window(const StageModel& model, const Invariant& invariant,
                                            const Budget& budget, Window& window) {
  assert(std::none_of(window.group.begin(), window.group.end(),
                      [&](std::uint32_t brick) { return brick >= model.bricks(); }));
  std::sort(window.group.begin(), window.group.end());
  return Exploration(model, invariant, budget, window).explore();
}

/// The search is a tree: each filling remembers the one it came from, so a path costs no
/// search.
std::vector<std::uint32_t> path_to(const Window& window, std::size_t filling) {
  assert(filling < window.count());
  std::vector<std::uint32_t> path;
  for (; filling != 0; filling = window.from[filling]) {
    path.push_back(window.brick(window.added[filling]));
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace stig::verify
