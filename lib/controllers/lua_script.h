// SPDX-License-Identifier: MIT
// A script of an experiment: Lua that sees the truth of a world and interferes with it, as no
// robot can. Callbacks on_start, on_step and on_end are each given the table `world`; what is in
// it is in docs/simulate.md. The sandbox is that of robots' programs.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "controllers/controller.h"
#include "controllers/lua_settings.h"

namespace stig {

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
  double driven = 0;  ///< m
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
  virtual void push_block(std::size_t place, const Vec3& force) = 0;
  virtual void push_robot(std::size_t place, const Vec3& force) = 0;
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

  /// Appends what it says to `log`. Once failed, it stays so.
  ControllerStatus call(ScriptCall which, ScriptWorld& world, std::vector<std::string>& log);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stig
