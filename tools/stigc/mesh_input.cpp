// SPDX-License-Identifier: MIT
#include "mesh_input.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/file_guard.h"
#include "child_process.h"
#include "report.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPrinted = std::size_t{1} << 28;

/// An absolute name is no option, whatever it begins with.
std::string absolute_name(const std::string& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).string();
}

/// What a mesh is measured in; the program for meshes knows none.
std::vector<std::string> arguments_for(const std::string& path, const MeshOptions& options) {
  std::vector<std::string> out{absolute_name(path), options.shell ? "shell" : "solid", options.up};
  if (options.side) {
    out.insert(out.end(), {"side", fmt::format("{}", *options.side / options.unit)});
  } else {
    out.insert(out.end(), {"bricks", std::to_string(options.bricks.value_or(kUsualBricks))});
  }
  return out;
}

/// The answer as JSON, or nothing with `problem` set.
std::optional<Json> ask(const std::string& program, const std::vector<std::string>& arguments,
                        std::string& problem) {
  const auto finished = run_program(program, arguments, kMostPrinted, problem);
  if (!finished) return std::nullopt;
  Json answer = Json::parse(finished->out, nullptr, false);
  if (finished->exit_code > 1 || finished->exit_code < 0 || !answer.is_object()) {
    problem = finished->exit_code < 0 ? "took more time or memory than stigc-mesh is given"
                                      : "stigc-mesh failed: " + printable(finished->words);
    return std::nullopt;
  }
  if (answer.contains("problem")) {
    problem = printable(answer["problem"].get<std::string>());
    return std::nullopt;
  }
  return answer;
}

LoadedStructure structure_of(const Json& cells) {
  LoadedStructure out;
  out.bricks = {{"1", "brick", "#4363d8", "", {}}};
  out.placed = false;
  for (const Json& cell : cells) {
    out.structure.place({cell[0].get<int>(), cell[1].get<int>(), cell[2].get<int>()}, 1);
  }
  return out;
}

std::string counted(std::size_t count, std::string_view one, std::string_view more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

/// What of a mesh was not as it should be, and was mended.
std::string repairs_in_words(const Json& repairs) {
  struct Repair {
    const char* key;
    std::string_view one, more;
  };
  constexpr Repair kRepairs[] = {
      {"duplicate_points", "corner merged with another", "corners merged with others"},
      {"degenerate_faces", "face without area left out", "faces without area left out"},
      {"split_points", "corner split between surfaces", "corners split between surfaces"},
      {"turned_surfaces", "surface turned outside in", "surfaces turned outside in"},
      {"holes", "hole closed", "holes closed"},
      {"flat_surfaces", "surface without volume left out", "surfaces without volume left out"}};
  std::string out;
  for (const Repair& repair : kRepairs) {
    const auto count = repairs[repair.key].get<std::size_t>();
    if (count == 0) continue;
    out += (out.empty() ? "" : ", ") + counted(count, repair.one, repair.more);
  }
  return out.empty() ? "nothing" : out;
}

}  // namespace

bool is_mesh(const std::string& path) { return is_mesh_name(path); }

std::optional<std::string> find_mesh_program() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const std::string program = (self.parent_path() / "stigc-mesh").string();
  if (access(program.c_str(), X_OK) != 0) return std::nullopt;
  return program;
}

std::string bricks_problem(const MeshOptions& options, const std::vector<std::string>& files) {
  if (!options.bricks || std::any_of(files.begin(), files.end(), is_mesh)) return {};
  return "--bricks is about meshes (.stl .obj .off .ply), and none is given";
}

namespace {

/// What stigc-mesh says of a mesh; problems are complained of.
std::optional<Json> answer_of(const std::string& path, const std::vector<std::string>& arguments,
                              const App& app) {
  const auto program = find_mesh_program();
  if (!program) {
    app.complain(fmt::format(
        "'{}' is a mesh, which the program stigc-mesh reads; it is not here: install the package "
        "stigc-mesh, or install libcgal-dev and build again",
        printable(path)));
    return std::nullopt;
  }
  if (const auto number = file_number(path)) note_read(*number);
  std::string problem;
  auto answer = ask(*program, arguments, problem);
  if (!answer) app.complain(fmt::format("'{}' {}", printable(path), problem));
  return answer;
}

/// Three numbers, of lengths to the power of `power`.
Vec3 vec_from(const Json& json, double unit) {
  return Vec3{json[0].get<double>(), json[1].get<double>(), json[2].get<double>()} * unit;
}

/// From the file's unit to metres; divided last, so that whole millimetres stay short numbers.
Vec3 place_from(const Json& json, double unit) {
  const Vec3 p = vec_from(json, unit);
  return {p.x / 1000, p.y / 1000, p.z / 1000};
}

}  // namespace

