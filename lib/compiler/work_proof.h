// SPDX-License-Identifier: MIT
// The proof that robots complete the structure, written down for lib/recheck.
#pragma once

#include "compiler/compile.h"
#include "compiler/controller_plan.h"
#include "compiler/uses.h"
#include "recheck/work_certificate.h"

namespace stig::compiler {

/// Of rules that were compiled with success, for robots that look from the plan's viewpoints.
/// `rules` are those that were compiled.
WorkCertificate certificate_of_work(const RuleSet& rules, const CompiledRules& compiled,
                                    const ControllerPlan& plan);

}  // namespace stig::compiler
