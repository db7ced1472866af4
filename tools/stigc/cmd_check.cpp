// SPDX-License-Identifier: MIT
// stigc check: every problem of every file, at once.
#include <fmt/format.h>

#include "commands.h"
#include "rules/rule_reader.h"

namespace stig {

int run(const CheckOptions& options, App& app) {
  Diagnostics all;
  std::size_t good = 0;
  for (const std::string& file : options.files) {
    Diagnostics diagnostics;
    read_rule_set_file(file, diagnostics);
    if (!app.invalid(diagnostics)) ++good;
    all.append(diagnostics);
  }
  if (app.options().json_diagnostics) {
    // Here the diagnostics are the result.
    app.print(to_json(all));
  } else {
    app.report(all);
    const std::size_t count = options.files.size();
    app.say(fmt::format("{} of {} {} good", good, count, count == 1 ? "file is" : "files are"));
  }
  return app.invalid(all) ? kFailed : kOk;
}

}  // namespace stig
