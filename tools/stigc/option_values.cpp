// SPDX-License-Identifier: MIT
#include "option_values.h"

#include <nlohmann/json.hpp>
#include <variant>

#include "explore_config.h"

namespace stig::cli {
namespace {

template <class Value>
Json maybe(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json cells(const std::vector<Cell>& all) {
  Json out = Json::array();
  for (const Cell cell : all) out.push_back(to_json(cell));
  return out;
}

/// The file's or the command's own where nobody gave one; "none" is unbounded space.
Json box_values(const WorldOptions& world) {
  Json out{{"box", nullptr}, {"origin", nullptr}, {"periodic", world.periodic}};
  if (world.box) out["box"] = world.box->size ? to_json(*world.box->size) : Json("none");
  if (world.origin) out["origin"] = to_json(*world.origin);
  return out;
}

Json values(const ExploreOptions& o) {
  Json out = box_values(o.world);
  out["motion"] = to_string(o.motion);
  out["agents"] = maybe(o.agents);
  out["agents-at"] = cells(o.agents_at);
  out["moves"] = maybe(o.moves);
  out["steps"] = maybe(o.steps);
  out["deposits"] = maybe(o.deposits);
  // The limit where none is given; with events it holds in unbounded space alone.
  const bool limited = o.steps || o.deposits;
  if (!limited && o.motion != Motion::event) out["steps"] = kDefaultSteps;
  if (!limited && o.motion == Motion::event && o.world.box && !o.world.box->size) {
    out["deposits"] = kDefaultDeposits;
  }
  out["seed"] = o.seed;
  out["run"] = o.run.value_or(0);
  return out;
}

Json values(const VerifyFileOptions& o) {
  Json out = box_values(o.world);
  out["sides"] = o.sides;
  out["effort"] = o.effort;
  out["budget"] = maybe(o.budget);
  out["states"] = o.states;
  return out;
}

Json values(const SynthOptions& o) {
  return {{"lattice", o.lattice && *o.lattice == Lattice::hexagonal ? "hexagonal" : "cubic"},
          {"bricks", o.mesh.bricks.value_or(kUsualBricks)},
          {"colours", o.colours                   ? Json(*o.colours)
                      : o.use == ColourUse::given ? Json("given")
                                                  : Json("free")},
          {"symmetry", to_string(o.symmetry)},
          {"start", cells(o.start)},
          {"floor", o.floor},
          {"robot", maybe(o.robot)},
          {"block", maybe(o.block)},
          {"sides", o.sides},
          {"robots", maybe(o.robots)},
          {"fewest", o.fewest == Fewest::rules ? "rules" : "colours"},
          {"order", o.family ? Json(static_cast<int>(*o.family)) : Json("all")},
          {"strict", o.strict},
          {"exact", o.exact},
          {"kinds", maybe(o.kinds)},
          {"scaffold", o.scaffold},
          {"effort", o.effort},
          {"budget", o.seconds}};
}

Json values(const CompileFileOptions& o) {
  return {{"robot", maybe(o.robot)},   {"block", maybe(o.block)},   {"sides", o.sides},
          {"robots", maybe(o.robots)}, {"budget", maybe(o.budget)}, {"states", o.states}};
}

Json values(const ValidateOptions& o) {
  return {{"scene", maybe(o.scene)},
          {"robot", maybe(o.robot)},
          {"sides", o.sides},
          {"structures", maybe(o.structures)},
          {"robots", maybe(o.robots)},
          {"allocation", o.allocation == Allocation::dynamic_ ? "dynamic" : "fixed"},
          {"duration", maybe(o.duration)},
          {"seed", o.seed}};
}

template <class Other>
Json values(const Other&) {
  return nullptr;
}

}  // namespace

Json option_values(const CommandOptions& options) {
  return std::visit([](const auto& one) { return values(one); }, options);
}

}  // namespace stig::cli
