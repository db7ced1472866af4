// SPDX-License-Identifier: MIT
// Structures are kept as sets of bricks, and bricks as numbers, in the order in which they were
// first placed: a structure of 15 takes 30 bytes.
#include "verify/losses.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

#include "certify/loss_check.h"
#include "lattice/world.h"

namespace stig::verify {
namespace {

using Key = std::u16string;  ///< rising numbers of the bricks besides the start's

constexpr std::uint64_t kStepsOfStructure = 20'000;
constexpr std::uint64_t kStepsOfBrick = 2000;    ///< of each of its bricks
constexpr std::uint64_t kStepsOfLoss = 200;      ///< likewise, for each that it may lose
constexpr std::size_t kMostBricks = 0xFFFF;      ///< different ones
constexpr std::uint64_t kMostInAll = 5'000'000;  ///< bricks of all structures
constexpr std::uint64_t kTell = 256;             ///< structures, between two words of progress

/// Structures in the order in which they were found.
class Structures {
 public:
  /// Its number, and whether it is new.
  std::pair<std::uint32_t, bool> add(const Key& key) {
    const auto [at, fresh] = numbers_.try_emplace(key, static_cast<std::uint32_t>(keys_.size()));
    if (fresh) keys_.push_back(key);
    return {at->second, fresh};
  }
  bool contains(const Key& key) const { return numbers_.contains(key); }
  std::optional<std::uint32_t> find(const Key& key) const {
    const auto at = numbers_.find(key);
    return at == numbers_.end() ? std::nullopt : std::optional(at->second);
  }
  const Key& operator[](std::size_t number) const { return keys_[number]; }
  std::size_t size() const { return keys_.size(); }

 private:
  std::unordered_map<Key, std::uint32_t> numbers_;
  std::vector<Key> keys_;
};

class Losses {
 public:
  Losses(const RuleSet& rules, const LossOptions& options)
      : rules_(rules),
        options_(options),
        table_(rules),
        budget_{time_after(options.seconds), options.states, options.stop, options.work, &done_} {}

  LossResult run(const Structure& end) {
    LossResult result;
    result.open = problem();
    if (result.open.empty() && reach() && lose() && follow()) {
      judge(end, result);
      check(end, result);
    } else {
      break_off(result);
    }
    return result;
  }

 private:
  /// What keeps all structures from being looked at, whatever the budget.
  std::string problem() const {
    if (rules_.stage_count() > 1) return "losses are followed in rule sets of one stage";
    if (table_.stage_limit(1) != 0)
      return "losses are followed where no number of bricks ends a stage";
    return {};
  }

  /// Says nothing, and why.
  void break_off(LossResult& result) const {
    const std::uint64_t structures = reached_.size() + after_.size();
    result.verdict = LossVerdict::unknown;
    result.interrupted = options_.stop != nullptr && options_.stop->load();
    if (!result.open.empty()) return;
    if (result.interrupted) {
      result.open = fmt::format("interrupted after {} structures", structures);
    } else if (is_too_many()) {
      result.open = fmt::format("there are more than {} structures", structures - 1);
    } else {
      result.open =
          fmt::format("the effort, or the budget, was spent after {} structures", structures);
    }
  }

  bool is_too_many() const {
    return reached_.size() + after_.size() > options_.states || cells_ > kMostInAll || full_;
  }

  bool goes_on() {
    const std::uint64_t structures = reached_.size() + after_.size();
    if (options_.progress && structures % kTell == 0) options_.progress(structures);
    return !is_too_many() && !budget_.spent();
  }

  std::uint64_t size_of(const Key& key) const { return rules_.start.size() + key.size(); }

  std::uint32_t add_to(Structures& structures, const Key& key) {
    const auto [number, fresh] = structures.add(key);
    if (fresh) cells_ += size_of(key);
    return number;
  }

  std::vector<PlacedBrick> bricks_of(const Key& key) const {
    std::vector<PlacedBrick> bricks = rules_.start;
    for (const char16_t brick : key) bricks.push_back(bricks_[brick]);
    std::sort(bricks.begin(), bricks.end());
    return bricks;
  }

  char16_t number_of(const PlacedBrick& brick) {
    // One more has no number, and nothing is said.
    full_ = full_ || bricks_.size() >= kMostBricks;
    if (full_) return 0;
    const auto [at, fresh] = numbers_.try_emplace(brick, static_cast<char16_t>(bricks_.size()));
    if (fresh) bricks_.push_back(brick);
    return at->second;
  }

