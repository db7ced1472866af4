// SPDX-License-Identifier: MIT
// The keys of the file format as data, one list for each kind of mapping, so that a key is
// described once. Their order is the order in which a canonical file has them. Ranges are part
// of the format, and bound the work and memory that a hostile file can ask for.
#include "rules/rule_schema.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "rules/cell.h"
#include "rules/neighbourhood.h"
#include "rules/state.h"

namespace stig {

namespace {

using enum ValueKind;
constexpr double kFar = kMaxCoordinate;

// Designated initialisers name only what a key needs; the rest keeps its default. GCC warns
// of members that an initialiser leaves to their defaults, which is what these tables rely
// on.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

std::vector<KeySchema> rule_set_keys() {
  return {
      {.name = "stigc",
       .kind = integer,
       .required = true,
       .doc = "Version of the file format: 1.",
       .low = 1,
       .high = kFormatVersion},
      {.name = "name", .kind = name, .required = true, .doc = "Short name, for files and reports."},
      {.name = "title", .kind = text, .doc = "What it builds, in one line."},
      {.name = "source", .kind = text, .doc = "Where the rules come from."},
      {.name = "lattice",
       .kind = choice,
       .required = true,
       .doc = "Cubic: 26 neighbours. Hexagonal: 20, in axial coordinates.",
       .words = {"cubic", "hexagonal"}},
      {.name = "symmetry",
       .kind = choice,
       .doc = "Turns and mirrors about the vertical under which every rule holds.",
       .words = {"none", "rotations", "rotations+mirrors"}},
      {.name = "inversion", .kind = boolean, .doc = "Rules hold upside down as well."},
      {.name = "floor", .kind = boolean, .doc = "Cells below z = 0 are seen as floor (=)."},
      {.name = "conflicts",
       .kind = choice,
       .doc = "What happens when rules that place different bricks match together.",
       .words = {"error", "random", "first"}},
      {.name = "bricks",
       .kind = bricks,
       .required = true,
       .doc = "The kinds of brick, by the symbol that drawings use.",
       .object = ObjectKind::brick,
       .least = 1,
       .most = kMaxColours},
      {.name = "legend", .kind = legend, .doc = "Symbols that stand for a set of states."},
      {.name = "box", .kind = object, .doc = "A bounded world.", .object = ObjectKind::box},
      {.name = "stages",
       .kind = by_stage,
       .doc = "Deposits after which the next stage begins; without: when no rule of the stage can "
              "fire.",
       .low = 1,
       .high = 1e12},
      {.name = "start",
       .kind = objects,
       .required = true,
       .doc = "The bricks that are there before.",
       .object = ObjectKind::start_entry},
      {.name = "physical",
       .kind = object,
       .doc = "What is assumed of the robots' world; for compile and validate alone.",
       .object = ObjectKind::physical},
      {.name = "expect",
       .kind = object,
       .doc = "What `stigc test` holds the file to.",
       .object = ObjectKind::expect},
      {.name = "rules",
       .kind = objects,
       .required = true,
       .doc = "The rules.",
       .object = ObjectKind::rule,
       .least = 1,
       .most = kMaxRules},
  };
}

std::vector<KeySchema> brick_keys() {
  return {
      {.name = "name", .kind = name, .doc = "What people call it; its symbol, if left out."},
      {.name = "color", .kind = colour, .required = true, .doc = "For pictures: \"#rrggbb\"."},
      {.name = "led",
       .kind = choice,
       .doc = "Block colour of the physical layer.",
       .words = {"Q1", "Q2", "Q3", "Q4"}},
  };
}

std::vector<KeySchema> start_keys() {
  return {
      {.name = "at",
       .kind = cell,
       .required = true,
       .doc = "Cell [x, y, z].",
       .low = -kFar,
       .high = kFar},
      {.name = "brick", .kind = symbol, .required = true, .doc = "Symbol of the brick."},
  };
}

std::vector<KeySchema> rule_keys() {
  return {
      {.name = "name", .kind = name, .required = true, .doc = "Unique among the rules."},
      {.name = "stage",
       .kind = integer,
       .doc = "The one stage in which the rule is active.",
       .low = 1,
       .high = kMaxStage},
      {.name = "place", .kind = symbol, .required = true, .doc = "Symbol of the brick to place."},
      {.name = "probability",
       .kind = number,
       .doc = "Chance to fire when chosen.",
       .low = 0,
       .high = 1,
       .above_low = true},
      {.name = "weight",
       .kind = number,
       .doc = "Share in `conflicts: random`.",
       .low = 0,
       .high = 1e9,
       .above_low = true},
      {.name = "symmetry",
       .kind = choice,
       .doc = "For this rule alone.",
       .words = {"none", "rotations", "rotations+mirrors"}},
      {.name = "inversion", .kind = boolean, .doc = "For this rule alone."},
      {.name = "when",
       .kind = drawing,
       .required = true,
       .doc = "The neighbourhood: slices above, level, below side by side."},
      {.name = "height",
       .kind = object,
       .doc = "Height of the site; the floor's first layer is 0.",
       .object = ObjectKind::height},
      {.name = "count",
       .kind = objects,
       .doc = "How many neighbours show what.",
       .object = ObjectKind::count},
  };
}

std::vector<KeySchema> height_keys() {
  return {
      {.name = "min", .kind = integer, .doc = "Lowest.", .low = -kFar, .high = kFar},
      {.name = "max", .kind = integer, .doc = "Highest.", .low = -kFar, .high = kFar},
  };
}

std::vector<KeySchema> count_keys() {
  return {
      {.name = "of",
       .kind = symbols,
       .required = true,
       .doc = "Symbols that are counted.",
       .least = 1},
      {.name = "among",
       .kind = choice,
       .doc = "All neighbours, or those that share a face.",
       .words = {"faces", "all"}},
      {.name = "min", .kind = integer, .doc = "Fewest.", .low = 0, .high = kMaxNeighbours},
      {.name = "max", .kind = integer, .doc = "Most.", .low = 0, .high = kMaxNeighbours},
  };
}

std::vector<KeySchema> box_keys() {
  return {
      {.name = "size",
       .kind = cell,
       .required = true,
       .doc = "Cells along [x, y, z].",
       .low = 1,
       .high = kFar},
      {.name = "origin",
       .kind = cell,
       .doc = "Lowest cell; if left out, the box is laid around the start.",
       .low = -kFar,
       .high = kFar},
      {.name = "periodic", .kind = boolean, .doc = "Opposite sides are joined."},
  };
}

std::vector<KeySchema> physical_keys() {
  return {
      {.name = "sides",
       .kind = choices,
       .doc = "Robots work from these sides only.",
       .words = {"+x", "-x", "+y", "-y"},
       .most = 4},
      {.name = "robots", .kind = integer, .doc = "How many.", .low = 1, .high = 1000},
  };
}

std::vector<KeySchema> expect_keys() {
  return {
      {.name = "bricks",
       .kind = integer,
       .doc = "Bricks in the end, the start included.",
       .low = 1,
       .high = 1e12},
      {.name = "verdict",
       .kind = choice,
       .doc = "Do all orders of events end alike?",
       .words = {"coordinated", "order-dependent", "endless"}},
      {.name = "structure",
       .kind = drawing,
       .doc = "The structure in the end: slices from the top down, parted by ---."},
  };
}

#pragma GCC diagnostic pop

}  // namespace

const ObjectSchema& object_schema(ObjectKind kind) {
  // In the order of ObjectKind; the assertion below checks it at every use.
  static const std::array<ObjectSchema, 9> kTable = {{
      {ObjectKind::rule_set, "rule set", "stigc: 1 …", rule_set_keys()},
      {ObjectKind::brick, "brick", "{color: \"#8d99ae\"}", brick_keys()},
      {ObjectKind::start_entry, "start entry", "{at: [0, 0, 0], brick: 1}", start_keys()},
      {ObjectKind::rule, "rule", "{name: …, place: …, when: …}", rule_keys()},
      {ObjectKind::height, "height", "{min: 0, max: 3}", height_keys()},
      {ObjectKind::count, "count", "{of: [1], min: 2}", count_keys()},
      {ObjectKind::box, "box", "{size: [9, 9, 4]}", box_keys()},
      {ObjectKind::physical, "physical", "{sides: [+x]}", physical_keys()},
      {ObjectKind::expect, "expect", "{bricks: 6}", expect_keys()},
  }};
  const ObjectSchema& found = kTable[static_cast<std::size_t>(kind)];
  assert(found.kind == kind);
  return found;
}

const KeySchema& key_schema(ObjectKind kind, std::string_view path) {
  const std::size_t slash = path.find('/');
  const auto& keys = object_schema(kind).keys;
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeySchema& key) {
    return key.name == path.substr(0, slash);
  });
  assert(found != keys.end());
  return slash == std::string_view::npos ? *found
                                         : key_schema(found->object, path.substr(slash + 1));
}

bool is_reserved_symbol(std::string_view symbol) {
  static constexpr std::array<std::string_view, 6> kReserved = {".", "*", "?", "#", "=", "---"};
  return std::find(kReserved.begin(), kReserved.end(), symbol) != kReserved.end();
}

}  // namespace stig
