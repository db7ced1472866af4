// SPDX-License-Identifier: MIT
#include "assembly/any_rules.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "assembly/candidate.h"
#include "assembly/clauses.h"
#include "assembly/faces.h"
#include "compiler/columns.h"

namespace stig::assembly {

namespace {

/// A site with what stands about it: bricks by their places, in one order.
struct RuleLook {
  Cell site;
  std::vector<std::pair<Offset, std::uint32_t>> about;
  auto operator<=>(const RuleLook&) const = default;
};

/// What a rule does where that stands about a site.
struct RuleVariables {
  int fires = 0;
  int met = 0;  ///< events lead to a structure with this
};

/// What robots do who see a column so.
struct ViewVariables {
  int met = 0;  ///< robots come to a structure where they see this
  /// By place: is a brick put there? And which, where it is always the same.
  std::map<WindowCell, std::pair<int, std::uint32_t>> puts;
};

constexpr int kMostConflicts = 50'000;
/// A literal and what it takes to bring it about, solve and check.
constexpr std::uint64_t kStepsOfLiteral = 500;

class AnyRules {
 public:
  AnyRules(const RuleQuestion& question)
      : target_(numbered(question.target)),
        builders_(question.builders),
        colours_(question.colours),
        sight_(target_, question.visibility) {
    for (std::uint32_t brick = 0; brick < target_.bricks(); ++brick) {
      std::vector<int> some;
      for (int c = 0; c < colours_; ++c) {
        some.push_back(clauses_.variable());
        for (int d = 0; d < c; ++d)
          clauses_.add({-some.back(), -some[static_cast<std::size_t>(d)]});
      }
      clauses_.add(some);
      has_.push_back(std::move(some));
    }
  }

  RuleAnswer run(std::uint32_t start, const Allowance& allowance) {
    BrickSet first(target_.bricks());
    first.add(start);
    clauses_.add({built(first)});
    clauses_.add({come_to(first)});
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (open_.size() > kMostAsked || allowance.passed()) return {};
      const BrickSet structure = open_[i];  // a copy: the list grows
      add_rules(structure);
      add_robots(structure);
    }
    compare_looks();
    compare_views();
    allowance.spend(clauses_.literals() * kStepsOfLiteral);
    return {clauses_.fulfilled(kMostConflicts), open_.size(), clauses_.size()};
  }

 private:
  /// Colours stand for "which brick", as in a candidate.
  static TargetBricks numbered(const TargetBricks& target) {
    std::vector<PlacedBrick> out;
    for (std::size_t i = 0; i < target.bricks(); ++i) {
      out.push_back({target.cell(i), static_cast<Colour>(i + 1)});
    }
    return {out, 0};
  }

  /// Do events lead there? Structures are listed as they are first asked for.
  int built(const BrickSet& structure) {
    const auto [at, added] = built_.emplace(structure, 0);
    if (added) {
      at->second = clauses_.variable();
      open_.push_back(structure);
    }
    return at->second;
  }
  int come_to(const BrickSet& structure) {
    int& out = come_to_[structure];
    if (out == 0) out = clauses_.variable();
    return out;
  }
  RuleVariables of(const RuleLook& look) {
    RuleVariables& out = looks_[look];
    if (out.fires == 0) out = {clauses_.variable(), clauses_.variable()};
    return out;
  }

