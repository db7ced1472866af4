// SPDX-License-Identifier: MIT
#include "assembly/assemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>

#include "assembly/any_rules.h"
#include "assembly/colours.h"
#include "assembly/likings.h"
#include "assembly/local_cases.h"
#include "assembly/rules.h"
#include "base/hash.h"
#include "compiler/precedence.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"

namespace stig::assembly {

namespace {

constexpr std::size_t kMostStates = 3'000;  ///< of a candidate
/// At bricks, for one order: so many, or so many a brick.
constexpr std::uint64_t kMostLooks = 20'000, kMostLooksOfBrick = 20;
/// Structures that compile may walk where its proof column by column is not enough.
constexpr std::size_t kMostCompiledStates = 20'000;
constexpr std::uint64_t kStepsOfLook = 5'000, kStepsOfSituation = 20'000, kStepsOfJudging = 60'000;
constexpr std::size_t kMostCandidates = 4'000;
/// The first candidates for larger targets grow from a spine, the rows beside it in few colours
/// (texture.h), and no candidate's colours are looked for longer than the steps below say.
constexpr std::size_t kMostPlainBricks = 200;
constexpr std::uint64_t kStepsOfPaint = 2'000'000'000;
/// The same for a spine with rows that are swept, which leave the spine's colours alone to count.
constexpr std::uint64_t kStepsOfSweptPaint = 4 * kStepsOfPaint;
constexpr int kConflictsAtOnce = 1000;
/// Small targets take so many candidates by chance before any that go round.
constexpr std::uint64_t kFirstByChance = 8;
/// After so many candidates from each set of sides it is asked whether there are rules at all.
constexpr std::uint64_t kAskedAfter = 8;
/// Candidates for one robot are taken when so many more did not do for several.
constexpr std::size_t kPatience = 24;
/// Those of fewer sides than robots likewise, or earlier: see Assembler::suffices.
constexpr auto kStepsAfterwards = static_cast<std::uint64_t>(kStepsOfEffort / 20);

using Sides = std::vector<ApproachSide>;

/// Sets of sides that are tried in turn.
std::vector<Sides> choices_of_sides(const AssemblyTask& task) {
  if (!task.sides.empty()) return {task.sides};
  constexpr auto px = ApproachSide::plus_x, mx = ApproachSide::minus_x, py = ApproachSide::plus_y,
                 my = ApproachSide::minus_y;
  // Two opposite sides first, then single ones, all four last: more sides leave robots more room,
  // and make more cases that colours have to tell apart.
  return {{px, mx}, {py, my}, {px}, {py}, {mx}, {my}, {px, py, mx, my}};
}

class Assembler {
 public:
  Assembler(const AssemblyTask& task, double effort, const AssemblyHooks& hooks)
      : task_(task),
        hooks_(hooks),
        effort_(hooks.deadline),
        allowance_{&effort_, static_cast<std::uint64_t>(effort * kStepsOfEffort)},
        bricks_(all_bricks(task.target), 0),
        widest_{task.robot, task.sides},
        visibility_(
            std::make_shared<Visibility>(task.robot, window_levels(task.robot, bricks_.levels()))) {
    if (task.sides.empty()) widest_.sides.assign(kAllSides.begin(), kAllSides.end());
    if (task.start) start_ = bricks_.brick_at(*task.start);
  }

  Assembly run() {
    out_.obstacle = find_obstacle(bricks_, widest_, start_, task_.most_colours);
    out_.too_many = !out_.obstacle && bricks_.bricks() > kMostOrderedBricks;
    if (out_.obstacle || out_.too_many) return result();
    set_likings();
    std::vector<Sides> sides = choices_of_sides(task_);
    if (task_.sides.empty() && counts())
      sides.emplace_back(kCountedSides.begin(), kCountedSides.end());
    // A set of sides from which even a robot that knows all could not build is left out for good.
    std::erase_if(sides, [&](const Sides& some) {
      return !find_remainder(bricks_, {task_.robot, some}, start_).barred.empty();
    });
    std::size_t since_found = 0;
    // Every seed goes round all sets of sides before the next, so that no set uses up the effort
    // alone.
    for (std::uint64_t seed = 0; !sides.empty(); ++seed) {
      if (seed == kAskedAfter && !out_.plan) out_.obstacle = find_no_rules();
      if (out_.obstacle) return result();
      for (std::size_t i = 0; i < sides.size();) {
        if (allowance_.passed() || out_.counts.candidates >= kMostCandidates) return result();
        if (!worth_trying(sides[i])) {
          ++i;
          continue;
        }
        report();
        if (try_one({task_.robot, sides[i]}, seed)) {
          ++i;
        } else if (sides[i].size() == widest_.sides.size()) {
          // From all sides there is no order at all, so there is none from fewer.
          out_.obstacle = AssemblyObstacle{};
          return result();
        } else {
          sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(i));
        }
        // A plan that could be better is kept while others are looked for, but not for long.
        if (out_.plan && (suffices(sides) || ++since_found > kPatience)) return result();
      }
    }
    return result();
  }

