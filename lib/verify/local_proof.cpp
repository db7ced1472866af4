// SPDX-License-Identifier: MIT
// Houdini's fixed point over sites (local_proof.h). Every look at a site does two things:
// it finds which of the site's `before` bricks a rule does not insist on, and whether some
// local state breaks conditions 2 or 3 of docs/proofs.md. As `before` only ever shrinks,
// and a site is looked at again only when it or a neighbour lost something, the number of
// looks is at most bricks x neighbours^2, and in practice a small multiple of the bricks.
//
// There are three ways to look, from cheap to dear: rule by rule in the least state where
// the rule matches, the fillings of a window that shows all that is around the site, and
// state by state.
#include "verify/local_proof.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <deque>

namespace stig::verify {
namespace {

/// A quarter of what the checker lists at most, so what passes here is not refused there
/// for its size.
constexpr std::uint64_t kMostLocalStates = 1U << 14U;  ///< looked at of one site
/// After so many failures there is no hope that the order of neighbours alone proves the
/// stage.
constexpr std::size_t kMostFailures = 2000;

/// What one look at a site gives.
struct Look {
  Mask before = ~Mask{0};  ///< what may stay of the site's `before`
  std::optional<LocalFailure> failure;
  std::uint64_t states = 0;
  std::uint64_t work = 0;  ///< steps that the look took
};

/// Looks at one site after another under an invariant that may change between looks.
class SiteChecker {
 public:
  SiteChecker(const StageModel& model, const std::vector<Mask>& first, const Invariant& invariant)
      : model_(model), first_(first), invariant_(invariant) {}

  Look check(std::uint32_t number) {
    assert(number < model_.sites());
    result_ = {};
    model_.look(number, site_);
    result_.work = kStepsOfLook + kStepsOfState * site_.rules.size();
    const bool is_brick = number < model_.bricks();
    // No rule of this stage can ever act here: fine for a border site, fatal for a brick.
    if (site_.rules.empty()) {
      if (is_brick) fail(LocalFailure::Kind::stuck, 0);
      return result_;
    }
    seen_ = 0;
    for (const LocalRule& rule : site_.rules) seen_ |= rule.sees();
    if (in_group()) return result_;  // its window answers for it
    order_ = local_order(model_, invariant_, site_);
    run_ = is_brick ? first_[number] & site_.bricks : 0;
    find_windows();
    if (const Window* window = covering_window()) {
      check_by_window(*window);
    } else if (windows_.empty() && (only_patterns() || stays_open_by_itself())) {
      check_rules();
      if (is_brick && !result_.failure) check_stays_open();
    } else {
      check_states();
    }
    return result_;
  }

  /// Number of local states that the invariant leaves possible at the site last checked.
  std::uint64_t count_states() {
    if (site_.rules.empty() || in_group()) return 0;
    if (!windows_.empty()) return result_.states;
    std::uint64_t count = 0;
    for_each_local_state(model_, site_, order_, seen_ & ~order_.after, kMostLocalStates, [&](Mask) {
      ++count;
      return true;
    });
    return count;
  }

 private:
  bool in_group() const {
    return site_.number < model_.bricks() &&
           invariant_.group_of[site_.number] != Invariant::kNoWindow;
  }
  void fail(LocalFailure::Kind kind, Mask state) {
    if (!result_.failure) result_.failure = {kind, site_.number, state, seen_};
  }
  bool right(const LocalRule& rule) const { return rule.colour == site_.colour; }

  /// Do need and forbid say it all? Then a rule matches exactly in the states that contain
  /// `need` and avoid `forbid`, and its least state decides. Under `conflicts: first` rules
  /// of different colours hide each other, so what acts depends on the whole state.
  bool only_patterns() const {
    bool counts = false, mixed = false;
    for (const LocalRule& rule : site_.rules) {
      counts = counts || !rule.counts.empty();
      mixed = mixed || rule.colour != site_.rules.front().colour;
    }
    return !counts && !(mixed && model_.first_acts());
  }

