// SPDX-License-Identifier: MIT
// What a Lua program runs under: its text, its limits, its parameters and its randomness.
// Programs are untrusted; docs/controllers.md says what they find and what they do not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/file_io.h"
#include "lua/uses.h"

namespace stig::lua {

/// Limits of one state. Work other than instructions (searching texts, sorting, strings) is
/// charged as instructions too, so that the first of these bounds the time of a call.
struct LuaLimits {
  std::uint64_t instructions = 1'000'000;  ///< a call of init, step, reset or destroy
  std::size_t memory = std::size_t{16} << 20;
  std::size_t object = std::size_t{1} << 20;   ///< one list, one stack of calls
  std::size_t string = std::size_t{64} << 10;  ///< one string
  int depth = 5000;                            ///< calls nested within each other
};
/// As for robots, but small: there are thousands of blocks.
LuaLimits block_limits();

/// The generation of the robot's interface that a program was written for. That of 2019 has all of
/// 2021's and what docs/controllers.md lists besides.
enum class InterfaceLevel : std::uint8_t { of_2021, of_2019 };

struct LuaProgram {
  std::string path;  ///< as messages say it; `require` looks beside it
  std::string text;
  /// What `require` finds without looking for files: a scene's programs bring theirs. By name, or,
  /// for programs of 2019, by the path of the file: see module_path.
  std::vector<std::pair<std::string, std::string>> modules{};
  bool whole = false;  ///< `require` knows `modules` and no files
  InterfaceLevel interface = InterfaceLevel::of_2021;
};
/// The path of the file that a module of the program comes from, by its entry in `modules`.
std::string module_path(const LuaProgram& program, const std::string& module);
/// Names that a text's `require 'name'` asks for, as far as they are written out; each once.
std::vector<std::string> required_names(std::string_view text);
/// Whether `require` takes the name: letters, digits, _ and -, and a dot after each folder.
bool is_module_name(std::string_view name);
/// Where a module of such a name is, from the program's folder: "motion/lift.lua" for motion.lift.
std::string module_file(std::string_view name);
inline constexpr std::size_t kMostLuaSource = std::size_t{256} << 10;
std::optional<LuaProgram> read_lua_program(const std::string& path, FileError& error);

/// What ended a program, and where as far as that is known.
struct LuaFailure {
  std::string file;      ///< as messages say it: a path, or the end of a long one; empty: unknown
  std::size_t line = 0;  ///< from 1; 0: unknown
  std::string what;      ///< without the place
};

using LuaValue = std::variant<bool, double, std::string>;

/// Where a line of a generated program came from: file and line.
using LineMap =
    std::function<std::optional<std::pair<std::string, int>>(const std::string& file, int line)>;

struct LuaSettings {
  std::string id;  ///< robot.id
  std::vector<std::pair<std::string, LuaValue>> params;
  LuaLimits limits;
  std::uint64_t seed = 0;
  std::uint32_t run = 0;    ///< below 2^24
  std::uint32_t agent = 0;  ///< tells the streams of one run's robots apart
  LineMap line_map;
};

}  // namespace stig::lua
