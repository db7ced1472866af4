// SPDX-License-Identifier: MIT
// stigc voxelise: from a mesh to bricks.
#include <fmt/format.h>

#include "base/hash.h"
#include "commands.h"
#include "lattice/structure_files.h"
#include "mesh_input.h"
#include "outputs.h"
#include "report.h"

namespace stig::cli {

int run(const VoxeliseOptions& options, App& app) {
  if (!is_mesh(options.model)) {
    app.complain(fmt::format("'{}' is no mesh by its name, which ends in .stl, .obj, .off or .ply",
                             printable(options.model)));
    return kUsage;
  }
  for (const std::string& path : options.outputs) {
    std::string error;
    if (can_write_structure(path, error)) continue;
    app.complain(printable(error));
    return kUsage;
  }
  const auto voxels = voxelise(options.model, options.mesh, app);
  if (!voxels) return kFailed;
  if (const int code = check_outputs(options.outputs, app); code != kOk) return code;
  const LoadedStructure& loaded = voxels->loaded;
  for (const std::string& path : options.outputs) {
    std::string error;
    if (!write_structure(path, loaded.structure, loaded.bricks, file_name(options.model), true,
                         error)) {
      app.complain(error);
      return kRunFailed;
    }
    app.say("wrote " + printable(path));
  }
  if (options.json) {
    Json json = voxels->report;
    json["bricks"] = loaded.structure.size();
    json["structure_hash"] = to_hex(structure_hash(loaded.structure));
    app.print(dump(json));
  } else {
    app.print(bold(printable(options.model), app.color_out()) + "\n");
    app.print(mesh_lines(*voxels));
  }
  return kOk;
}

}  // namespace stig::cli
