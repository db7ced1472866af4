// SPDX-License-Identifier: MIT
// stigc measure and stigc draw: structure files by themselves.
//
// Structure files need no rule set: what they do not say of themselves the command line may.
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "commands.h"
#include "lattice/structure_files.h"
#include "mesh_input.h"
#include "outputs.h"
#include "report.h"
#include "structure_input.h"

namespace stig::cli {
namespace {

/// The file's name without folders and ending.
std::string stem(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  return name.substr(0, name.rfind('.'));
}

}  // namespace

int run(const MeasureOptions& options, App& app) {
  if (const std::string problem = bricks_problem(options.mesh, {options.structure});
      !problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  const auto loaded = read_structure(options.structure, options.lattice, app, options.mesh);
  if (!loaded) return kFailed;
  if (options.json) {
    // The same figures as explore prints of a run's end (report.h).
    const Measures measures = measure(loaded->structure);
    Json json;
    json["structure"] = options.structure;
    json["lattice"] = to_string(loaded->structure.lattice());
    json["bricks"] = loaded->structure.size();
    json["structure_hash"] = to_hex(structure_hash(loaded->structure));
    json["colours"] = colours_json(measures, loaded->bricks);
    json["measures"] = to_json(measures);
    app.print(dump(json));
  } else {
    app.print(bold(printable(options.structure), app.color_out()) + "\n");
    app.print(line("lattice", to_string(loaded->structure.lattice())));
    app.print(line("bricks", std::to_string(loaded->structure.size())));
    if (!loaded->structure.empty()) app.print(structure_lines(loaded->structure, loaded->bricks));
  }
  return kOk;
}

int run(const DrawOptions& options, App& app) {
  // All endings first: drawing the first file is no use if the second cannot be.
  for (const std::string& path : options.outputs) {
    std::string error;
    if (can_write_structure(path, error)) continue;
    app.complain(printable(error));
    return kUsage;
  }
  if (const std::string problem = bricks_problem(options.mesh, {options.structure});
      !problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  const auto loaded = read_structure(options.structure, options.lattice, app, options.mesh);
  if (!loaded) return kFailed;
  if (const int code = check_outputs(options.outputs, app); code != kOk) return code;
  for (const std::string& path : options.outputs) {
    std::string error;
    if (!write_structure(path, loaded->structure, loaded->bricks, stem(options.structure), false,
                         error, options.palette)) {
      app.complain(error);
      return kRunFailed;
    }
    app.say("wrote " + printable(path));
  }
  return kOk;
}

}  // namespace stig::cli
