// SPDX-License-Identifier: MIT
// Exhaustive search over the orders of events, breadth first by the number of bricks. A
// state is a sorted list of events in one array per layer, found again by a hash and
// compared in full, so that merging states is exact. The enabled events of a state are
// inherited from its parent and corrected around the new brick only; views are read from
// one shared array of cell states, into which the present state is written and taken back.
#include "lattice/event_orders.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <unordered_map>

#include "base/hash.h"
#include "lattice/swarm.h"

namespace stig::lattice {
namespace {

/// A site and a colour in one word: the site's number shifted by six bits.
using Event = std::uint32_t;
/// 62 colours fit six bits, which leaves 2^26 sites; the search is given up before that
/// many are numbered.
constexpr int kColourBits = 6;
constexpr std::uint32_t kMaxSites = std::uint32_t{1} << (32 - kColourBits);

std::uint32_t site_of(Event event) { return event >> kColourBits; }
Colour colour_of(Event event) { return static_cast<Colour>(event & ((1U << kColourBits) - 1)); }

struct CellHash {
  std::size_t operator()(Cell c) const {
    const auto word = [](std::int32_t v) { return std::uint64_t{static_cast<std::uint32_t>(v)}; };
    return static_cast<std::size_t>(combine(word(c.x) << 32 | word(c.y), word(c.z)));
  }
};

/// The cells met so far, numbered, with the states they have in the structure
/// being looked at. Numbers 0 and 1 stand for all cells outside the world.
class Sites {
 public:
  static constexpr std::uint32_t kOutside = 0, kBelowFloor = 1, kFirst = 2;

  Sites(const RuleTable& rules, const std::optional<Box>& box)
      : neighbours_(rules.neighbours()), floor_(rules.floor()), box_(box) {
    cells_.resize(kFirst);
    around_.resize(kFirst);
    states_ = {kEmpty, kFloor};
  }

  std::uint32_t number(Cell cell) {
    if (box_) cell = box_->wrap(cell);
    // Cells outside get shared numbers: they never change, and need no entry of their own.
    if (floor_ && cell.z < 0) return kBelowFloor;
    if (box_ && !box_->contains(cell)) return kOutside;
    const auto [it, fresh] = numbers_.try_emplace(cell, static_cast<std::uint32_t>(cells_.size()));
    if (fresh) {
      cells_.push_back(cell);
      around_.emplace_back();
      states_.push_back(kEmpty);
    }
    return it->second;
  }
  Cell cell(std::uint32_t site) const { return cells_[site]; }
  State state(std::uint32_t site) const { return states_[site]; }
  void set(std::uint32_t site, State state) { states_[site] = state; }
  // 26 neighbours may be numbered in one step, hence the margin before the limit of an
  // event's bits.
  bool full() const { return cells_.size() + kMaxNeighbours >= kMaxSites; }

  /// Numbers of the neighbours, by index. Neighbours' numbers are cached: a site is looked
  /// at in many states.
  const std::vector<std::uint32_t>& around(std::uint32_t site) {
    if (around_[site].empty()) {
      std::vector<std::uint32_t> numbers;
      for (int i = 0; i < neighbours_.size; ++i) {
        numbers.push_back(number(cells_[site] + neighbours_.offsets[static_cast<std::size_t>(i)]));
      }
      around_[site] = std::move(numbers);
    }
    return around_[site];
  }
  View view(std::uint32_t site) {
    View view;
    std::size_t i = 0;
    for (const std::uint32_t n : around(site)) view.at[i++] = states_[n];
    return view;
  }

 private:
  const Neighbourhood& neighbours_;
  bool floor_;
  std::optional<Box> box_;
  std::unordered_map<Cell, std::uint32_t, CellHash> numbers_;
  std::vector<Cell> cells_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<State> states_;
};

/// A state as its events in rising order.
using Events = std::vector<Event>;

/// The states of one size: events, enabled events, and an index by hash. Arrays of
/// structures would cost an allocation for each state; these vectors cost none.
class Layer {
 public:
  explicit Layer(std::size_t depth) : depth_(depth), slots_(64, 0) {}

  std::size_t depth() const { return depth_; }
  std::size_t size() const { return hashes_.size(); }
  std::uint64_t words() const { return events_.size() + open_.size() + 6 * size(); }
  const Event* events(std::size_t state) const {
    assert(state < size());
    return events_.data() + state * depth_;
  }
  const Event* open_begin(std::size_t state) const { return open_.data() + open_from_[state]; }
  const Event* open_end(std::size_t state) const {
    return open_.data() + (state + 1 < size() ? open_from_[state + 1] : open_.size());
  }

  /// False when the layer has the state already; its open events are then set by
  /// the caller with add_open, before the next insert.
  bool insert(const Events& events) {
    assert(events.size() == depth_);
    // A sum, so it does not depend on the order; events are sorted anyway, and the
    // comparison is exact.
    std::uint64_t hash = 0;
    for (const Event e : events) hash += mix(e + 0x9e3779b97f4a7c15ULL);
    if (2 * size() >= slots_.size()) grow();
    std::uint32_t& slot = find(hash, &events);
    if (slot != 0) return false;
    events_.insert(events_.end(), events.begin(), events.end());
    hashes_.push_back(hash);
    open_from_.push_back(open_.size());
    slot = static_cast<std::uint32_t>(size());
    return true;
  }
  void add_open(Event event) { open_.push_back(event); }

