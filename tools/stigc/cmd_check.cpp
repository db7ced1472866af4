// SPDX-License-Identifier: MIT
// stigc check: every problem of every file, at once.
//
// Whatever the file is, all of its errors come at once; what takes work (do rules ever fire, do
// programs load) is only asked of files that could be read.
#include <fmt/format.h>

#include "base/load.h"
#include "commands.h"
#include "lattice/never_fires.h"
#include "physical/scene/scene_programs.h"
#include "robots/robot_reader.h"
#include "rules/rule_reader.h"
#include "scene_input.h"

namespace stig::cli {
namespace {

/// Reads a file as what its first keys say it is; rule sets are the default.
void check_file(const std::string& path, Diagnostics& diagnostics) {
  SourceRef source = load_source(path, kMaxSceneBytes, diagnostics);
  if (!source) return;
  switch (content_of(source->text())) {
    case FileContent::scene:
      if (const auto scene = read_scene(source, scene_loader(path), diagnostics)) {
        // Placing finds what no key shows: overlaps, and blocks outside of the arena.
        const auto placed = place_scene(*scene, scene->seed, diagnostics);
        if (placed) check_programs(*scene, *placed, diagnostics);
      }
      break;
    case FileContent::robot:
      read_robot(std::move(source), diagnostics);
      break;
    case FileContent::block:
      read_block(std::move(source), diagnostics);
      break;
    case FileContent::solid:
      read_solid(std::move(source), diagnostics);
      break;
    case FileContent::rules:
      if (const auto rules = read_rule_set(std::move(source), diagnostics)) {
        check_rules_fire(*rules, diagnostics);
      }
      break;
  }
}

}  // namespace

int run(const CheckOptions& options, App& app) {
  Diagnostics all;
  std::size_t good = 0;
  for (const std::string& file : options.files) {
    // Each file's own, so that one bad file does not make the next one bad.
    Diagnostics diagnostics;
    check_file(file, diagnostics);
    if (!app.invalid(diagnostics)) ++good;
    all.append(diagnostics);
  }
  if (app.options().json_diagnostics) {
    // Here the diagnostics are the result.
    app.print(to_json(all));
  } else {
    app.report(all);
    // The count goes to standard output: it is the result, even when all is well.
    const std::size_t count = options.files.size();
    app.print(fmt::format("{} of {} {} good\n", good, count, count == 1 ? "file is" : "files are"));
  }
  return app.invalid(all) ? kFailed : kOk;
}

}  // namespace stig::cli