 private:
  void set_likings() {
    if (!small()) regular_ = regular_likings();
    const std::vector<Liking> rounds = round_likings(bricks_);
    regular_.insert(regular_.begin(), rounds.begin(), rounds.end());
    if (!large()) return;
    std::stable_partition(regular_.begin(), regular_.end(),
                          [](const Liking& one) { return one.spine != Liking::Spine::none; });
    const std::vector<Liking> first = large_likings(bricks_, task_.most_colours);
    regular_.insert(regular_.begin(), first.begin(), first.end());
  }

  Assembly result() {
    out_.cut_short = effort_.cut_short();
    return std::move(out_);
  }

  static std::vector<PlacedBrick> all_bricks(const Target& target) {
    std::vector<PlacedBrick> out;
    for (const Cell cell : target.cells) out.push_back({cell, 1});
    return out;
  }

  void report() const {
    if (!hooks_.progress) return;
    const double spent = static_cast<double>(effort_.spent()) / static_cast<double>(allowance_.end);
    hooks_.progress(std::min(1.0, spent), fmt::format("candidate {}", out_.counts.candidates + 1));
  }

  /// Robots that share a side get in each other's way, so there should be as many sides as robots.
  std::size_t wanted_sides() const {
    const auto robots = static_cast<std::size_t>(task_.robots.value_or(2));
    return std::min(robots, widest_.sides.size());
  }

  /// What is better of a plan: first how many robots it is for, any number before one a side and
  /// one alone, then its sides.
  using Merit = std::pair<int, std::size_t>;
  static constexpr int kAnyNumber = 2, kOneASide = 1, kOneAlone = 0;
  Merit merit(const AssemblyPlan& plan) const {
    const std::size_t sides = std::min(plan.compiled.sides.size(), wanted_sides());
    const int crowd = plan.any_number ? kAnyNumber : plan.one_a_side ? kOneASide : kOneAlone;
    return {crowd, crowd == kOneAlone ? 0 : sides};
  }

  /// May a plan from these sides be better than the one there is?
  bool worth_trying(const Sides& sides) const {
    return !out_.plan ||
           Merit(kAnyNumber, std::min(sides.size(), wanted_sides())) > merit(*out_.plan);
  }

  /// Nothing better is to be had, or not for as much work again as the plan took, and a little.
  bool suffices(const std::vector<Sides>& sides) const {
    const bool long_enough =
        out_.plan->any_number && effort_.spent() > 2 * found_after_ + kStepsAfterwards;
    return long_enough || std::none_of(sides.begin(), sides.end(),
                                       [&](const Sides& some) { return worth_trying(some); });
  }

  /// That no rules do, from whatever start and whatever the colours; nothing where there may be
  /// some.
  std::optional<AssemblyObstacle> find_no_rules() {
    AssemblyObstacle out;
    out.kind = AssemblyObstacle::Kind::rules;
    out.colours = task_.most_colours;
    for (std::uint32_t i = 0; i < bricks_.bricks(); ++i) {
      if (start_ ? i != *start_ : bricks_.cell(i).z != bricks_.floor_level()) continue;
      const RuleQuestion question{bricks_, widest_, visibility_, task_.most_colours};
      const RuleAnswer answer = any_rules(question, i, allowance_);
      if (answer.rules != Answered::no) return std::nullopt;
      ++out.starts;
      out.structures = std::max(out.structures, answer.structures);
    }
    return out;
  }

