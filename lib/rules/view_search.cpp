// SPDX-License-Identifier: MIT
// Decides whether some neighbourhood satisfies a drawing and counts at once. Cells are
// independent of each other but for the counts, so a dynamic programme over cells with the
// tally of all conditions as its state is exact: at most 27^k tallies for k conditions, and
// few in practice, since cells that add the same are alike. Heights are an intersection of
// intervals.
#include "rules/view_search.h"

#include <algorithm>
#include <unordered_map>

namespace stig::rules {

namespace {

/// Counts of all conditions, packed: five bits each hold 0..26, a neighbourhood's most, and
/// twelve conditions fit a word.
using Tally = std::uint64_t;
constexpr int kBits = 5;
constexpr std::size_t kMostConditions = 64 / kBits;

/// One kind of neighbourhood that a world has.
struct World {
  Interval heights;
  bool on_floor;  ///< the slice below is floor
};

/// With a floor there are two kinds of sites, those on it and those above; without, one.
std::vector<World> worlds_of(const RuleSet& rules) {
  if (!rules.floor) return {{Interval(), false}};
  return {{{0, 0}, true}, {{1, INT32_MAX}, false}};
}

/// Conditions on the same thing become one; those that always hold go. Fewer conditions
/// mean fewer tallies.
std::vector<CountCondition> merged(const std::vector<CountCondition>& counts, int size) {
  std::vector<CountCondition> out;
  for (const CountCondition& count : counts) {
    const auto same = std::find_if(out.begin(), out.end(), [&](const CountCondition& other) {
      return other.of == count.of && other.faces_only == count.faces_only;
    });
    if (same == out.end()) {
      out.push_back(count);
    } else {
      same->min = std::max(same->min, count.min);
      same->max = std::min(same->max, count.max);
    }
  }
  const auto idle = [&](const CountCondition& c) { return c.min <= 0 && c.max >= size; };
  out.erase(std::remove_if(out.begin(), out.end(), idle), out.end());
  return out;
}

/// Decides counts cell by cell: which tallies can be reached by choosing a state in
/// each of the first k cells, and from where.
class CountSearch {
 public:
  CountSearch(const Neighbourhood& neighbours, std::vector<StateSet> cells,
              std::vector<CountCondition> counts, Budget& budget)
      : neighbours_(neighbours),
        cells_(std::move(cells)),
        counts_(std::move(counts)),
        budget_(budget) {}

  // More conditions than fit are left undecided, which is reported and never guessed.
  Answer run(View& view) {
    if (counts_.size() > kMostConditions) return Answer::unknown;
    find_reachable();
    layers_.assign(1, {{0, {0, kEmpty}}});
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      if (!extend(cell)) return Answer::unknown;
      if (layers_.back().empty()) return Answer::no;
    }
    trace_back(view);
    return Answer::yes;
  }

 private:
  struct Step {
    Tally before;
    State state;
  };
  using Layer = std::unordered_map<Tally, Step>;

  /// What a state in a cell adds to the tally.
  Tally gain(std::size_t cell, State state) const {
    Tally sum = 0;
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      const bool counted = !counts_[k].faces_only || neighbours_.is_face[cell];
      if (counted && counts_[k].of.contains(state)) sum |= Tally{1} << (k * kBits);
    }
    return sum;
  }

  /// One state for each thing that a cell can add, the lowest. States that add the same to
  /// all counts are interchangeable; the lowest keeps examples plain.
  std::vector<std::pair<Tally, State>> choices(std::size_t cell) const {
    std::vector<std::pair<Tally, State>> out;
    for (std::uint64_t bits = cells_[cell].bits(); bits != 0; bits &= bits - 1) {
      const State state = StateSet(bits).first();
      const Tally adds = gain(cell, state);
      const bool known =
          std::any_of(out.begin(), out.end(), [&](auto& c) { return c.first == adds; });
      if (!known) out.emplace_back(adds, state);
    }
    return out;
  }

  /// For each condition, how many of the cells from `cell` on can still add to it. The most
  /// that can still be added bounds the search from below.
  void find_reachable() {
    room_.assign(cells_.size() + 1, std::vector<int>(counts_.size(), 0));
    for (std::size_t cell = cells_.size(); cell-- > 0;) {
      Tally most = 0;
      for (const auto& [adds, state] : choices(cell)) most |= adds;
      for (std::size_t k = 0; k < counts_.size(); ++k) {
        room_[cell][k] = room_[cell + 1][k] + static_cast<int>((most >> (k * kBits)) & 1U);
      }
    }
  }

