// SPDX-License-Identifier: MIT
// The trace is kept in memory, since going back to a checkpoint takes from it what came later.
// Pieces of a run end at whole ticks and at no other condition, so that it is the run that
// `stigc simulate` makes.
#include "live/pose_live.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "physical/render/show_json.h"
#include "physical/simulation/checkpoint_file.h"
#include "physical/simulation/simulation.h"
#include "view/pose_run.h"

namespace stig::live {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kTicksAtOnce = 4;  ///< between two looks at the clock

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// A run without steps, as a page has it.
PoseTrace beginning_of(const LoadedScene& loaded) {
  std::string bytes;
  PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                         [&](std::string_view more) { bytes += more; });
  Simulation run(loaded.scene, loaded.placed, false);
  run.record(writer);
  run.finish(RunEnd::duration);
  Diagnostics ignored;
  auto trace = read_pose_trace("", std::move(bytes), ignored);
  assert(trace);
  return std::move(*trace);
}

class PoseLive final : public LiveRun {
 public:
  explicit PoseLive(LoadedScene loaded) : loaded_(std::move(loaded)) {
    hooks_.on_line = [this](const CrewLine& line) { lines_.push_back(line); };
    run_ = std::make_unique<Simulation>(loaded_.scene, loaded_.placed);
    begin_trace();
    run_->record(*writer_);
  }

  void add_to(PageContent& page) const override {
    add_pose_run(beginning_of(loaded_), loaded_.scene.title, page);
  }
  double time() const override { return run_->world().time(); }
  double end() const override { return loaded_.scene.duration; }
  double rate() const override { return 1; }
  double one_step() const override { return step(); }

  void advance(double units, Clock::time_point until) override {
    // Whole ticks: what a piece leaves over is the next one's.
    due_ += units / step();
    while (due_ >= 1 && ended().empty()) {
      const auto ticks = std::min(kTicksAtOnce, static_cast<std::uint64_t>(std::min(due_, 1e9)));
      const std::uint64_t before = run_->world().tick();
      go_on(before + ticks);
      due_ -= static_cast<double>(ticks);
      if (Clock::now() >= until) break;
    }
    due_ = std::min(due_, 1.0);  // what the clock did not allow is not made up for
  }

  std::string ended() const override {
    if (!end_) return {};
    return run_->message().empty() ? std::string(to_string(*end_)) : run_->message();
  }

  std::string state() const override;
  std::string take_news() override {
    std::string out;
    for (; told_ < lines_.size(); ++told_) {
      const CrewLine& line = lines_[told_];
      fmt::format_to(std::back_inserter(out), "{}[{:.3f},{},{}]", out.empty() ? "" : ",",
                     static_cast<double>(line.tick) * step(), static_cast<std::uint32_t>(line.body),
                     quoted(line.who + ": " + line.text));
    }
    return out;
  }

  std::string work(const HandAction& action) override {
    // An end by the script, by failure or by divergence is in the middle of a tick.
    if (end_ && *end_ != RunEnd::asleep && *end_ != RunEnd::duration) return "the run has ended";
    std::string problem = run_->intervene(action);
    if (!problem.empty()) return problem;
    ++hands_;
    if (end_ == RunEnd::asleep && run_->world().awake_count() > 0) end_.reset();
    return {};
  }

  LiveCheckpoint checkpoint() override {
    return {time(), checkpoint_bytes({loaded_.scene.files, loaded_.placed.seed, run_->state()}),
            hands_};
  }
  void go_back(const LiveCheckpoint& checkpoint) override;

  std::string finish() override {
    run_->end_script(hooks_);
    run_->finish(end_.value_or(RunEnd::interrupted));
    return trace_;
  }

 private:
  double step() const { return loaded_.placed.config.step; }

  void begin_trace() {
    trace_.clear();
    writer_ = std::make_unique<PoseTraceWriter>(trace_header(loaded_.scene, loaded_.placed),
                                                [this](std::string_view more) { trace_ += more; });
  }

  void go_on(std::uint64_t tick) {
    const double duration = loaded_.scene.duration;
    const auto last = static_cast<std::uint64_t>(std::ceil(duration / step() - 1e-6));
    const RunEnd end = run_->until(static_cast<double>(std::min(tick, last)) * step(), hooks_);
    if (end != RunEnd::duration || run_->world().tick() >= last) end_ = end;
  }

  LoadedScene loaded_;
  RunHooks hooks_;
  std::string trace_;
  std::unique_ptr<PoseTraceWriter> writer_;
  std::unique_ptr<Simulation> run_;
  std::optional<RunEnd> end_;
  std::vector<CrewLine> lines_;  ///< that programs said
  std::size_t told_ = 0;         ///< of them
  std::size_t hands_ = 0;        ///< done in the run so far
  double due_ = 0;               ///< ticks
};

std::string PoseLive::state() const {
  const World& world = run_->world();
  std::string bodies, leds, show, broken, robots;
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    const TraceState now = trace_state(world.state(BodyId{i}));
    const auto& [x, y, z] = now.place;
    const auto& [qw, qx, qy, qz] = now.turn;
    fmt::format_to(std::back_inserter(bodies), "{}[{},{},{},{},{},{},{},{}]",
                   bodies.empty() ? "" : ",", now.left ? 1 : 0, x, y, z, qw, qx, qy, qz);
    leds += static_cast<char>('0' + static_cast<int>(run_->led(i)));
  }
  const Crew* crew = run_->crew();
  for (std::size_t r = 0; crew != nullptr && r < crew->robots(); ++r) {
    const char* comma = r == 0 ? "" : ",";
    show += comma + quoted(show_json(crew->commands(r).user, inverse(crew->root_pose(r))));
    const Pose pose = crew->robot_pose(world, r);
    fmt::format_to(std::back_inserter(robots), "{}[{:.5f},{:.5f},{:.5f}]", comma, pose.p.x,
                   pose.p.y, pose.p.z);
    broken += comma;
    broken += crew->halted(r) ? "1" : crew->failed(r) ? "2" : "0";
  }
  return fmt::format(R"("bodies":[{}],"leds":"{}","show":[{}],"broken":[{}],"robots":[{}])", bodies,
                     leds, show, broken, robots);
}

// The trace is read, and its records up to the checkpoint written anew, as for a run that is taken
// up again from a file.
void PoseLive::go_back(const LiveCheckpoint& checkpoint) {
  std::string problem;
  const auto read = read_checkpoint_file(checkpoint.bytes, problem);
  run_->finish(RunEnd::interrupted);
  Diagnostics ignored;
  const auto trace = read_pose_trace("", std::move(trace_), ignored);
  assert(read && trace);
  run_ = std::make_unique<Simulation>(loaded_.scene, loaded_.placed);
  [[maybe_unused]] const bool good = run_->resume(read->state);
  assert(good);
  begin_trace();
  const std::uint64_t tick = run_->world().tick();
  if (tick > 0) copy_records(*trace, tick, *writer_, checkpoint.mark);
  run_->record(*writer_);
  for (std::size_t i = 0; tick == 0 && i < checkpoint.mark; ++i) writer_->hand(trace->hands[i]);
  hands_ = checkpoint.mark;
  end_.reset();
  due_ = 0;
  told_ = 0;
  std::erase_if(lines_, [&](const CrewLine& line) { return line.tick >= tick; });
}

}  // namespace

std::unique_ptr<LiveRun> pose_live(LoadedScene loaded) {
  return std::make_unique<PoseLive>(std::move(loaded));
}

}  // namespace stig::live
