// SPDX-License-Identifier: MIT
// Simulation, watch and robots' records are parts of one loop; after each fifth of a second the
// observer looks, and the run ends by `halt_`, the same flag that an interruption sets. So a run
// that is complete, stuck or spoilt ends between two steps like any other and its trace is whole.
#include "validate/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>

#include "physical/simulation/run_picture.h"
#include "validate/robot_watch.h"

namespace stig::validate {
namespace {

// The control period of the robots that ship.
constexpr double kLookSeconds = 0.2;
constexpr double kSettled = 10;        ///< s, that the whole structure has to stand
constexpr double kSpoilt = 300;        ///< s, that a wrong brick has to stand
constexpr double kNothingMoves = 600;  ///< s
constexpr std::size_t kMostLines = 200;

class TrialRun {
 public:
  TrialRun(const BuildTarget& target, const Scene& scene, const PlacedScene& placed,
           const TrialSettings& settings, const TrialHooks& hooks)
      : target_(target),
        settings_(settings),
        hooks_(hooks),
        // Not resumable: nobody takes a trial up again, and accounts of readings would take memory.
        run_(scene, placed, false),
        robots_(run_),
        watch_(target),
        look_every_(std::max<std::uint64_t>(
            1, static_cast<std::uint64_t>(std::llround(kLookSeconds / placed.config.step)))),
        standing_(target.sites.size()) {}

  Trial go() {
    if (settings_.trace != nullptr) run_.record(*settings_.trace);
    RunHooks hooks;
    hooks.stop = &halt_;
    hooks.on_line = [this](const CrewLine& line) { note(line); };
    hooks.after_step = [this](const World& world) { after_step(world); };
    const RunEnd end = run_.until(settings_.duration, hooks);
    run_.end_script(hooks);
    // A run that was halted here ends as planned, for its trace.
    run_.finish(end == RunEnd::interrupted && end_ != TrialEnd::interrupted ? RunEnd::duration
                                                                            : end);
    return report(end);
  }

 private:
  void note(const CrewLine& line) {
    lines_.push_back({static_cast<double>(line.tick) * run_.placed().config.step, line.who,
                      line.text, line.failure});
    // The last lines are kept: what a robot said before it failed.
    if (lines_.size() > kMostLines) lines_.pop_front();
  }

  void after_step(const World& world) {
    robots_.after_step();
    if (hooks_.stop != nullptr && hooks_.stop->load(std::memory_order_relaxed)) {
      return halt(TrialEnd::interrupted);
    }
    // Looking costs a fit of every block; states and motors above are noted each step.
    if (world.tick() % look_every_ != 0) return;
    watch_.look(world.time(), blocks(), robots_.hands());
    if (hooks_.progress) hooks_.progress(world.time(), watch_.brick_count());
    take_picture();
    if (const auto end = work_over(world.time())) return halt(*end);
    // Neither a robot nor a brick has moved for so long; or all are out at once.
    const double last = std::max(robots_.last_motion(), last_event());
    if (robots_.all_out() || world.time() - last >= kNothingMoves) halt(TrialEnd::stuck);
  }

  /// When every structure is over, one way or the other.
  std::optional<TrialEnd> work_over(double now) {
    // How long something has held without a break.
    const auto since = [&](bool holds, double& began) {
      began = !holds ? -1 : began < 0 ? now : began;
      return holds ? now - began : 0;
    };
    bool over = true;
    TrialEnd end = TrialEnd::built;
    for (std::size_t i = 0; i < standing_.size(); ++i) {
      const bool built = since(stands(target_, i, watch_), standing_[i].whole) >= kSettled;
      const bool bad = since(spoilt(target_, i, watch_), standing_[i].spoilt) >= kSpoilt;
      if (bad) end = TrialEnd::spoilt;
      over = over && (built || bad);
    }
    return over ? std::optional(end) : std::nullopt;
  }

  void halt(TrialEnd why) {
    // The first reason counts.
    if (halt_) return;
    end_ = why;
    halt_ = true;
  }

  double last_event() const { return watch_.events().empty() ? 0 : watch_.events().back().time; }

  std::vector<WatchedBlock> blocks() const {
    std::vector<WatchedBlock> out;
    const auto& bodies = run_.placed().config.bodies;
    for (std::size_t i = 0; i < run_.world().size(); ++i) {
      if (!run_.placed().bodies[i].block) continue;
      const BodyState state = run_.world().state(BodyId{static_cast<std::uint32_t>(i)});
      if (state.left) continue;
      // Blocks from caches come after those of the config, and are never fixed.
      out.push_back({i, state.X_WB, run_.led(i), i < bodies.size() && bodies[i].fixed});
    }
    return out;
  }

  /// After so many bricks that the pictures part the work evenly. Pictures at even shares of the
  /// work, whatever time it takes; the end has its own.
  void take_picture() {
    if (settings_.pictures <= 0) return;
    const std::size_t structures = target_.sites.size();
    const std::size_t start = structures * target_.rules->start.size();
    const std::size_t whole = structures * target_.whole.size();
    const auto parts = static_cast<std::size_t>(settings_.pictures) + 1;
    const std::size_t due = start + (pictures_.size() + 1) * (whole - start) / parts;
    if (pictures_.size() + 1 == parts || watch_.brick_count() < std::max(due, start + 1)) return;
    pictures_.push_back(picture());
  }

  TrialPicture picture() const {
    PictureLook look;
    // Twice the width that a figure has on the report's page.
    look.width = 640;
    look.height = 420;
    const bool floor = run_.placed().config.floor;
    const std::vector<PictureBody> bodies = picture_bodies(run_);
    const ScenePicture drawn = draw_bodies(bodies, fitted_view(bodies, look), floor);
    return {run_.world().time(), png_of(drawn.image, fmt::format("{:.0f} s", run_.world().time()))};
  }

