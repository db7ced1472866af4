// SPDX-License-Identifier: MIT
// Every site of a stage, in every local state.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/text.h"
#include "certify/filling.h"
#include "certify/stage_check.h"
#include "rules/cell_text.h"

namespace stig::certify {
namespace {

/// Beyond this check_least_states takes over; docs/proofs.md names the bound.
constexpr std::size_t kMostLocalStates = std::size_t{1} << 16;

template <class Seen>
NeighbourSet projection(const Filling& filling, const Seen& seen) {
  NeighbourSet there = 0;
  for (const auto& brick : seen) {
    if (has(filling, brick.bit)) there |= brick.at;
  }
  return there;
}

void keep_each_once(std::vector<NeighbourSet>& sets) {
  std::sort(sets.begin(), sets.end());
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
}

}  // namespace

bool StageCheck::check_sites() {
  add_sites_beside_bricks();
  Site site;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    const bool was_there = cells_[cell].colour != 0 && cells_[cell].position == kNone;
    if (was_there) continue;
    look(cell, site);
    ++sites_;
    if (!check_site(site)) return false;
  }
  return true;
}

/// Sites beside bricks of the final structure X are enough: what can be reached is a subset
/// of X, and an event needs a brick beside its site.
void StageCheck::add_sites_beside_bricks() {
  const std::uint32_t known = cells_.size();
  for (std::uint32_t cell = 0; cell < known; ++cell) {
    if (cells_[cell].colour == 0) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours_.size); ++i) {
      const Cell beside = space_.wrap(cells_[cell].at + neighbours_.offsets[i]);
      if (space_.placeable(beside)) cells_.find_or_add(beside);
    }
  }
}

/// The site as it is while it is empty: in a periodic box of side 1 it sees itself so.
void StageCheck::look(std::uint32_t cell, Site& site) const {
  const KnownCell& own = cells_[cell];
  site.at = own.at;
  site.colour = own.colour;
  site.position = own.position;
  site.outlook = Outlook{own.at.z};
  site.locals.clear();
  for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours_.size); ++i) {
    const Cell at = own.at + neighbours_.offsets[i];
    if (space_.is_floor(at)) {
      site.outlook.shows[i] = kFloor;
      continue;
    }
    const std::uint32_t found = cells_.find(space_.wrap(at));
    if (found == kNone || found == cell || cells_[found].colour == 0) continue;
    site.outlook.shows[i] = cells_[found].colour;
    if (cells_[found].position == kNone) {
      site.outlook.beside_brick = true;
    } else {
      site.outlook.open |= NeighbourSet{1} << i;
      site.locals.push_back({cells_[found].position, NeighbourSet{1} << i});
    }
  }
  std::sort(site.locals.begin(), site.locals.end(),
            [](const Local& a, const Local& b) { return a.position < b.position; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < site.locals.size(); ++i) {
    if (kept > 0 && site.locals[kept - 1].position == site.locals[i].position) {
      site.locals[kept - 1].at |= site.locals[i].at;
    } else {
      site.locals[kept++] = site.locals[i];
    }
  }
  site.locals.resize(kept);
  acting_.candidates(site.outlook, number_, site.candidates);
}

/// Conditions 2 and 3, and of 4 what concerns the context.
bool StageCheck::check_site(const Site& site) {
  if (site.colour == 0 && site.candidates.empty()) return true;
  if (in_group(site.position)) return check_group_brick(site);
  if (list_local_states(site) ? !check_local_states(site) : !check_least_states(site)) {
    return false;
  }
  if (site.position == kNone) return true;
  const std::vector<Member>& windows = members_[site.position];
  return std::all_of(windows.begin(), windows.end(),
                     [&](const Member& window) { return check_context_brick(site, window); });
}

/// The bricks around a site when the run places its own.
NeighbourSet StageCheck::seen_in_run(const Site& site) {
  assert(site.position != kNone);
  NeighbourSet there = 0;
  for (const Local& local : site.locals) {
    if (local.position < site.position) there |= local.at;
  }
  return there;
}

