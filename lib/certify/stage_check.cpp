// SPDX-License-Identifier: MIT
// The order, the limit and the windows; sites are in stage_sites.cpp.
#include "certify/stage_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>

#include "base/text.h"
#include "certify/filling.h"
#include "rules/cell_text.h"

namespace stig::certify {

StageCheck::StageCheck(const RuleSet& rules, const ActingRules& acting, const Space& space,
                       const CertifiedStage& stage, int number, KnownCells& cells)
    : rules_(rules),
      acting_(acting),
      space_(space),
      stage_(stage),
      number_(number),
      cells_(cells),
      neighbours_(neighbourhood(rules.lattice)) {}

std::string StageCheck::refusal() {
  // Conditions 1, 4 and 5 of docs/proofs.md; conditions 2, 3 and the rest of 4 need the
  // local states and are in stage_sites.cpp. The order of the calls matters: a later one
  // relies on positions and bits that an earlier one has checked, and untrusted numbers are
  // used as indices only afterwards.
  if (load_order() && within_limit() && load_far() && load_windows() && check_sites()) {
    windows_progress();
  }
  // The next stage finds these bricks as part of its initial structure, which has no
  // positions.
  for (const std::uint32_t cell : cell_of_) cells_[cell].position = kNone;
  return refusal_;
}

bool StageCheck::refuse(std::string why) {
  refusal_ = std::move(why);
  return false;
}

/// While bricks are entered one by one, `position` of a cell is set only for bricks that
/// come earlier; load_before uses this to see whether a neighbour is one.
bool StageCheck::load_order() {
  earlier_.resize(stage_.order.size());
  members_.resize(stage_.order.size());
  for (std::uint32_t position = 0; position < stage_.order.size(); ++position) {
    const CertifiedBrick& brick = stage_.order[position];
    if (brick.colour < 1 || brick.colour > rules_.colours()) {
      return refuse(fmt::format("the brick at {} has a colour that the rules do not know",
                                cell_text(brick.at)));
    }
    if (!space_.placeable(brick.at)) {
      return refuse(fmt::format("no brick can be placed at {}", cell_text(brick.at)));
    }
    const std::uint32_t cell = cells_.find_or_add(brick.at);
    if (cells_[cell].colour != 0) {
      return refuse(fmt::format("there is a brick already at {}", cell_text(brick.at)));
    }
    cells_[cell].colour = brick.colour;
    cells_[cell].position = position;
    cell_of_.push_back(cell);
    if (!load_before(position)) return false;
  }
  return true;
}

/// Each brick of `before` comes earlier in the order, so that `before` has no circles.
bool StageCheck::load_before(std::uint32_t position) {
  const CertifiedBrick& brick = stage_.order[position];
  // The mask's bits are untrusted: one beyond the neighbourhood names no neighbour.
  for (std::uint32_t rest = brick.before; rest != 0; rest &= rest - 1) {
    const int index = std::countr_zero(rest);
    std::uint32_t earlier = kNone;
    if (index < neighbours_.size) {
      const Offset offset = neighbours_.offsets[static_cast<std::size_t>(index)];
      const std::uint32_t cell = cells_.find(space_.wrap(brick.at + offset));
      if (cell != kNone) earlier = cells_[cell].position;
    }
    if (earlier == kNone || earlier >= position) {
      return refuse(fmt::format("neighbour {} of the brick at {} is no brick that comes earlier",
                                index, cell_text(brick.at)));
    }
    earlier_[position].push_back(earlier);
  }
  return true;
}

/// Condition 5. A stage without a number of deposits ends when no rule acts any more.
bool StageCheck::within_limit() {
  const auto found = rules_.stages.find(number_);
  if (found == rules_.stages.end() || found->second <= 0) return true;
  const auto limit = static_cast<std::uint64_t>(found->second);
  if (stage_.order.size() > limit) {
    return refuse(fmt::format("{} placed, and the stage ends with {}",
                              counted(stage_.order.size(), "brick"), limit));
  }
  // Then the stage is over as soon as the group is full, even if rules could go on: the
  // full filling takes no part in conditions 2 to 4. One window with all bricks is
  // demanded, since no other claim knows when the last brick has been placed.
  spent_ = stage_.order.size() == limit && stage_.windows.size() == 1 &&
           stage_.windows.front().group.size() == limit;
  return true;
}

bool StageCheck::load_far() {
  // Facts are added after all chains have been checked: a chain's steps must be `before`
  // steps of the certificate and may not lean on other facts. Each fact is then a step like
  // the others.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> facts;
  for (const std::vector<std::uint32_t>& chain : stage_.far) {
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (chain[i] >= stage_.order.size()) return refuse("a far fact names no brick");
      if (i == 0) continue;
      const std::vector<std::uint32_t>& earlier = earlier_[chain[i - 1]];
      if (std::find(earlier.begin(), earlier.end(), chain[i]) == earlier.end()) {
        return refuse(fmt::format("a far fact has a step that is none, from {} to {}",
                                  cell_text(stage_.order[chain[i - 1]].at),
                                  cell_text(stage_.order[chain[i]].at)));
      }
    }
    if (chain.size() >= 2) facts.emplace_back(chain.front(), chain.back());
  }
  for (const auto& [brick, earlier] : facts) earlier_[brick].push_back(earlier);
  return true;
}

