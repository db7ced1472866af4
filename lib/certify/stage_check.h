// SPDX-License-Identifier: MIT
// One stage of a certificate, checked against the five conditions of docs/proofs.md:
//
//   order     each brick has a place of its own, a deposit of the run can be made by some
//             rule, `before` and `far` point to bricks that come earlier
//   windows   each is closed: what is listed leads to what is listed, and never ends
//             before the window is full
//   sites     at a site that stays empty, no rule ever acts; a brick's site gets its
//             colour and no other, not before `before`, and once the rules can place
//             it as in the run, they can until it is there
//   limit     a stage with a number of deposits has no more than that
//
// "Ever" means: for every set of neighbours of the site, bricks of this stage, that the
// claims of the certificate do not rule out: the site's local states. Neighbours that no
// rule asks about are left out of these sets. Where there are very many, and rules are
// patterns alone, one look at each rule does: the least set in which it matches is what it
// asks for and what comes before that.
#pragma once

#include <string>
#include <vector>

#include "certify/acting_rules.h"
#include "certify/certificate.h"
#include "certify/space.h"
#include "certify/uses.h"

namespace stig::certify {

class StageCheck {
 public:
  /// `cells` holds the structure that the stage finds; all must outlive the check.
  StageCheck(const RuleSet& rules, const ActingRules& acting, const Space& space,
             const CertifiedStage& stage, int number, KnownCells& cells);

  /// What does not hold, or nothing. Afterwards, `cells` holds the stage's bricks too.
  std::string refusal();
  std::uint64_t sites() const { return sites_; }
  std::uint64_t local_states() const { return local_states_; }

 private:
  /// A brick's place in a window.
  struct Member {
    std::uint32_t window;
    std::uint32_t bit;  ///< in its fillings
    bool group;         ///< not context
  };
  /// A brick of this stage that a site sees; in a narrow periodic box at several indices.
  struct Local {
    std::uint32_t position;
    NeighbourSet at;
  };
  struct Site {
    Cell at;
    Colour colour = 0;               ///< that it gets; 0: stays empty
    std::uint32_t position = kNone;  ///< in the order, if it gets one
    Outlook outlook;
    std::vector<Local> locals;  ///< by position
    std::vector<RuleCandidate> candidates;
  };
  /// Those of a filling's bricks that a site sees.
  struct Seen {
    std::uint32_t bit;
    NeighbourSet at;
  };

  // The order.
  bool load_order();
  bool load_before(std::uint32_t position);
  bool load_far();
  bool within_limit();
  // Windows.
  bool load_windows();
  bool load_members(std::uint32_t window, const std::vector<std::uint32_t>& bricks,
                    std::uint32_t first_bit, bool group);
  bool fillings_well_formed(const CertifiedWindow& window);
  bool windows_progress();
  bool in_group(std::uint32_t position) const;
  /// Its bit in a window's fillings, or kNone.
  std::uint32_t bit_in(std::uint32_t position, std::uint32_t window) const;
  std::size_t fillings_to_check(const CertifiedWindow& window) const;
  static bool is_listed(const CertifiedWindow& window, const Filling& filling);
  // Sites.
  bool check_sites();
  void add_sites_beside_bricks();
  void look(std::uint32_t cell, Site& site) const;
  bool check_site(const Site& site);
  bool check_group_brick(const Site& site);
  bool check_context_brick(const Site& site, const Member& own);
  bool check_local_states(const Site& site);
  bool check_least_states(const Site& site);
  bool check_run(const Site& site);
  static NeighbourSet seen_in_run(const Site& site);
  // Local states: the sets of open neighbours that can be there while the site is empty.
  bool list_local_states(const Site& site);
  std::uint32_t window_around(const Site& site) const;
  bool all_within(const Site& site, std::uint32_t window) const;
  std::vector<Seen> seen_of(const Site& site, std::uint32_t window, bool group_alone) const;
  std::vector<NeighbourSet> projections(const Site& site, std::uint32_t window,
                                        bool group_alone) const;
  bool add_closed_sets(const Site& site);
  /// Fills in below_; returns the neighbours that come only after the site's own brick.
  NeighbourSet order_locals(const Site& site);
  /// With all that must be there before these.
  NeighbourSet closed(const Site& site, NeighbourSet there) const;
  /// Where the site sees this brick; empty: nowhere.
  static NeighbourSet bricks_at(const Site& site, std::uint32_t position);

  bool refuse(std::string why);
  bool refuse_rule(const Site& site, std::uint32_t rule);
  bool refuse_filling(const Site& site, const Filling& filling);
  bool refuse_too_many(const Site& site);

  const RuleSet& rules_;
  const ActingRules& acting_;
  const Space& space_;
  const CertifiedStage& stage_;
  const int number_;
  KnownCells& cells_;
  const Neighbourhood& neighbours_;

  std::vector<std::uint32_t> cell_of_;               ///< by position
  std::vector<std::vector<std::uint32_t>> earlier_;  ///< bricks before it, by `before` and `far`
  std::vector<std::vector<Member>> members_;         ///< windows it is in; a group's alone
  std::vector<std::vector<bool>> leads_on_;          ///< [window][filling]: its group can grow
  bool spent_ = false;                ///< the stage ends with its last brick, whatever rules say
  std::vector<NeighbourSet> states_;  ///< the present site's local states, of what matters
  NeighbourSet matters_ = 0;          ///< its neighbours that rules ask about
  std::vector<NeighbourSet> below_;   ///< by local: all that must be there before it
  std::uint64_t sites_ = 0, local_states_ = 0;
  std::string refusal_;
};

}  // namespace stig::certify
