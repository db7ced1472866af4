// SPDX-License-Identifier: MIT
// The list of a world's settings: every one of them can be set from a scene, is checked, and is
// part of the fingerprint that checkpoints have.
#include "physical/dynamics/world_settings.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <limits>

#include "physical/dynamics/world.h"
#include "physical/scene/block_text.h"
#include "physical/scene/scene.h"
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

WorldConfig settings_of_scene(const std::string& text) {
  Diagnostics diagnostics;
  const auto scene =
      read_scene(std::make_shared<const SourceFile>("s.yaml", "stigc_scene: 1\n" + text),
                 memory_loader({{"stigmergic.yaml", block_text()}}), diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(scene);
  return scene->settings;
}

std::string shown(const auto& value) {
  if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(value)>>) {
    return std::to_string(static_cast<int>(value));
  } else {
    return fmt::format("{}", value);
  }
}
std::string shown(const std::vector<FrictionPair>& pairs) {
  std::string out;
  for (const FrictionPair& p : pairs) out += fmt::format("{} {} {},", p.a, p.b, p.coefficient);
  return out;
}

/// Each setting's path and value.
std::vector<std::pair<std::string, std::string>> all_settings(const WorldConfig& config) {
  std::vector<std::pair<std::string, std::string>> out;
  visit_settings([&](const Setting& setting,
                     const auto& value) { out.emplace_back(setting.path(), shown(value)); },
                 config);
  return out;
}

/// Another value of a setting, as scene files have it.
std::string other(const Setting& setting, double value) {
  const double half = value > 0 ? value / 2 : setting.high / 2;
  return fmt::format("{}", half / setting.unit);
}
std::string other(const Setting& /*setting*/, int value) { return std::to_string(value + 1); }
std::string other(const Setting& /*setting*/, bool value) { return value ? "false" : "true"; }
std::string other(const Setting& /*setting*/, const std::vector<FrictionPair>& /*pairs*/) {
  return "[{of: [block, floor], is: 0.1}]";
}
template <class Choice>
requires std::is_enum_v<Choice> std::string other(const Setting& setting, Choice value) {
  return std::string(setting.words[value == Choice{} ? 1 : 0]);
}

struct Change {
  std::string path, text;
};
/// A line of a scene file for each setting, which changes it.
std::vector<Change> changes() {
  std::vector<Change> out;
  const WorldConfig plain;
  visit_settings(
      [&](const Setting& setting, const auto& value) {
        const std::string pair = fmt::format("{}: {}", setting.key, other(setting, value));
        out.push_back({setting.path(), setting.group.empty()
                                           ? pair + "\n"
                                           : fmt::format("{}: {{{}}}\n", setting.group, pair)});
      },
      plain);
  return out;
}

World world_of(WorldConfig config, bool own_step) {
  if (!own_step) config.step = 0.001;  // integrated magnets take no longer one
  config.bodies = {solid_body(Shape::box({0.1, 0.1, 0.1}), 1, {0, 0, 0.05})};
  return World(config);
}

// How many settings a value is. The structured bindings name every member, so that a new one does
// not compile until it is counted.
std::size_t count_of(const auto& /*value*/) { return 1; }
template <class... Values>
std::size_t count_of_all(const Values&... values);
std::size_t count_of(const Relaxation& relaxation) {
  const auto& [time, sweeps] = relaxation;
  return count_of_all(time, sweeps);
}
std::size_t count_of(const SnapRule& snap) {
  const auto& [force] = snap;
  return count_of_all(force);
}
std::size_t count_of(const SleepRules& sleep) {
  const auto& [enabled, time, speed, spin, waking_speed, waking_spin, waking_force] = sleep;
  return count_of_all(enabled, time, speed, spin, waking_speed, waking_spin, waking_force);
}
template <class... Values>
std::size_t count_of_all(const Values&... values) {
  return (count_of(values) + ...);
}
/// Bodies and joints apart.
std::size_t count_of(const WorldConfig& config) {
  const auto& [step, solver, gravity, floor, arena, friction, frictions, damping, angular_damping,
               magnet_cutoff, magnet_contact, magnets, relaxation, bearing_damping, snap,
               small_steps, sweeps, grasps, sleep, bodies, joints] = config;
  return count_of_all(step, solver, gravity, floor, arena, friction, frictions, damping,
                      angular_damping, magnet_cutoff, magnet_contact, magnets, relaxation,
                      bearing_damping, snap, small_steps, sweeps, grasps, sleep);
}

}  // namespace

TEST_CASE("every setting of a world has a key of scene files, which changes it alone") {
  const auto before = all_settings(settings_of_scene(""));
  const std::vector<Change> all = changes();
  REQUIRE(all.size() == before.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(all[i].text);
    const auto after = all_settings(settings_of_scene(all[i].text));
    for (std::size_t j = 0; j < before.size(); ++j) {
      CAPTURE(before[j].first);
      CHECK((after[j].second != before[j].second) == (i == j));
    }
  }
}

TEST_CASE("every member of a world's configuration is a setting that is listed") {
  // One that is not is in no fingerprint: checkpoints would be taken by worlds that differ in it.
  CHECK(count_of(WorldConfig()) == all_settings(WorldConfig()).size());
}

TEST_CASE("damping and integrated magnets from a scene") {
  const WorldConfig config = settings_of_scene(
      "step: 0.0005\ndamping: 0.5\nangular_damping: 2\n"
      "magnets: {model: integrated, bearing_damping: 5.0e-6}\nsleep: {waking_spin: 90}\n");
  CHECK(config.damping == 0.5);
  CHECK(config.angular_damping == 2);
  CHECK(config.magnets == MagnetModel::integrated);
  CHECK(config.bearing_damping == 5e-6);
  CHECK(config.sleep.waking_spin == doctest::Approx(1.5707963));
  CHECK(problems_of(config).empty());
}

TEST_CASE("a checkpoint is refused by a world with any other setting") {
  const World plain = world_of(settings_of_scene(""), false);
  CHECK(world_of(settings_of_scene(""), false).resume(plain.checkpoint()));
  for (const Change& change : changes()) {
    CAPTURE(change.text);
    World other = world_of(settings_of_scene(change.text), change.path == "step");
    CHECK_FALSE(other.resume(plain.checkpoint()));
  }
}

TEST_CASE("settings out of their bounds are refused by name, and NaN is") {
  const auto refused = [](const std::string& path, const WorldConfig& config) {
    const auto problems = problems_of(config);
    REQUIRE_FALSE(problems.empty());
    CHECK_MESSAGE(problems[0].starts_with(path + " must be "), problems[0]);
  };
  WorldConfig config;
  CHECK(problems_of(config).empty());
  visit_settings(
      [&](const Setting& setting, auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        CAPTURE(setting.path());
        if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, int>) {
          const Value good = value;
          value = static_cast<Value>(setting.low * setting.unit - 1);
          refused(setting.path(), config);
          value = static_cast<Value>(setting.high * setting.unit * 1.01 + 1);
          refused(setting.path(), config);
          if constexpr (std::is_same_v<Value, double>) {
            value = std::numeric_limits<double>::quiet_NaN();
            refused(setting.path(), config);
          }
          value = good;
        }
      },
      config);
  config.frictions = {{0, 1, -0.1}};
  refused("friction.pairs", config);
}
