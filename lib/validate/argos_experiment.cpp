// SPDX-License-Identifier: MIT
// The same layout as set_up.h has it, in the words of ARGoS 3's experiments (docs/argos.md). Two
// things differ: ARGoS drops no blocks from caches, so as many as the work needs lie at the caches
// from the start; and what a robot is told about its side goes through the parameters of its
// controller, of which ARGoS has one per configuration and not one per robot.
#include "validate/argos_experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <set>
#include <string>

#include "base/text.h"
#include "robots/device_kinds.h"
#include "validate/build_site.h"

namespace stig::validate {
namespace {

// m, of the arena round the outermost block: ARGoS ends where something leaves it.
constexpr double kMargin = 2;
// Where loose blocks lie, in units of kBlocksApart from the cache: outwards, to the left. Three,
// then two behind their gaps, and so on.
constexpr double kLoosePlaces[][2] = {{0, 0}, {0, 1}, {0, -1}, {1, 0.5}, {1, -0.5}};
constexpr double kLooseRows = 2;
// m, from a robot's middle: where robots stand by no block lies.
constexpr double kRobotRoom = 0.25;

// Its robots turn slowly, since they slip otherwise.
constexpr double kSlower = 2;

constexpr const char* kBlockDevices = R"(      <actuators>
        <directional_leds implementation="default"/>
        <simple_radios implementation="default"/>
      </actuators>
      <sensors>
        <simple_radios implementation="default"/>
      </sensors>
)";

constexpr const char* kPhysicsAndMedia = R"(  <physics_engines>
    <dynamics3d id="dyn3d" iterations="100">
      <floor/>
      <gravity g="9.8"/>
      <srocs disable_block_magnets_during_manipulation="true"/>
    </dynamics3d>
  </physics_engines>

  <media>
    <directional_led id="directional_leds" index="grid" grid_size="20,20,20"/>
    <tag id="tags" index="grid" grid_size="20,20,20"/>
    <simple_radio id="nfc" index="grid" grid_size="20,20,20"/>
    <simple_radio id="wifi" index="grid" grid_size="20,20,20"/>
  </media>

  <visualization/>

</argos-configuration>
)";

/// Elements of a list of interfaces, by their names.
std::string interfaces(std::vector<std::string_view> names) {
  std::sort(names.begin(), names.end());
  std::string out;
  for (const std::string_view name : names) {
    out += fmt::format("        <{} implementation=\"default\"/>\n", name);
  }
  return out;
}

/// The interfaces of ARGoS's BuilderBot, which has every kind of device that ARGoS knows.
std::string builder_devices() {
  std::vector<std::string_view> actuators, sensors = {"builderbot_system"};
  DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (requires { Kind::argos_actuator; }) actuators.push_back(Kind::argos_actuator);
    if constexpr (requires { Kind::argos_sensor; }) sensors.push_back(Kind::argos_sensor);
  });
  return "      <actuators>\n" + interfaces(actuators) + "      </actuators>\n      <sensors>\n" +
         interfaces(sensors) + "      </sensors>\n";
}

/// What ARGoS's camera takes for a quadrant.
const char* colour_name(Led led) {
  constexpr const char* kNames[] = {"black", "magenta", "orange", "green", "blue"};
  return kNames[static_cast<std::size_t>(led)];
}

/// Blocks that nobody uses yet, their centres' places on the floor. One more on each side than its
/// share, for a block that is pushed out of reach.
std::vector<Vec3> loose_blocks(const SetUpLayout& layout, std::size_t wanted) {
  assert(!layout.caches.empty());
  const std::size_t sides = layout.caches.size();
  const std::size_t each = (wanted + sides - 1) / sides + 1;
  std::vector<Vec3> out;
  for (const SetUpLayout::Cache& cache : layout.caches) {
    // Caches point along an axis, so the direction is one of four, in whole numbers.
    const int quarter = cache.outwards / 90;
    const int dx = quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
    const int dy = quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
    std::size_t laid = 0;
    for (std::size_t i = 0; laid < each; ++i) {
      const std::size_t group = i / std::size(kLoosePlaces);
      const auto& [row, beside] = kLoosePlaces[i % std::size(kLoosePlaces)];
      const double out_by = kBlocksApart * (row + kLooseRows * static_cast<double>(group));
      const double left = kBlocksApart * beside;
      const Vec3 at{cache.at.x + dx * out_by - dy * left, cache.at.y + dy * out_by + dx * left, 0};
      const bool robot_there =
          std::any_of(layout.robots.begin(), layout.robots.end(), [&](const auto& robot) {
            return std::hypot(robot.at.x - at.x, robot.at.y - at.y) < kRobotRoom;
          });
      if (robot_there) continue;
      out.push_back(at);
      ++laid;
    }
  }
  return out;
}

