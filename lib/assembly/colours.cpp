// SPDX-License-Identifier: MIT
#include "assembly/colours.h"

#include <algorithm>
#include <cadical.hpp>
#include <cassert>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "assembly/likeness.h"

namespace stig::assembly {

namespace {

constexpr int kSatisfiable = 10, kUnsatisfiable = 20;
constexpr std::size_t kClausesOfRound = 4000, kClashesOfState = 64;
constexpr std::uint64_t kStepsOfPair = 100, kStepsOfCall = 20'000;
/// The same for a large target: some 100 µs.
constexpr std::uint64_t kStepsOfConflict = 100'000;
constexpr int kMostRounds = 400;

using BrickPair = std::pair<std::uint32_t, std::uint32_t>;

class Painter {
 public:
  /// The problem has two kinds of variables: "brick b has colour c", and "choice c of case i is
  /// done". Auxiliary ones (a way is open, two bricks differ, two are equal) imply what they stand
  /// for and are not implied by it; that is enough, since clauses only ever ask for them to be
  /// true.
  Painter(const Target& target, const Cases& cases, const RuleView& rules, int k,
          const Texture& texture, const PaintLimits& limits)
      : rules_(rules),
        k_(k),
        texture_(target.bricks.empty() ? texture : no_texture(texture.size())),
        limits_(limits),
        allowance_(limits.allowance),
        cases_(cases),
        likenesses_(cases.cases) {
    solver_.set("quiet", 1);
    next_ = static_cast<int>(target.cells.size()) * k_ + 1;
    add_domains(target);
    add_choices();
  }

  PaintResult run() {
    for (int round = 0; round < kMostRounds; ++round) {
      if (allowance_.passed()) return {};
      const int result = solve();
      if (result == kUnsatisfiable) return {Answered::no, {}};
      if (result != kSatisfiable) return {};
      read_solution();
      if (!add_violated()) return {Answered::yes, colours_};
    }
    return {};
  }

 private:
  /// As CaDiCaL says it; 0: given up.
  int solve() {
    const std::uint64_t steps = kStepsOfConflict * static_cast<std::uint64_t>(limits_.conflicts);
    for (;;) {
      solver_.limit("conflicts", limits_.conflicts);
      const int result = solver_.solve();
      allowance_.spend(limits_.counted && result == 0 ? steps : kStepsOfCall);
      if (result != 0 || !limits_.counted || allowance_.passed()) return result;
    }
  }

  /// Variables count from 1, as in DIMACS: colour c of brick b is t · k + c, where t is the first
  /// brick of b's texture.
  int has(std::uint32_t brick, int colour) const {
    return static_cast<int>(texture_[brick]) * k_ + colour;
  }

  void clause(const std::vector<int>& literals) {
    for (const int literal : literals) solver_.add(literal);
    solver_.add(0);
  }

  void add_domains(const Target& target) {
    for (std::size_t orbit = 0; orbit < rules_.brick.size(); ++orbit) {
      const std::uint32_t brick = rules_.brick[orbit];
      if (texture_[brick] != brick) continue;
      std::vector<int> some;
      for (int c = 1; c <= k_; ++c) {
        if (rules_.frame.orbits[orbit].colours.contains(static_cast<State>(c))) {
          some.push_back(has(brick, c));
        } else {
          clause({-has(brick, c)});
        }
        // At most one colour, pair by pair: k is small.
        for (int d = 1; d < c; ++d) clause({-has(brick, c), -has(brick, d)});
      }
      clause(some);
    }
    // Colours that the target does not name are interchangeable.
    if (target.bricks.empty()) clause({has(0, 1)});
  }

