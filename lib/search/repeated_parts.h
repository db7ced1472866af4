// SPDX-License-Identifier: MIT
// Parts of a structure that come again, as patterns in its graph of contacts: bricks are nodes, and
// those that share a face are joined.
//
// The part of a brick is what is joined to it by two contacts at most: the subgraph on these
// bricks, with their colours and places. Parts are of one kind where a translation and a turn about
// the vertical take one to the other. A kind is a module where it has three bricks or more, and two
// parts of it have no brick in common.
#pragma once

#include <vector>

#include "rules/rule_set.h"
#include "search/uses.h"

namespace stig::search {

/// Each part at most 25 cubic or 35 hexagonal bricks: the work grows as the number of bricks.
int repeated_parts(Lattice lattice, const std::vector<PlacedBrick>& bricks);

}  // namespace stig::search