 private:
  /// The slot of the state, or the free one where it belongs. Without `events`
  /// every state counts as different.
  std::uint32_t& find(std::uint64_t hash, const Events* events) {
    std::size_t at = static_cast<std::size_t>(mix(hash)) & (slots_.size() - 1);
    while (slots_[at] != 0) {
      const std::size_t state = slots_[at] - 1;
      if (events && hashes_[state] == hash &&
          std::equal(events->begin(), events->end(), this->events(state))) {
        break;
      }
      at = (at + 1) & (slots_.size() - 1);
    }
    return slots_[at];
  }
  void grow() {
    slots_.assign(2 * slots_.size(), 0);
    // Rehashing knows that all states differ, so it only looks for free slots.
    for (std::uint32_t state = 0; state < size(); ++state)
      find(hashes_[state], nullptr) = state + 1;
  }

  std::size_t depth_;
  std::vector<Event> events_;
  std::vector<Event> open_;
  std::vector<std::size_t> open_from_;
  std::vector<std::uint64_t> hashes_;
  std::vector<std::uint32_t> slots_;  ///< open addressing: 1 + state, 0 free
};

class Search {
 public:
  Search(const RuleTable& rules, const std::vector<PlacedBrick>& start,
         const std::optional<Box>& box, const EventOrdersLimits& limits,
         const EventOrdersHooks& hooks)
      : rules_(rules),
        start_(start),
        box_(box),
        limits_(limits),
        hooks_(hooks),
        sites_(rules, box) {
    for (const PlacedBrick& brick : start) sites_.set(sites_.number(brick.at), brick.brick);
  }

  EventOrders run() {
    // The empty state is the start; its bricks are in `sites_` throughout.
    std::vector<Events> states{{}};
    for (int stage = 1; stage <= rules_.stage_count() && !given_up_; ++stage) {
      stage_ = stage;
      last_stage_ = stage == rules_.stage_count();
      states = run_stage(std::move(states));
    }
    result_.complete = !given_up_;
    // Stopped before the last stage, `states` are ends of a stage, not of the whole.
    if (last_stage_) keep_ends(states);
    return std::move(result_);
  }

 private:
  /// From the states in which the stage begins to those in which it ends.
  std::vector<Events> run_stage(std::vector<Events> begin) {
    result_.states_by_stage.push_back(0);
    ends_.clear();
    const std::int64_t limit = rules_.stage_limit(stage_);
    // States of one size form a layer; a stage may begin with states of several sizes,
    // which join the search when their layer is reached.
    std::map<std::size_t, std::vector<Events>> by_depth;
    for (Events& state : begin) by_depth[state.size()].push_back(std::move(state));
    if (limit == 0) {
      run_layers(std::move(by_depth), std::nullopt);
    } else {
      // Equal states are not the same when different numbers of their bricks are
      // of this stage, so each size at which it begins is searched alone.
      for (auto& [depth, states] : by_depth) {
        run_layers({{depth, std::move(states)}}, depth + static_cast<std::size_t>(limit));
      }
    }
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    return std::move(ends_);
  }

  void run_layers(std::map<std::size_t, std::vector<Events>> waiting,
                  std::optional<std::size_t> last_depth) {
    Layer layer(waiting.begin()->first);
    while (!given_up_ && (layer.size() > 0 || !waiting.empty())) {
      // Gaps between sizes are skipped.
      if (layer.size() == 0) layer = Layer(waiting.begin()->first);
      if (const auto it = waiting.find(layer.depth()); it != waiting.end()) {
        for (const Events& state : it->second) add_first(layer, state);
        waiting.erase(it);
      }
      Layer next(layer.depth() + 1);
      for (std::size_t state = 0; state < layer.size() && !given_up_; ++state) {
        const bool over = last_depth && layer.depth() >= *last_depth;
        if (over || layer.open_begin(state) == layer.open_end(state)) {
          add_end({layer.events(state), layer.events(state) + layer.depth()});
        } else {
          expand(layer, state, next);
        }
      }
      layer = std::move(next);
    }
  }

  /// A state in which the stage begins: its events are found from scratch.
  void add_first(Layer& layer, const Events& state) {
    assert(state.size() == layer.depth());
    if (given_up_ || !layer.insert(state)) return;
    for (const Cell cell : enabled_sites(structure_of(state), rules_, box_, stage_)) {
      // Fetched first: numbering a cell may move the states.
      candidates_.push_back(sites_.number(cell));
    }
    apply(state.data(), state.size());
    for (const std::uint32_t site : candidates_) add_open(layer, site);
    candidates_.clear();
    undo(state.data(), state.size());
    account(layer, 0);
  }