  void add_choices() {
    for (const Case& one : cases_.cases) {
      first_choice_.push_back(next_);
      next_ += static_cast<int>(one.choices.size());
    }
    for (const auto& ways : cases_.ways_on) {
      std::vector<int> some;
      for (const WayOn& way : ways) add_way(way, some);
      clause(some);
    }
    // The more is done the better. Phases are hints for the solver's first guess, no conditions.
    for (std::uint32_t i = 0; i < cases_.cases.size(); ++i) {
      for (std::size_t c = 0; c < cases_.cases[i].choices.size(); ++c) solver_.phase(choice(i, c));
    }
  }
  /// Adds literals of which one is true only where the way is open.
  void add_way(const WayOn& way, std::vector<int>& some) {
    if (way.size() == 1) return add_work_in(way.front(), some);
    // With several cases at a column, all of which may be what the robot sees, work has to be done
    // in each.
    const int open = next_++;
    some.push_back(open);
    for (const std::uint32_t i : way) {
      std::vector<int> work = {-open};
      add_work_in(i, work);
      clause(work);
    }
  }
  void add_work_in(std::uint32_t i, std::vector<int>& out) const {
    for (std::size_t c = 0; c < cases_.cases[i].choices.size(); ++c) out.push_back(choice(i, c));
  }
  int choice(std::uint32_t i, std::size_t c) const {
    return first_choice_[i] + static_cast<int>(c);
  }

  BrickPair pair(std::uint32_t a, std::uint32_t b) const {
    return std::minmax(texture_[a], texture_[b]);
  }
  /// Adds a literal that is true only where the two have different colours, if they ever can.
  void add_differ(std::uint32_t a, std::uint32_t b, std::vector<int>& out) {
    const BrickPair both = pair(a, b);
    if (both.first == both.second) return;
    // Made when first asked for: most pairs of bricks are never compared.
    const auto [at, added] = differ_.emplace(both, next_);
    if (added) {
      ++next_;
      for (int c = 1; c <= k_; ++c)
        clause({-at->second, -has(both.first, c), -has(both.second, c)});
    }
    out.push_back(at->second);
  }
  /// True only where they have the same.
  int equal(std::uint32_t a, std::uint32_t b) {
    const BrickPair both = pair(a, b);
    const auto [at, added] = equal_.emplace(both, next_);
    if (added) {
      ++next_;
      for (int c = 1; c <= k_; ++c) clause({-at->second, -has(both.first, c), has(both.second, c)});
    }
    return at->second;
  }

  void read_solution() {
    // In a solution every brick has exactly one colour, so the loop ends by k.
    colours_.assign(rules_.brick.size(), 0);
    for (std::uint32_t i = 0; i < colours_.size(); ++i) {
      int c = 1;
      while (solver_.val(has(i, c)) < 0) ++c;
      colours_[i] = static_cast<Colour>(c);
    }
    done_.assign(cases_.cases.size(), {});
    for (std::uint32_t i = 0; i < cases_.cases.size(); ++i) {
      for (std::size_t c = 0; c < cases_.cases[i].choices.size(); ++c) {
        done_[i].push_back(solver_.val(choice(i, c)) > 0);
      }
    }
  }

  bool add_violated() {
    const std::size_t rules = add_clashes();
    return add_lookalikes() + rules > 0;
  }

  std::size_t add_clashes() {
    Colouring by_orbit(rules_.brick.size());
    for (std::size_t i = 0; i < by_orbit.size(); ++i) by_orbit[i] = colours_[rules_.brick[i]];
    // Clashes and conditions are bounded for a round: a bad first colouring violates far more than
    // the solver should be given, and some of them mend most of the others.
    const std::vector<Clash> some = clashes(by_orbit, {});
    const std::size_t added = add_level_clashes(some);
    if (added > 0 || !bounded(some)) return added;
    // Clashes between levels, which are none here, may have taken all the places there were.
    return add_level_clashes(
        clashes(by_orbit, [this](const Clash& clash) { return within_level(clash); }));
  }
  std::vector<Clash> clashes(const Colouring& by_orbit,
                             const std::function<bool(const Clash&)>& counts) const {
    const Schedule& schedule = *rules_.schedule;
    allowance_.spend(cost_of(schedule));
    return find_clashes(schedule, by_orbit, kClashesOfState, kClausesOfRound, {}, counts);
  }
  /// May there be clashes that these leave out?
  static bool bounded(const std::vector<Clash>& some) {
    if (some.size() >= kClausesOfRound) return true;
    // Clashes of one state follow each other.
    for (std::size_t i = kClashesOfState; i <= some.size(); ++i) {
      const Clash &first = some[i - kClashesOfState], &last = some[i - 1];
      if (first.site == last.site && first.mask == last.mask) return true;
    }
    return false;
  }
  std::size_t site_of_key(const Clash& clash) const {
    const auto key = static_cast<std::size_t>(clash.key);
    return static_cast<std::size_t>(rules_.schedule->keys[key].site);
  }
  /// Sites of different levels are told apart by heights, which rules.cpp adds where they are
  /// needed.
  bool within_level(const Clash& clash) const {
    const std::vector<Site>& sites = rules_.frame.sites;
    return sites[site_of_key(clash)].at.z == sites[static_cast<std::size_t>(clash.site)].at.z;
  }

