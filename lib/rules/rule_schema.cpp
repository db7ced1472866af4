// SPDX-License-Identifier: MIT
// The keys of the file format as data, one list for each kind of mapping, so that a key is
// described once. Their order is the order in which a canonical file has them. Ranges are part
// of the format, and bound the work and memory that a hostile file can ask for.
#include "rules/rule_schema.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/led_name.h"
#include "rules/cell.h"
#include "rules/neighbourhood.h"
#include "rules/rule.h"
#include "rules/rule_kinds.h"
#include "rules/state.h"

namespace stig::rules {

namespace {

using enum FormKind;
constexpr double kFar = kMaxCoordinate;
constexpr std::string_view kCell = "three whole numbers [x, y, z]";

// Designated initialisers name only what a key needs; the rest keeps its default. GCC warns
// of members that an initialiser leaves to their defaults, which is what these tables rely
// on.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

/// Keys that name what is built come first, then the world, then what acts in it, so that a file
/// can be read from the top down.
std::vector<FormKey> rule_set_keys() {
  static const FormKey kBrick{.name = "bricks", .kind = form, .form = &brick_form()};
  static const FormKey kStates{.name = "legend", .kind = own, .own = &kStatesKind};
  static const FormKey kDeposits{.name = "stages", .kind = integer, .low = 1, .high = 1e12};
  return {
      {.name = "stigc",
       .kind = version,
       .required = true,
       .doc = "Version of the file format: 1.",
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
       .kind = map,
       .required = true,
       .doc = "The kinds of brick, by the symbol that drawings use.",
       .least = 1,
       .most = kMaxColours,
       .own = &kSymbolKind,
       .entry = &kBrick,
       .wanted = "symbols and their bricks, like 1: {color: \"#8d99ae\"}"},
      {.name = "legend",
       .kind = map,
       .doc = "Symbols that stand for a set of states.",
       .own = &kSymbolKind,
       .entry = &kStates,
       .wanted = "symbols and their lists, like a: [1, 2]"},
      {.name = "box", .kind = form, .doc = "A bounded world.", .form = &box_form()},
      {.name = "stages",
       .kind = map,
       .doc = "Deposits after which the next stage begins; without: when no rule of the stage can "
              "fire.",
       .own = &kStageKind,
       .entry = &kDeposits,
       .wanted = "stages and their numbers, like 1: 24"},
      {.name = "start",
       .kind = forms,
       .required = true,
       .doc = "The bricks that are there before.",
       .form = &start_form()},
      {.name = "physical",
       .kind = form,
       .doc = "What is assumed of the robots' world; for compile and validate alone.",
       .form = &physical_form()},
      {.name = "expect",
       .kind = form,
       .doc = "What `stigc test` holds the file to.",
       .form = &expect_form()},
      {.name = "rules",
       .kind = forms,
       .required = true,
       .doc = "The rules.",
       .form = &rule_form(),
       .least = 1,
       .most = kMaxRules},
  };
}

std::vector<FormKey> brick_keys() {
  return {
      {.name = "name", .kind = name, .doc = "What people call it; its symbol, if left out."},
      {.name = "color", .kind = colour, .required = true, .doc = "For pictures: \"#rrggbb\"."},
      {.name = "led",
       .kind = choice,
       .doc = "Block colour of the physical layer; from Q5 on a code word of its LEDs.",
       .words = {kLedNames.begin() + 1, kLedNames.end()}},
  };
}

std::vector<FormKey> start_keys() {
  return {
      {.name = "at",
       .kind = integers,
       .required = true,
       .doc = "Cell [x, y, z].",
       .low = -kFar,
       .high = kFar,
       .least = 3,
       .most = 3,
       .wanted = kCell},
      {.name = "brick",
       .kind = own,
       .required = true,
       .doc = "Symbol of the brick.",
       .own = &kSymbolKind},
  };
}

std::vector<FormKey> rule_keys() {
  return {
      {.name = "name", .kind = name, .required = true, .doc = "Unique among the rules."},
      {.name = "stage",
       .kind = integer,
       .doc = "The one stage in which the rule is active.",
       .low = 1,
       .high = kMaxStage},
      {.name = "place",
       .kind = own,
       .required = true,
       .doc = "Symbol of the brick to place.",
       .own = &kSymbolKind},
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
       .kind = own,
       .required = true,
       .doc = "The neighbourhood: slices above, level, below side by side.",
       .own = &kDrawingKind},
      {.name = "height",
       .kind = form,
       .doc = "Height of the site; the floor's first layer is 0.",
       .form = &height_form()},
      {.name = "count",
       .kind = forms,
       .doc = "How many neighbours show what.",
       .form = &count_form()},
  };
}

std::vector<FormKey> height_keys() {
  return {
      {.name = "min", .kind = integer, .doc = "Lowest.", .low = -kFar, .high = kFar},
      {.name = "max", .kind = integer, .doc = "Highest.", .low = -kFar, .high = kFar},
  };
}

std::vector<FormKey> count_keys() {
  return {
      {.name = "of",
       .kind = own,
       .required = true,
       .doc = "Symbols that are counted.",
       .own = &kStatesKind},
      {.name = "among",
       .kind = choice,
       .doc = "All neighbours, or those that share a face.",
       .words = {"faces", "all"}},
      {.name = "min", .kind = integer, .doc = "Fewest.", .low = 0, .high = kMaxNeighbours},
      {.name = "max", .kind = integer, .doc = "Most.", .low = 0, .high = kMaxNeighbours},
  };
}

/// One box for all runs; a command's --box takes its place.
std::vector<FormKey> box_keys() {
  return {
      {.name = "size",
       .kind = integers,
       .required = true,
       .doc = "Cells along [x, y, z].",
       .low = 1,
       .high = kFar,
       .least = 3,
       .most = 3,
       .wanted = kCell},
      {.name = "origin",
       .kind = integers,
       .doc = "Lowest cell; if left out, the box is laid around the start.",
       .low = -kFar,
       .high = kFar,
       .least = 3,
       .most = 3,
       .wanted = kCell},
      {.name = "periodic", .kind = boolean, .doc = "Opposite sides are joined."},
  };
}

/// The rules themselves know nothing of robots: these are for whoever lets robots follow them.
std::vector<FormKey> physical_keys() {
  return {
      {.name = "sides",
       .kind = choices,
       .doc = "Robots work from these sides only.",
       .words = {"+x", "-x", "+y", "-y"},
       .most = 4},
      {.name = "robots", .kind = integer, .doc = "How many.", .low = 1, .high = 1000},
  };
}

/// What the author knows about the end; `stigc test` finds it out by proof or by running.
std::vector<FormKey> expect_keys() {
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
       .kind = own,
       .doc = "The structure in the end: slices from the top down, parted by ---.",
       .own = &kDrawingKind},
  };
}

