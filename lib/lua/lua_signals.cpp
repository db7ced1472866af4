// SPDX-License-Identifier: MIT
// What a robot lets others hear and see: radios, lights, and what viewers show of its mind.
#include <algorithm>
#include <array>
#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_devices.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

// Shown values go into each frame of a trace: bounded, so that programs do not decide its size.
constexpr std::size_t kMostShown = 256;  ///< of each kind in a step
constexpr std::size_t kMostShownText = 1000;

int robot_send(lua_State* state) {
  RobotSide& side = robot_side(state);
  add_message(state, side.commands->sends, side.model.radios.size());
  return 0;
}

struct NamedColour {
  std::string_view name;
  Rgb rgb;
};
// ARGoS's names of colours and their values (CColor), as far as programs use them.
constexpr std::array<NamedColour, 12> kColours{{{"black", {0, 0, 0}},
                                                {"white", {255, 255, 255}},
                                                {"red", {255, 0, 0}},
                                                {"green", {0, 255, 0}},
                                                {"blue", {0, 0, 255}},
                                                {"magenta", {255, 0, 255}},
                                                {"cyan", {0, 255, 255}},
                                                {"yellow", {255, 255, 0}},
                                                {"orange", {255, 140, 0}},
                                                {"brown", {165, 42, 42}},
                                                {"purple", {160, 32, 240}},
                                                {"gray", {128, 128, 128}}}};

/// A name, "#rrggbb", or three numbers from 0 to 255, from `index` on.
Rgb rgb_argument(lua_State* state, int index, const char* function) {
  if (lua_type(state, index) == LUA_TNUMBER) {
    std::array<std::uint8_t, 3> parts{};
    for (int i = 0; i < 3; ++i) {
      parts[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(
          integer_argument(state, index + i, function, "red, green or blue", 0, 255));
    }
    return {parts[0], parts[1], parts[2]};
  }
  const std::string_view text = text_argument(state, index, function, "color");
  const auto named = std::find_if(kColours.begin(), kColours.end(),
                                  [&](const NamedColour& c) { return c.name == text; });
  if (named != kColours.end()) return named->rgb;
  const auto rgb = parse_color(text);
  if (!rgb) bad_argument(state, index, function, "color", "the name of a colour or \"#rrggbb\"");
  return *rgb;
}

// The last command of a step holds.
void set_led(RobotCommands& commands, std::size_t led, Rgb rgb) {
  const auto set = std::find_if(commands.leds.begin(), commands.leds.end(),
                                [&](const auto& entry) { return entry.first == led; });
  if (set == commands.leds.end()) {
    commands.leds.emplace_back(led, rgb);
  } else {
    set->second = rgb;
  }
}
int set_leds(lua_State* state) {
  const Rgb rgb = rgb_argument(state, 1, "leds.set_leds");
  RobotSide& side = robot_side(state);
  for (std::size_t i = 0; i < side.model.leds.size(); ++i) set_led(*side.commands, i, rgb);
  return 0;
}
int set_led_index(lua_State* state) {
  RobotSide& side = robot_side(state);
  const auto count = static_cast<std::int64_t>(side.model.leds.size());
  const std::int64_t led = integer_argument(state, 1, "leds.set_led_index", "index", 1, count);
  const Rgb rgb = rgb_argument(state, 2, "leds.set_led_index");
  set_led(*side.commands, static_cast<std::size_t>(led - 1), rgb);
  return 0;
}

/// Sets the value of a name in a list that stays short. Linear search: the list has at most
/// kMostShown entries, and searching it is charged.
template <class List, class Value>
void show(lua_State* state, List& list, std::string_view name, Value value) {
  if (name.size() > kMostShownText) luaL_error(state, "robot.show: the name is too long");
  LuaBox::of(state).charge(state, 10 + list.size());
  const auto old = std::find_if(list.begin(), list.end(),
                                [&](const auto& entry) { return entry.first == name; });
  if (old != list.end()) {
    old->second = std::move(value);
    return;
  }
  if (list.size() >= kMostShown) luaL_error(state, "robot.show: too much in one step");
  list.emplace_back(name, std::move(value));
}
int show_number(lua_State* state) {
  const std::string_view name = text_argument(state, 1, "show.number", "name");
  const double number = number_argument(state, 2, "show.number", "value");
  show(state, robot_commands(state).user.numbers, name, number);
  return 0;
}
int show_text(lua_State* state) {
  const std::string_view name = text_argument(state, 1, "show.text", "name");
  luaL_checkany(state, 2);
  std::string text(push_text(state, 2).substr(0, kMostShownText));
  show(state, robot_commands(state).user.texts, name, std::move(text));
  return 0;
}
int show_arrow(lua_State* state) {
  const Vec3 from = vector_argument(state, 1, "show.arrow", "from");
  const Vec3 to = vector_argument(state, 2, "show.arrow", "to");
  const Rgb rgb = lua_isnoneornil(state, 3) ? Rgb{} : rgb_argument(state, 3, "show.arrow");
  auto& arrows = robot_commands(state).user.arrows;
  if (arrows.size() >= kMostShown) return luaL_error(state, "robot.show: too much in one step");
  arrows.push_back({from, to, rgb});
  return 0;
}

}  // namespace

template <>
void LuaDevice<RadioKind>::open(lua_State* state, RobotSide& side) {
  if (side.model.radios.empty()) return;
  lua_newtable(state);
  for (std::size_t i = 0; i < side.model.radios.size(); ++i) {
    push_radio(state, i, robot_send);
    side.tables<RadioKind>().push_back(keep_table(state));
    put(state, side.model.radios[i].name.c_str());
  }
  put(state, RadioKind::program_key);
}

template <>
void LuaDevice<RadioKind>::update(lua_State* state, const RobotSide& side,
                                  const RobotReadings& readings) {
  const std::vector<int>& tables = side.tables<RadioKind>();
  for (std::size_t i = 0; i < std::min(tables.size(), readings.radios.size()); ++i) {
    put_received(state, tables[i], readings.radios[i]);
  }
}

template <>
void LuaDevice<LedKind>::open(lua_State* state, RobotSide& side) {
  if (side.model.leds.empty()) return;
  lua_newtable(state);
  set_functions(state, {{"set_leds", set_leds}, {"set_led_index", set_led_index}});
  put(state, LedKind::key);
}

template <>
void LuaDevice<LedKind>::update(lua_State* /*state*/, const RobotSide& /*side*/,
                                const RobotReadings& /*readings*/) {}

void put_show(lua_State* state) {
  lua_newtable(state);
  set_functions(state, {{"number", show_number}, {"text", show_text}, {"arrow", show_arrow}});
  put(state, "show");
}

}  // namespace stig::lua