  /// Do all rules place the right brick, and does one go on matching from the run's state
  /// on, whatever comes? Then it does not matter what the others count.
  bool stays_open_by_itself() const {
    return std::all_of(site_.rules.begin(), site_.rules.end(),
                       [&](const LocalRule& rule) { return right(rule); }) &&
           std::any_of(site_.rules.begin(), site_.rules.end(),
                       [&](const LocalRule& rule) { return goes_on_matching(rule); });
  }
  bool goes_on_matching(const LocalRule& rule) const {
    // The counterpart of the checker's ActingRules::counts_stay: with nothing forbidden
    // that could still come, and counts that more bricks cannot spoil.
    return right(rule) && (rule.need & ~run_) == 0 && (rule.forbid & ~order_.after) == 0 &&
           std::all_of(rule.counts.begin(), rule.counts.end(),
                       [&](const LocalCount& count) { return count.holds_from(run_); });
  }

  /// The smallest state in which a rule matches is its needs and what is below them. If
  /// even the least closed state that contains what the rule needs is impossible, the rule
  /// never matches. Otherwise each brick outside that least state may be missing when the
  /// rule fires, so it cannot stay in `before`.
  void check_rules() {
    for (const LocalRule& rule : site_.rules) {
      const Mask least = order_.closed(rule.need);
      if ((least & (rule.forbid | order_.after)) != 0) continue;
      if (right(rule)) {
        result_.before &= least;
      } else {
        fail(LocalFailure::Kind::wrong, least);
      }
    }
  }

  /// From the state in which the run placed the brick on, some rule goes on matching.
  void check_stays_open() {
    // Only what right rules ask about can close the site again; enumerating the rest would
    // multiply states without effect.
    Mask matters = 0;
    for (const LocalRule& rule : site_.rules) {
      if (!right(rule)) continue;
      if (goes_on_matching(rule)) return;
      matters |= rule.need | rule.forbid;
    }
    const auto open = [&](Mask state) {
      return std::any_of(site_.rules.begin(), site_.rules.end(),
                         [&](const LocalRule& rule) { return right(rule) && rule.matches(state); });
    };
    // The checker lists these states together with all others; it has to be able to.
    if (count_states() >= kMostLocalStates) return fail(LocalFailure::Kind::too_many, 0);
    visit(matters & ~order_.after & ~run_, [&](Mask more) {
      if (!open(run_ | more)) fail(LocalFailure::Kind::stuck, (run_ | more) & seen_);
      return !result_.failure;
    });
  }

  /// One state after another: for rules that count, and for groups of windows. States are
  /// filtered and not generated from the windows' fillings: the invariant's order and the
  /// fillings both restrict them, and filtering a few thousand masks is cheap.
  void check_states() {
    std::vector<std::vector<Mask>> parts;
    for (const std::uint32_t w : windows_) parts.push_back(projections(w, group_bricks(w) & seen_));
    const auto fits = [&](Mask state) {
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const Mask part = state & group_bricks(windows_[k]) & seen_;
        if (!std::binary_search(parts[k].begin(), parts[k].end(), part)) return false;
      }
      return true;
    };
    visit(seen_ & ~order_.after, [&](Mask state) {
      // Bricks that do not matter to the rules may be there all the same.
      if (fits(state)) examine(state, true);
      return !result_.failure;
    });
  }

  void check_by_window(const Window& window) {
    const auto number = static_cast<std::uint32_t>(&window - invariant_.windows.data());
    std::vector<Mask> states = projections(number, site_.bricks);
    for (const Mask state : states) examine(state, site_.beside);
  }