  bool within_limits(Tally tally, std::size_t next_cell) const {
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      const int count = static_cast<int>((tally >> (k * kBits)) & 31U);
      if (count > counts_[k].max || count + room_[next_cell][k] < counts_[k].min) return false;
    }
    return true;
  }

  bool extend(std::size_t cell) {
    const auto options = choices(cell);
    Layer next;
    for (const auto& [tally, step] : layers_.back()) {
      for (const auto& [adds, state] : options) {
        budget_ -= 20;
        const Tally sum = tally + adds;
        if (within_limits(sum, cell + 1)) next.emplace(sum, Step{tally, state});
      }
      if (budget_ < 0) return false;
    }
    layers_.push_back(std::move(next));
    return true;
  }

  // Layers go by cell, and each tally keeps the step that first led to it.
  void trace_back(View& view) const {
    // The lowest tally, so that the example does not hang on a hash table's order.
    Tally tally = layers_.back().begin()->first;
    for (const auto& [other, step] : layers_.back()) tally = std::min(tally, other);
    for (std::size_t cell = cells_.size(); cell-- > 0;) {
      const Step& step = layers_[cell + 1].at(tally);
      view.at[cell] = step.state;
      tally = step.before;
    }
  }

  const Neighbourhood& neighbours_;
  std::vector<StateSet> cells_;
  std::vector<CountCondition> counts_;
  Budget& budget_;
  std::vector<std::vector<int>> room_;
  std::vector<Layer> layers_;
};

/// The states each cell may have in this world under the demand's drawing. An empty set for
/// some cell means that drawing and world contradict.
std::vector<StateSet> cells_in(const World& world, const RuleSet& rules, const Demand& demand) {
  const Neighbourhood& neighbours = neighbourhood(rules.lattice);
  std::vector<StateSet> cells;
  for (int i = 0; i < neighbours.size; ++i) {
    const StateSet possible = world.on_floor && i >= neighbours.first_below
                                  ? StateSet::floor()
                                  : StateSet::empty_cell() | StateSet::bricks(rules.colours());
    cells.push_back(demand.pattern.allowed[static_cast<std::size_t>(i)] & possible);
  }
  return cells;
}

}  // namespace

Demand demand_of(const Rule& rule) {
  Demand demand;
  demand.pattern = rule.pattern;
  demand.where = site_condition(rule);
  demand.counts = rule.counts;
  return demand;
}

/// The conjunction of two rules: what is allowed by both, and all counts of both.
Demand both(const Demand& a, const Demand& b) {
  Demand out = a;
  for (std::size_t i = 0; i < out.pattern.allowed.size(); ++i) {
    out.pattern.allowed[i] = a.pattern.allowed[i] & b.pattern.allowed[i];
  }
  out.where = both(a.where, b.where);
  out.counts.insert(out.counts.end(), b.counts.begin(), b.counts.end());
  return out;
}

Pattern turned(const Pattern& pattern, const Orientation& orientation, Lattice lattice) {
  Pattern out;
  for (int i = 0; i < neighbourhood(lattice).size; ++i) {
    const auto from = static_cast<std::size_t>(i);
    out.allowed[static_cast<std::size_t>(orientation.image[from])] = pattern.allowed[from];
  }
  return out;
}

Answer find_view(const RuleSet& rules, const Demand& demand, Example& example, Budget& budget) {
  const Neighbourhood& neighbours = neighbourhood(rules.lattice);
  const std::vector<CountCondition> counts = merged(demand.counts, neighbours.size);
  Answer answer = Answer::no;
  for (const World& world : worlds_of(rules)) {
    budget -= 30;
    const std::optional<std::int64_t> height = allowed_height(demand.where, world.heights);
    if (!height) continue;
    const std::vector<StateSet> cells = cells_in(world, rules, demand);
    if (std::any_of(cells.begin(), cells.end(), [](StateSet s) { return s.none(); })) continue;
    // As near to 0 as the interval allows, so that examples are easy to picture.
    example.z = static_cast<std::int32_t>(*height);
    example.view = View{};
    const Answer found = CountSearch(neighbours, cells, counts, budget).run(example.view);
    if (found == Answer::yes) return found;
    if (found == Answer::unknown) answer = found;
  }
  return answer;
}

bool fulfils(const Demand& demand, Lattice lattice, const View& view, std::int64_t z) {
  const Neighbourhood& neighbours = neighbourhood(lattice);
  if (!allows_height(demand.where, z)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours.size); ++i) {
    if (!demand.pattern.allowed[i].contains(view.at[i])) return false;
  }
  return std::all_of(demand.counts.begin(), demand.counts.end(), [&](const CountCondition& c) {
    int count = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours.size); ++i) {
      const bool counted = !c.faces_only || neighbours.is_face[i];
      if (counted && c.of.contains(view.at[i])) ++count;
    }
    return count >= c.min && count <= c.max;
  });
}

}  // namespace stig::rules
