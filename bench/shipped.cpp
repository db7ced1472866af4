// SPDX-License-Identifier: MIT
#include "shipped.h"

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>

#include "rules/rule_reader.h"
#include "support/uses.h"

namespace stig::bench {

RuleSet shipped(const std::string& name) {
  Diagnostics diagnostics;
  auto rules = read_rule_set_file(STIG_SOURCE_DIR "/rulesets/" + name + ".yaml", diagnostics);
  if (!rules) {
    std::fputs(to_text(diagnostics).c_str(), stderr);
    std::exit(1);
  }
  return *std::move(rules);
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace stig::bench
