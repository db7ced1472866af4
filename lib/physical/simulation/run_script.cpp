// SPDX-License-Identifier: MIT
// A script's Lua state cannot be saved. So while a run may be resumed, each call is recorded with
// everything that the script was answered; a resumed run calls a fresh script again with these
// answers (script_record.h). What it did to the world is in the world's own checkpoint.
#include "physical/simulation/run_script.h"

#include "physical/scene/lua_programs.h"
#include "physical/simulation/run_state.h"
#include "physical/simulation/scene_script.h"
#include "physical/simulation/script_record.h"

namespace stig::physics {

RunScript::RunScript(const Scene& scene, const PlacedScene& placed)
    : script_(script_of(scene, placed)) {}

void RunScript::before_step(RunState& run, const RunHooks& hooks) {
  if (!script_ || !looks_now(run)) return;
  // on_start is called in the first tick, before the first on_step.
  if (run.world.tick() == 0) call(ScriptCall::start, run, hooks);
  if (!run.stop) call(ScriptCall::step, run, hooks);
}

void RunScript::end(RunState& run, const RunHooks& hooks) {
  if (script_ && !failed_) call(ScriptCall::end, run, hooks);
}

void RunScript::call(ScriptCall which, RunState& run, const RunHooks& hooks) {
  SceneScript world(run);
  std::string answers;
  RecordedWorld recorded(world, answers);
  // Recording costs memory, so it is left out where nobody can resume.
  ScriptWorld& seen = run.resumable ? static_cast<ScriptWorld&>(recorded) : world;
  std::vector<std::string> log;
  ended(script_->call(which, seen, log), run);
  if (run.resumable) {
    std::string record(1, static_cast<char>(which));
    put_block(record, answers);
    record.push_back(failed_ ? '\1' : '\0');
    history_.add(record);
  }
  // Lines of a script belong to no body.
  for (const std::string& line : log) {
    if (hooks.on_line) hooks.on_line({run.world.tick(), "script", {}, line, false});
  }
}

/// A failure ends the run as a stop does.
void RunScript::ended(const ControllerStatus& status, RunState& run) {
  if (status.ok) return;
  failed_ = run.stop = true;
  run.message = status.error;
}

bool RunScript::accept(RunState& run) {
  if (!script_) return true;
  // The script needs no world here, since it gets the answers that were recorded.
  return history_.each([&](ByteReader& in) { return replay(in, run); });
}

/// One call.
bool RunScript::replay(ByteReader& in, RunState& run) {
  const std::uint8_t which = in.u8();
  ByteReader answers(in.block());
  const bool failed = in.u8() == 1;
  if (!in.good() || which > static_cast<std::uint8_t>(ScriptCall::end)) return false;
  ReplayedWorld world(answers);
  std::vector<std::string> said;
  ended(script_->call(static_cast<ScriptCall>(which), world, said), run);
  if (world.stopped) {
    run.stop = true;
    run.message = *world.stopped;
  }
  for (const auto& [name, value] : world.measures) measures_[name] = value;
  // All answers used, and the same outcome: otherwise the bytes are of another script.
  return answers.good() && answers.left() == 0 && failed_ == failed;
}

}  // namespace stig::physics
