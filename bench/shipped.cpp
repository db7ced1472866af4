// SPDX-License-Identifier: MIT
#include "shipped.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

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

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(STIG_SOURCE_DIR "/rulesets")) {
    if (file.path().extension() == ".yaml") names.push_back(file.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace stig::bench
