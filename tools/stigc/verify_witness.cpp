// SPDX-License-Identifier: MIT
// A verdict can be looked at: orders of events as traces, which `stigc replay` runs, and pictures
// of their ends. Names are fixed endings after the name given, so that all can be checked before
// the work.
#include <fmt/format.h>

#include "lattice/picture.h"
#include "lattice/trace.h"
#include "outputs.h"
#include "rules/rule_printer.h"
#include "verify_report.h"

namespace stig::cli {
namespace {

// Larger pictures take minutes and show nothing.
constexpr std::size_t kMostPictured = 200'000;  ///< bricks

std::string trace_of(const VerifyReport& report, const std::vector<Deposit>& order) {
  SwarmConfig config;
  // Orders are lists of events, so the trace is one of event motion, whatever runs usually do.
  config.motion = Motion::event;
  config.box = report.box;
  TraceWriter writer(report.rules, config, "given");
  for (const Deposit& deposit : order) writer.deposit(deposit);
  return writer.finish(order.size(), Terminated::saturated);
}

Structure after(const RuleSet& rules, const std::vector<Deposit>& order) {
  Structure structure(rules.lattice, rules.start);
  for (const Deposit& deposit : order) structure.place(deposit.site, deposit.colour);
  return structure;
}

std::string walled_in_ending(std::size_t number) {
  return fmt::format("-walled-in-{}.stigt", number);
}

/// Writes files under one name, and remembers whether all went well.
class Witness {
 public:
  Witness(const std::string& name, const VerifyReport& report, const App& app)
      : name_(name), report_(report), app_(app) {}

  void write(const std::string& ending, const std::string& bytes) {
    // A file that fails does not keep the next one from being written.
    code_ = std::max(code_, write_output(name_ + ending, bytes, app_));
  }
  void trace(const std::string& ending, const std::vector<Deposit>& order) {
    write(ending, trace_of(report_, order));
  }
  void picture(const std::vector<PicturePanel>& panels, const std::string& title) {
    for (const PicturePanel& panel : panels) {
      if (panel.structure->size() > kMostPictured) {
        return app_.say("the structure is too large for a picture");
      }
    }
    PictureOptions options;
    options.title = title;
    options.floor = report_.rules.floor;
    write(".png", draw_structures(panels, report_.rules.bricks, options));
  }
  int code() const { return code_; }

 private:
  const std::string& name_;
  const VerifyReport& report_;
  const App& app_;
  int code_ = kOk;
};

}  // namespace

std::vector<std::string> witness_names(const std::string& name) {
  std::vector<std::string> names;
  for (const char* ending : {".stigt", ".png", "-first.stigt", "-second.stigt", "-repaired.yaml"}) {
    names.push_back(name + ending);
  }
  for (std::size_t i = 1; i <= kMostWalledIn; ++i) names.push_back(name + walled_in_ending(i));
  return names;
}

int write_witness(const std::string& name, const VerifyReport& report, const App& app) {
  const VerifyResult& result = report.result;
  const std::string& title = report.rules.name;
  Witness witness(name, report, app);
  if (result.refutation) {
    const DivergingOrders& found = *result.refutation;
    witness.trace("-first.stigt", found.first);
    witness.trace("-second.stigt", found.second);
    // Side by side, so that the difference is seen.
    witness.picture(
        {{&found.first_end, "one end"},
         {&found.second_end, found.second_ended ? "another" : "another, still growing"}},
        title + ": two orders, two ends");
  } else if (result.endless) {
    const Structure grown = after(report.rules, result.endless->run);
    witness.trace(".stigt", result.endless->run);
    witness.picture({{&grown, "and so on"}}, title + ": grows for ever");
  } else if (result.structure) {
    witness.trace(".stigt", result.run);
    witness.picture({{&*result.structure, ""}}, title);
  } else {
    app.say("there is nothing to show");
  }
  for (std::size_t i = 0; i < report.findings.walled_in.size(); ++i) {
    witness.trace(walled_in_ending(i + 1), report.findings.walled_in[i].order);
  }
  // A repair that reaches some stages alone is shown, and not written as if it were whole.
  if (report.findings.repair && report.findings.repair->whole) {
    witness.write("-repaired.yaml", print_rule_set(report.findings.repair->repaired));
  }
  return witness.code();
}

}  // namespace stig::cli