bool StageCheck::check_run(const Site& site) {
  const Action action = acting_.act(site.outlook, site.candidates, seen_in_run(site), site.colour);
  if (action.other) return refuse_rule(site, action.rule);
  return action.acts || refuse(fmt::format("no rule places the brick at {} when its turn comes",
                                           cell_text(site.at)));
}

bool StageCheck::check_local_states(const Site& site) {
  const bool brick = site.position != kNone;
  if (brick && !check_run(site)) return false;
  const NeighbourSet run = brick ? seen_in_run(site) & matters_ : 0;
  // What no rule asks about may be there and make the site one beside a brick. See
  // acting_rules.h: such a neighbour changes no rule's answer, only whether there is an
  // event; granting it errs on the side of more events, which is the safe one.
  Outlook outlook = site.outlook;
  outlook.beside_brick = outlook.beside_brick || (outlook.open & ~matters_) != 0;
  const NeighbourSet before = brick ? stage_.order[site.position].before : 0;
  local_states_ += states_.size();
  for (const NeighbourSet there : states_) {
    const Action action = acting_.act(outlook, site.candidates, there, site.colour);
    if (action.other) return refuse_rule(site, action.rule);
    if (action.acts && (before & ~closed(site, there)) != 0) {
      return refuse(
          fmt::format("the rule {} can place the brick at {} when a brick that should "
                      "be there before it is not",
                      in_quotes(rules_.rules[action.rule].name), cell_text(site.at)));
    }
    // Condition 3, last part: once the rules can place the brick as in the run, they can in
    // every state with more around it, so it never becomes a dead end (Lemma 3).
    if (brick && !action.acts && (run & ~there) == 0) {
      return refuse(
          fmt::format("the brick at {} can be placed, and can no longer be when more "
                      "bricks stand around it",
                      cell_text(site.at)));
    }
  }
  return true;
}

/// For a site of whose local states there are too many to list. A rule is granted that it
/// matches where its pattern does, whatever it counts. Each rule is looked at in its least
/// local state, see docs/proofs.md, "The conditions". Sound since closed sets form a
/// lattice: if a rule's pattern matches in some closed set, then in the least closed one
/// with what it asks for.
bool StageCheck::check_least_states(const Site& site) {
  const bool brick = site.position != kNone;
  const bool groups = std::any_of(site.locals.begin(), site.locals.end(),
                                  [&](const Local& local) { return in_group(local.position); });
  if (groups) return refuse_too_many(site);
  if (brick && !check_run(site)) return false;
  const NeighbourSet never = order_locals(site);
  const NeighbourSet run = brick ? seen_in_run(site) : 0;
  const NeighbourSet before = brick ? stage_.order[site.position].before : 0;
  bool stays = !brick;
  for (const RuleCandidate& candidate : site.candidates) {
    ++local_states_;
    const NeighbourSet least = closed(site, candidate.there);
    if ((least & (candidate.not_there | never)) != 0) continue;
    if (rules_.rules[candidate.rule].place != site.colour) {
      return rules_.rules[candidate.rule].counts.empty() && rules_.conflicts != Conflicts::first
                 ? refuse_rule(site, candidate.rule)
                 : refuse_too_many(site);
    }
    if ((before & ~least) != 0) {
      return refuse(
          fmt::format("the rule {} can place the brick at {} when a brick that should "
                      "be there before it is not",
                      in_quotes(rules_.rules[candidate.rule].name), cell_text(site.at)));
    }
    // It matches in the run's state, and what can come does not undo that.
    stays = stays || ((candidate.there & ~run) == 0 && (candidate.not_there & ~never) == 0 &&
                      acting_.counts_stay(site.outlook, candidate, run));
  }
  return stays || refuse_too_many(site);
}

