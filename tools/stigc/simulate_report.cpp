// SPDX-License-Identifier: MIT
// What is told of a run: how it ended, what moved, what the robots did, and which lattices the
// blocks form now. A trace and a run are drawn by the same functions, so that replay's pictures are
// those of simulate.
#include "simulate_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app.h"
#include "base/degree.h"
#include "base/file_io.h"
#include "base/hash.h"
#include "physical/render/show_json.h"
#include "physical/simulation/run_picture.h"
#include "report.h"

namespace stig::cli {
namespace {

// Lists are cut for people; JSON has all.
constexpr std::size_t kMostLattices = 12;
constexpr std::size_t kMostListed = 12;

std::string plural(std::size_t number, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", number, number == 1 ? one : many);
}

std::string some_names(const std::vector<std::string>& names) {
  const auto shown = std::min(names.size(), kMostListed);
  std::string out = fmt::format(
      "{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  return shown < names.size() ? out + fmt::format(" and {} more", names.size() - shown) : out;
}

std::string end_in_words(const SimulationReport& r) {
  // Every end has its words, but for divergence, which has its message.
  switch (r.end) {
    case RunEnd::duration:
      return fmt::format("after {:.3f} s, {}", r.time, plural(r.ticks, "tick", "ticks"));
    case RunEnd::asleep:
      return fmt::format("asleep after {:.3f} s, {}", r.time, plural(r.ticks, "tick", "ticks"));
    case RunEnd::interrupted:
      return fmt::format("interrupted after {:.3f} s", r.time);
    case RunEnd::failed:
      return fmt::format("all robots' programs failed after {:.3f} s", r.time);
    case RunEnd::script:
      return fmt::format("{} after {:.3f} s{}",
                         r.script_failed ? "the script failed" : "stopped by the script", r.time,
                         r.script_failed || r.message.empty() ? "" : ": " + printable(r.message));
    case RunEnd::diverged:
      break;
  }
  return r.message;
}

std::string moved_in_words(const SimulationReport& r) {
  if (r.moved == 0) return fmt::format("nothing by more than {} mm", kMovedFrom * 1e3);
  return fmt::format("{} by more than {} mm; '{}' by {:.1f} mm", r.moved, kMovedFrom * 1e3,
                     printable(r.farthest_name), r.farthest * 1e3);
}

// The size in cells along the lattice's own axes.
std::string size_in_words(const ReadLattice& lattice) {
  LatticeCell size;
  for (const ReadBlock& block : lattice.blocks) {
    // Cells count from 0, so the largest plus one is the size.
    size = {std::max(size.x, block.cell.x + 1), std::max(size.y, block.cell.y + 1),
            std::max(size.z, block.cell.z + 1)};
  }
  return fmt::format("{}×{}×{}", size.x, size.y, size.z);
}

/// The worst of a lattice's blocks: m and rad.
std::pair<double, double> misfit(const ReadLattice& lattice) {
  double offset = 0, turn = 0;
  for (const ReadBlock& block : lattice.blocks) {
    offset = std::max(offset, block.offset);
    turn = std::max(turn, block.turn);
  }
  return {offset, turn};
}

/// Degrees to a tenth, and no minus before nothing. A yaw of -0.04° is none that anybody sees.
/// Adding 0.0 turns -0.0 into 0.0.
double tenths(double radians) { return std::round(radians / kDegree * 10) / 10 + 0.0; }

Json vec_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

StructureReading structure_of(const std::vector<PictureBody>& bodies) {
  std::vector<PlacedBlock> blocks;
  double side = 0;
  for (const PictureBody& body : bodies) {
    if (!body.block) continue;
    // All blocks have one side where a lattice is read; the first says which.
    if (side == 0) side = 2 * body.shape.half.x;
    blocks.push_back({body.X_WB, static_cast<std::uint8_t>(body.led)});
  }
  return blocks.empty() ? StructureReading{} : read_lattices(blocks, side);
}

SimulationReport report_of(const Scene& scene, const Simulation& run, RunEnd end, double seconds) {
  const World& world = run.world();
  const PlacedScene& placed = run.placed();
  SimulationReport r;
  r.title = scene.title;
  r.seed = placed.seed;
  r.ticks = world.tick();
  r.hash = run.hash();
  r.time = world.time();
  r.seconds = seconds;
  r.end = end;
  r.message = run.message();
  r.bodies = world.size();
  r.awake = world.awake_count();
  r.tally = run.tally();
  for (const std::uint32_t body : r.tally.left) r.left.push_back(placed.bodies[body].name);
  for (std::size_t i = 0; i < world.size(); ++i) {
    // What came while the scene ran was not there to be moved.
    const bool dropped = i >= placed.config.bodies.size();
    r.fixed += !dropped && placed.config.bodies[i].fixed ? 1 : 0;
    const BodyState state = world.state(BodyId{static_cast<std::uint32_t>(i)});
    if (state.left) continue;
    // Names beside `structure`, which knows blocks by their numbers.
    if (placed.bodies[i].block) r.names.push_back(placed.bodies[i].name);
    if (dropped) continue;
    const double way = length(state.X_WB.p - placed.config.bodies[i].X_WB.p);
    r.moved += way > kMovedFrom ? 1 : 0;
    if (way <= r.farthest) continue;
    r.farthest = way;
    r.farthest_name = placed.bodies[i].name;
  }
  r.structure = structure_of(picture_bodies(run));
  r.measures = run.measures();
  r.script_failed = run.script_failed();
  for (std::size_t i = 0; run.crew() != nullptr && i < run.crew()->robots(); ++i) {
    r.robots.push_back({run.crew()->robot_name(i), run.crew()->robot_pose(world, i),
                        run.crew()->failed(i), run.crew()->halted(i), run.driven(i)});
  }
  if (run.crew() != nullptr) {
    r.failed_blocks = run.crew()->failed_blocks();
    r.programs_failed = run.crew()->programs_failed();
  }
  return r;
}

Json structure_json(const StructureReading& structure, const std::vector<std::string>& names) {
  Json json;
  json["lattices"] = Json::array();
  for (const ReadLattice& lattice : structure.lattices) {
    Json one;
    one["at"] = vec_json(lattice.X_WL.p);
    one["pitch_mm"] = lattice.pitch * 1e3;
    one["yaw_degrees"] = lattice.yaw / kDegree;
    one["tilt_degrees"] = lattice.tilt / kDegree;
    one["blocks"] = Json::array();
    for (const ReadBlock& block : lattice.blocks) {
      one["blocks"].push_back({{"name", names[block.block]},
                               {"cell", {block.cell.x, block.cell.y, block.cell.z}},
                               {"color", kLedNames[block.colour]},
                               {"offset_mm", block.offset * 1e3},
                               {"turn_degrees", block.turn / kDegree}});
    }
    json["lattices"].push_back(std::move(one));
  }
  json["loose"] = Json::array();
  for (const std::size_t block : structure.loose) json["loose"].push_back(names[block]);
  return json;
}

Json to_json(const SimulationReport& r) {
  Json json;
  json["title"] = r.title;
  json["seed"] = r.seed;
  json["end"] = to_string(r.end);
  json["message"] = r.message;
  json["time"] = r.time;
  json["ticks"] = r.ticks;
  json["bodies"] = r.bodies;
  json["fixed"] = r.fixed;
  json["awake"] = r.awake;
  json["moved"] = r.moved;
  json["farthest_mm"] = r.farthest * 1e3;
  json["contacts"] = r.tally.contacts;
  json["slept"] = r.tally.slept;
  json["woke"] = r.tally.woke;
  json["snapped"] = r.tally.snapped;
  json["let_go"] = r.tally.let_go;
  json["left"] = r.left;
  json["robots"] = Json::array();
  for (const ScriptRobot& robot : r.robots) {
    json["robots"].push_back({{"name", robot.name},
                              {"at", vec_json(robot.X_WR.p)},
                              {"driven_m", robot.driven},
                              {"failed", robot.failed},
                              {"halted", robot.halted}});
  }
  json["failed_blocks"] = r.failed_blocks;
  json["measures"] = r.measures;
  json["structure"] = structure_json(r.structure, r.names);
  json["hash"] = to_hex(r.hash);
  json["seconds"] = r.seconds;
  // Zero where it was too quick to be measured.
  json["real_time_factor"] = r.seconds > 0 ? r.time / r.seconds : 0;
  return json;
}

std::string structure_in_lines(const StructureReading& structure) {
  std::string out;
  // The largest first; the rest are counted.
  for (std::size_t i = 0; i < std::min(structure.lattices.size(), kMostLattices); ++i) {
    const ReadLattice& lattice = structure.lattices[i];
    const auto [offset, turn] = misfit(lattice);
    out += line(i == 0 ? "lattices" : "",
                fmt::format("{} blocks, {}, yaw {:.1f}°, tilt {:.1f}°, fit {:.2f} mm and {:.2f}°",
                            lattice.blocks.size(), size_in_words(lattice), tenths(lattice.yaw),
                            tenths(lattice.tilt), offset * 1e3, turn / kDegree));
  }
  if (structure.lattices.size() > kMostLattices) {
    out += line("", fmt::format("and {} more", structure.lattices.size() - kMostLattices));
  }
  return out + line("loose", plural(structure.loose.size(), "block", "blocks"));
}

std::string lines_of(const SimulationReport& r, bool speed) {
  std::string out = line("scene", printable(r.title));
  out +=
      line("bodies", fmt::format("{}{}, seed {}", r.bodies,
                                 r.fixed > 0 ? fmt::format(" ({} fixed)", r.fixed) : "", r.seed));
  out += line("end", end_in_words(r));
  out += line("moved", moved_in_words(r));
  out += line(
      "asleep",
      fmt::format("{} of {}; fell asleep {}, woke {}", r.bodies - r.awake - r.left.size(), r.bodies,
                  plural(r.tally.slept, "time", "times"), plural(r.tally.woke, "time", "times")));
  out += line("contacts", fmt::format("{} began", r.tally.contacts));
  out += line("magnets", fmt::format("snapped together {}, let go {}",
                                     plural(r.tally.snapped, "time", "times"),
                                     plural(r.tally.let_go, "time", "times")));
  if (!r.left.empty()) out += line("left", printable(some_names(r.left)) + " left the arena");
  for (std::size_t i = 0; i < std::min(r.robots.size(), kMostListed); ++i) {
    const ScriptRobot& robot = r.robots[i];
    out += line(i == 0 ? "robots" : "",
                fmt::format("{}, {:.3f} m driven{}", printable(robot.name), robot.driven,
                            robot.halted   ? ", halted"
                            : robot.failed ? ", its program failed"
                                           : ""));
  }
  if (r.robots.size() > kMostListed) {
    out += line("", fmt::format("and {} more", r.robots.size() - kMostListed));
  }
  if (!r.failed_blocks.empty()) {
    out += line("failed", fmt::format("{} of {}",
                                      r.failed_blocks.size() == 1 ? "the program" : "the programs",
                                      printable(some_names(r.failed_blocks))));
  }
  for (const auto& [name, value] : r.measures) {
    out += line("measure", fmt::format("{} {:g}", printable(name), value));
  }
  out += structure_in_lines(r.structure);
  out += line("hash", to_hex(r.hash));
  // Left out of what is compared: it is the only line that differs from run to run.
  if (speed && r.seconds > 0) {
    out += line("speed", fmt::format("{:.1f} times real time", r.time / r.seconds));
  }
  return out;
}

namespace {

/// A table of what scripts have measured; empty when they have not.
std::string measures_of(const std::vector<SimulationReport>& runs) {
  std::set<std::string> names;
  for (const SimulationReport& r : runs) {
    for (const auto& [name, value] : r.measures) names.insert(name);
  }
  if (names.empty()) return {};
  std::string out = fmt::format("\n{:>8}", "seed");
  for (const std::string& name : names) out += fmt::format("  {:>12}", printable(name));
  for (const SimulationReport& r : runs) {
    out += fmt::format("\n{:>8}", r.seed);
    for (const std::string& name : names) {
      const auto found = r.measures.find(name);
      // A script need not measure the same in every run.
      out += found == r.measures.end() ? fmt::format("  {:>12}", "-")
                                       : fmt::format("  {:>12g}", found->second);
    }
  }
  return out + "\n";
}

}  // namespace

std::string table_of(const std::vector<SimulationReport>& runs) {
  std::string out =
      fmt::format("{:>8}  {:<11} {:>9} {:>6} {:>6} {:>8} {:>5} {:>8} {:>7}  {}\n", "seed", "end",
                  "time/s", "awake", "moved", "snapped", "left", "lattices", "largest", "hash");
  for (const SimulationReport& r : runs) {
    const auto& lattices = r.structure.lattices;
    out += fmt::format("{:>8}  {:<11} {:>9.3f} {:>6} {:>6} {:>8} {:>5} {:>8} {:>7}  {}\n", r.seed,
                       to_string(r.end), r.time, r.awake, r.moved, r.tally.snapped, r.left.size(),
                       lattices.size(), lattices.empty() ? 0 : lattices[0].blocks.size(),
                       to_hex(r.hash));
  }
  return out + measures_of(runs);
}

std::string picture_caption(const std::string& title, double time, double grid) {
  // The middle dot parts what the picture is of from what it shows.
  std::string caption = title.empty() ? "" : printable(title) + " · ";
  caption += fmt::format("{:.2f} s", time);
  if (grid > 0) caption += fmt::format(" · grid {:g} m", grid);
  return caption;
}

bool write_picture(const std::string& path, const std::vector<PictureBody>& bodies,
                   const std::vector<PictureLine>& lines, bool floor, const std::string& title,
                   double time, std::string& error) {
  PictureLook look;
  const ScenePicture picture = draw_bodies(bodies, fitted_view(bodies, look), floor, lines);
  FileError failure;
  const std::string caption = picture_caption(title, time, floor ? picture.grid : 0);
  const bool good = write_file(path, png_of(picture.image, caption), failure);
  error = failure.message;
  return good;
}

}  // namespace stig::cli
