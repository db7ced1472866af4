// SPDX-License-Identifier: MIT
// Rules that build a structure, as far as this goes without a SAT solver (stand_ins/colouring.cpp):
// where one colour does. What was found is proved before it is handed out.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "answers.h"
#include "lattice/structure_json.h"
#include "rules/rule_printer.h"
#include "rules_text.h"
#include "synth_report.h"
#include "synth_words.h"
#include "synthesis/emit.h"
#include "synthesis/synthesise.h"

namespace stig::playground {
namespace {

constexpr const char* kNotFound =
    "no rules of one colour were found, and more colours take a SAT solver, which the page has "
    "not: save the structure and run stigc synth";

void add_rules(const std::string& name, const Solution& s, const Target& target, Json& out) {
  const Wording wording{name, fmt::format("{}, {}", name, counted(s.frame->cells.size(), "brick")),
                        fmt::format("{} in the playground; {}", kMadeBySynth, s.order.name)};
  const RuleSet rules =
      make_rule_set(*s.frame, s.colours, s.colour_count, target.bricks, s.rules, wording);
  const VerifyResult proof = verify::verify(rules, {});
  if (proof.verdict == ProofVerdict::proved) {
    out["rules"] = print_rule_set(rules);
  } else {
    out["problem"] = "rules were found, but not proved: " + proof.open;
  }
}

}  // namespace

Json synth_answer(const Json& question) {
  Json out;
  const SourceRef file = source_of(question, "target");
  Diagnostics diagnostics;
  const auto loaded = file ? read_structure_json(file, diagnostics) : std::nullopt;
  add_diagnostics(diagnostics, out);
  if (!loaded || loaded->structure.empty()) {
    out["problem"] = "there is no structure to be built";
    return out;
  }
  const Target target = target_of(*loaded, ColourUse::free);
  SynthesisOptions options;
  options.floor = question.value("floor", false);
  options.effort = effort_of(question);
  const Synthesis result = synthesise(target, options);
  if (result.best) {
    add_rules(question.value("name", "structure"), *result.best, target, out);
  } else if (result.obstacle && result.obstacle->proved) {
    out["problem"] = synth_reason(result, false);
  } else {
    out["problem"] = kNotFound;
  }
  return out;
}

}  // namespace stig::playground
