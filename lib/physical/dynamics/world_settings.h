// SPDX-License-Identifier: MIT
// Every setting of a world, listed once: its member, its key in scene files,
// and its bounds.
//
//     visit_settings([](const Setting& setting, auto& value) { … }, config);
//
// Through the list go the fingerprint by which a checkpoint knows its world,
// the check that configurations are possible, and the keys, schema and reader
// of scene files. Its order is that of the fingerprint, so settings stay where
// they are and new ones come last.
//
// Bodies and joints are no settings.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/degree.h"
#include "physical/dynamics/uses.h"
#include "physical/dynamics/world_config.h"

namespace stig::physics {

struct Setting {
  /// The mapping of a scene file that has the key; empty: the file itself.
  std::string_view group;
  std::string_view key;
  std::string_view doc;  ///< one line, for people and editors
  double low = 0, high = 0;
  bool above_low = false;                    ///< low itself is not allowed
  double unit = 1;                           ///< of the key and the bounds, in that of the member
  std::vector<std::string_view> words = {};  ///< of an enumeration, in its order

  /// As scene files have it: "magnets.cutoff".
  std::string path() const {
    return group.empty() ? std::string(key) : std::string(group) + "." + std::string(key);
  }
};

/// Makes the settings of one group.
struct SettingsOf {
  std::string_view group;

  Setting from(std::string_view key, double low, double high, std::string_view doc,
               double unit = 1) const {
    return {group, key, doc, low, high, false, unit};
  }
  Setting above(std::string_view key, double low, double high, std::string_view doc) const {
    return {group, key, doc, low, high, true};
  }
  Setting truth(std::string_view key, std::string_view doc) const { return {group, key, doc}; }
  Setting one_of(std::string_view key, std::vector<std::string_view> words,
                 std::string_view doc) const {
    return {group, key, doc, 0, 0, false, 1, std::move(words)};
  }
};

template <class Config>
concept EitherConfig = std::is_same_v<std::remove_const_t<Config>, WorldConfig>;

void visit_magnet_settings(auto& each, EitherConfig auto& config) {
  constexpr SettingsOf kKeys{"magnets"};
  each(kKeys.above("cutoff", 0, 10, "m, beyond which magnets ignore each other."),
       config.magnet_cutoff);
  each(kKeys.above("contact", 0, 10, "m: nearer magnets pull as at this distance."),
       config.magnet_contact);
  each(kKeys.above("relaxation_time", 0, 1, "s, in which free magnets turn to the field."),
       config.relaxation.time);
  each(kKeys.from("relaxation_sweeps", 1, 1000, "Turns of every magnet in a step."),
       config.relaxation.sweeps);
  each(kKeys.one_of("model", {"quasi_static", "integrated"},
                    "How free magnets turn; integrated is the reference, and takes a step of at "
                    "most 0.001 (default: quasi_static)."),
       config.magnets);
  each(kKeys.from("bearing_damping", 0, 1, "N·m·s, of integrated magnets (default: 0)."),
       config.bearing_damping);
  each(kKeys.above("snap_force", 0, 1e4,
                   "N, with which magnets press on each other bodies that count as snapped "
                   "together (default: 1)."),
       config.snap.force);
}

void visit_sleep_settings(auto& each, EitherConfig auto& config) {
  constexpr SettingsOf kKeys{"sleep"};
  auto& sleep = config.sleep;
  each(kKeys.truth("enabled", "false: nothing ever sleeps."), sleep.enabled);
  each(kKeys.above("time", 0, 1e3, "s, for which all that touch must be at rest."), sleep.time);
  each(kKeys.from("speed", 0, 10, "m/s, below which a body is at rest."), sleep.speed);
  each(kKeys.from("spin", 0, 1e4, "Degrees a second, likewise.", kDegree), sleep.spin);
  each(kKeys.from("waking_speed", 0, 10, "m/s, of a body that wakes what it touches."),
       sleep.waking_speed);
  each(kKeys.from("waking_spin", 0, 1e4, "Degrees a second, likewise.", kDegree),
       sleep.waking_spin);
  each(kKeys.from("waking_force", 0, 1e3, "N, of passing magnets that wake."), sleep.waking_force);
}

/// Calls each(setting, value). Values are double, int, bool, an enumeration, or the list of
/// frictions, where the bounds are those of each coefficient.
void visit_settings(auto&& each, EitherConfig auto& config) {
  constexpr SettingsOf kKeys{""}, kFriction{"friction"};
  each(kKeys.one_of("solver", {"fast", "stock"},
                    "fast, or stock: DART's own, slow, for comparison (default: fast)."),
       config.solver);
  // Stacks collapse in longer steps.
  each(kKeys.from("step", 1e-6, 0.02, "s (default: 0.005)."), config.step);
  each(kKeys.from("gravity", 0, 1000, "m/s² (default: 9.8)."), config.gravity);
  each(kKeys.truth("floor", "Is there a floor at z = 0? (default: true)"), config.floor);
  each(kKeys.above("arena", 0, 1000, "m: what is farther from the origin has left (default: 100)."),
       config.arena);
  each(kFriction.from("default", 0, 10, "Of pairs that are not listed (default: 0.5)."),
       config.friction);
  each(kFriction.from("pairs", 0, 10, "Others than [block, block] 0.2 and [block, floor] 0.4."),
       config.frictions);
  each(kKeys.from("damping", 0, 1e4, "1/s: free motion decays as exp(-damping t) (default: 0)."),
       config.damping);
  each(kKeys.from("angular_damping", 0, 1e4, "1/s, likewise of spins (default: 0)."),
       config.angular_damping);
  visit_magnet_settings(each, config);
  each(kKeys.from("small_steps", 1, 1000, "Of the contact solver, in each step (default: 16)."),
       config.small_steps);
  each(kKeys.from("sweeps", 1, 10'000,
                  "Of the contact solver, in each of its small steps (default: 1)."),
       config.sweeps);
  visit_sleep_settings(each, config);
  each(kKeys.truth("grasps",
                   "false: what a robot holds is solved by its points of contact alone, never as "
                   "one joint (default: true)."),
       config.grasps);
}

}  // namespace stig::physics