/// Groups first, then contexts: whether a context contains a brick of some group can be
/// seen only when all groups are known (condition 4).
bool StageCheck::load_windows() {
  for (std::uint32_t w = 0; w < stage_.windows.size(); ++w) {
    if (stage_.windows[w].group.empty()) return refuse("a window has no group");
    if (!load_members(w, stage_.windows[w].group, 0, true)) return false;
  }
  for (std::uint32_t w = 0; w < stage_.windows.size(); ++w) {
    const CertifiedWindow& window = stage_.windows[w];
    const auto first_bit = static_cast<std::uint32_t>(window.group.size());
    if (!load_members(w, window.context, first_bit, false)) return false;
    if (!fillings_well_formed(window)) return false;
    leads_on_.emplace_back(window.fillings.size(), false);
  }
  return true;
}

bool StageCheck::load_members(std::uint32_t window, const std::vector<std::uint32_t>& bricks,
                              std::uint32_t first_bit, bool group) {
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const std::uint32_t position = bricks[i];
    if (position >= stage_.order.size()) return refuse("a window names no brick");
    const std::string at = cell_text(stage_.order[position].at);
    // The first entry of `members_` is the group's, if there is one, since groups are
    // loaded first.
    if (in_group(position)) {
      return refuse(
          fmt::format("the brick at {} is in the group of a window and in another "
                      "group or context",
                      at));
    }
    if (bit_in(position, window) != kNone) {
      return refuse(fmt::format("the brick at {} is twice in one window", at));
    }
    // Bricks of a group have no `before`: what precedes them is said by the fillings alone.
    if (group && stage_.order[position].before != 0) {
      return refuse(fmt::format("the brick at {} is in a group and has bricks before it", at));
    }
    members_[position].push_back({window, first_bit + static_cast<std::uint32_t>(i), group});
  }
  return true;
}

/// Strictly rising, from the empty one on, without bits that no brick has.
bool StageCheck::fillings_well_formed(const CertifiedWindow& window) {
  const std::size_t bits = window.group.size() + window.context.size();
  for (std::size_t i = 0; i < window.fillings.size(); ++i) {
    if (!is_filling_of(bits, window.fillings[i])) return refuse("a filling has a wrong length");
    if (i > 0 && !less(window.fillings[i - 1], window.fillings[i])) {
      return refuse("the fillings of a window do not rise");
    }
  }
  // Rising order puts the empty filling first, if it is there. The stage begins with it
  // (Lemma 2).
  if (window.fillings.empty() || count_bricks(window.fillings.front()) != 0) {
    return refuse("a window does not list the empty filling");
  }
  return true;
}

bool StageCheck::in_group(std::uint32_t position) const {
  return position != kNone && !members_[position].empty() && members_[position].front().group;
}

std::uint32_t StageCheck::bit_in(std::uint32_t position, std::uint32_t window) const {
  if (position == kNone) return kNone;
  for (const Member& member : members_[position]) {
    if (member.window == window) return member.bit;
  }
  return kNone;
}

/// With a spent stage the full filling is left out: nothing happens there any more.
std::size_t StageCheck::fillings_to_check(const CertifiedWindow& window) const {
  assert(!window.fillings.empty());
  const bool ends_full = count_bricks(window.fillings.back()) == window.group.size();
  return window.fillings.size() - (spent_ && ends_full ? 1 : 0);
}

/// No filling is a dead end: of the window's bricks that are not in it, let the run's first
/// be one of the group; then some brick of the group can be placed. With check_group_brick,
/// which notes where a group can grow, this is the last part of condition 4. If the first
/// missing brick is one of the context, Lemma 3 speaks of its own site and nothing is asked
/// of the window.
bool StageCheck::windows_progress() {
  for (std::size_t w = 0; w < stage_.windows.size(); ++w) {
    const CertifiedWindow& window = stage_.windows[w];
    // The order of the run, over group and context together; bits follow the order in the
    // certificate instead.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_order;  // position, bit
    for (const auto* bricks : {&window.group, &window.context}) {
      for (const std::uint32_t position : *bricks) {
        by_order.emplace_back(position, static_cast<std::uint32_t>(by_order.size()));
      }
    }
    std::sort(by_order.begin(), by_order.end());
    for (std::size_t f = 0; f < window.fillings.size(); ++f) {
      const auto missing = std::find_if(by_order.begin(), by_order.end(), [&](const auto& brick) {
        return !has(window.fillings[f], brick.second);
      });
      if (missing == by_order.end() || !in_group(missing->first) || leads_on_[w][f]) continue;
      return refuse(fmt::format(
          "a filling of {} is a dead end: no rule places a brick of "
          "the group of the brick at {}",
          counted(static_cast<std::uint64_t>(count_bricks(window.fillings[f])), "brick"),
          cell_text(stage_.order[missing->first].at)));
    }
  }
  return true;
}

}  // namespace stig::certify
