// SPDX-License-Identifier: MIT
// The block's devices: directional LEDs of one colour out of four, and six radios.
#include <algorithm>
#include <array>
#include <cassert>
#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_interface.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

// The side is handed to the box as LuaSide, since a box knows no kinds of programs; the cast goes
// back the way it came.
BlockCommands& block_commands(lua_State* state) {
  auto* side = static_cast<LuaSide*>(LuaBox::of(state).user());
  return *static_cast<BlockSide*>(side)->commands;
}

/// What a program may call each colour; the words are those of the real blocks' programs.
struct Name {
  std::string_view name;
  std::uint8_t colour;
};
constexpr std::array<Name, 11> kNames{{{"off", 0},
                                       {"black", 0},
                                       {"Q1", 1},
                                       {"magenta", 1},
                                       {"pink", 1},
                                       {"Q2", 2},
                                       {"orange", 2},
                                       {"Q3", 3},
                                       {"green", 3},
                                       {"Q4", 4},
                                       {"blue", 4}}};

std::uint8_t led_argument(lua_State* state, int index, const char* function) {
  if (lua_type(state, index) == LUA_TNUMBER) {
    return static_cast<std::uint8_t>(integer_argument(state, index, function, "color", 0, 4));
  }
  const std::string_view text = text_argument(state, index, function, "color");
  const auto named = std::find_if(kNames.begin(), kNames.end(),
                                  [&](const Name& name) { return name.name == text; });
  if (named == kNames.end()) {
    bad_argument(state, index, function, "color", "0 to 4, \"off\" or \"Q1\" to \"Q4\"");
  }
  return named->colour;
}

int set_all_colors(lua_State* state) {
  const std::uint8_t colour = led_argument(state, 1, "directional_leds.set_all_colors");
  // All LEDs at once overwrite what was set one by one before in this step, and not what comes
  // after.
  block_commands(state).leds.clear();
  block_commands(state).all_leds = colour;
  return 0;
}

int set_single_color(lua_State* state) {
  constexpr const char* kFunction = "directional_leds.set_single_color";
  const auto led =
      static_cast<std::size_t>(integer_argument(state, 1, kFunction, "index", 1, kBlockLeds) - 1);
  const std::uint8_t colour = led_argument(state, 2, kFunction);
  auto& leds = block_commands(state).leds;
  // The last command of a step holds; the list stays as short as a block has LEDs.
  std::erase_if(leds, [&](const auto& entry) { return entry.first == led; });
  leds.emplace_back(led, colour);
  return 0;
}

int block_send(lua_State* state) {
  add_message(state, block_commands(state).sends, kBlockRadios);
  return 0;
}

}  // namespace

void open_block(lua_State* state, BlockSide& side) {
  assert(side.radios.empty());
  push_robot(state);
  lua_newtable(state);
  set_functions(state,
                {{"set_all_colors", set_all_colors}, {"set_single_color", set_single_color}});
  put(state, "directional_leds");
  lua_newtable(state);
  for (std::size_t i = 0; i < kBlockRadios; ++i) {
    push_radio(state, i, block_send);
    side.radios.push_back(keep_table(state));
    put(state, kBlockRadioNames[i]);
  }
  put(state, "simple_radios");
  lua_newtable(state);
  put(state, "time", 0.0);
  side.system = keep_table(state);
  put(state, "system");
  if (is_of_2019(state)) put_radios_2019(state, side.radios);
  lua_pop(state, 1);
}

void put_readings(lua_State* state, const BlockSide& side, const BlockReadings& readings) {
  push_kept(state, side.system);
  put(state, "time", readings.time);
  lua_pop(state, 1);
  const std::size_t count = std::min(side.radios.size(), readings.radios.size());
  for (std::size_t i = 0; i < count; ++i) put_received(state, side.radios[i], readings.radios[i]);
  if (is_of_2019(state)) put_received_2019(state, side.radios);
}

}  // namespace stig::lua
