// SPDX-License-Identifier: MIT
// What both ways of checking ask: is a brick that robots put right, by the rules and by reach?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/acting_rules.h"
#include "recheck/check_work.h"
#include "recheck/decide.h"
#include "recheck/room.h"
#include "recheck/uses.h"
#include "recheck/view.h"
#include "recheck/whole.h"

namespace stig::recheck {

/// Before a column, in all structures of a range.
struct Before {
  int side = 0, u = 0, v = 0;
};

/// A brick to be put, from a side.
struct Deed {
  std::uint32_t brick = 0;
  int side = 0;
  auto operator<=>(const Deed&) const = default;
};

class WorkSite {
 public:
  /// All must outlive it.
  WorkSite(const RuleSet& rules, const Figures& robot, const WorkCertificate& certificate);

  const WorkCertificate& certificate;
  const Whole whole;
  View view;
  Room room;

  /// What robots do before the column, by what they see there in `sure`; all that is in sight and
  /// may be there has to be sure.
  std::optional<Put> wish(const Before& at, const Bricks& sure);
  /// The brick that this is; kNoBrick, and why, when it is wrong in some structure of the range.
  std::uint32_t meant(const Before& at, const Put& put, const Range& there, std::string& why);
  /// Why a missing brick may be wrong or out of reach in some structure of the range.
  std::string fault(const Deed& deed, const Range& there);
  /// Cell of the brick, in words.
  std::string name(std::uint32_t brick) const;

 private:
  bool always_due(std::uint32_t brick, const Range& there) const;
  /// Bricks on the cells in view of a column, or kNoBrick, by number of the cell.
  const std::vector<std::uint32_t>& about(const Before& at);

  const RuleSet& rules_;
  ActingRules acting_;
  std::map<std::array<int, 3>, std::vector<std::uint32_t>> about_;
};

/// What has to hold before anything else: sizes, cells, sides, colours, the start.
std::string form_fault(const RuleSet& rules, const Figures& robot,
                       const WorkCertificate& certificate);
/// The two ways; a refusal or nothing.
std::string check_ordered(WorkSite& site, WorkReport& report);
std::string check_walked(WorkSite& site, WorkReport& report);

}  // namespace stig::recheck
