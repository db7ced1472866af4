// SPDX-License-Identifier: MIT
// What `stigc explain` says: rule by rule, why it fires at a site or why not.
//
// The explanation itself is made in rules/explain.h, in terms of cells and conditions; here it
// becomes words or JSON.
#pragma once

#include <optional>
#include <string>

#include "lattice/swarm.h"
#include "report.h"
#include "rules/explain.h"
#include "uses.h"

namespace stig::cli {

/// What is explained, and where.
struct ExplainedSite {
  const RuleSet& rules;
  const Structure& structure;
  std::optional<Box> box;
  Cell site;
  Explanation explanation;
};

/// The site as rules of that stage see it; sites beyond the file's own box look like walls.
ExplainedSite explained_site(const RuleSet& rules, const Structure& structure, Cell site,
                             int stage);

/// All rules, or the one with this number, from 1.
std::string explain_text(const ExplainedSite& scene, std::optional<int> rule, bool color);
Json explain_json(const ExplainedSite& scene, std::optional<int> rule);

}  // namespace stig::cli