  Trial report(RunEnd end) {
    Trial out;
    out.seed = run_.placed().seed;
    out.hash = run_.hash();
    out.end = end_of(end);
    out.message = run_.message();
    out.time = run_.world().time();
    out.events = watch_.events();
    out.hauls = watch_.hauls();
    out.robots = robots_.finish(watch_);
    out.measures = run_.measures();
    std::vector<WatchedBlock> free = blocks();
    for (WatchedBlock& block : free) {
      const BodyId body{static_cast<std::uint32_t>(block.block)};
      block.dead = run_.crew() != nullptr && run_.crew()->leds_dead(body);
    }
    // Counted before those in hands are taken out.
    out.blocks = count(free);
    out.broken = broken_parts();
    out.caches = cache_troubles(*target_.rules, free, watch_, run_.scene().caches);
    // A block that is being carried is not in anybody's way yet.
    std::erase_if(free, [this](const WatchedBlock& block) { return watch_.held(block.block); });
    for (std::size_t i = 0; i < target_.sites.size(); ++i) {
      out.judgements.push_back(judge(target_, i, free, out.events));
    }
    std::erase_if(free, [this](const WatchedBlock& block) {
      return block.fixed || watch_.is_part(block.block);
    });
    out.loose = std::move(free);
    out.lines = {lines_.begin(), lines_.end()};
    if (settings_.pictures >= 0) pictures_.push_back(picture());
    out.pictures = std::move(pictures_);
    return out;
  }

  std::vector<std::string> broken_parts() const {
    std::vector<std::string> out;
    if (run_.crew() != nullptr) out = run_.crew()->broken();
    for (std::uint32_t i = 0; i < run_.world().size(); ++i) {
      const double grip = run_.world().grip(BodyId{i});
      if (grip == 1) continue;
      out.push_back(fmt::format("{} rubs with {:.3g} times its friction",
                                run_.placed().bodies[i].name, grip));
    }
    return out;
  }

  BlockCount count(const std::vector<WatchedBlock>& there) const {
    BlockCount out = count_blocks(there, watch_, run_.scene().caches);
    const std::size_t began = run_.placed().config.bodies.size();
    // Bodies beyond those of the scene came while it ran.
    for (std::size_t i = 0; i < run_.world().size(); ++i) {
      if (!run_.placed().bodies[i].block) continue;
      ++(i < began ? out.began : out.dropped);
      if (run_.world().state(BodyId{static_cast<std::uint32_t>(i)}).left) ++out.left;
    }
    return out;
  }

  TrialEnd end_of(RunEnd end) const {
    const bool interrupted = end == RunEnd::interrupted && end_ == TrialEnd::interrupted;
    if (run_.script_failed() && !interrupted) return TrialEnd::script_failed;
    switch (end) {
      case RunEnd::interrupted:
        return end_;
      case RunEnd::diverged:
        return TrialEnd::diverged;
      case RunEnd::script:
        return TrialEnd::script;
      case RunEnd::failed:
      case RunEnd::asleep:
        // Every robot's program failed, or nothing moves: the same to a trial.
        return TrialEnd::stuck;
      case RunEnd::duration:
        break;
    }
    return TrialEnd::time;
  }

  const BuildTarget& target_;
  const TrialSettings& settings_;
  const TrialHooks& hooks_;
  Simulation run_;
  RobotWatch robots_;
  Watch watch_;
  std::uint64_t look_every_;
  std::atomic<bool> halt_{false};
  TrialEnd end_ = TrialEnd::time;
  struct Since {
    double whole = -1, spoilt = -1;  ///< s; -1: it is not
  };
  std::vector<Since> standing_;  ///< of each structure
  std::deque<TrialLine> lines_;
  std::vector<TrialPicture> pictures_;
};

}  // namespace

std::string_view to_string(TrialEnd end) {
  constexpr std::string_view kNames[] = {"built",  "out of time", "spoilt",      "stuck",
                                         "script", "diverged",    "interrupted", "script failed"};
  return kNames[static_cast<std::size_t>(end)];
}

bool broke_off(TrialEnd end) {
  return end == TrialEnd::interrupted || end == TrialEnd::diverged ||
         end == TrialEnd::script_failed;
}

BuildVerdict Trial::verdict() const {
  assert(!judgements.empty());
  // In the order of their gravity.
  BuildVerdict worst = BuildVerdict::complete;
  for (const Judgement& judgement : judgements) worst = std::max(worst, judgement.verdict);
  return worst;
}

TrialTotals totals_of(const Trial& trial) {
  TrialTotals out;
  for (const Judgement& one : trial.judgements) {
    out.wanted += one.bricks.size();
    out.there += one.bricks.size() - one.missing();
    out.placements += one.placements;
    out.allowed += one.allowed;
    out.worst_way = std::max(out.worst_way, one.worst_way);
    out.worst_turn = std::max(out.worst_turn, one.worst_turn);
  }
  return out;
}

std::optional<double> last_placement(const Trial& trial, std::size_t structure) {
  std::optional<double> last;
  for (const BrickEvent& event : trial.events) {
    if (event.structure == structure && event.kind == BrickEvent::Kind::placed) last = event.time;
  }
  return last;
}

Trial run_trial(const BuildTarget& target, const Scene& scene, const PlacedScene& placed,
                const TrialSettings& settings, const TrialHooks& hooks) {
  assert(target.rules != nullptr && !target.sites.empty() && settings.duration >= 0);
  return TrialRun(target, scene, placed, settings, hooks).go();
}

}  // namespace stig::validate
