// SPDX-License-Identifier: MIT
// The checker of certificates of robots' work (work_certificate.h). It shares no code with the
// compiler; of the rest of the project it takes how files are read, the camera's projection, the
// boxes about a robot's bodies, and the matcher of rules of lib/certify. docs/proofs.md says what
// an accepted certificate proves.
#pragma once

#include <cstdint>
#include <string>

#include "recheck/figures.h"
#include "recheck/uses.h"
#include "recheck/work_certificate.h"
#include "rules/rule_set.h"

namespace stig::recheck {

struct WorkReport {
  bool accepted = false;
  std::string refusal;         ///< one sentence: what does not hold, and where
  std::size_t situations = 0;  ///< before columns, that were looked at
  std::size_t structures = 0;  ///< on the way, where they were walked
};

/// More is refused: it would take too much time or memory.
inline constexpr std::size_t kMostOrderedWork = 6000, kMostSituations = 20'000'000,
                             kMostWalkedWork = 200'000;

/// For rules as these sides work by them (rules/worked_from.h).
WorkReport check_work(const RuleSet& rules, const Figures& robot,
                      const WorkCertificate& certificate);

}  // namespace stig::recheck
