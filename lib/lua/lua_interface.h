// SPDX-License-Identifier: MIT
// The tables that a program finds under `robot`: their making, and the readings that go into
// them before each step. Tables are kept by reference, so that a program may rename, hide or
// replace what it likes; fields are set raw, past any metatable.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lua/uses.h"
#include "robots/robot_io.h"
#include "robots/robot_model.h"

struct lua_State;

namespace stig::lua {

/// What the functions of the interface act on: LuaBox::user().
struct LuaSide {
  std::vector<std::string>* log = nullptr;  ///< of the call that runs
  std::size_t logged = 0;                   ///< bytes in this call
};

/// References to the tables that the readings of a kind of device go into.
template <class Kind>
struct KeptTables {
  std::vector<int> references;
};
template <class Kinds>
struct KeptTablesOf;
template <class... Kinds>
struct KeptTablesOf<KindList<Kinds...>> : KeptTables<Kinds>... {};

struct RobotSide : LuaSide {
  RobotModel model;
  const RobotReadings* readings = nullptr;  ///< of the last step
  RobotCommands* commands = nullptr;
  KeptTablesOf<DeviceKinds> kept;
  int system = 0;

  /// In the order of the devices.
  template <class Kind>
  std::vector<int>& tables() {
    return static_cast<KeptTables<Kind>&>(kept).references;
  }
  template <class Kind>
  const std::vector<int>& tables() const {
    return static_cast<const KeptTables<Kind>&>(kept).references;
  }
};

struct BlockSide : LuaSide {
  BlockCommands* commands = nullptr;
  std::vector<int> radios;
  int system = 0;
};

/// In the order of a block's radios and faces.
inline constexpr const char* kBlockRadioNames[kBlockRadios] = {"north", "east", "south",
                                                               "west",  "top",  "bottom"};

/// The global `robot` with id, params, logger, and the rest of its devices.
void open_robot(lua_State* state, RobotSide& side);
void open_block(lua_State* state, BlockSide& side);
void put_readings(lua_State* state, const RobotSide& side, const RobotReadings& readings);
void put_readings(lua_State* state, const BlockSide& side, const BlockReadings& readings);

// What programs of 2019 find besides, with `robot` on top:
bool is_of_2019(lua_State* state);
void open_robot_2019(lua_State* state, const RobotSide& side);
/// robot.radios, which are the same tables as simple_radios, with what came as rx_data, and tx_data
/// to send.
void put_radios_2019(lua_State* state, const std::vector<int>& radios);
void put_received_2019(lua_State* state, const std::vector<int>& radios);

// What both are made of:

/// Puts the value on top into the table under it.
void put(lua_State* state, const char* key);
void put(lua_State* state, const char* key, double number);
void put(lua_State* state, const char* key, bool truth);
void put(lua_State* state, const char* key, std::string_view text);
inline void put(lua_State* state, const char* key, const char* text) {
  put(state, key, std::string_view(text));  // and not as the truth that a pointer is
}
/// Puts a function that knows a device's place in its list.
void put_function(lua_State* state, const char* key, int (*function)(lua_State*),
                  std::size_t device = 0);
/// The place that put_function gave.
std::size_t device_of(lua_State* state);
/// A reference to the table on top, which stays there.
int keep_table(lua_State* state);
void push_kept(lua_State* state, int reference);

/// `robot` on the stack with id, params and logger, and the globals log, logerr and print.
void push_robot(lua_State* state);

/// A radio with its send function and an empty recv.
void push_radio(lua_State* state, std::size_t place, int (*send)(lua_State*));
/// The argument of send, a list of bytes or a text, into what a radio sends.
void add_message(lua_State* state, std::vector<std::vector<Message>>& sends, std::size_t radios);
void put_received(lua_State* state, int radio, const std::vector<Message>& messages);

}  // namespace stig::lua
