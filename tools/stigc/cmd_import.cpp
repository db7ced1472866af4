// SPDX-License-Identifier: MIT
// stigc import: from a published table of rules to a rule set, and from URDF or SDF to a robot or a
// scene (description_input.cpp).
//
// What is printed is read again before anybody gets it, so that a table whose rules contradict each
// other under the symmetry is refused as a rule set would be.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/load.h"
#include "commands.h"
#include "description_input.h"
#include "lattice/rgb.h"
#include "outputs.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "urdf/import_robot.h"

namespace stig::cli {
namespace {

/// A name for a set from that of its file.
std::string name_from(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  return plain && !name.empty() && name != "-" ? name : "table";
}

std::optional<RuleSet> read_table(const ImportOptions& options, SourceRef source, const App& app) {
  Diagnostics diagnostics;
  std::optional<RuleSet> rules =
      read_published_table(std::move(source), options.reading, diagnostics);
  app.report(diagnostics);
  if (!rules) return std::nullopt;
  rules->name = name_from(options.table);
  for (int k = 1; k <= rules->colours(); ++k) {
    rules->bricks[static_cast<std::size_t>(k - 1)].color =
        to_color(rgb_of({}, static_cast<Colour>(k)));
  }
  return rules;
}

/// Is this the text of a sound rule set? Otherwise what is wrong is reported, at its place in the
/// text.
bool sound(const std::string& name, const std::string& text, const App& app) {
  Diagnostics diagnostics;
  read_rule_set(std::make_shared<SourceFile>(name, text), diagnostics);
  const bool bad = app.invalid(diagnostics);
  if (bad) app.report(diagnostics);
  const std::size_t warnings = diagnostics.count(Severity::warning);
  if (!bad && warnings > 0) {
    app.say(fmt::format("{}, which stigc check shows", counted(warnings, "warning")));
  }
  return !bad;
}

}  // namespace

int run(const ImportOptions& options, App& app) {
  const bool hexagonal = options.reading.matrices_of == Lattice::hexagonal;
  if (hexagonal && options.reading.form && *options.reading.form != TableForm::matrices) {
    app.complain("--lattice is that of matrices; the other forms are hexagonal anyway");
    return kUsage;
  }
  Diagnostics diagnostics;
  SourceRef source = load_source(options.table, kMaxDescriptionBytes, diagnostics);
  if (!source) {
    app.report(diagnostics);
    return kFailed;
  }
  if (is_description(source->text())) return import_described(options, source, app);
  const std::optional<RuleSet> rules = read_table(options, std::move(source), app);
  if (!rules) return kFailed;
  const std::string text = print_rule_set(*rules);
  // The file is not there yet, and will not be if this fails.
  if (!sound("<imported rules>", text, app)) return kFailed;
  if (!options.output) {
    app.print(text);
    return kOk;
  }
  if (const int code = check_outputs({*options.output}, app); code != kOk) return code;
  return write_output(*options.output, text, app);
}

}  // namespace stig::cli
