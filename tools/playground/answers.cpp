// SPDX-License-Identifier: MIT
#include "answers.h"

#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "lattice/never_fires.h"
#include "rules/rule_reader.h"
#include "rules/rule_schema.h"
#include "rules_text.h"

namespace stig::playground {
namespace {

constexpr std::pair<std::string_view, Json (*)(const Json&)> kAnswers[] = {
    {"schema", schema_answer},   {"check", check_answer},         {"explore", explore_answer},
    {"explain", explain_answer}, {"verify", verify_answer},       {"compile", compile_answer},
    {"synth", synth_answer},     {"structure", structure_answer},
};

Json answer_json(const Json& question) {
  const std::string wanted = question.is_object() ? question.value("do", "") : "";
  for (const auto& [name, function] : kAnswers) {
    if (name == wanted) return function(question);
  }
  return {{"error", "there is no such question"}};
}

}  // namespace

std::string answer(std::string_view question) {
  const Json asked = Json::parse(question, nullptr, false);
  return answer_json(asked).dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json schema_answer(const Json&) { return Json::parse(json_schema()); }

Json check_answer(const Json& question) {
  Json out;
  Diagnostics diagnostics;
  // As stigc check: what takes work is only asked of rules that could be read.
  if (const auto rules = read_rule_set(rules_source(question), diagnostics)) {
    check_rules_fire(*rules, diagnostics);
  }
  add_diagnostics(diagnostics, out);
  return out;
}

}  // namespace stig::playground

/// What the page calls. The caller frees the answer, which ends with a null byte.
extern "C" char* stig_answer(const char* question) {
  const std::string text = stig::playground::answer(question);
  auto* out = static_cast<char*>(std::malloc(text.size() + 1));
  if (out != nullptr) std::memcpy(out, text.c_str(), text.size() + 1);
  return out;
}