  /// What a state that may occur allows. Conditions 2 and 3 for one state.
  void examine(Mask state, bool beside) {
    ++result_.states;
    const std::uint64_t placed = colours_placed(model_, site_, state, beside);
    const std::uint64_t wanted = site_.colour == 0 ? 0 : std::uint64_t{1} << site_.colour;
    if ((placed & ~wanted) != 0) return fail(LocalFailure::Kind::wrong, state);
    if (placed != 0) result_.before &= order_.closed(state);
    const Mask run = run_ & seen_;
    if (placed == 0 && wanted != 0 && (state & run) == run) {
      fail(LocalFailure::Kind::stuck, state);
    }
  }

  void visit(Mask among, const std::function<bool(Mask)>& each) {
    const auto counted = [&](Mask state) {
      result_.work += kStepsOfState;
      return each(state);
    };
    const bool all = for_each_local_state(model_, site_, order_, among, kMostLocalStates, counted);
    if (!all) fail(LocalFailure::Kind::too_many, 0);
  }

  // Windows.

  void find_windows() {
    windows_.clear();
    for (Mask left = site_.bricks; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const std::uint32_t window = invariant_.group_of[site_.brick[i]];
      if (window == Invariant::kNoWindow) continue;
      if (std::find(windows_.begin(), windows_.end(), window) == windows_.end()) {
        windows_.push_back(window);
      }
    }
  }
  Mask group_bricks(std::uint32_t window) const {
    Mask mask = 0;
    for (Mask left = site_.bricks; left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      if (invariant_.group_of[site_.brick[static_cast<std::size_t>(i)]] == window) mask |= bit(i);
    }
    return mask;
  }
  static std::optional<std::size_t> position(const Window& window, std::uint32_t brick) {
    for (std::size_t i = 0; i < window.size(); ++i) {
      if (window.brick(i) == brick) return i;
    }
    return std::nullopt;
  }
  /// The window that shows all that is around the site, if there is one. Such a window is
  /// exact about the site: no combination with the order of neighbours is needed.
  const Window* covering_window() const {
    if (windows_.size() != 1) return nullptr;
    const Window& window = invariant_.windows[windows_.front()];
    if (site_.colour != 0 && !position(window, site_.number)) return nullptr;
    for (Mask left = site_.bricks; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      if (!position(window, site_.brick[i])) return nullptr;
    }
    return &window;
  }
  /// What the window's fillings show of some neighbours while the site is empty; sorted.
  std::vector<Mask> projections(std::uint32_t number, Mask of) {
    const Window& window = invariant_.windows[number];
    std::vector<std::pair<std::size_t, Mask>> bits;
    for (Mask left = of; left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      const auto at = position(window, site_.brick[static_cast<std::size_t>(i)]);
      if (at) bits.emplace_back(*at, bit(i));
    }
    const auto self =
        site_.colour != 0 ? position(window, site_.number) : std::optional<std::size_t>{};
    std::vector<Mask> masks;
    result_.work += window.count() * kStepsOfCell;
    for (std::size_t f = 0; f < window.count(); ++f) {
      if (self && window.has(f, *self)) continue;
      // The stage is over in a full filling, whatever the rules would still do (condition
      // 5).
      if (invariant_.over_at > 0 && window.bricks_in(f) >= invariant_.over_at) continue;
      Mask mask = 0;
      for (const auto& [at, b] : bits) mask |= window.has(f, at) ? b : 0;
      masks.push_back(mask);
    }
    std::sort(masks.begin(), masks.end());
    masks.erase(std::unique(masks.begin(), masks.end()), masks.end());
    return masks;
  }

