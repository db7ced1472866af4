// SPDX-License-Identifier: MIT
#include "shown_runs.h"

#include <nlohmann/json.hpp>

#include "base/base64.h"
#include "rules/rule_printer.h"

namespace stig::playground {

Trace given_order(const RuleSet& rules, const std::optional<Box>& box,
                  const std::vector<Deposit>& events, const Structure& end) {
  Trace trace;
  trace.rule_set_hash = rule_set_hash(rules);
  trace.kind = "given";
  trace.config.motion = Motion::event;
  trace.config.box = box;
  trace.events = events;
  trace.steps = events.size();
  trace.final_hash = structure_hash(end);
  return trace;
}

void add_view(const PageContent& page, Json& out) {
  out["view"] = {{"json", page.json()}, {"columns", base64(page.columns().bytes())}};
}

std::string trace_file(const RuleSet& rules, const Trace& trace) {
  TraceWriter writer(rules, trace.config, trace.kind);
  for (const Deposit& event : trace.events) writer.deposit(event);
  return base64(writer.finish(trace.steps, trace.terminated));
}

}  // namespace stig::playground