  /// Calls visit(key) for every structure that one event leads to.
  template <class Visit>
  void for_each_next(const Key& key, const Visit& visit) {
    const LatticeWorld world(table_, bricks_of(key), options_.box);
    budget_.spend(kStepsOfStructure + kStepsOfBrick * size_of(key));
    for (const Cell site : world.enabled_sites()) {
      table_.matches(world.view(site), site.z, 1, matches_);
      if (table_.conflicts() == Conflicts::first)
        matches_.resize(std::min<std::size_t>(matches_.size(), 1));
      std::uint64_t placed = 0;
      for (const Match& match : matches_) {
        const Colour colour = table_.place(match.rule);
        if ((placed >> colour & 1U) != 0) continue;
        placed |= std::uint64_t{1} << colour;
        visit(with(key, number_of({site, colour})));
      }
    }
  }

  static Key with(const Key& key, char16_t brick) {
    Key out = key;
    out.insert(std::upper_bound(out.begin(), out.end(), brick), brick);
    return out;
  }

  /// Those that no loss leads to.
  bool reach() {
    add_to(reached_, {});
    for (std::size_t i = 0; i < reached_.size(); ++i) {
      if (!goes_on()) return false;
      for_each_next(Key(reached_[i]), [&](const Key& next) { add_to(reached_, next); });
    }
    return goes_on();
  }

  /// The place of a cell's brick among these, by cell, or their number.
  static std::size_t find(const std::vector<PlacedBrick>& bricks, Cell cell) {
    const auto at = std::lower_bound(bricks.begin(), bricks.end(), cell,
                                     [](const PlacedBrick& brick, Cell c) { return brick.at < c; });
    const bool there = at != bricks.end() && at->at == cell;
    return there ? static_cast<std::size_t>(at - bricks.begin()) : bricks.size();
  }

  /// Whether these hang together, face to face.
  bool in_one_piece(const std::vector<PlacedBrick>& bricks) const {
    std::vector<bool> seen(bricks.size(), false);
    std::vector<std::size_t> open;
    const auto take = [&](Cell cell) {
      const std::size_t number = find(bricks, cell);
      if (number == bricks.size()) return;
      if (!seen[number]) open.push_back(number);
      seen[number] = true;
    };
    for (const PlacedBrick& brick : rules_.start) take(brick.at);
    const Neighbourhood& n = table_.neighbours();
    while (!open.empty()) {
      const Cell at = bricks[open.back()].at;
      open.pop_back();
      for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
        if (n.is_face[i]) take(wrap(at + n.offsets[i]));
      }
    }
    return std::all_of(seen.begin(), seen.end(), [](bool one) { return one; });
  }

  Cell wrap(Cell cell) const { return options_.box ? options_.box->wrap(cell) : cell; }

  /// Whether a structure can lose a brick, and be what `without` says then.
  bool can_lose(const std::vector<PlacedBrick>& bricks, const PlacedBrick& lost,
                const Key& without) const {
    const Cell above = wrap(lost.at + Offset{0, 0, 1});
    // In a periodic box of one level a brick is above itself.
    const bool carries = above != lost.at && find(bricks, above) != bricks.size();
    return !carries && in_one_piece(bricks_of(without));
  }

  bool lose() {
    for (std::size_t i = 0; i < reached_.size(); ++i) {
      const std::vector<PlacedBrick> bricks = bricks_of(reached_[i]);
      for (std::size_t k = 0; k < reached_[i].size(); ++k) {
        if (!goes_on()) return false;
        budget_.spend(kStepsOfLoss * size_of(reached_[i]));
        const char16_t lost = reached_[i][k];
        Key without = reached_[i];
        without.erase(k, 1);
        if (!can_lose(bricks, bricks_[lost], without)) continue;
        if (!reached_.contains(without)) add_to(after_, without);
        losses_.push_back({static_cast<std::uint32_t>(i), lost});
      }
    }
    return true;
  }

  /// All that orders of events make of those.
  bool follow() {
    for (std::size_t i = 0; i < after_.size(); ++i) {
      if (!goes_on()) return false;
      first_next_.push_back(next_.size());
      bool ends = true;
      for_each_next(Key(after_[i]), [&](const Key& next) {
        ends = false;
        if (!reached_.contains(next)) next_.push_back(add_to(after_, next));
      });
      ends_.push_back(ends);
    }
    first_next_.push_back(next_.size());
    return goes_on();
  }

  /// Of structures after a loss: whether every order ends well. Events add bricks, so that larger
  /// ones come first.
  std::vector<bool> restored(const Structure& end) const {
    std::vector<std::uint32_t> by_size(after_.size());
    std::iota(by_size.begin(), by_size.end(), 0U);
    std::stable_sort(by_size.begin(), by_size.end(), [&](std::uint32_t a, std::uint32_t b) {
      return after_[a].size() > after_[b].size();
    });
    const std::vector<PlacedBrick> wanted = end.bricks();
    std::vector<bool> good(after_.size());
    for (const std::uint32_t one : by_size) {
      good[one] = ends_[one] ? bricks_of(after_[one]) == wanted
                             : std::all_of(next_of(one).first, next_of(one).second,
                                           [&](std::uint32_t next) { return good[next]; });
    }
    return good;
  }

