// SPDX-License-Identifier: MIT
// Several robots at one structure (concurrent.h), of a policy that was proved column by column.
//
//     lasting   a brick that is ever decided on from a side is due and within reach from there in
//               every closed structure that has what comes before it and lacks it
//     way out   no brick is ever due in the lane of a robot, farther out than its back, when the
//               robot can stand there
//
// Where each robot has sides of its own, a brick that its side's robot alone puts shuts nobody in
// there.
//
// The way on is that of local_policy.h: as long as decisions last, every structure that robots come
// to is closed. It is stricter than the walk over structures, and says less of what goes wrong.
#pragma once

#include "compiler/compile.h"
#include "compiler/lanes.h"
#include "compiler/local_situations.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// `decided`: bricks and the sides from which they are put. A structure that shows a conflict is
/// added to the policy's.
Concurrency check_locally(CompiledRules& compiled, const std::vector<Work>& decided,
                          const Abilities& robot, const LocalSituations& local,
                          const Precedence& precedence, Lanes& lanes);

}  // namespace stig::compiler
