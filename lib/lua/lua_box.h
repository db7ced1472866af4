// SPDX-License-Identifier: MIT
// A Lua state that untrusted code may run in.
//
// Instructions are counted by a hook and work of library functions is charged by them; memory is
// counted by the allocator. Who exceeds a limit is stopped for good: whatever catches errors
// (pcall, coroutines) raises again, until the call from outside ends. Lua's own collector is
// off; the box collects after a fixed amount of objects made, since when Lua would collect
// depends on addresses, and weak tables would show it.
//
// liblua5.4-c++ is Lua compiled as C++: errors are exceptions, destructors run.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "lua/lua_settings.h"
#include "lua/uses.h"
#include "robots/controller.h"

struct lua_State;
struct lua_Debug;

namespace stig::lua {

class LuaBox {
 public:
  using Body = int (*)(lua_State*);

  /// `user` is what the functions of the interface act on.
  LuaBox(LuaProgram program, LuaSettings settings, void* user);
  ~LuaBox();
  LuaBox(const LuaBox&) = delete;
  LuaBox& operator=(const LuaBox&) = delete;

  static LuaBox& of(lua_State* state);

  /// Calls `body(argument)` protected, with a whole budget; a failure says file, line and
  /// robot, and its traceback is `traceback()`.
  ControllerStatus run(Body body, void* argument);
  const std::string& traceback() const { return traceback_; }
  const LuaFailure& last_failure() const { return last_failure_; }

  /// Work of a library function, in instructions; raises an error when the budget is spent.
  void charge(lua_State* state, std::uint64_t instructions);
  /// What is left of the budget, at least 0.
  std::uint64_t left() const { return budget_ > 0 ? static_cast<std::uint64_t>(budget_) : 0; }
  bool stopped() const { return stop_ != Stop::none; }

  const LuaProgram& program() const { return program_; }
  const LuaSettings& settings() const { return settings_; }
  void* user() const { return user_; }
  Random& random() { return random_; }
  void reseed(std::uint64_t key);
  std::uint64_t next_number() { return ++last_number_; }
  /// Bytes in use, all of the state's.
  std::size_t memory() const { return used_; }
  /// Bytes of objects made since the last collection; the same in every run.
  std::size_t made() const { return made_; }
  /// Name under which messages speak of a file.
  std::string chunk_name(const std::string& path);

  /// A resumed coroutine counts its instructions from the start of an interval.
  static constexpr int kHookInterval = 500;

 private:
  enum class Stop : std::uint8_t { none, instructions, depth, memory };

  static void* allocate(void* user, void* block, std::size_t old_size, std::size_t new_size);
  static void count(lua_State* state, lua_Debug* frame);
  static int explain(lua_State* state);
  bool may_grow(bool is_new, std::size_t tag, std::size_t old_size, std::size_t new_size);
  bool starve(Stop reason);
  void stop(lua_State* state, int level, Stop reason);
  void leave_hook(lua_State* state, Stop reason);
  void note_traceback(lua_State* state, int level);
  void collect();
  std::string failure(int status);
  std::string mapped(std::string text) const;
  LuaFailure placed(std::string_view text) const;
  void new_random();

  LuaProgram program_;
  LuaSettings settings_;
  void* user_;
  lua_State* state_ = nullptr;
  std::int64_t budget_ = 0;
  std::size_t used_ = 0, made_ = 0;
  int refusals_ = 0;      ///< of the next attempts to grow, to leave the hook
  bool starved_ = false;  ///< the last attempt to grow failed
  Stop stop_ = Stop::none;
  std::string stop_message_, traceback_;
  LuaFailure last_failure_;
  std::uint64_t last_number_ = 0;
  std::vector<std::string> files_;
  std::uint64_t key_;
  std::uint64_t epoch_ = 0;  ///< calls since the generator was keyed
  Random random_;
};

}  // namespace stig::lua