  std::pair<std::vector<std::uint32_t>::const_iterator, std::vector<std::uint32_t>::const_iterator>
  next_of(std::uint32_t one) const {
    const auto at = [&](std::size_t i) {
      return next_.begin() + static_cast<std::ptrdiff_t>(first_next_[i]);
    };
    return {at(one), at(std::size_t{one} + 1)};
  }

  void judge(const Structure& end, LossResult& result) const {
    const std::vector<bool> good = restored(end);
    std::map<PlacedBrick, LostBrick> bricks;
    std::optional<Loss> least;
    for (const Loss& loss : losses_) {
      LostBrick& brick = bricks[bricks_[loss.brick]];
      const std::optional<std::uint32_t> left = after_.find(without(loss));
      ++brick.losses;
      if (!left || good[*left]) {
        ++brick.restored;
      } else if (!least || reached_[loss.of].size() < reached_[least->of].size()) {
        least = loss;
      }
    }
    for (auto& [brick, lost] : bricks) {
      lost.brick = brick;
      result.bricks.push_back(lost);
    }
    if (least) result.lasting = lasting(*least, good);
    for (std::size_t i = 0; i < reached_.size(); ++i)
      result.reached.push_back(bricks_of(reached_[i]));
    for (std::size_t i = 0; i < after_.size(); ++i) result.after.push_back(bricks_of(after_[i]));
    result.verdict = least ? LossVerdict::lasting : LossVerdict::restored;
  }

  /// Nothing is said that the checker does not find as well.
  void check(const Structure& end, LossResult& result) const {
    std::optional<BoxSpec> box;
    if (options_.box) box = BoxSpec{options_.box->size, options_.box->low, options_.box->periodic};
    const std::vector<PlacedBrick> wanted = end.bricks();
    // What ends elsewhere is shown by an example, and only the rest is claimed.
    if (result.verdict != LossVerdict::restored) return;
    const auto goes_on = [&](std::size_t bricks) {
      budget_.spend(kStepsOfStructure + kStepsOfBrick * bricks);
      return !budget_.spent();
    };
    const std::string refusal =
        loss_refusal(rules_, box, {wanted, result.reached, result.after}, goes_on);
    if (refusal.empty()) return;
    if (budget_.spent()) return break_off(result);
    result.verdict = LossVerdict::unknown;
    result.open = "the checker does not find the same: " + refusal;
  }

  struct Loss {
    std::uint32_t of;  ///< of reached_
    char16_t brick;
  };

  Key without(const Loss& loss) const {
    Key key = reached_[loss.of];
    key.erase(key.find(loss.brick), 1);
    return key;
  }

  LastingLoss lasting(const Loss& loss, const std::vector<bool>& good) const {
    std::uint32_t one = *after_.find(without(loss));
    while (!ends_[one]) {
      one = *std::find_if(next_of(one).first, next_of(one).second,
                          [&](std::uint32_t next) { return !good[next]; });
    }
    return {bricks_of(reached_[loss.of]), bricks_[loss.brick], bricks_of(after_[one])};
  }

  const RuleSet& rules_;
  const LossOptions& options_;
  const RuleTable table_;
  std::uint64_t done_ = 0;
  const Budget budget_;
  std::map<PlacedBrick, char16_t> numbers_;
  std::vector<PlacedBrick> bricks_;
  std::vector<Match> matches_;
  Structures reached_, after_;
  std::uint64_t cells_ = 0;  ///< bricks of all of them
  bool full_ = false;        ///< there are more different bricks than numbers
  std::vector<Loss> losses_;
  std::vector<std::size_t> first_next_;  ///< by structure of after_, into next_
  std::vector<std::uint32_t> next_;      ///< structures of after_ that one event leads to
  std::vector<bool> ends_;               ///< none leads on
};

}  // namespace

std::string_view to_string(LossVerdict verdict) {
  switch (verdict) {
    case LossVerdict::restored:
      return "restored";
    case LossVerdict::lasting:
      return "lasting";
    case LossVerdict::unknown:
      break;
  }
  return "unknown";
}

std::uint64_t LossResult::losses() const {
  return std::accumulate(bricks.begin(), bricks.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const LostBrick& b) { return sum + b.losses; });
}

std::uint64_t LossResult::restored() const {
  return std::accumulate(bricks.begin(), bricks.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const LostBrick& b) { return sum + b.restored; });
}

LossResult find_losses(const RuleSet& rules, const Structure& end, const LossOptions& options) {
  return Losses(rules, options).run(end);
}

}  // namespace stig::verify
