// SPDX-License-Identifier: MIT
// stigc --explain: what the codes of diagnostics mean.
//
// The texts are those of base/diagnostics.def, the same as in docs/diagnostics.md.
#include <fmt/format.h>

#include "base/diagnostic_example.h"
#include "commands.h"

namespace stig::cli {
namespace {

/// The name or the slug that was meant.
std::string_view meant(std::string_view code) {
  std::vector<std::string_view> names;
  for (const CodeInfo& known : all_codes()) {
    // Slugs are what users remember, names what messages show: both are understood.
    names.push_back(known.name);
    names.push_back(known.slug);
  }
  return nearest(code, names);
}

}  // namespace

int explain_code(const std::string& code, App& app) {
  if (code.empty()) {
    app.print(list_of_codes());
    return kOk;
  }
  if (const CodeInfo* known = find_code(code)) {
    app.print(explanation_text(*known));
    return kOk;
  }
  const std::string_view near = meant(code);
  const std::string hint = near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
  app.complain(fmt::format("there is no diagnostic {}{}\n'stigc --explain' lists them",
                           in_quotes(code), hint));
  return kUsage;
}

}  // namespace stig::cli