#pragma GCC diagnostic pop

}  // namespace

const Form& rule_set_form() {
  static const Form kForm{"rule set", rule_set_keys(), "stigc: 1 …"};
  return kForm;
}

const Form& brick_form() {
  static const Form kForm{"brick", brick_keys(), "{color: \"#8d99ae\"}"};
  return kForm;
}

const Form& start_form() {
  static const Form kForm{"start entry", start_keys(), "{at: [0, 0, 0], brick: 1}"};
  return kForm;
}

const Form& rule_form() {
  static const Form kForm{"rule", rule_keys(), "{name: …, place: …, when: …}"};
  return kForm;
}

const Form& height_form() {
  static const Form kForm{"height", height_keys(), "{min: 0, max: 3}"};
  return kForm;
}

const Form& count_form() {
  static const Form kForm{"count", count_keys(), "{of: [1], min: 2}"};
  return kForm;
}

const Form& box_form() {
  static const Form kForm{"box", box_keys(), "{size: [9, 9, 4]}"};
  return kForm;
}

const Form& physical_form() {
  static const Form kForm{"physical", physical_keys(), "{sides: [+x]}"};
  return kForm;
}

const Form& expect_form() {
  static const Form kForm{"expect", expect_keys(), "{bricks: 6}"};
  return kForm;
}

const FormKey& key_of(const Form& form, std::string_view path) {
  const std::size_t slash = path.find('/');
  const auto found = std::find_if(form.keys.begin(), form.keys.end(), [&](const FormKey& key) {
    return key.name == path.substr(0, slash);
  });
  assert(found != form.keys.end());
  return slash == std::string_view::npos ? *found : key_of(*found->form, path.substr(slash + 1));
}

bool is_reserved_symbol(std::string_view symbol) {
  static constexpr std::array<std::string_view, 6> kReserved = {".", "*", "?", "#", "=", "---"};
  return std::find(kReserved.begin(), kReserved.end(), symbol) != kReserved.end();
}

std::string json_schema() { return json_schema({"1", "2", "3", "4"}); }

std::string json_schema(const std::vector<std::string>& symbols) {
  return form_schema(rule_set_form(), "stigc rule set, version 1",
                     "Rules of collective construction on a 3-D lattice.",
                     kind_definitions(symbols));
}

}  // namespace stig::rules
