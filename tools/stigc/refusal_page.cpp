// SPDX-License-Identifier: MIT
#include "refusal_page.h"

#include "outputs.h"
#include "page_template.h"
#include "view/lattice_run.h"
#include "view/page.h"

namespace stig::cli {
namespace {

/// Errors and warnings with their notes, a line each.
std::vector<std::string> reasons(const Diagnostics& diagnostics) {
  std::vector<std::string> out;
  for (const Diagnostic& one : diagnostics.all()) {
    out.push_back(one.message);
    for (const auto& note : one.notes) out.push_back(note.message);
  }
  return out;
}

}  // namespace

int write_refusal_page(const std::string& path, const RuleSet& rules, const CompiledRules& compiled,
                       const Diagnostics& diagnostics, App& app) {
  if (compiled.drawings.empty()) {
    app.say("no page was written: there is no structure that this is about");
    return kOk;
  }
  PageContent page;
  const std::vector<std::string> why = reasons(diagnostics);
  for (const RefusalDrawing& drawing : compiled.drawings) {
    std::vector<SceneMark> marks;
    for (const RefusalMark& mark : drawing.marks) {
      marks.push_back({mark.at, mark.kind == RefusalMark::Kind::in_the_way, mark.text});
    }
    add_marked_structure(rules, drawing.bricks, drawing.title, marks, why, page);
  }
  const auto text = page_template(app);
  const auto whole = text ? page_of(*text, page) : std::nullopt;
  return whole ? write_output(path, *whole, app) : kRunFailed;
}

}  // namespace stig::cli
