// SPDX-License-Identifier: MIT
// The script of a run: called where it is due, and brought back with the answers that it had.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "lua/lua_script.h"
#include "physical/robots/reading_history.h"
#include "physical/simulation/run_part.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

struct PlacedScene;
struct Scene;

class RunScript final : public SavedPart<RunScript> {
 public:
  RunScript(const Scene& scene, const PlacedScene& placed);

  bool failed() const { return failed_; }
  /// What it has measured, the newest value of each name.
  const std::map<std::string, double>& measures() const { return measures_; }
  void measure(std::string name, double value) { measures_[std::move(name)] = value; }
  /// Its last words: on_end.
  void end(RunState& run, const RunHooks& hooks);

  void before_step(RunState& run, const RunHooks& hooks) override;
  /// Its own state cannot be saved; what it was answered can.
  static void members(auto& each, auto& script) { each_member(each, script.history_); }
  /// Gives a fresh script the answers that the last one had.
  bool accept(RunState& run);

 private:
  void call(ScriptCall which, RunState& run, const RunHooks& hooks);
  void ended(const ControllerStatus& status, RunState& run);
  bool replay(ByteReader& in, RunState& run);

  std::optional<LuaScript> script_;
  bool failed_ = false;
  ReadingHistory history_;
  std::map<std::string, double> measures_;
};

}  // namespace stig::physics
