// SPDX-License-Identifier: MIT
// A certificate: why every order of events ends in one structure, written so that a
// small program can check it. docs/proofs.md has the theorem and its proof.
//
// Stage by stage, a certificate claims that the events of the stage lead from the
// structure S0 that it finds to X = S0 + the bricks it lists, whatever their order. It
// lists those bricks in an order in which the rules can place them (the witness run), and
// an invariant of every structure S that can be reached on the way:
//
//   before   for each brick q, a set of neighbours that are in S whenever q is
//   window   some bricks (its `group`) about which nothing is known by `before`, some
//            bricks around them (its `context`), and every filling of group and context
//            that can occur
//   far      p is in S whenever q is, p and q being a few cells apart: a chain of
//            `before` steps leads from q to p. Steps between neighbours of one site are
//            found by the checker; a far fact says what it would have to go far to see.
//
// What is verified of it stands in check.h. The text form, a line an item:
//
//   stigc-certificate 1
//   rules 5f0c…            rule_set_hash of the set
//   box none               or: box X Y Z SX SY SZ [periodic] (lowest cell, size)
//   stage 1 order 3        stage number, bricks it deposits
//   0 0 1 2 0              x y z colour, and `before` as a hexadecimal mask over
//   1 0 1 2 8              neighbour indices (neighbourhood.h), least bit index 0
//   …
//   far 4 2 0              numbers of bricks in this stage (from 0), from q back to p
//   window 2 1 4           sizes of group and context, number of fillings
//   5 6                    the group, as numbers of bricks
//   3                      the context
//   0 1 3 7                fillings, hexadecimal: bit 0 the first of group, then context
//                          (all with as many digits as there are bricks for)
//   end 6                  bricks in the final structure, the start included
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "certify/uses.h"
#include "rules/rule_set.h"

namespace stig::certify {

/// One deposit of the witness run.
struct CertifiedBrick {
  Cell at;
  Colour colour = 0;
  std::uint32_t before = 0;  ///< bit i: the brick at neighbour index i is always there first
  bool operator==(const CertifiedBrick&) const = default;
};

/// A set of bricks of a window: bit i of word i / 64 is the i-th of group, then context.
using Filling = std::vector<std::uint64_t>;

struct CertifiedWindow {
  std::vector<std::uint32_t> group, context;  ///< positions in CertifiedStage::order
  std::vector<Filling> fillings;              ///< strictly rising as numbers, all of one length
  bool operator==(const CertifiedWindow&) const = default;
};

struct CertifiedStage {
  std::vector<CertifiedBrick> order;  ///< the witness run
  /// Each a chain q, …, p of positions in `order`: a step's target is before its origin.
  std::vector<std::vector<std::uint32_t>> far;
  std::vector<CertifiedWindow>
      windows;  ///< no group has two bricks of different windows beside each other
  bool operator==(const CertifiedStage&) const = default;
};

struct Certificate {
  std::uint64_t rule_set_hash = 0;
  std::optional<BoxSpec> box;  ///< with its origin; none: unbounded space
  std::vector<CertifiedStage> stages;
  std::uint64_t bricks = 0;  ///< in the end, the start included
  bool operator==(const Certificate&) const = default;
};

/// The file's text; the same certificate always gives the same bytes.
std::string print_certificate(const Certificate& certificate);

/// Reads the text form; anything malformed is a diagnostic, and memory stays within a
/// small multiple of the text's size.
std::optional<Certificate> read_certificate(const std::string& path, const std::string& text,
                                            Diagnostics& diagnostics);

}  // namespace stig::certify
