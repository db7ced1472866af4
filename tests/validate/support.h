// SPDX-License-Identifier: MIT
// Made-up building sites: the staircase as it should be, to be spoilt by tests.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "compiler/compile.h"
#include "compiler/support.h"
#include "support/uses.h"
#include "validate/judge.h"
#include "validate/trial.h"

namespace stig {

/// A rule set that ships, compiled for the paper's robot.
struct CompiledSet {
  RuleSet rules;
  CompiledRules compiled;

  explicit CompiledSet(const std::string& name) : rules(shipped(name)) {
    Diagnostics diagnostics;
    compiled = compile_rules(rules, paper_robot(), {}, diagnostics);
    REQUIRE_MESSAGE(compiled.decision, to_text(diagnostics));
  }
  CompiledSet(const CompiledSet&) = delete;
  CompiledSet& operator=(const CompiledSet&) = delete;
};

/// The staircase, its lattice turned and moved, every brick in its place.
class Staircase {
 public:
  Staircase() {
    target.rules = &set.rules;
    target.whole = *set.compiled.proof.structure;
    target.sites = {{{{0.3, -0.2, 0.0275}, rotation({0, 0, 0.4})}, 0.055}};
    for (const Deposit& deposit : set.compiled.proof.run) {
      order.push_back({deposit.site, deposit.colour});
    }
    blocks.push_back(block(0, {0, 0, 0}, Led::q3));
    blocks[0].fixed = true;
    for (std::size_t i = 0; i < order.size(); ++i) {
      blocks.push_back(block(i + 1, order[i].at, led_of(set.rules, order[i].brick)));
    }
  }

  /// A block in a cell.
  WatchedBlock block(std::size_t number, Cell cell, Led led) const {
    WatchedBlock out;
    out.block = number;
    out.X_WB = {centre_of(target.sites[0], cell), target.sites[0].X_WL.q};
    out.led = led;
    return out;
  }
  /// As if they had come in the order of the proof's run, ten seconds apart.
  std::vector<BrickEvent> events() const {
    std::vector<BrickEvent> out;
    for (std::size_t i = 0; i < order.size(); ++i) {
      out.push_back({BrickEvent::Kind::placed, 10.0 * static_cast<double>(i + 1), i + 1,
                     order[i].at, led_of(set.rules, order[i].brick), 0});
    }
    return out;
  }
  /// The block that is in a cell.
  WatchedBlock& at(Cell cell) {
    for (WatchedBlock& block : blocks) {
      if (fit_of(target.sites[0], block.X_WB).cell == cell) return block;
    }
    REQUIRE_MESSAGE(false, "no block there");
    return blocks.front();
  }

  CompiledSet set{"staircase"};
  BuildTarget target;
  std::vector<PlacedBrick> order;  ///< of the proof's run
  std::vector<WatchedBlock> blocks;
};

}  // namespace stig
