// SPDX-License-Identifier: MIT
// Small rule sets as text: whatever the verdict, a certificate is accepted by the checker
// and two orders that are said to differ do.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "certify/check.h"
#include "rules/rule_reader.h"
#include "support/uses.h"
#include "verify/verify.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stig;
  Diagnostics diagnostics;
  const auto rules =
      read_rule_set(std::make_shared<const SourceFile>(
                        "fuzz.yaml", std::string(reinterpret_cast<const char*>(data), size)),
                    diagnostics);
  if (!rules || rules->rules.size() > 50) return 0;
  VerifyOptions options;
  options.box = file_box(*rules);
  options.seconds = 0.2;
  options.states = 2000;
  SwarmConfig config;
  config.motion = Motion::event;
  config.box = options.box;
  if (!config_problem(RuleTable(*rules), rules->start, config).empty()) return 0;
  const VerifyResult result = verify::verify(*rules, options);
  if (result.certificate) {
    const auto box = result.certificate->box;
    const CheckReport report = check_certificate(*rules, *result.certificate, box);
    if (!report.accepted || report.structure != result.structure->bricks()) std::abort();
  }
  if (result.refutation && result.refutation->first_end == result.refutation->second_end) {
    std::abort();
  }
  return 0;
}
