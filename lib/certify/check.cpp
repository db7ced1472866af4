// SPDX-License-Identifier: MIT
// Puts the parts of the check together: does the certificate fit the rules and the box,
// then one StageCheck after another, each starting from the structure in which the one
// before ended. By induction over the stages the last structure is the end of every order
// of events (docs/proofs.md, "The proof").
#include "certify/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/hash.h"
#include "base/text.h"
#include "certify/stage_check.h"
#include "rules/cell_text.h"
#include "rules/rule_printer.h"

namespace stig::certify {
namespace {

/// Coordinates are bounded so that adding an offset, or measuring a side, never overflows
/// 32 bits. Bricks of the file's start pass the reader with the same bound.
bool within_reach(Cell cell) {
  const auto near = [](std::int32_t n) { return n >= -kMaxCoordinate && n <= kMaxCoordinate; };
  return near(cell.x) && near(cell.y) && near(cell.z);
}

std::string text_of(const std::optional<BoxSpec>& box) {
  if (!box) return "unbounded space";
  assert(box->origin);
  return fmt::format("{}box {}x{}x{} at {}", box->periodic ? "the periodic " : "the ", box->size.x,
                     box->size.y, box->size.z, cell_text(*box->origin));
}

/// Does the certificate speak of these rules in this box at all?
std::string misfit(const RuleSet& rules, const Certificate& certificate,
                   const std::optional<BoxSpec>& box) {
  // The hash covers what the rules mean and nothing of their layout. The check is sound
  // without it, since a wrong claim makes a condition fail, but the refusal would be hard
  // to understand.
  if (certificate.rule_set_hash != rule_set_hash(rules)) {
    return fmt::format("the certificate is for rules with the hash {}, and these have {}",
                       to_hex(certificate.rule_set_hash), to_hex(rule_set_hash(rules)));
  }
  // The box is part of the claim: in another box other sites can be filled.
  const std::optional<BoxSpec>& own = certificate.box;
  if (own && (!own->origin || !within_reach(*own->origin) || own->size.x < 1 || own->size.y < 1 ||
              own->size.z < 1)) {
    return "the certificate's box is no box";
  }
  std::optional<BoxSpec> asked = box;
  if (asked) asked = placed_box(*asked, rules.start, rules.floor);
  if (asked != own) {
    return fmt::format("the certificate is for {}, and asked for is {}", text_of(own),
                       text_of(asked));
  }
  if (certificate.stages.size() != static_cast<std::size_t>(rules.stage_count())) {
    return fmt::format("the certificate has {} stages, and the rules have {}",
                       certificate.stages.size(), rules.stage_count());
  }
  return "";
}

/// Adds the start; says what is wrong with it. Two bricks in one cell, or one below the
/// floor, make the initial structure meaningless; the conditions on stages presuppose one
/// colour per cell.
std::string add_start(const RuleSet& rules, const Space& space, KnownCells& cells) {
  for (const PlacedBrick& brick : rules.start) {
    if (!within_reach(brick.at) || !space.placeable(brick.at)) {
      return fmt::format("the start has a brick where none can be, at {}", cell_text(brick.at));
    }
    KnownCell& cell = cells[cells.find_or_add(brick.at)];
    if (cell.colour != 0) {
      return fmt::format("the start has two bricks at {}", cell_text(brick.at));
    }
    cell.colour = brick.brick;
  }
  return "";
}

/// Sorted by cell, so that reports and comparisons do not depend on the order in which the
/// checker met the cells.
std::vector<PlacedBrick> bricks_of(const KnownCells& cells) {
  std::vector<PlacedBrick> bricks;
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    if (cells[i].colour != 0) bricks.push_back({cells[i].at, cells[i].colour});
  }
  std::sort(bricks.begin(), bricks.end());
  return bricks;
}

std::string refusal_of(const RuleSet& rules, const Certificate& certificate,
                       const std::optional<BoxSpec>& box, CheckReport& report) {
  if (std::string problem = misfit(rules, certificate, box); !problem.empty()) return problem;
  const Space space{certificate.box, rules.floor};
  KnownCells cells;
  if (std::string problem = add_start(rules, space, cells); !problem.empty()) return problem;
  // Built once: the oriented rules are the same in all stages, and the filter by stage is
  // applied when candidates are listed.
  const ActingRules acting(rules);
  for (std::size_t i = 0; i < certificate.stages.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    // Checked here and not in StageCheck, since Space::wrap and the hash of cells already
    // presuppose bounded coordinates.
    for (const CertifiedBrick& brick : certificate.stages[i].order) {
      if (within_reach(brick.at)) continue;
      return fmt::format("stage {}: the brick at {} is out of reach", number, cell_text(brick.at));
    }
    StageCheck stage(rules, acting, space, certificate.stages[i], number, cells);
    if (std::string problem = stage.refusal(); !problem.empty()) {
      return fmt::format("stage {}: {}", number, problem);
    }
    report.sites += stage.sites();
    report.local_states += stage.local_states();
  }
  // After an accepted last stage `cells` holds the start and the bricks of all stages;
  // sites that stay empty have colour 0 and are left out.
  report.structure = bricks_of(cells);
  if (report.structure.size() != certificate.bricks) {
    return fmt::format("the structure has {}, and the certificate says {}",
                       counted(report.structure.size(), "brick"), certificate.bricks);
  }
  return "";
}

}  // namespace

CheckReport check_certificate(const RuleSet& rules, const Certificate& certificate) {
  return check_certificate(rules, certificate, rules.box);
}

CheckReport check_certificate(const RuleSet& rules, const Certificate& certificate,
                              const std::optional<BoxSpec>& box) {
  CheckReport report;
  report.box = certificate.box;
  report.refusal = refusal_of(rules, certificate, box, report);
  report.accepted = report.refusal.empty();
  // A structure that was only partly checked must not be mistaken for a result.
  if (!report.accepted) report.structure.clear();
  return report;
}

}  // namespace stig::certify