/// Condition 3 for a brick of a group. The fillings are all local states there are, so
/// nothing is closed or enumerated.
bool StageCheck::check_group_brick(const Site& site) {
  assert(in_group(site.position));
  const Member own = members_[site.position].front();
  const CertifiedWindow& window = stage_.windows[own.window];
  if (!all_within(site, own.window)) {
    return refuse(
        fmt::format("the brick at {} is in the group of a window that does not have all "
                    "bricks around it",
                    cell_text(site.at)));
  }
  if (!check_run(site)) return false;
  const std::vector<Seen> seen = seen_of(site, own.window, false);
  for (std::size_t f = 0; f < fillings_to_check(window); ++f) {
    const Filling& filling = window.fillings[f];
    if (has(filling, own.bit)) continue;
    ++local_states_;
    const Action action =
        acting_.act(site.outlook, site.candidates, projection(filling, seen), site.colour);
    if (action.other) return refuse_rule(site, action.rule);
    if (!action.acts) continue;
    if (!is_listed(window, with(filling, own.bit))) return refuse_filling(site, filling);
    leads_on_[own.window][f] = true;
  }
  return true;
}

/// Where the brick of a context can be placed, the filling with it is listed.
bool StageCheck::check_context_brick(const Site& site, const Member& own) {
  assert(!own.group);
  const CertifiedWindow& window = stage_.windows[own.window];
  const std::vector<Seen> seen = seen_of(site, own.window, false);
  const bool sees_all = all_within(site, own.window);
  const NeighbourSet before = stage_.order[site.position].before;
  for (std::size_t f = 0; f < fillings_to_check(window); ++f) {
    const Filling& filling = window.fillings[f];
    if (has(filling, own.bit) || is_listed(window, with(filling, own.bit))) continue;
    // before(c) is not fulfilled within this filling, so by Lemma 2 the brick cannot come
    // next.
    const bool waits = std::any_of(seen.begin(), seen.end(), [&](const Seen& brick) {
      return (brick.at & before) != 0 && !has(filling, brick.bit);
    });
    if (waits) continue;
    const NeighbourSet there = projection(filling, seen);
    if (sees_all && !acting_.act(site.outlook, site.candidates, there, site.colour).acts) continue;
    return refuse_filling(site, filling);
  }
  return true;
}

bool StageCheck::list_local_states(const Site& site) {
  const std::uint32_t window = window_around(site);
  const NeighbourSet never = order_locals(site);
  const NeighbourSet asked = acting_.asked_about(site.outlook, site.candidates) & ~never;
  matters_ = 0;
  // A brick that is seen at several places matters if one of them does.
  for (const Local& local : site.locals) {
    if ((local.at & asked) != 0) matters_ |= local.at;
  }
  if (window == kNone) return add_closed_sets(site);
  matters_ = site.outlook.open;
  states_ = projections(site, window, false);
  return true;
}

/// The window that tells all about this site, or kNone: it has a group brick beside it,
/// all bricks around, and the site's own if there is one.
std::uint32_t StageCheck::window_around(const Site& site) const {
  for (const Local& local : site.locals) {
    if (!in_group(local.position)) continue;
    const std::uint32_t window = members_[local.position].front().window;
    const bool own = site.position == kNone || bit_in(site.position, window) != kNone;
    return own && all_within(site, window) ? window : kNone;
  }
  return kNone;
}

bool StageCheck::all_within(const Site& site, std::uint32_t window) const {
  return std::all_of(site.locals.begin(), site.locals.end(),
                     [&](const Local& local) { return bit_in(local.position, window) != kNone; });
}

std::vector<StageCheck::Seen> StageCheck::seen_of(const Site& site, std::uint32_t window,
                                                  bool group_alone) const {
  std::vector<Seen> seen;
  for (const Local& local : site.locals) {
    if (group_alone && !in_group(local.position)) continue;
    const std::uint32_t bit = bit_in(local.position, window);
    if (bit != kNone) seen.push_back({bit, local.at});
  }
  return seen;
}

/// What the site can see of a window (or of its group alone) while it is empty.
std::vector<NeighbourSet> StageCheck::projections(const Site& site, std::uint32_t window,
                                                  bool group_alone) const {
  const CertifiedWindow& w = stage_.windows[window];
  const std::vector<Seen> seen = seen_of(site, window, group_alone);
  const std::uint32_t own = bit_in(site.position, window);
  std::vector<NeighbourSet> sets;
  for (std::size_t f = 0; f < fillings_to_check(w); ++f) {
    if (own != kNone && has(w.fillings[f], own)) continue;
    sets.push_back(projection(w.fillings[f], seen));
  }
  keep_each_once(sets);
  return sets;
}

