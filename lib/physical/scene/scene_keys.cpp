// SPDX-License-Identifier: MIT
// The one list of a scene's keys: the reader checks against it, the JSON Schema is written from it,
// and docs/simulate.md is held to it by a test. Bounds are there so that no file can ask for more
// than a machine has, and so that units mistaken (mm for m) are noticed.
#include "physical/scene/scene_keys.h"

#include "base/node_checks.h"
#include "physical/dynamics/world_settings.h"
#include "physical/scene/scene.h"
#include "robots/body_reader.h"

namespace stig::physics {

namespace {

using enum FormKind;

constexpr double kFar = 1000;  ///< m, the largest arena
constexpr double kMostCount = 100'000;
constexpr double kMostSeconds = 1e7;

// Members left out have their defaults.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

// Helpers for the common kinds of keys, in the words of base/form.h.
FormKey real(std::string_view name, std::string_view doc, double low, double high) {
  return {.name = name, .kind = number, .doc = doc, .low = low, .high = high};
}
FormKey above_zero(std::string_view name, std::string_view doc, double high) {
  return {.name = name, .kind = number, .doc = doc, .low = 0, .high = high, .above_low = true};
}
FormKey whole(std::string_view name, std::string_view doc, double low, double high) {
  return {.name = name, .kind = integer, .doc = doc, .low = low, .high = high};
}
FormKey vector(std::string_view name, std::string_view doc, double low, double high) {
  // Vectors have exactly three numbers.
  return {
      .name = name, .kind = numbers, .doc = doc, .low = low, .high = high, .least = 3, .most = 3};
}
FormKey flag(std::string_view name, std::string_view doc) {
  return {.name = name, .kind = boolean, .doc = doc};
}
FormKey word(std::string_view name, std::string_view doc, std::vector<std::string_view> words) {
  return {.name = name, .kind = choice, .doc = doc, .words = std::move(words)};
}

const Form& friction_pair_keys() {
  // Forms are static and made when first asked for, in the order in which they need each other.
  static const Form kKeys{"pair of materials",
                          {
                              {.name = "of",
                               .kind = names,
                               .required = true,
                               .doc = "Two materials: block, floor, or those of robots' bodies.",
                               .least = 2,
                               .most = 2},
                              {.name = "is",
                               .kind = number,
                               .required = true,
                               .doc = "Coulomb's coefficient.",
                               .low = 0,
                               .high = 10},
                          }};
  return kKeys;
}

FormKey key_of(const Setting& setting, double /*value*/) {
  FormKey key = real(setting.key, setting.doc, setting.low, setting.high);
  key.above_low = setting.above_low;
  return key;
}
FormKey key_of(const Setting& setting, int /*value*/) {
  return whole(setting.key, setting.doc, setting.low, setting.high);
}
FormKey key_of(const Setting& setting, bool /*value*/) { return flag(setting.key, setting.doc); }
template <class Choice>
requires std::is_enum_v<Choice> FormKey key_of(const Setting& setting, Choice /*value*/) {
  return word(setting.key, setting.doc, setting.words);
}
FormKey key_of(const Setting& setting, const std::vector<FrictionPair>& /*value*/) {
  return {.name = setting.key,
          .kind = forms,
          .doc = setting.doc,
          .form = &friction_pair_keys(),
          .most = 1000};
}

/// The keys of a world's settings that stand in one mapping.
void add_settings(std::string_view group, std::vector<FormKey>& out) {
  const WorldConfig any;
  visit_settings(
      [&](const Setting& setting, const auto& value) {
        if (setting.group == group) out.push_back(key_of(setting, value));
      },
      any);
}
Form settings_form(std::string_view title, std::string_view group, std::vector<FormKey> others) {
  add_settings(group, others);
  return {title, std::move(others)};
}

const Form& friction_keys() {
  static const Form kKeys = settings_form("table of friction", "friction", {});
  return kKeys;
}

const Form& magnet_keys() {
  static const Form kKeys = settings_form("magnets' settings", "magnets",
                                          {flag("enabled", "false: no block has magnets.")});
  return kKeys;
}

const Form& sleep_keys() {
  static const Form kKeys = settings_form("sleep settings", "sleep", {});
  return kKeys;
}

const Form& stop_keys() {
  static const Form kKeys{"stop condition",
                          {flag("asleep", "The run ends as soon as nothing is awake."),
                           flag("failed", "The run ends when every robot's program has failed.")}};
  return kKeys;
}

const Form& block_keys() {
  static const Form kKeys{
      "block entry",
      {
          {.name = "name", .kind = FormKind::name, .doc = "What reports call it."},
          {.name = "file", .kind = text, .doc = "Block file (default: stigmergic.yaml)."},
          vector("at",
                 "[x, y, z] in m: a block's centre, or the middle of what a structure "
                 "stands on.",
                 -kFar, kFar),
          vector("turn", "[z, y, x] in degrees: about z, then the new y, then the new x.", -360,
                 360),
          word("color", "Of its LEDs.", {kLedNames.begin(), kLedNames.end()}),
          flag("fixed", "Nothing moves it."),
          vector("velocity", "m/s along the world's axes.", -100, 100),
          vector("spin", "Degrees a second about the world's axes.", -5e4, 5e4),
          whole("column", "So many blocks, one upon the other.", 1, 1000),
          {.name = "wall",
           .kind = integers,
           .doc = "[length, height] in blocks, along x.",
           .low = 1,
           .high = 1000,
           .least = 2,
           .most = 2},
          whole("pyramid", "So many layers; 3 is the paper's, of 15 blocks.", 1, 30),
          {.name = "grid",
           .kind = integers,
           .doc = "[x, y, z]: loose blocks in rows and layers.",
           .low = 1,
           .high = 1000,
           .least = 3,
           .most = 3},
          above_zero("pitch", "m between the centres of a grid (default: 1.8 sides).", kFar),
          real("jitter", "m, at most, by which a grid's places are off in x and y.", 0, kFar),
          real("tumble", "Degrees, at most, by which a grid's blocks are turned.", 0, 180),
          whole("scatter", "So many blocks at random in a box.", 1, kMostCount),
          vector("size", "[x, y, z] of that box in m; z 0: all stand on its bottom.", 0, kFar),
          word("turned", "How scattered blocks are turned.", {"none", "upright", "any"}),
          {.name = "poses",
           .kind = text,
           .doc = "CSV file of x, y, z in m and rz, ry, rx in "
                  "degrees, a block a line."},
      }};
  return kKeys;
}

const Form& robot_keys() {
  static const Form kKeys{
      "robot entry",
      {
          {.name = "file", .kind = text, .required = true, .doc = "Robot file: bebot.yaml."},
          {.name = "name", .kind = FormKind::name, .doc = "What reports and programs call it."},
          {.name = "at",
           .kind = numbers,
           .doc = "[x, y] in m, on the floor.",
           .low = -kFar,
           .high = kFar,
           .least = 2,
           .most = 2},
          real("heading", "Degrees from the x axis, counter-clockwise.", -360, 360),
          {.name = "grid",
           .kind = integers,
           .doc = "[x, y]: robots in rows, the middle of which is at `at`.",
           .low = 1,
           .high = 100,
           .least = 2,
           .most = 2},
          above_zero("pitch", "m between the robots of a grid (default: 0.4).", kFar),
          real("jitter", "m, at most, by which the robot is off in x and y; by the seed.", 0, 1),
          real("turn_jitter", "Degrees, at most, by which its heading is off.", 0, 180),
          {.name = "program", .kind = text, .doc = "Lua file; without it the robot's own."},
          {.name = "params", .kind = anything, .doc = "What the program finds in robot.params."},
      }};
  return kKeys;
}

const Form& obstacle_keys() {
  static const Form kKeys{"obstacle", shape_keys(kFar)};
  return kKeys;
}

const Form& cache_keys() {
  static const Form kKeys{
      "block cache",
      {
          vector("at", "[x, y, z] in m: where a block is dropped.", -kFar, kFar),
          above_zero("radius", "m: a block nearer than this keeps the next one back (0.35).", kFar),
          real("yaw", "Degrees, of the blocks.", -360, 360),
          real("jitter", "m, at most, by which each block is off in x and y; by the seed.", 0, 1),
          real("turn_jitter", "Degrees, at most, by which each is turned.", 0, 180),
          {.name = "file", .kind = text, .doc = "Block file (default: stigmergic.yaml)."},
          whole("stock", "Blocks that it has (default: 100).", 0, 10'000),
      }};
  return kKeys;
}

const Form& noise_keys() {
  static const Form kKeys{
      "noise of sensors",
      {
          real("pixels", "Standard deviation of corners and LEDs, in pixels.", 0, 100),
          real("missed_tags", "Probability.", 0, 1),
          real("missed_leds", "Probability.", 0, 1),
          real("false_tags", "Probability, of an image.", 0, 1),
          real("false_leds", "Probability, of an image.", 0, 1),
          real("colour", "Standard deviation of Y, U and V, which are 0 to 255.", 0, 255),
          whole("camera_latency", "Control ticks.", 0, 100),
          real("distance", "Standard deviation of rangefinders, m.", 0, 1),
          whole("range_latency", "Control ticks.", 0, 100),
          real("encoder_count",
               "Speed of a rim that is one count of its encoder in a window, m/s; 0: exact.", 0, 1),
      }};
  return kKeys;
}

/// A year, which YAML has for a number.
bool check_interface(NodeChecks& checks, const YamlNode& node, const FormKey& key) {
  return checks.check_choice(node, key.name, {"2019", "2021"});
}
constexpr ValueKind kInterface{.check = check_interface, .schema = R"({"enum": [2019, 2021]})"};

/// What stands in the scene, and what is done with it.
std::vector<FormKey> content_keys() {
  return {
      {.name = "blocks",
       .kind = forms,
       .doc = "Blocks and structures of blocks.",
       .form = &block_keys(),
       .most = 20'000},
      {.name = "robots",
       .kind = forms,
       .doc = "Robots and their programs.",
       .form = &robot_keys(),
       .most = 1000},
      {.name = "obstacles",
       .kind = forms,
       .doc = "Bodies by themselves; those without a mass are fixed.",
       .form = &obstacle_keys(),
       .most = 1000},
      {.name = "caches",
       .kind = forms,
       .doc = "Where new blocks come from.",
       .form = &cache_keys(),
       .most = 1000},
      {.name = "robot_program",
       .kind = text,
       .doc = "Lua file that robots without a program of their own run."},
      {.name = "block_program",
       .kind = text,
       .doc = "Lua file that every block runs: stigmergic.lua is the paper's."},
      {.name = "interface",
       .kind = own,
       .doc = "Year of the interface that programs were written for (default: 2021).",
       .own = &kInterface},
      {.name = "script",
       .kind = text,
       .doc = "Lua file of the experiment: on_start, on_step, on_end."},
      whole("stock", "Blocks that the script may drop (default: 0).", 0, 10'000),
      flag("lights", "false: no LED shines."),
      {.name = "noise",
       .kind = form,
       .doc = "What sensors get wrong (default: nothing).",
       .form = &noise_keys()},
  };
}

Form make_scene_form() {
  Form out{"scene",
           {{.name = "stigc_scene",
             .kind = version,
             .required = true,
             .doc = "Version of the format: 1.",
             .high = 1},
            {.name = "title", .kind = FormKind::name, .doc = "One line for people."},
            // 2^53: a seed beyond could not be written in YAML or JSON without loss.
            whole("seed", "Of all random choices (default: 1).", 0, 9007199254740992.0),
            above_zero("duration", "s of simulated time (default: 10).", kMostSeconds)}};
  add_settings("", out.keys);
  const auto add_form = [&out](std::string_view name, std::string_view doc, const Form& form) {
    out.keys.push_back({.name = name, .kind = FormKind::form, .doc = doc, .form = &form});
  };
  add_form("friction", "Coefficients of pairs of materials.", friction_keys());
  add_form("magnets", "How magnets are computed.", magnet_keys());
  add_form("sleep", "When bodies fall asleep and wake.", sleep_keys());
  add_form("stop", "What ends a run before its duration.", stop_keys());
  for (FormKey& key : content_keys()) out.keys.push_back(std::move(key));
  return out;
}

}  // namespace

const Form& scene_keys() {
  static const Form kKeys = make_scene_form();
  return kKeys;
}

#pragma GCC diagnostic pop

std::string scene_schema() {
  return form_schema(scene_keys(), "stigc scene, version 1",
                     "What stands where when a physical simulation begins.");
}

}  // namespace stig::physics
