// SPDX-License-Identifier: MIT
// A script of an experiment: Lua that sees the truth of a world and interferes with it, as no
// robot can. Callbacks on_start, on_step and on_end are each given the table `world`; what is in
// it is in docs/simulate.md. The sandbox is that of robots' programs.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"
#include "lua/lua_settings.h"
#include "lua/uses.h"
#include "robots/controller.h"

namespace stig::lua {

struct ScriptBlock {
  std::string name;
  Pose X_WB;
  int colour = 0;              ///< 0 to 4, of most LEDs
  std::array<int, 6> faces{};  ///< likewise, of each face, in the order of its radios
  bool left = false;
  int lattice = 0;  ///< from 1; 0: in none
  int x = 0, y = 0, z = 0;
};
struct ScriptRobot {
  std::string name;
  Pose X_WR;
  bool failed = false;
  bool halted = false;  ///< by the script; it counts as failed
  double driven = 0;    ///< m
};

/// A block or a robot, by its place.
struct ScriptThing {
  bool robot = false;
  std::size_t place = 0;
};

/// The world as the script may see and touch it; places from 0.
class ScriptWorld {
 public:
  virtual ~ScriptWorld() = default;
  virtual double time() const = 0;
  virtual std::uint64_t seed() const = 0;
  virtual std::size_t blocks() const = 0;
  virtual ScriptBlock block(std::size_t place) const = 0;
  virtual std::size_t robots() const = 0;
  virtual ScriptRobot robot(std::size_t place) const = 0;
  virtual std::optional<ScriptThing> find(std::string_view name) const = 0;
  /// A force at the centre of mass, of a robot's root; `seconds` 0: for one step of physics.
  /// False: there are too many such.
  virtual bool push(ScriptThing thing, const Vec3& force, double seconds) = 0;
  /// Puts a block, or a whole robot by its frame, elsewhere; without a turn it stays turned as it
  /// is. Nothing, or why it cannot be there.
  virtual std::string place(ScriptThing thing, const Vec3& at, const std::optional<Quat>& turn) = 0;
  /// The robot's program is not called again, and its motors stand.
  virtual void halt(std::size_t robot) = 0;
  /// All LEDs of a block, 0 to 4.
  virtual void set_colour(std::size_t block, int colour) = 0;
  /// Faults of devices, and their ends. A robot's cameras see nothing; radios neither send nor
  /// receive; LEDs of a block, a bit each in their order, stay dark whatever is set.
  virtual void set_camera(std::size_t robot, bool alive) = 0;
  virtual void set_radio(ScriptThing thing, bool alive) = 0;
  virtual void set_leds(std::size_t block, std::uint32_t which, bool alive) = 0;
  /// What touches a body rubs it with so many times the friction of their materials. False: nothing
  /// is called so.
  virtual bool set_friction(std::string_view body, double factor) = 0;
  /// The new block's place; nothing, with a reason, when there is no room or no stock.
  virtual std::optional<std::size_t> drop(const Pose& X_WB, std::string& problem) = 0;
  virtual void stop(std::string reason) = 0;
  virtual void measure(std::string name, double value) = 0;
};

enum class ScriptCall : std::uint8_t { start, step, end };

class LuaScript {
 public:
  LuaScript(LuaProgram program, LuaSettings settings);
  ~LuaScript();
  LuaScript(LuaScript&&) noexcept;
  LuaScript& operator=(LuaScript&&) noexcept;

  /// Runs its text alone, before any call and for whoever would know whether it is sound.
  enum class Loaded : std::uint8_t { good, failed, without_callback };
  Loaded load();
  /// What ended the call that failed, or the loading, and where.
  const LuaFailure& failure() const;
  /// Appends what it says to `log`. Once failed, it stays so.
  ControllerStatus call(ScriptCall which, ScriptWorld& world, std::vector<std::string>& log);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stig::lua
