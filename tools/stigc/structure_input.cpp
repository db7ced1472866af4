// SPDX-License-Identifier: MIT
// Two ways to read a structure: as its file has it, or in terms of a rule set, whose symbols and
// colours decide then.
#include "structure_input.h"

#include <fmt/format.h>

#include "lattice/structure_files.h"
#include "mesh_input.h"

namespace stig::cli {
namespace {

std::optional<LoadedStructure> read(const std::string& path, const StructureReadOptions& options,
                                    const App& app) {
  Diagnostics diagnostics;
  auto loaded = read_structure_file(path, options, diagnostics);
  app.report(diagnostics);
  if (app.invalid(diagnostics)) loaded.reset();
  return loaded;
}

std::optional<LoadedStructure> read_mesh(const std::string& path, std::optional<Lattice> lattice,
                                         const MeshOptions& mesh, const App& app) {
  if (lattice == Lattice::hexagonal) {
    app.complain(fmt::format("'{}' is a mesh, which becomes cubes", printable(path)));
    return std::nullopt;
  }
  auto voxels = voxelise(path, mesh, app);
  if (!voxels) return std::nullopt;
  app.say(fmt::format("{}: {} bricks, each {:.6g} mm of the mesh wide", printable(path),
                      voxels->loaded.structure.size(), voxels->report["side"].get<double>()));
  return std::move(voxels->loaded);
}

/// The set's colour for a brick of the file; 0 when there is none.
Colour counterpart(const RuleSet& rules, const Brick& brick) {
  // Symbols first: two bricks may be painted alike, but not called alike.
  if (const Colour by_symbol = rules.colour_of(brick.symbol)) return by_symbol;
  for (std::size_t k = 0; k < rules.bricks.size(); ++k) {
    if (rules.bricks[k].color == brick.color) return static_cast<Colour>(k + 1);
  }
  return 0;
}

}  // namespace

std::optional<LoadedStructure> read_structure(const std::string& path,
                                              std::optional<Lattice> lattice, const App& app,
                                              const MeshOptions& mesh) {
  if (is_mesh(path)) return read_mesh(path, lattice, mesh, app);
  return read(path, {lattice, {}}, app);
}

std::optional<Structure> read_structure_for(const RuleSet& rules, const std::string& path,
                                            const App& app) {
  // The set's bricks give symbols to files that have none of their own.
  auto loaded = read(path, {rules.lattice, rules.bricks}, app);
  if (!loaded) return std::nullopt;
  if (!loaded->placed) {
    app.say(fmt::format("{}: the file names no place; its lowest corner is taken to be (0, 0, 0)",
                        printable(path)));
  }
  Structure structure(rules.lattice);
  for (const PlacedBrick& placed : loaded->structure.bricks()) {
    // Colours count from 1.
    const Brick& brick = loaded->bricks[placed.brick - 1U];
    const Colour colour = counterpart(rules, brick);
    if (colour == 0) {
      app.complain(fmt::format("'{}' has bricks '{}' ({}), which the rule set does not",
                               printable(path), printable(brick.symbol), printable(brick.color)));
      return std::nullopt;
    }
    structure.place(placed.at, colour);
  }
  return structure;
}

}  // namespace stig::cli