  std::size_t add_level_clashes(const std::vector<Clash>& some) {
    std::size_t added = 0;
    for (const Clash& clash : some) {
      if (!within_level(clash)) continue;
      const Site& to = rules_.frame.sites[static_cast<std::size_t>(clash.site)];
      std::vector<int> literals;
      for (const auto& [a, b] : compared_orbits(*rules_.schedule, clash)) {
        add_differ(brick_of(a), brick_of(b), literals);
      }
      // Where the other site has a brick of the same colour due, the clash does no harm.
      if (clash.intended) {
        const auto from = static_cast<int>(site_of_key(clash));
        literals.push_back(equal(brick_of(from), brick_of(to.orbit)));
      }
      clause(literals);
      ++added;
    }
    return added;
  }
  std::uint32_t brick_of(int orbit) const { return rules_.brick[static_cast<std::size_t>(orbit)]; }

  std::size_t add_lookalikes() {
    std::size_t added = 0;
    const std::uint64_t looked =
        likenesses_.for_each(colours_, done_, [&](const Likeness& likeness) {
          const std::vector<bool>& done = done_[likeness.a];
          for (std::size_t c = 0; c < done.size(); ++c) {
            if (done[c]) added += add_lookalike(likeness, c);
          }
          return added < kClausesOfRound;
        });
    allowance_.spend(looked * kStepsOfPair);
    return added;
  }

  std::size_t add_lookalike(const Likeness& likeness, std::size_t c) {
    const Case &a = cases_.cases[likeness.a], &b = cases_.cases[likeness.b];
    const Choice& done = a.choices[c];
    std::vector<int> literals = {-choice(likeness.a, c)};
    for (const Choice& there : b.choices) {
      if (there.at != done.at) continue;
      // The same choice is there as well and means the same colour: nothing wrong would be done.
      if (colours_[there.brick] == colours_[done.brick]) return 0;
      literals.push_back(equal(there.brick, done.brick));
    }
    for (const BrickPair& bricks : compared_bricks(a, b)) {
      add_differ(bricks.first, bricks.second, literals);
    }
    if (!likeness.unless_idle) {
      clause(literals);
      return 1;
    }
    // Or nothing at all is done in b: one clause for each of its choices.
    for (std::size_t k = 0; k < b.choices.size(); ++k) {
      std::vector<int> busy = literals;
      busy.push_back(-choice(likeness.b, k));
      clause(busy);
    }
    return 1;
  }

  const RuleView& rules_;
  int k_;
  Texture texture_;
  const PaintLimits& limits_;
  const Allowance& allowance_;
  const Cases& cases_;
  Likenesses likenesses_;
  CaDiCaL::Solver solver_;
  int next_ = 1;  ///< variable
  std::vector<int> first_choice_;
  std::map<BrickPair, int> differ_, equal_;
  std::vector<Colour> colours_;
  std::vector<std::vector<bool>> done_;  ///< by case and choice
};

}  // namespace

PaintResult paint(const Target& target, const Cases& cases, const RuleView& rules, int k,
                  const Texture& texture, const PaintLimits& limits) {
  assert(rules.schedule && k > 0);
  return Painter(target, cases, rules, k, texture, limits).run();
}

}  // namespace stig::assembly
