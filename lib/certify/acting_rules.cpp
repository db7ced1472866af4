// SPDX-License-Identifier: MIT
// The checker's matcher. It is written from the definition of a rule alone and shares
// nothing with lib/rules/rule_table.h, which engines and verifier use: a fault there cannot
// hide itself here. All it takes from lib/rules are the neighbours' offsets and the
// orientations of a symmetry group, which docs/proofs.md lists among what is trusted.
//
// A site has up to 2^26 sets of open neighbours, but only those that some rule asks about
// make a difference, so each oriented rule is reduced to two masks once per site (`asked`),
// and a local state then costs a few bit operations per rule (`act`).
#include "certify/acting_rules.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace stig::certify {
namespace {

/// States are cell contents: empty, up to 62 colours and the floor fit a 64-bit word
/// (rules/state.h), so a set of states is one word and `accept_` has a fixed stride.
constexpr std::size_t kStates = 64;

/// The pattern as the site sees it when the structure is turned by `g`: what was asked of
/// neighbour i is then asked of its image. Orientations permute the neighbourhood, so every
/// entry of the result is written exactly once.
Pattern turned(const Pattern& pattern, const Orientation& g, const Neighbourhood& neighbours) {
  Pattern image;
  for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours.size); ++i) {
    const int to = neighbours.index_of(g.apply(neighbours.offsets[i]));
    assert(to >= 0);
    image.allowed[static_cast<std::size_t>(to)] = pattern.allowed[i];
  }
  return image;
}

/// Heights are absolute: z counts from the floor or from the file's origin, and not from
/// the start. Both bounds are inclusive.
bool height_holds(const Rule& rule, std::int32_t z) {
  return (!rule.height_min || z >= *rule.height_min) && (!rule.height_max || z <= *rule.height_max);
}

/// What the rule asks of the open neighbours, given that it accepts the others.
RuleCandidate asked(std::uint32_t rule, const Pattern& pattern, const Outlook& site) {
  RuleCandidate candidate{rule, 0, 0};
  for (NeighbourSet rest = site.open; rest != 0; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    const NeighbourSet bit = NeighbourSet{1} << i;
    // "Must be there" and "must not" are read off the two states that an open neighbour can
    // show: a rule that rejects the empty cell needs the brick, and one that rejects the
    // brick's colour needs its absence. A rule that rejects both was left out by
    // `accepting` already.
    if (!pattern.allowed[i].contains(kEmpty)) candidate.there |= bit;
    if (!pattern.allowed[i].contains(site.shows[i])) candidate.not_there |= bit;
  }
  return candidate;
}

}  // namespace

ActingRules::ActingRules(const RuleSet& rules)
    : rules_(rules), neighbours_(neighbourhood(rules.lattice)) {
  // Distinct orientations may give equal patterns, if the pattern has a symmetry of its
  // own. Such duplicates cost time and change no answer, so they are kept.
  for (std::uint32_t r = 0; r < rules.rules.size(); ++r) {
    const Rule& rule = rules.rules[r];
    for (const Orientation& g :
         orientations(rules.lattice, rules.symmetry_of(rule), rules.inversion_of(rule))) {
      oriented_.push_back({r, turned(rule.pattern, g, neighbours_)});
    }
  }
  assert(std::is_sorted(oriented_.begin(), oriented_.end(),
                        [](const Oriented& a, const Oriented& b) { return a.rule < b.rule; }));
  words_ = (oriented_.size() + 63) / 64;
  const auto size = static_cast<std::size_t>(neighbours_.size);
  // The transposed table: for each neighbour and state, the oriented rules that accept it,
  // 64 to a word. A site's candidates are then the AND of one row per neighbour, which is
  // what makes rule sets with tens of thousands of oriented rules checkable.
  accept_.assign(size * kStates * words_, 0);
  for (std::size_t k = 0; k < oriented_.size(); ++k) {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::uint64_t rest = oriented_[k].pattern.allowed[i].bits(); rest != 0;
           rest &= rest - 1) {
        const auto state = static_cast<std::size_t>(std::countr_zero(rest));
        accept_[(i * kStates + state) * words_ + k / 64] |= std::uint64_t{1} << k % 64;
      }
    }
  }
}

/// Those of 64 oriented rules that accept, at each neighbour, something it can show.
/// Necessary for a match in some local state, and not sufficient: the claims on what
/// precedes what, and the rule's counts, may exclude that state. `act` decides for each.
std::uint64_t ActingRules::accepting(std::size_t word, const Outlook& site) const {
  std::uint64_t alive = ~std::uint64_t{0};
  for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours_.size) && alive != 0; ++i) {
    assert(site.shows[i] < kStates);
    std::uint64_t accept = accept_[(i * kStates + site.shows[i]) * words_ + word];
    if (site.open >> i & 1U) accept |= accept_[(i * kStates + kEmpty) * words_ + word];
    alive &= accept;
  }
  return alive;
}