  RuleLook look_at(const BrickSet& structure, Cell site) const {
    RuleLook out{site, {}};
    for_each_about(site, [&](Cell cell) {
      if (target_.filled(structure, cell)) {
        out.about.emplace_back(cell - site, target_.brick_at(cell));
      }
    });
    return out;
  }
  /// The 26 cells about one, as far as they are above the floor.
  template <class Visit>
  void for_each_about(Cell middle, const Visit& visit) const {
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell cell = middle + Offset{dx, dy, dz};
          if (cell != middle && cell.z >= target_.floor_level()) visit(cell);
        }
      }
    }
  }

  void add_rules(const BrickSet& structure) {
    std::set<Cell> sites;
    for (std::size_t i = 0; i < target_.bricks(); ++i) {
      if (!structure.has(i)) continue;
      for_each_about(target_.cell(i), [&](Cell cell) {
        if (!target_.filled(structure, cell)) sites.insert(cell);
      });
    }
    const int here = built(structure);
    for (const Cell site : sites) {
      const RuleVariables rule = of(look_at(structure, site));
      clauses_.add({-here, rule.met});
      const std::uint32_t brick = target_.brick_at(site);
      if (brick == TargetBricks::kNone) {
        clauses_.add({-here, -rule.fires});
      } else if (beside_a_brick(structure, site)) {
        clauses_.add({-here, -rule.fires, built(with(structure, brick))});
      }
    }
  }
  /// Robots put bricks beside bricks or on them, so other events need not be followed.
  bool beside_a_brick(const BrickSet& structure, Cell site) const {
    return std::any_of(kFaces.begin(), kFaces.end(),
                       [&](Offset step) { return target_.filled(structure, site + step); });
  }
  static BrickSet with(BrickSet structure, std::uint32_t brick) {
    structure.add(brick);
    return structure;
  }

  void add_robots(const BrickSet& structure) {
    const int here = come_to(structure);
    std::vector<int> ways_on = {-here};
    clauses_.add({-here, built(structure)});
    for (const ApproachSide side : builders_.sides) {
      for (const auto& [v, u] : columns_before(target_, structure, side)) {
        add_view(structure, side, u, v, ways_on);
      }
    }
    if (!target_.complete(structure)) clauses_.add(ways_on);
  }

  void add_view(const BrickSet& structure, ApproachSide side, int u, int v,
                std::vector<int>& ways_on) {
    const int here = come_to(structure);
    ViewVariables& view = views_[{side, sight_.look(structure, side, u, v).cells}];
    if (view.met == 0) begin(view);
    clauses_.add({-here, view.met});
    const std::map<WindowCell, std::uint32_t> possible = possible_at(structure, side, u, v);
    for (auto& [place, put] : view.puts) {
      const auto found = possible.find(place);
      if (found == possible.end()) {
        clauses_.add({-here, -put.first});
        continue;
      }
      const std::uint32_t brick = found->second;
      put.second = put.second == kAny || put.second == brick ? brick : TargetBricks::kNone;
      clauses_.add({-here, -put.first, of(look_at(structure, target_.cell(brick))).fires});
      clauses_.add({-here, -put.first, come_to(with(structure, brick))});
      ways_on.push_back(put.first);
    }
  }
  void begin(ViewVariables& view) {
    view.met = clauses_.variable();
    view.puts[{0, 0, 0}] = {clauses_.variable(), kAny};
    for (int z = 0; z < target_.levels(); ++z) {
      for (const WindowCell& place : {WindowCell{1, 0, z}, {0, 1, z}, {0, -1, z}}) {
        view.puts[place] = {clauses_.variable(), kAny};
      }
    }
  }
  /// Bricks within reach next to a column, by place; that on top has no height, as in a policy.
  std::map<WindowCell, std::uint32_t> possible_at(const BrickSet& structure, ApproachSide side,
                                                  int u, int v) const {
    std::map<WindowCell, std::uint32_t> out;
    for (const std::uint32_t brick : bricks_about(target_, side, u, v)) {
      if (structure.has(brick)) continue;
      auto place = next_to_column(target_, structure, side, u, v, brick);
      if (!place ||
          reach(target_, structure, target_.cell(brick), side, builders_.robot).obstruction !=
              Obstruction::none) {
        continue;
      }
      if (place->du == 0 && place->dv == 0) place->z = 0;
      out[*place] = brick;
    }
    return out;
  }

  /// Rules have no more to go by than height, places and colours.
  void compare_looks() {
    std::map<std::pair<std::int32_t, std::vector<Offset>>, std::vector<const RuleLook*>> by_form;
    for (const auto& [look, rule] : looks_) {
      std::vector<Offset> form;
      for (const auto& [step, brick] : look.about) form.push_back(step);
      by_form[{look.site.z, form}].push_back(&look);
    }
    for (const auto& [form, some] : by_form) {
      for (const RuleLook* a : some) {
        for (const RuleLook* b : some) {
          if (a != b) compare(*a, *b);
        }
      }
    }
  }
  void compare(const RuleLook& a, const RuleLook& b) {
    std::vector<int> unless;
    for (std::size_t i = 0; i < a.about.size(); ++i) {
      add_differ(a.about[i].second, b.about[i].second, unless);
    }
    const RuleVariables one = looks_.at(a), other = looks_.at(b);
    unless.push_back(-one.fires);
    unless.push_back(other.fires);
    clauses_.add(unless);
    unless.pop_back();
    unless.insert(unless.end(), {-one.met, -other.met});
    add_equal(target_.brick_at(a.site), target_.brick_at(b.site), unless);
  }

  /// Robots go by the side, by which cells they see and by colours.
  void compare_views() {
    using Seen = std::pair<ApproachSide, std::vector<std::uint8_t>>;
    std::map<Seen, std::vector<decltype(views_)::const_pointer>> by_form;
    for (const auto& view : views_) {
      Seen form = view.first;
      for (std::uint8_t& cell : form.second) cell = std::min<std::uint8_t>(cell, kSeenBrick + 1);
      by_form[std::move(form)].push_back(&view);
    }
    for (const auto& [form, some] : by_form) {
      for (const auto* a : some) {
        for (const auto* b : some) {
          if (a != b) compare(a->first.second, a->second, b->first.second, b->second);
        }
      }
    }
  }
  void compare(const std::vector<std::uint8_t>& seen, const ViewVariables& a,
               const std::vector<std::uint8_t>& other_seen, const ViewVariables& b) {
    std::vector<int> unlike;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i] > kSeenBrick) {
        add_differ(seen[i] - kSeenBrick - 1U, other_seen[i] - kSeenBrick - 1U, unlike);
      }
    }
    for (const auto& [place, put] : a.puts) {
      const auto& [other_put, other_brick] = b.puts.at(place);
      std::vector<int> unless = unlike;
      unless.push_back(-put.first);
      unless.push_back(other_put);
      clauses_.add(unless);
      unless.pop_back();
      unless.insert(unless.end(), {-a.met, -b.met});
      if (put.second != kAny && other_brick != kAny) add_equal(put.second, other_brick, unless);
    }
  }

  /// Adds a literal that is true only if they have different colours; none for one brick.
  void add_differ(std::uint32_t a, std::uint32_t b, std::vector<int>& out) {
    if (a == b) return;
    int& differ = differ_[std::minmax(a, b)];
    if (differ == 0) {
      differ = clauses_.variable();
      for (std::size_t c = 0; c < has_[a].size(); ++c) {
        clauses_.add({-differ, -has_[a][c], -has_[b][c]});
      }
    }
    out.push_back(differ);
  }
  /// One colour, unless something of this is true. Nothing is said of what is no brick.
  void add_equal(std::uint32_t a, std::uint32_t b, const std::vector<int>& unless) {
    if (a == b || a == TargetBricks::kNone || b == TargetBricks::kNone) return;
    for (std::size_t c = 0; c < has_[a].size(); ++c) {
      std::vector<int> clause = unless;
      clause.insert(clause.end(), {-has_[a][c], has_[b][c]});
      clauses_.add(clause);
    }
  }

  static constexpr std::uint32_t kAny = TargetBricks::kNone - 1;  ///< no brick has been put yet

  const TargetBricks target_;
  const Builders& builders_;
  int colours_;
  Sight sight_;
  Clauses clauses_;
  std::vector<std::vector<int>> has_;  ///< by brick and colour
  std::map<BrickSet, int> built_, come_to_;
  std::vector<BrickSet> open_;
  std::map<RuleLook, RuleVariables> looks_;
  std::map<std::pair<ApproachSide, std::vector<std::uint8_t>>, ViewVariables> views_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> differ_;
};

}  // namespace

RuleAnswer any_rules(const RuleQuestion& question, std::uint32_t start,
                     const Allowance& allowance) {
  // A brick is a colour for sight.
  if (question.target.bricks() > kMostWalkedBricks) return {};
  return AnyRules(question).run(start, allowance);
}

}  // namespace stig::assembly
