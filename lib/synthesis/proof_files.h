// SPDX-License-Identifier: MIT
// The files of a proof that k colours do not do for a target under an order.
//
//   fewer.json   the problem: lattice, symmetry, floor, k, and for each orbit the cell
//                that stands for it, its cells, rank and allowed colours
//   fewer.cnf    the clauses, each behind a comment that says why it holds
//   fewer.drat   CaDiCaL's proof that they contradict each other (DRAT, text)
//
// Variables: orbit o (from 0, as in fewer.json) has colour c: o·k + c. Those above are
// pairs of orbits that are equal. Comments:
//
//   c colour O           orbit O has a colour
//   c one O              … and no other (left out where many are allowed)
//   c domain O           a colour the target does not allow there
//   c naming I O         colours are named in the order in which a list of orbits takes
//                        new ones: O, the I-th from 1 on, has one of the first I beyond
//                        those the target names
//   c pair P A B         what variable P means: orbits A and B are equal
//   c A Q X Y Z G S X Y Z M     the key of orbit Q at its cell, seeing the neighbours M
//   c B Q X Y Z G S X Y Z M     (bits, in neighbour order, as turned), turned by
//                        orientation G, looks like the site S (orbit or -1) at its cell:
//                        some compared pair differs; B: or both sites are equal
//
// A checker derives each clause from its comment and fewer.json, and then the proof.
#pragma once

#include <string>
#include <vector>

#include "synthesis/differences.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

std::string print_cnf(const Differences& differences, int named, int k,
                      const std::vector<int>& naming);
std::string print_problem(const Schedule& schedule, int named, int k);

}  // namespace stig::synthesis
