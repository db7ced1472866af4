// SPDX-License-Identifier: MIT
#include "certify/loss_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "certify/acting_rules.h"
#include "certify/space.h"
#include "rules/cell_text.h"

namespace stig::certify {
namespace {

using Bricks = std::vector<PlacedBrick>;
using Colours = std::map<Cell, Colour>;

Colours colours_of(const Bricks& bricks) {
  Colours out;
  for (const PlacedBrick& brick : bricks) out[brick.at] = brick.brick;
  return out;
}

Colour at(const Colours& colours, Cell cell) {
  const auto found = colours.find(cell);
  return found == colours.end() ? Colour{0} : found->second;
}

class LossCheck {
 public:
  LossCheck(const RuleSet& rules, const std::optional<BoxSpec>& box, const LossClaim& claim,
            const std::function<bool(std::size_t)>& goes_on)
      : rules_(rules),
        acting_(rules),
        neighbours_(neighbourhood(rules.lattice)),
        space_{box, rules.floor},
        claim_(claim),
        goes_on_(goes_on),
        reached_(claim.reached.begin(), claim.reached.end()),
        after_(claim.after.begin(), claim.after.end()) {}

  std::string refusal() {
    if (rules_.stage_count() > 1 || !rules_.stages.empty()) return "there are stages";
    Bricks start = rules_.start;
    std::sort(start.begin(), start.end());
    if (!reached_.contains(start)) return "the start is not listed";
    for (const Bricks& bricks : claim_.reached) {
      if (!follow(bricks, false) || !lose(bricks)) return refusal_;
    }
    for (const Bricks& bricks : claim_.after) {
      if (!follow(bricks, true)) return refusal_;
    }
    return {};
  }

 private:
  bool is_listed(const Bricks& bricks, bool after_loss) const {
    return reached_.contains(bricks) || (after_loss && after_.contains(bricks));
  }

  Outlook look(const Colours& colours, Cell site) const {
    Outlook out;
    out.z = site.z;
    for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours_.size); ++i) {
      const Cell cell = site + neighbours_.offsets[i];
      if (space_.is_floor(cell)) {
        out.shows[i] = kFloor;
        continue;
      }
      const Cell there = space_.wrap(cell);
      const Colour colour = space_.placeable(there) ? at(colours, there) : Colour{0};
      out.shows[i] = colour == 0 ? kEmpty : State{colour};
      out.beside_brick = out.beside_brick || colour != 0;
    }
    return out;
  }

  /// Bricks that rules can place at a site.
  std::set<Colour> placed_at(const Colours& colours, Cell site) {
    const Outlook outlook = look(colours, site);
    std::set<Colour> out;
    acting_.candidates(outlook, 1, candidates_);
    for (const RuleCandidate& candidate : candidates_) {
      if (!acting_.act(outlook, {candidate}, 0, 0).acts) continue;
      out.insert(rules_.rules[candidate.rule].place);
      if (rules_.conflicts == Conflicts::first) break;
    }
    return out;
  }

  /// Every event leads to what is listed, and only the end has none.
  bool follow(const Bricks& bricks, bool after_loss) {
    if (goes_on_ && !goes_on_(bricks.size())) return refuse("it was broken off");
    const Colours colours = colours_of(bricks);
    std::set<Cell> sites;
    for (const PlacedBrick& brick : bricks) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours_.size); ++i) {
        const Cell site = space_.wrap(brick.at + neighbours_.offsets[i]);
        if (space_.placeable(site) && at(colours, site) == 0) sites.insert(site);
      }
    }
    bool ends = true;
    for (const Cell site : sites) {
      for (const Colour colour : placed_at(colours, site)) {
        ends = false;
        Bricks next = bricks;
        next.push_back({site, colour});
        std::sort(next.begin(), next.end());
        if (!is_listed(next, after_loss)) {
          return refuse(fmt::format("a brick at {} leads to what is not listed", cell_text(site)));
        }
      }
    }
    return !ends || bricks == claim_.end ||
           refuse("a structure that is not the end has no event left");
  }

  /// Whether all but one brick are joined to the start, face to face.
  bool hangs_together(const Colours& colours, Cell without) const {
    std::set<Cell> joined;
    std::vector<Cell> open;
    const auto join = [&](Cell cell) {
      if (cell != without && at(colours, cell) != 0 && joined.insert(cell).second) {
        open.push_back(cell);
      }
    };
    for (const PlacedBrick& brick : rules_.start) join(brick.at);
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours_.size); ++i) {
        if (neighbours_.is_face[i]) join(space_.wrap(cell + neighbours_.offsets[i]));
      }
    }
    return joined.size() + 1 == colours.size();
  }

  /// What is left of a structure after each loss is listed.
  bool lose(const Bricks& bricks) {
    const Colours colours = colours_of(bricks), start = colours_of(rules_.start);
    for (std::size_t i = 0; i < bricks.size(); ++i) {
      const Cell lost = bricks[i].at;
      // In a periodic box of one level a brick is above itself.
      const Cell above = space_.wrap(lost + Offset{0, 0, 1});
      const bool carries = above != lost && at(colours, above) != 0;
      if (at(start, lost) != 0 || carries || !hangs_together(colours, lost)) continue;
      Bricks left = bricks;
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      if (!is_listed(left, true)) {
        return refuse(fmt::format("the loss of {} leads to what is not listed", cell_text(lost)));
      }
    }
    return true;
  }

  bool refuse(std::string why) {
    refusal_ = std::move(why);
    return false;
  }

  const RuleSet& rules_;
  const ActingRules acting_;
  const Neighbourhood& neighbours_;
  const Space space_;
  const LossClaim& claim_;
  const std::function<bool(std::size_t)>& goes_on_;
  const std::set<Bricks> reached_, after_;
  std::vector<RuleCandidate> candidates_;
  std::string refusal_;
};

}  // namespace

std::string loss_refusal(const RuleSet& rules, const std::optional<BoxSpec>& box,
                         const LossClaim& claim,
                         const std::function<bool(std::size_t bricks)>& goes_on) {
  return LossCheck(rules, box, claim, goes_on).refusal();
}

}  // namespace stig::certify