  bool small() const { return bricks_.bricks() <= kMostWalkedFirst; }
  /// Is there a liking that counts?
  bool counts() const {
    return std::any_of(regular_.begin(), regular_.end(),
                       [](const Liking& one) { return one.counting_rows > 0; });
  }
  bool large() const { return bricks_.bricks() > kMostPlainBricks; }

  /// False when there is no order at all from these sides.
  bool try_one(const Builders& builders, std::uint64_t seed) {
    const bool only_some = large() || liking(seed).round;
    if (only_some && !suits(bricks_, liking(seed), builders.sides)) return true;
    ++out_.counts.candidates;
    bool exhausted = false;
    const auto sequence = sequence_of(builders, seed, exhausted);
    if (!sequence) {
      ++out_.counts.no_order;
      return !exhausted;
    }
    // Walking needs a colour for each brick and all structures on the way, which large targets
    // exceed; there neighbours wait for each other throughout, so that less can occur.
    // What goes round is closed by what neighbours know of each other.
    const bool all_wait = bricks_.bricks() > kMostWalkedBricks || liking(seed).round;
    const Waiting waiting = all_wait || combine(seed, 6) % 2 == 0 ? Waiting::all : Waiting::needed;
    CandidateOrder candidate = make_candidate(bricks_, *sequence, builders, waiting);
    if (!is_new(candidate, builders.sides)) return true;
    ++out_.counts.looked_at;
    if (const auto cases = cases_on_the_way(candidate, builders)) {
      paint_and_judge(candidate, *cases, liking(seed), builders);
    }
    return true;
  }

  /// As compile will look at the rules: in large structures column by column first.
  std::optional<Cases> cases_on_the_way(CandidateOrder& candidate, const Builders& builders) {
    const std::size_t bricks = candidate.target->bricks();
    if (bricks > kMostWalkedFirst) {
      // Column by column is proved without a walk, but proves less: where it fails, a target that
      // is small enough is walked still.
      std::size_t looked = 0;
      auto cases = local_cases(candidate, builders, visibility_, looked);
      allowance_.spend((looked + bricks) * kStepsOfSituation);
      if (cases) return cases;
    }
    if (bricks > kMostWalkedBricks) {
      ++out_.counts.dead_end;
      return std::nullopt;
    }
    walk(builders, visibility_, {kMostStates, hooks_.deadline.stop}, candidate);
    allowance_.spend(candidate.policy.situations.size() * kStepsOfSituation);
    if (candidate.walked) return cases_of(candidate);
    ++(candidate.policy.too_large ? out_.counts.too_large : out_.counts.dead_end);
    return std::nullopt;
  }

  /// Was none like it walked before?
  bool is_new(const CandidateOrder& candidate, const Sides& sides) {
    // Two orders are the same candidate if every brick waits for the same neighbours: rules say no
    // more than that. The key goes by the target's numbers, so the order itself does not show.
    std::vector<std::uint64_t> key(candidate.target->bricks() + 1);
    for (const ApproachSide side : sides)
      key.back() = combine(key.back(), static_cast<std::uint64_t>(side) + 1);
    for (std::size_t i = 0; i < candidate.target->bricks(); ++i) {
      BrickSet before(bricks_.bricks());
      for (std::size_t k = 0; k < i; ++k) {
        if (candidate.before[i].has(k)) before.add(candidate.sequence.bricks[k]);
      }
      key[candidate.sequence.bricks[i]] = before.hash();
    }
    return known_.insert(std::move(key)).second;
  }

  Liking liking(std::uint64_t seed) const {
    const std::uint64_t by_chance = small() ? kFirstByChance : 0;
    if (seed < by_chance) return liking_of(seed);
    const std::uint64_t place = seed - by_chance;
    return place < regular_.size() ? regular_[place] : liking_of(seed - regular_.size());
  }

  std::optional<Sequence> sequence_of(const Builders& builders, std::uint64_t seed,
                                      bool& exhausted) {
    const std::uint64_t all = std::max(kMostLooks, kMostLooksOfBrick * bricks_.bricks());
    std::uint64_t most = all;
    auto out = find_sequence(bricks_, builders, start_, liking(seed), most);
    allowance_.spend((all - most) * kStepsOfLook);
    exhausted = !out && most > 0;
    return out;
  }

  PaintLimits paint_limits(const Liking& liking) const {
    if (!large()) return {allowance_};
    const std::uint64_t most = liking.swept ? kStepsOfSweptPaint : kStepsOfPaint;
    return {allowance_.within(most), kConflictsAtOnce, true};
  }

