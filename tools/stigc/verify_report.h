// SPDX-License-Identifier: MIT
// What `stigc verify` says and writes.
#pragma once

#include "app.h"
#include "report.h"
#include "uses.h"
#include "verify/findings.h"
#include "verify/losses.h"
#include "verify/verify.h"

namespace stig::cli {

struct VerifyReport {
  const RuleSet& rules;
  std::optional<Box> box;
  const VerifyResult& result;
  const Findings& findings;
  const LossResult* losses = nullptr;  ///< where they were asked for, of a proof
};

std::string to_text(const VerifyReport& report, bool color);
Json to_json(const VerifyReport& report);

/// Writes what shows the verdict, each under a name that begins with `name`: a trace and a
/// picture of the structure (proved, endless); two traces and a picture of both ends
/// (refuted); the repaired rule set, if one was found. Returns an exit code.
int write_witness(const std::string& name, const VerifyReport& report, const App& app);
/// Every name that a file of write_witness can have.
std::vector<std::string> witness_names(const std::string& name);

}  // namespace stig::cli
