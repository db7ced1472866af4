// SPDX-License-Identifier: MIT
// stigc convex: from a mesh to a solid that robots and scenes can have.
#include <fmt/format.h>

#include "commands.h"
#include "mesh_input.h"
#include "outputs.h"
#include "report.h"

namespace stig::cli {
namespace {

std::string lines_of(const Solid& solid) {
  const Json& report = solid.report;
  const auto number = [&](const char* key) { return report[key].get<double>(); };
  std::string out = repair_lines(report);
  if (const auto crossing = report["repairs"]["crossing_faces"].get<std::size_t>(); crossing > 0) {
    out +=
        line("crossing", fmt::format("{} of faces cross or touch: what two surfaces enclose "
                                     "weighs twice",
                                     crossing == 1 ? "1 pair" : fmt::format("{} pairs", crossing)));
  }
  const Vec3& c = solid.model.centre;
  out += line("center", fmt::format("{:.6g}, {:.6g}, {:.6g} mm", c.x * 1e3, c.y * 1e3, c.z * 1e3));
  out += line("pieces",
              fmt::format("{} with {:.6g} mm³ in all, corners left out by at most {:.3g} mm",
                          solid.model.pieces.size(), number("pieces_volume"), number("off")));
  return out + line("surface", fmt::format("{} triangles", solid.model.surface.triangles.size()));
}

}  // namespace

int run(const ConvexOptions& options, App& app) {
  if (!is_mesh(options.model)) {
    app.complain(fmt::format("'{}' is no mesh by its name, which ends in .stl, .obj, .off or .ply",
                             printable(options.model)));
    return kUsage;
  }
  const auto solid = read_mesh_solid(options, app);
  if (!solid) return kFailed;
  const std::string text = print_solid(
      solid->model,
      fmt::format("Made by stigc convex of {}; for the key `solid` of robots and scenes.",
                  solid->model.source));
  // What a model of kilometres or of micrometres makes, no robot can have.
  Diagnostics diagnostics;
  if (!read_solid(std::make_shared<SourceFile>(*options.output, text), diagnostics)) {
    app.complain(fmt::format("'{}' makes no solid for physics in the unit of --unit: {}",
                             printable(options.model), diagnostics.all().front().message));
    return kFailed;
  }
  if (const int code = check_outputs({*options.output}, app); code != kOk) return code;
  if (const int code = write_output(*options.output, text, app); code != kOk) return code;
  if (options.json) {
    app.print(dump(solid->report));
  } else {
    app.print(bold(printable(options.model), app.color_out()) + "\n");
    app.print(lines_of(*solid));
  }
  return kOk;
}

}  // namespace stig::cli
