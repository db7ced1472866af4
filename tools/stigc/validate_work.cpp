// SPDX-License-Identifier: MIT
// The figures of work_summary.h in both forms. Times are null where no run was complete: 0 s would
// be the best of all.
#include "validate_work.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/text.h"

namespace stig::cli {

Json to_json(const WorkSummary& all) {
  Json json{{"runs", all.runs},
            {"complete", all.complete},
            // The time of the last brick, of complete runs alone; other sums are over all runs.
            {"finish_s", all.complete > 0 ? Json(all.finish) : Json(nullptr)},
            {"finish_deviation_s", all.complete > 0 ? Json(all.deviation) : Json(nullptr)},
            {"robots_s", all.time},
            {"ideal_s", all.ideal},
            {"efficiency", all.efficiency()},
            {"idle_s", all.idle},
            {"idle_share", all.idle_share()},
            // The share of time at work, under the name that the literature has for it.
            {"utilisation", 1 - all.idle_share()},
            {"placed", all.placed},
            {"busy", all.busy},
            {"busy_per_brick", all.busy_per_brick()}};
  json["states"] = Json::array();
  for (const StateTime& one : all.states) {
    json["states"].push_back({{"state", one.state}, {"time", one.time}, {"idle", one.idle}});
  }
  return json;
}

Json to_json(const std::vector<WorkPhase>& phases) {
  Json json = Json::array();
  for (const WorkPhase& phase : phases) {
    json.push_back({{"name", phase.name},
                    {"from", phase.from},
                    {"to", phase.to},
                    {"sites", phase.sites},
                    {"bricks", phase.bricks},
                    {"busy", phase.busy},
                    {"idle_share", phase.idle}});
  }
  return json;
}

std::string time_in_words(const WorkSummary& all) {
  if (all.complete == 0) return "no run was complete";
  return fmt::format("the last brick after {:.0f} s on average, deviation {:.0f} s", all.finish,
                     all.deviation);
}

std::string work_in_words(const WorkSummary& all) {
  return fmt::format(
      "at work {:.0f} % of their time, idle {:.0f} %; aborted {} times since another was in the "
      "way, {:.2f} for each brick placed",
      100 * (1 - all.idle_share()), 100 * all.idle_share(), all.busy, all.busy_per_brick());
}

std::string efficiency_in_words(const WorkSummary& all) {
  const auto bricks = static_cast<double>(all.placed > 0 ? all.placed : 1);
  return fmt::format("{:.2f}: {:.1f} s of a robot for each brick, where {:.1f} s are ideal",
                     all.efficiency(), all.taken / bricks, all.ideal / bricks);
}

std::string lines_of(const std::vector<WorkPhase>& phases) {
  if (phases.empty()) return {};
  std::string out = fmt::format("{:<12}  {:>7}  {:>7}  {:>6}  {:>6}  {:>6}  {:>7}\n", "phase",
                                "from/s", "to/s", "sites", "bricks", "busy", "idle/%");
  for (const WorkPhase& phase : phases) {
    out += fmt::format("{:<12}  {:>7.0f}  {:>7.0f}  {:>6.1f}  {:>6.1f}  {:>6.1f}  {:>7.1f}\n",
                       phase.name, phase.from, phase.to, phase.sites, phase.bricks, phase.busy,
                       100 * phase.idle);
  }
  return out;
}

std::string state_lines(const WorkSummary& all) {
  if (all.states.empty()) return {};
  std::string out =
      fmt::format("{:<16}  {:>9}  {:>7}  {:>9}\n", "state", "time/s", "share/%", "idle/s");
  for (const StateTime& one : all.states) {
    // Where there is any state, the time of all robots is positive.
    out += fmt::format("{:<16}  {:>9.1f}  {:>7.1f}  {:>9.1f}\n", printable(one.state), one.time,
                       100 * one.time / all.time, one.idle);
  }
  return out;
}

}  // namespace stig::cli
