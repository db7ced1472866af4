// SPDX-License-Identifier: MIT
#include "rules_text.h"

#include <nlohmann/json.hpp>

#include "rules/rule_reader.h"

namespace stig::playground {

void add_diagnostics(const Diagnostics& diagnostics, Json& out) {
  Json list = Json::parse(to_json(diagnostics));
  if (!out.contains("diagnostics")) out["diagnostics"] = Json::array();
  for (Json& one : list) out["diagnostics"].push_back(std::move(one));
}

SourceRef source_of(const Json& question, const char* key) {
  const auto found = question.find(key);
  if (found == question.end() || !found->is_object()) return nullptr;
  return std::make_shared<const SourceFile>(found->value("name", ""), found->value("text", ""));
}

SourceRef rules_source(const Json& question) {
  return std::make_shared<const SourceFile>(question.value("name", "rules.yaml"),
                                            question.value("text", ""));
}

std::optional<RuleSet> read_rules_text(const Json& question, Json& out) {
  Diagnostics diagnostics;
  auto rules = read_rule_set(rules_source(question), diagnostics);
  add_diagnostics(diagnostics, out);
  return rules;
}

double effort_of(const Json& question) {
  constexpr double kMost = 1e6;
  const auto found = question.find("effort");
  if (found == question.end() || !found->is_number()) return 1;
  const double effort = found->get<double>();
  return effort > 0 && effort <= kMost ? effort : 1;
}

}  // namespace stig::playground