/// By rising position, so what comes before a brick has had its turn.
NeighbourSet StageCheck::order_locals(const Site& site) {
  NeighbourSet never = 0;
  below_.assign(site.locals.size(), 0);
  for (std::size_t k = 0; k < site.locals.size(); ++k) {
    const Local& local = site.locals[k];
    for (const std::uint32_t earlier : earlier_[local.position]) {
      if (earlier == site.position) never |= local.at;
      below_[k] |= bricks_at(site, earlier);
    }
    below_[k] = closed(site, below_[k]);
    if ((below_[k] & never) != 0) never |= local.at;
  }
  return never;
}

NeighbourSet StageCheck::closed(const Site& site, NeighbourSet there) const {
  NeighbourSet all = there;
  for (std::size_t k = 0; k < site.locals.size(); ++k) {
    if ((site.locals[k].at & there) != 0) all |= below_[k];
  }
  return all;
}

/// False when there are too many. Sets that claims do not rule out: of each group something
/// that a filling shows, and a brick only with those that come before it and not if the
/// site's own does. (iii) first, as a product over the groups in sight, then (i) and (ii)
/// brick by brick in the order of the run, so that what precedes a brick is decided before
/// it.
bool StageCheck::add_closed_sets(const Site& site) {
  states_.assign(1, 0);
  std::vector<std::uint32_t> windows;
  for (const Local& local : site.locals) {
    if (in_group(local.position)) windows.push_back(members_[local.position].front().window);
  }
  keep_each_once(windows);
  for (const std::uint32_t window : windows) {
    std::vector<NeighbourSet> parts = projections(site, window, true);
    for (NeighbourSet& part : parts) part &= matters_;
    keep_each_once(parts);
    if (states_.size() * parts.size() > kMostLocalStates) return false;
    std::vector<NeighbourSet> joined;
    for (const NeighbourSet there : states_) {
      for (const NeighbourSet part : parts) joined.push_back(there | part);
    }
    states_ = std::move(joined);
  }
  for (std::size_t k = 0; k < site.locals.size(); ++k) {
    const Local& local = site.locals[k];
    if (in_group(local.position) || (local.at & matters_) == 0) continue;
    const NeighbourSet before = below_[k] & matters_;
    const std::size_t without = states_.size();
    for (std::size_t i = 0; i < without; ++i) {
      if ((before & ~states_[i]) == 0) states_.push_back(states_[i] | local.at);
    }
    if (states_.size() > kMostLocalStates) return false;
  }
  return true;
}

NeighbourSet StageCheck::bricks_at(const Site& site, std::uint32_t position) {
  const auto found = std::lower_bound(
      site.locals.begin(), site.locals.end(), position,
      [](const Local& local, std::uint32_t wanted) { return local.position < wanted; });
  return found != site.locals.end() && found->position == position ? found->at : 0;
}

bool StageCheck::is_listed(const CertifiedWindow& window, const Filling& filling) {
  return std::binary_search(window.fillings.begin(), window.fillings.end(), filling, less);
}

bool StageCheck::refuse_rule(const Site& site, std::uint32_t rule) {
  const Rule& acting = rules_.rules[rule];
  std::string why = fmt::format("the rule {} can place a brick {} at {}", in_quotes(acting.name),
                                in_quotes(rules_.brick(acting.place).symbol), cell_text(site.at));
  why += site.colour == 0 ? std::string(", where the structure has none")
                          : fmt::format(", where the structure has {}",
                                        in_quotes(rules_.brick(site.colour).symbol));
  return refuse(std::move(why));
}

bool StageCheck::refuse_filling(const Site& site, const Filling& filling) {
  return refuse(fmt::format(
      "the brick at {} can be placed in a filling of {}, and the "
      "window does not list the filling with it",
      cell_text(site.at), counted(static_cast<std::uint64_t>(count_bricks(filling)), "brick")));
}

bool StageCheck::refuse_too_many(const Site& site) {
  return refuse(fmt::format("the site {} has more than {} local states", cell_text(site.at),
                            kMostLocalStates));
}

}  // namespace stig::certify
