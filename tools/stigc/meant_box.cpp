// SPDX-License-Identifier: MIT
// The same answer for explore, verify and certify: what is proved must be what is run.
#include "meant_box.h"

namespace stig::cli {

std::optional<BoxSpec> meant_box(const RuleSet& rules, const WorldOptions& world,
                                 std::string& problem) {
  std::optional<BoxSpec> meant = rules.box;
  if (world.box) {
    // A size given on the command line says nothing of the sides and the place of the file's box.
    meant.reset();
    if (world.box->size) meant = BoxSpec{*world.box->size, std::nullopt, false};
  }
  if (!meant && world.periodic) problem = "unbounded space has no sides that could be periodic";
  if (!meant && world.origin) problem = "unbounded space has no --origin: give a --box";
  if (meant && world.periodic) meant->periodic = true;
  if (meant && world.origin) meant->origin = world.origin;
  return meant;
}

}  // namespace stig::cli
