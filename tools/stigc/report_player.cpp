// SPDX-License-Identifier: MIT
// Traces are read back from the folder rather than kept while runs go on: what can be played is
// what was written.
#include "report_player.h"

#include <fmt/format.h>

#include "outputs.h"
#include "physical/trace/pose_trace.h"
#include "trace_rules.h"
#include "view/page.h"
#include "view/pose_run.h"

namespace stig::cli {
namespace {

/// Runs beyond are left to `stigc view`: a browser opens as much within seconds, and the report can
/// still be mailed. About 2400 s of four robots take a sixth of it.
constexpr std::size_t kMostColumnBytes = std::size_t{40} << 20;

}  // namespace

std::optional<ReportPlayer> report_player(const std::string& page_template,
                                          const std::vector<std::string>& traces, const App& app) {
  PageContent page;
  std::size_t runs = 0;
  for (const std::string& path : traces) {
    if (page.columns().bytes().size() > kMostColumnBytes) break;
    auto bytes = trace_bytes(path, app);
    if (!bytes) return std::nullopt;
    Diagnostics diagnostics;
    const auto trace = read_pose_trace(path, std::move(*bytes), diagnostics);
    app.report(diagnostics);
    if (!trace) return std::nullopt;
    add_pose_run(*trace, fmt::format("seed {}", trace->header.seed), page);
    ++runs;
  }
  const auto parts = player_of(page_template, page);
  if (parts) return ReportPlayer{parts->script, parts->style, parts->body, runs};
  app.complain("the template of the page is damaged: build or install the program again");
  return std::nullopt;
}

}  // namespace stig::cli