  void expand(const Layer& layer, std::size_t state, Layer& next) {
    const Event* events = layer.events(state);
    apply(events, layer.depth());
    // A stop in the middle of a state is harmless: an incomplete search makes no claims.
    for (const Event* open = layer.open_begin(state); open != layer.open_end(state); ++open) {
      if (given_up_) break;
      child_.assign(events, events + layer.depth());
      child_.insert(std::lower_bound(child_.begin(), child_.end(), *open), *open);
      if (!next.insert(child_)) continue;
      open_after(layer, state, *open, next);
      account(next, layer.words());
    }
    undo(events, layer.depth());
  }

  /// The events open after `event`: those of the parent, except around the site, where all
  /// is looked at afresh. `next` grows while pointers into `layer` are held: only `next` is
  /// written here.
  void open_after(const Layer& layer, std::size_t state, Event event, Layer& next) {
    const std::uint32_t site = site_of(event);
    assert(site >= Sites::kFirst);
    const auto& around = sites_.around(site);
    const auto touched = [&](std::uint32_t other) {
      return other == site || std::find(around.begin(), around.end(), other) != around.end();
    };
    for (const Event* open = layer.open_begin(state); open != layer.open_end(state); ++open) {
      if (!touched(site_of(*open))) next.add_open(*open);
    }
    sites_.set(site, colour_of(event));
    candidates_.assign(around.begin(), around.end());
    // In a narrow periodic box one cell is a neighbour several times over.
    std::sort(candidates_.begin(), candidates_.end());
    candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
    for (const std::uint32_t other : candidates_) add_open(next, other);
    candidates_.clear();
    sites_.set(site, kEmpty);
  }

  /// Appends the events of one site to the last state of the layer.
  void add_open(Layer& layer, std::uint32_t site) {
    if (site < Sites::kFirst || sites_.state(site) != kEmpty) return;
    const View view = sites_.view(site);
    rules_.matches(view, sites_.cell(site).z, stage_, matches_);
    // Under `conflicts: random` every match may act; otherwise the first in the file does.
    if (rules_.conflicts() != Conflicts::random && matches_.size() > 1) matches_.resize(1);
    std::uint64_t added = 0;
    for (const Match& match : matches_) {
      const Colour colour = rules_.place(match.rule);
      if ((added >> colour) & 1U) continue;
      added |= std::uint64_t{1} << colour;
      layer.add_open(site << kColourBits | colour);
    }
  }

  void account(const Layer& layer, std::uint64_t held_elsewhere) {
    ++result_.states;
    ++result_.states_by_stage.back();
    const std::size_t last = layer.size() - 1;
    // Words written stand for time, and words held for memory. Nothing is measured, so the
    // search ends alike on every machine.
    words_written_ += layer.depth() +
                      static_cast<std::uint64_t>(layer.open_end(last) - layer.open_begin(last)) + 1;
    const std::uint64_t held = layer.words() + held_elsewhere + end_words_;
    constexpr std::uint64_t kBetweenProgress = 1024;
    if (hooks_.progress && result_.states % kBetweenProgress == 0) {
      hooks_.progress(result_.states);
    }
    if (result_.states >= limits_.states || words_written_ >= limits_.words_written ||
        held >= limits_.words_held || sites_.full() || (hooks_.stop && *hooks_.stop)) {
      given_up_ = true;
    }
  }

  void add_end(Events state) {
    end_words_ += state.size() + 8;
    ends_.push_back(std::move(state));
    // In stages before the last, ends are states to go on from and none may be dropped.
    if (last_stage_ && ends_.size() > limits_.ends) given_up_ = true;
  }

  void keep_ends(const std::vector<Events>& states) {
    for (const Events& state : states) {
      if (result_.ends.size() >= limits_.ends) break;
      result_.ends.push_back(structure_of(state));
    }
    std::sort(result_.ends.begin(), result_.ends.end(), [](const Structure& a, const Structure& b) {
      return a.size() != b.size() ? a.size() < b.size() : a.bricks() < b.bricks();
    });
  }

  Structure structure_of(const Events& state) const {
    Structure structure(rules_.lattice(), start_);
    for (const Event event : state) structure.place(sites_.cell(site_of(event)), colour_of(event));
    return structure;
  }
  void apply(const Event* events, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) sites_.set(site_of(events[i]), colour_of(events[i]));
  }
  void undo(const Event* events, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) sites_.set(site_of(events[i]), kEmpty);
  }

  const RuleTable& rules_;
  const std::vector<PlacedBrick>& start_;
  const std::optional<Box>& box_;
  const EventOrdersLimits& limits_;
  const EventOrdersHooks& hooks_;
  Sites sites_;
  EventOrders result_;
  std::vector<Events> ends_;  ///< of the stage being searched
  int stage_ = 1;
  bool last_stage_ = false;
  bool given_up_ = false;
  std::uint64_t words_written_ = 0;
  std::uint64_t end_words_ = 0;
  Events child_;
  std::vector<std::uint32_t> candidates_;
  std::vector<Match> matches_;
};

}  // namespace

EventOrders explore_event_orders(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                                 const std::optional<Box>& box, const EventOrdersLimits& limits,
                                 const EventOrdersHooks& hooks) {
  return Search(rules, start, box, limits, hooks).run();
}

}  // namespace stig::lattice