void ActingRules::candidates(const Outlook& site, int stage,
                             std::vector<RuleCandidate>& out) const {
  out.clear();
  // Oriented rules were listed by rising rule, and words and bits are scanned upwards, so
  // the order that `conflicts: first` needs comes for free.
  for (std::size_t word = 0; word < words_; ++word) {
    for (std::uint64_t rest = accepting(word, site); rest != 0; rest &= rest - 1) {
      const Oriented& found =
          oriented_[word * 64 + static_cast<std::size_t>(std::countr_zero(rest))];
      const Rule& rule = rules_.rules[found.rule];
      if (rule.stage != 0 && rule.stage != stage) continue;
      if (height_holds(rule, site.z)) out.push_back(asked(found.rule, found.pattern, site));
    }
  }
}

NeighbourSet ActingRules::asked_about(const Outlook& site,
                                      const std::vector<RuleCandidate>& candidates) const {
  NeighbourSet asked = 0;
  for (const RuleCandidate& candidate : candidates) {
    asked |= candidate.there | candidate.not_there;
    // A count distinguishes an open neighbour only if the empty cell and the brick fall on
    // different sides of it. Where both are counted, or neither, the brick changes nothing
    // and need not be enumerated.
    for (const CountCondition& count : rules_.rules[candidate.rule].counts) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours_.size); ++i) {
        if (count.of.contains(kEmpty) == count.of.contains(site.shows[i])) continue;
        if (!count.faces_only || neighbours_.is_face[i]) asked |= NeighbourSet{1} << i;
      }
    }
  }
  return asked & site.open;
}

bool ActingRules::counts_stay(const Outlook& site, const RuleCandidate& candidate,
                              NeighbourSet there) const {
  const Rule& rule = rules_.rules[candidate.rule];
  assert((there & ~site.open) == 0);
  if (!counts_hold(rule, site, there)) return false;
  // Sufficient, not necessary: `there` is a state in which the counts hold, and any
  // superset must keep them. A minimum is safe when no open neighbour that is still empty
  // can lower the number; a maximum when all that could come leaves it within.
  return std::all_of(rule.counts.begin(), rule.counts.end(), [&](const CountCondition& count) {
    int most = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours_.size); ++i) {
      if (count.faces_only && !neighbours_.is_face[i]) continue;
      const bool counts = count.of.contains(site.shows[i]);
      const bool open = (site.open >> i & 1U) != 0;
      if (open && count.of.contains(kEmpty) && !counts) return false;  // what comes lowers it
      most += counts || (open && count.of.contains(kEmpty)) ? 1 : 0;
    }
    return most <= count.max;
  });
}

/// The counts of one local state. A neighbour that is not open always shows what `shows`
/// says; an open one shows it only when it is in `there`.
bool ActingRules::counts_hold(const Rule& rule, const Outlook& site, NeighbourSet there) const {
  return std::all_of(rule.counts.begin(), rule.counts.end(), [&](const CountCondition& count) {
    int number = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours_.size); ++i) {
      if (count.faces_only && !neighbours_.is_face[i]) continue;
      const bool shown = ((site.open & ~there) >> i & 1U) == 0;
      number += count.of.contains(shown ? site.shows[i] : kEmpty) ? 1 : 0;
    }
    return number >= count.min && number <= count.max;
  });
}

/// With `conflicts: first` the first rule that matches decides alone. Otherwise each that
/// matches may act, and the first one that would place a wrong colour is the one worth
/// reporting; if all agree on the colour it does not matter which rule is named.
Action ActingRules::act(const Outlook& site, const std::vector<RuleCandidate>& candidates,
                        NeighbourSet there, Colour expected) const {
  assert((there & ~site.open) == 0);
  Action action;
  // The definition of an event asks for a brick beside the site (docs/proofs.md, "The
  // claim"), so that agents that walk on the structure can get there at all.
  if (!site.event_possible(there)) return action;
  for (const RuleCandidate& candidate : candidates) {
    if ((candidate.there & ~there) != 0 || (candidate.not_there & there) != 0) continue;
    const Rule& rule = rules_.rules[candidate.rule];
    if (!counts_hold(rule, site, there)) continue;
    action = {true, candidate.rule, rule.place != expected};
    if (action.other || rules_.conflicts == Conflicts::first) break;
  }
  return action;
}

}  // namespace stig::certify