std::optional<Voxels> voxelise(const std::string& path, const MeshOptions& options,
                               const App& app) {
  auto answer = answer_of(path, arguments_for(path, options), app);
  if (!answer) return std::nullopt;
  Voxels out{structure_of((*answer)["cells"]), std::move(*answer)};
  out.report.erase("cells");
  out.report["side"] = out.report["side"].get<double>() * options.unit;
  Json& repairs = out.report["repairs"];
  repairs["volume"] = repairs["volume"].get<double>() * options.unit * options.unit * options.unit;
  return out;
}

std::optional<Solid> read_mesh_solid(const ConvexOptions& options, const App& app) {
  auto answer = answer_of(
      options.model,
      {absolute_name(options.model), "convex", options.up, "pieces", std::to_string(options.parts)},
      app);
  if (!answer) return std::nullopt;
  const double unit = options.unit, cube = unit * unit * unit;
  Solid out;
  SolidModel& solid = out.model;
  const fs::path path(options.model);
  solid.name = printable(path.stem().string());
  solid.source = printable(path.filename().string());
  const auto volume = (*answer)["volume"].get<double>();
  solid.volume = volume * cube / 1e9;
  solid.centre = place_from((*answer)["center"], unit);
  const double square = unit * unit / (volume * 1e6);
  solid.squares = vec_from((*answer)["squares"], square);
  solid.products = vec_from((*answer)["products"], square);
  for (const Json& piece : (*answer)["pieces"]) {
    solid.pieces.emplace_back();
    for (const Json& corner : piece) solid.pieces.back().push_back(place_from(corner, unit));
  }
  for (const Json& p : (*answer)["points"]) solid.surface.points.push_back(place_from(p, unit));
  for (const Json& t : (*answer)["triangles"]) {
    solid.surface.triangles.push_back(t.get<std::array<std::uint32_t, 3>>());
  }
  (*answer)["repairs"]["volume"] = (*answer)["repairs"]["volume"].get<double>() * cube;
  out.report = {{"faces", (*answer)["faces"]},
                {"repairs", (*answer)["repairs"]},
                {"volume", volume * cube},
                {"pieces", solid.pieces.size()},
                {"pieces_volume", (*answer)["pieces_volume"].get<double>() * cube},
                {"off", (*answer)["off"].get<double>() * unit},
                {"triangles", solid.surface.triangles.size()}};
  return out;
}

std::string repair_lines(const Json& report) {
  const Json& repairs = report["repairs"];
  const auto solids = repairs["solids"].get<std::size_t>();
  const auto hollows = repairs["hollows"].get<std::size_t>();
  std::string out = line("faces", std::to_string(report["faces"].get<std::size_t>()));
  out += line("repaired", repairs_in_words(repairs));
  std::string parts = counted(solids, "solid", "solids");
  if (hollows > 0) parts += ", " + counted(hollows, "hollow", "hollows");
  return out +
         line("surfaces", fmt::format("{}, {:.6g} mm³", parts, repairs["volume"].get<double>()));
}

std::string mesh_lines(const Voxels& voxels) {
  const Json& report = voxels.report;
  const Json& repairs = report["repairs"];
  const auto count = [&](const char* key) { return report[key].get<std::size_t>(); };
  std::string out = repair_lines(report);
  if (const auto crossing = repairs["crossing_faces"].get<std::size_t>(); crossing > 0) {
    out += line("crossing", counted(crossing, "pair of faces", "pairs of faces") +
                                " cross or touch: what any surface encloses is filled");
  }
  out +=
      line("bricks", fmt::format("{} of {:.6g} mm, {} on the floor", voxels.loaded.structure.size(),
                                 report["side"].get<double>(), count("on_floor")));
  if (const auto added = count("joined"); added > 0) {
    out += line("joined", counted(added, "brick", "bricks") +
                              " added where parts met at an edge or a corner alone");
  }
  if (const auto left = count("cells_left_out"); left > 0) {
    out += line("left out", fmt::format("{} in {}, which stand apart from the largest",
                                        counted(left, "brick", "bricks"),
                                        counted(count("parts_left_out"), "part", "parts")));
  }
  const auto overhanging = count("overhanging");
  out += line("overhang", overhanging == 0
                              ? "none: each brick stands on another or the floor"
                              : counted(overhanging, "brick has", "bricks have") + " none beneath");
  return out;
}

}  // namespace stig::cli
