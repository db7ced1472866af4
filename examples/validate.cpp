// SPDX-License-Identifier: MIT
// Lets a robot build a structure as physics has it, and holds what it builds to the rules:
// stig::validate, from the rule set to the verdict.
//
//     validate [SECONDS]     simulated, at most
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "compiler/block_figures.h"
#include "compiler/controller_lua.h"
#include "lua/lua_settings.h"
#include "robots/robot_reader.h"
#include "rules/rule_reader.h"
#include "validate/set_up.h"
#include "validate/trial.h"

namespace {

constexpr const char* kRules = R"(
stigc: 1
name: tower
lattice: cubic
symmetry: rotations
floor: true
bricks:
  1: {name: Q1, color: "#e6194b", led: Q1}
start:
  - {at: [0, 0, 0], brick: 1}
physical:
  sides: [+x]
rules:
  - name: raise
    place: 1
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   ? * ?   ? 1 ?
      ? ? ?   ? ? ?   ? ? ?
    height: {max: 1}
)";

/// The library of programs that a compiled controller calls: each module after those that it
/// requires.
void add_module(std::string_view name, const stig::physics::SceneLoader& load,
                std::vector<std::string>& begun, std::vector<std::string>& out) {
  if (std::find(begun.begin(), begun.end(), name) != begun.end()) return;
  begun.emplace_back(name);
  stig::FileError error;
  const auto text = load(stig::lua::module_file(name), stig::lua::kMostLuaSource, error);
  if (!text) {
    std::cerr << error.message << '\n';
    std::exit(1);
  }
  for (const std::string& required : stig::lua::required_names(*text)) {
    add_module(required, load, begun, out);
  }
  out.push_back(*text);
}

/// The controller in Lua: the library, the rules' decisions, and the chart that calls them.
std::string controller_of(const stig::rules::RuleSet& rules,
                          const stig::compiler::Abilities& abilities,
                          const stig::compiler::CompiledRules& compiled,
                          const stig::physics::SceneLoader& load) {
  std::vector<std::string> begun, library;
  add_module(stig::compiler::kRuntimeRoot, load, begun, library);
  const auto plan = stig::compiler::plan_controller(rules, abilities, compiled);
  return stig::compiler::controller_lua(rules, "tower.yaml", plan, compiled, library).text;
}

/// Runs a scene, watched by a judge who knows every pose and never asks robots what they believe.
int run(const stig::rules::RuleSet& rules, const stig::compiler::CompiledRules& compiled,
        const stig::physics::Scene& scene, double seconds, stig::Diagnostics& diagnostics) {
  const auto placed = stig::physics::place_scene(scene, /*seed=*/1, diagnostics);
  if (!placed) return 1;
  // Where the rules' lattice lies in the world: the blocks of the start say so. Of a scene with
  // several starts each has a site of its own; this one has one.
  stig::validate::BuildTarget target{&rules, *compiled.proof.structure, {}};
  target.sites = stig::validate::find_sites(rules, target.whole, compiled.target->floor_level(),
                                            scene, *placed, diagnostics);
  if (target.sites.empty()) return 1;
  stig::validate::TrialSettings settings;
  settings.duration = seconds;
  settings.pictures = -1;
  const stig::validate::Trial trial =
      stig::validate::run_trial(target, scene, *placed, settings, {});

  for (const stig::validate::BrickEvent& event : trial.events) {
    std::cout << (event.kind == stig::validate::BrickEvent::Kind::placed ? "placed" : "gone")
              << ": brick at (" << event.cell.x << ", " << event.cell.y << ", " << event.cell.z
              << ")\n";
  }
  const stig::validate::Judgement& judgement = trial.judgements.front();
  std::cout << to_string(trial.end) << ", " << to_string(judgement.verdict) << ": "
            << judgement.allowed << " of " << judgement.placements
            << " placements as the rules allow, " << judgement.missing() << " missing\n";
  return judgement.verdict == stig::validate::BuildVerdict::complete ? 0 : 1;
}

/// All of it; what is wrong is in the diagnostics.
int validate(double seconds, stig::Diagnostics& diagnostics) {
  // Rules and robot, read and compiled as in compile.cpp.
  const auto rules = stig::rules::read_rule_set(
      std::make_shared<const stig::SourceFile>("tower.yaml", kRules), diagnostics);
  const auto robot = stig::robots::read_robot_file(STIG_DATA "/robots/bebot.yaml", diagnostics);
  const auto block =
      stig::robots::read_block_file(STIG_DATA "/blocks/stigmergic.yaml", diagnostics);
  if (!rules || !robot || !block) return 1;
  const stig::compiler::Abilities abilities =
      stig::compiler::abilities_of(*robot, stig::compiler::figures_of(*block));
  const stig::compiler::CompiledRules compiled =
      stig::compiler::compile_rules(*rules, abilities, {}, diagnostics);
  if (!compiled.decision) return 1;

  // The scene asks for the controller by the name kControllerFile, for all else by files' names.
  const stig::physics::SceneLoader disk = stig::physics::disk_loader(
      STIG_DATA "/scenes", {STIG_DATA "/robots", STIG_DATA "/blocks", STIG_DATA "/programs"});
  const std::string controller = controller_of(*rules, abilities, compiled, disk);
  const stig::physics::SceneLoader loader = [&](const std::string& name, std::size_t most,
                                                stig::FileError& error) {
    return name == stig::validate::kControllerFile ? std::optional(controller)
                                                   : disk(name, most, error);
  };
  const std::string text = stig::validate::set_up_scene(*rules, compiled, {});
  const auto scene = stig::physics::read_scene(
      std::make_shared<const stig::SourceFile>("scene.yaml", text), loader, diagnostics);
  return scene ? run(*rules, compiled, *scene, seconds, diagnostics) : 1;
}

}  // namespace

int main(int argc, char** argv) {
  stig::Diagnostics diagnostics;
  const int code = validate(argc > 1 ? std::atof(argv[1]) : 600, diagnostics);
  std::cerr << stig::to_text(diagnostics);
  return code;
}