/// Robots that begin on one side are bound alike, and told the same, where all crews are as large.
std::string controller_of(const SetUpLayout::Robot& robot, const SetUpLayout& layout) {
  const bool even = std::all_of(layout.robots.begin(), layout.robots.end(),
                                [&](const auto& other) { return other.crew == robot.crew; });
  return fmt::format("builder{}{}{}", to_string(robot.side),
                     robot.standby > 0 ? fmt::format("-standby{}", robot.standby) : "",
                     even ? "" : fmt::format("-of{}", robot.crew));
}

std::string controllers(const SetUpLayout& layout, const ArgosScripts& scripts) {
  std::string out = "  <controllers>\n";
  // A controller configuration for each side, and for those that stand by there: ARGoS shares one
  // among all robots that name it.
  std::set<std::string> made;
  for (const SetUpLayout::Robot& robot : layout.robots) {
    const std::string name = controller_of(robot, layout);
    if (!made.insert(name).second) continue;
    std::string params = fmt::format(" side=\"{}\"", to_string(robot.side));
    const std::string bound = sides_text(robot.bound);
    if (!bound.empty()) params += fmt::format(" sides=\"{}\"", bound);
    if (robot.standby > 0) params += fmt::format(" standby=\"{}\"", robot.standby);
    if (robot.crew > 0) params += fmt::format(" crew=\"{}\"", robot.crew);
    out += fmt::format("    <lua_controller id=\"{}\">\n{}", name, builder_devices());
    out += fmt::format("      <params script=\"{}\"{}/>\n    </lua_controller>\n",
                       escaped_markup(scripts.robot), params);
  }
  out += fmt::format("    <lua_controller id=\"block\">\n{}", kBlockDevices);
  out += fmt::format("      <params script=\"{}\"/>\n    </lua_controller>\n  </controllers>\n\n",
                     escaped_markup(scripts.block));
  return out;
}

std::string block_element(const std::string& id, const char* attributes, const char* colour,
                          const Vec3& base) {
  return fmt::format(
      "    <block id=\"{}\"{} init_led_color=\"{}\">\n"
      "      <body position=\"{:g},{:g},{:g}\" orientation=\"0,0,0\"/>\n"
      "      <controller config=\"block\"/>\n"
      "    </block>\n",
      id, attributes, colour, base.x, base.y, base.z);
}

std::string arena(const RuleSet& rules, const SetUpLayout& layout, const SetUpRequest& request,
                  const std::vector<Vec3>& loose) {
  double half = layout.arena;
  for (const Vec3& at : loose) half = std::max({half, std::abs(at.x), std::abs(at.y)});
  half += kMargin;
  std::string out = fmt::format(
      "  <arena size=\"{0:g},{0:g},2\" center=\"0,0,0.5\"\n"
      "         positional_index=\"grid\" positional_grid_size=\"1,1,1\">\n",
      2 * half);
  int number = 0;
  for (const SetUpLayout::Block& block : layout.blocks) {
    // ARGoS places bodies by the middle of their base, layouts by their centre.
    out += block_element(fmt::format("start{}", ++number), " movable=\"false\"",
                         colour_name(led_of(rules, block.brick)),
                         block.centre - Vec3{0, 0, request.side / 2});
  }
  number = 0;
  for (const Vec3& at : loose) {
    out += block_element(fmt::format("block{}", ++number), "", "black", at);
  }
  number = 0;
  for (const SetUpLayout::Robot& robot : layout.robots) {
    // A robot's id is what the tag on its top says, and cameras read tags as numbers.
    out += fmt::format(
        "    <builderbot id=\"{}\" wifi_medium=\"wifi\" nfc_medium=\"nfc\" tag_medium=\"tags\">\n"
        "      <body position=\"{:g},{:g},0\" orientation=\"{},0,0\"/>\n"
        "      <controller config=\"{}\"/>\n"
        "    </builderbot>\n",
        ++number, robot.at.x, robot.at.y, robot.heading, controller_of(robot, layout));
  }
  return out + "  </arena>\n\n";
}

}  // namespace

std::string argos_experiment(const RuleSet& rules, const CompiledRules& compiled,
                             const SetUpRequest& request, const ArgosScripts& scripts) {
  const SetUpLayout layout = lay_out(rules, compiled, request);
  const std::vector<Vec3> loose =
      loose_blocks(layout, compiled.target->bricks() - compiled.target->start_bricks());
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<!-- Written by stigc compile. To be run in this folder: ARGoS looks for scripts there. "
      "-->\n"
      "<argos-configuration>\n\n";
  out += fmt::format(
      "  <framework>\n"
      "    <system threads=\"0\"/>\n"
      "    <experiment length=\"{:g}\" ticks_per_second=\"5\" random_seed=\"1\"/>\n"
      "  </framework>\n\n",
      kSlower * most_build_time(compiled));
  return out + controllers(layout, scripts) + arena(rules, layout, request, loose) +
         kPhysicsAndMedia;
}

}  // namespace stig::validate