  void paint_and_judge(const CandidateOrder& candidate, const Cases& cases, const Liking& liking,
                       const Builders& builders) {
    RuleView view;
    look_at_rules(task_.target, candidate, view);
    if (!view.schedule) {
      ++out_.counts.no_colours;
      return;
    }
    const Texture texture =
        large() ? texture_of(*candidate.target, liking) : no_texture(bricks_.bricks());
    const PaintResult painted =
        paint(task_.target, cases, view, task_.most_colours, texture, paint_limits(liking));
    if (painted.answer != Answered::yes) {
      ++out_.counts.no_colours;
      return;
    }
    judge(candidate, view, painted.colours, builders);
  }

  /// Keeps the plan where it is better than the one there is.
  void judge(const CandidateOrder& candidate, const RuleView& view,
             const std::vector<Colour>& colours, const Builders& builders) {
    RuleSet rules = rules_of(task_.target, candidate, view, colours, builders.sides, task_.robots,
                             task_.wording);
    auto plan = compiled(rules);
    if (plan && out_.plan && merit(*plan) <= merit(*out_.plan)) return;
    if (plan && !plan->any_number && !task_.robots) {
      // Or compile would warn that nobody said how many.
      rules.physical->robots = plan->one_a_side ? static_cast<int>(builders.sides.size()) : 1;
      plan = compiled(rules);
    }
    if (!plan) {
      ++out_.counts.refused;
      return;
    }
    if (!out_.plan) found_after_ = effort_.spent();
    // The bricks of a candidate are numbered by the order of work, the start first.
    std::vector<Cell> order;
    for (std::size_t i = 0; i < candidate.target->bricks(); ++i) {
      order.push_back(candidate.target->cell(i));
    }
    plan->start = order.front();
    plan->work = work_of(plan->compiled, order);
    out_.plan = std::move(plan);
  }

  /// As a file has the rules; nothing when they are refused.
  std::optional<AssemblyPlan> compiled(const RuleSet& printed) {
    AssemblyPlan plan;
    // What is judged is the text itself, read back as a user's file would be: no difference between
    // the set in memory and the one that is written can go unnoticed.
    plan.text = print_rule_set(printed);
    Diagnostics diagnostics;
    auto rules = read_rule_set(std::make_shared<const SourceFile>("plan", plan.text), diagnostics);
    // The reader asks for more than that no two rules disagree on the way: for that there is no
    // neighbourhood at all, be it one that never occurs, in which they do.
    if (!rules) return std::nullopt;
    plan.rules = std::make_unique<RuleSet>(std::move(*rules));
    CompileOptions options;
    options.verify.stop = options.limits.stop = hooks_.deadline.stop;
    if (bricks_.bricks() > kMostWalkedFirst) {
      options.limits.states = bricks_.bricks() > kMostWalkedBricks ? 0 : kMostCompiledStates;
    }
    plan.compiled = compile_rules(*plan.rules, task_.robot, options, diagnostics);
    allowance_.spend((plan.compiled.policy.situations.size() + plan.compiled.local_situations) *
                     kStepsOfJudging);
    if (!plan.compiled.decision || diagnostics.has_errors()) return std::nullopt;
    plan.any_number = plan.compiled.concurrency.conflicts.empty();
    plan.one_a_side = plan.compiled.concurrency.one_a_side;
    return plan;
  }

  const AssemblyTask& task_;
  const AssemblyHooks& hooks_;
  Effort effort_;
  Allowance allowance_;
  TargetBricks bricks_;
  Builders widest_;
  std::optional<std::uint32_t> start_;
  std::vector<Liking> regular_;
  std::shared_ptr<Visibility> visibility_;
  std::set<std::vector<std::uint64_t>> known_;
  std::uint64_t found_after_ = 0;  ///< steps that the first plan took
  Assembly out_;
};

}  // namespace

Assembly assemble(const AssemblyTask& task, double effort, const AssemblyHooks& hooks) {
  assert(!task.target.cells.empty());
  // As rules of all the kinds would have to be read: with fewer in the end more is seen.
  AssemblyTask seen = task;
  seen.robot = seeing(task.most_colours, task.robot);
  return Assembler(seen, effort, hooks).run();
}

}  // namespace stig::assembly