  const StageModel& model_;
  const std::vector<Mask>& first_;
  const Invariant& invariant_;
  StageSite site_;
  LocalOrder order_;
  Mask seen_ = 0;                       ///< neighbours that matter
  Mask run_ = 0;                        ///< those that were there when the run placed the brick
  std::vector<std::uint32_t> windows_;  ///< whose group bricks are around the site
  Look result_;
};

/// Sites that wait for a look, each once. A queue without duplicates, first in, first out.
/// The order of looks does not change the fixed point, which is the greatest one, but the
/// failures' examples depend on it; so it is fixed.
class Waiting {
 public:
  explicit Waiting(std::size_t sites) : waits_(sites, true) {
    for (std::uint32_t i = 0; i < sites; ++i) queue_.push_back(i);
  }
  bool empty() const { return queue_.empty(); }
  void add(std::uint32_t site) {
    assert(site < waits_.size());
    if (waits_[site]) return;
    waits_[site] = true;
    queue_.push_back(site);
  }
  std::uint32_t take() {
    assert(!queue_.empty());
    const std::uint32_t site = queue_.front();
    queue_.pop_front();
    waits_[site] = false;
    return site;
  }

 private:
  std::deque<std::uint32_t> queue_;
  std::vector<bool> waits_;
};

}  // namespace

/// The masks are taken over absolute neighbours of each brick. In a periodic box `number`
/// wraps.
std::vector<Mask> placed_before(const StageModel& model, const std::vector<Deposit>& run) {
  assert(run.size() == model.bricks());
  const Neighbourhood& n = model.table().neighbours();
  std::vector<std::uint32_t> time(model.bricks(), 0);
  for (std::uint32_t t = 0; t < run.size(); ++t) time[model.number(run[t].site)] = t;
  std::vector<Mask> before(model.bricks(), 0);
  for (std::uint32_t brick = 0; brick < model.bricks(); ++brick) {
    for (int i = 0; i < n.size; ++i) {
      const std::uint32_t other =
          model.number(model.at(brick) + n.offsets[static_cast<std::size_t>(i)]);
      if (other < model.bricks() && time[other] < time[brick]) before[brick] |= bit(i);
    }
  }
  return before;
}

LocalProof prove_locally(const StageModel& model, const std::vector<Mask>& first,
                         Invariant& invariant, const Budget& budget) {
  assert(first.size() == model.bricks());
  LocalProof proof;
  SiteChecker checker(model, first, invariant);
  const Neighbourhood& n = model.table().neighbours();
  Waiting waiting(model.sites());
  std::vector<LocalFailure> failures;
  std::vector<std::uint64_t> states(model.sites(), 0);
  for (std::uint64_t looks = 0; !waiting.empty(); ++looks) {
    if (budget.spent_at(looks)) return proof;
    const std::uint32_t number = waiting.take();
    const Look look = checker.check(number);
    budget.spend(look.work);
    // What fails under a strong invariant fails under a weaker one: once is enough. A
    // weaker invariant allows more states, so a failing state stays possible.
    if (look.failure) failures.push_back(*look.failure);
    if (failures.size() >= kMostFailures) break;
    states[number] = checker.count_states();
    budget.spend(states[number] * kStepsOfState);
    if (number >= model.bricks()) continue;
    const Mask kept = invariant.before[number] & look.before;
    if (kept == invariant.before[number]) continue;
    invariant.before[number] = kept;
    waiting.add(number);
    // Only neighbours' local orders use this brick's `before`. Farther chains are rechecked
    // by the caller.
    for (int i = 0; i < n.size; ++i) {
      const std::uint32_t other =
          model.number(model.at(number) + n.offsets[static_cast<std::size_t>(i)]);
      if (other != StageModel::kNone) waiting.add(other);
    }
  }
  // One failure for each site is reported: the first that was met, which the stable sort keeps
  // in front.
  std::stable_sort(failures.begin(), failures.end(),
                   [](const LocalFailure& a, const LocalFailure& b) { return a.site < b.site; });
  for (const LocalFailure& failure : failures) {
    if (proof.failures.empty() || proof.failures.back().site != failure.site) {
      proof.failures.push_back(failure);
    }
  }
  for (const std::uint64_t count : states) proof.local_states += count;
  proof.finished = true;
  return proof;
}

}  // namespace stig::verify
