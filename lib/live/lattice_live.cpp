// SPDX-License-Identifier: MIT
// The engines run from their beginning to their end, so one has a thread of its own that waits
// where it places a brick until it may go on. It is let on by numbers of bricks; a run is a
// function of its config alone, wherever it waits.
#include "live/lattice_live.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <thread>

#include "lattice/trace.h"
#include "rules/rule_table.h"
#include "view/lattice_run.h"

namespace stig::live {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBricksASecond = 10;        ///< at speed 1
constexpr std::uint64_t kTakenAtOnce = 256;  ///< bricks, so that the lock costs little

/// The engine in its thread.
class EngineThread {
 public:
  EngineThread(const RuleSet& rules, const RuleTable& table, const SwarmConfig& config)
      : thread_([this, &rules, &table, config] { run(rules, table, config); }) {}
  ~EngineThread() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
      wake_.notify_all();
    }
    thread_.join();
  }
  EngineThread(const EngineThread&) = delete;
  EngineThread& operator=(const EngineThread&) = delete;

  /// Lets it place so many bricks more, and waits until it has, or has ended, or the time is over;
  /// what it has not used by then is taken back. New ones are appended to `placed`.
  void go_on(std::uint64_t bricks, Clock::time_point until, std::vector<Deposit>& placed) {
    std::unique_lock lock(mutex_);
    allowed_ = bricks;
    wake_.notify_all();
    idle_.wait_until(lock, until, [this] { return result_ || (allowed_ == 0 && waits_); });
    allowed_ = 0;
    placed.insert(placed.end(), ready_.begin(), ready_.end());
    ready_.clear();
  }
  /// Nothing while it runs.
  std::optional<SwarmResult> result() const {
    const std::lock_guard lock(mutex_);
    return result_;
  }
  /// The step that its next brick is of, while it waits to place it.
  std::optional<std::uint64_t> waits_in() const {
    const std::lock_guard lock(mutex_);
    return waits_ ? std::optional(step_) : std::nullopt;
  }

 private:
  void run(const RuleSet& rules, const RuleTable& table, const SwarmConfig& config) {
    SwarmHooks hooks;
    hooks.stop = &stop_;
    hooks.deposit = [this](const Deposit& deposit) { placed(deposit); };
    // Bricks that wait to be handed over do not wait for the next ones, which may take long.
    hooks.progress = [this](std::uint64_t, std::uint64_t) {
      const std::lock_guard lock(mutex_);
      hand_over();
    };
    SwarmResult result = run_swarm(table, rules.start, config, hooks);
    const std::lock_guard lock(mutex_);
    hand_over();
    result_ = std::move(result);
    idle_.notify_all();
  }
  void placed(const Deposit& deposit) {
    if (taken_ == 0) wait_for_leave(deposit.step);
    if (stop_) return;
    --taken_;
    fresh_.push_back(deposit);
  }
  void wait_for_leave(std::uint64_t step) {
    std::unique_lock lock(mutex_);
    step_ = step;
    hand_over();
    waits_ = true;
    idle_.notify_all();
    wake_.wait(lock, [this] { return stop_ || allowed_ > 0; });
    waits_ = false;
    taken_ = std::min(allowed_, kTakenAtOnce);
    allowed_ -= taken_;
  }
  void hand_over() {
    ready_.insert(ready_.end(), fresh_.begin(), fresh_.end());
    fresh_.clear();
  }

  mutable std::mutex mutex_;
  std::condition_variable wake_, idle_;
  std::uint64_t allowed_ = 0;
  bool waits_ = false;
  std::uint64_t step_ = 0;
  std::vector<Deposit> ready_;
  std::optional<SwarmResult> result_;
  std::atomic<bool> stop_{false};
  // The engine's own.
  std::uint64_t taken_ = 0;
  std::vector<Deposit> fresh_;
  std::thread thread_;  // last: it uses the others
};

class LatticeLive final : public LiveRun {
 public:
  LatticeLive(RuleSet rules, const SwarmConfig& config, std::string name)
      : rules_(std::move(rules)), table_(rules_), config_(config), name_(std::move(name)) {
    engine_.emplace(rules_, table_, config_);
  }

  void add_to(PageContent& page) const override {
    Trace trace;
    trace.config = config_;
    trace.final_hash = structure_hash(Structure(rules_.lattice, rules_.start));
    add_lattice_run(trace, rules_, name_, page);
  }
  double time() const override { return static_cast<double>(placed_.size()); }
  double end() const override { return 0; }
  double rate() const override { return kBricksASecond; }
  double one_step() const override { return 1; }

  void advance(double units, Clock::time_point until) override {
    due_ = std::min(due_ + units, 1e9);
    if (due_ < 1 || result_) return;
    const std::size_t before = placed_.size();
    engine_->go_on(static_cast<std::uint64_t>(due_), until, placed_);
    due_ = std::clamp(due_ - static_cast<double>(placed_.size() - before), 0.0, 1.0);
    result_ = engine_->result();
  }
  std::string ended() const override {
    return result_ ? std::string(to_string(result_->terminated)) : std::string();
  }
  std::string state() const override {
    return fmt::format("\"bricks\":{}", rules_.start.size() + placed_.size());
  }
  std::string take_news() override {
    std::string out;
    for (; told_ < placed_.size(); ++told_) {
      const Deposit& d = placed_[told_];
      fmt::format_to(std::back_inserter(out), "{}[{},{},{},{},{},{},{}]", out.empty() ? "" : ",",
                     d.site.x, d.site.y, d.site.z, d.colour, d.match.rule, d.agent, d.step);
    }
    return out;
  }

  std::string work(const HandAction& /*action*/) override {
    return "on a lattice only rules place bricks";
  }
  LiveCheckpoint checkpoint() override { return {time(), trace(), placed_.size()}; }
  /// The same run again, as far as it was.
  void go_back(const LiveCheckpoint& checkpoint) override {
    engine_.reset();
    placed_.clear();
    result_.reset();
    told_ = 0;
    due_ = 0;
    engine_.emplace(rules_, table_, config_);
    while (placed_.size() < checkpoint.mark && !result_) {
      engine_->go_on(checkpoint.mark - placed_.size(), Clock::now() + std::chrono::seconds(1),
                     placed_);
      result_ = engine_->result();
    }
  }
  std::string finish() override { return trace(); }

 private:
  /// Of whole steps alone: a replay ends with one. Of one in which bricks may still come, none.
  std::string trace() const {
    TraceWriter writer(rules_, config_);
    const std::uint64_t begun = placed_.empty() ? 1 : placed_.back().step;
    const std::uint64_t beyond = std::max(engine_->waits_in().value_or(begun), begun);
    for (const Deposit& deposit : placed_) {
      if (result_ || deposit.step < beyond) writer.deposit(deposit);
    }
    if (result_) return writer.finish(result_->steps, result_->terminated);
    return writer.finish(beyond - 1, Terminated::interrupted);
  }

  RuleSet rules_;
  RuleTable table_;
  SwarmConfig config_;
  std::string name_;
  std::optional<EngineThread> engine_;
  std::optional<SwarmResult> result_;
  std::vector<Deposit> placed_;
  std::size_t told_ = 0;
  double due_ = 0;
};

}  // namespace

std::unique_ptr<LiveRun> lattice_live(RuleSet rules, const SwarmConfig& config, std::string name) {
  return std::make_unique<LatticeLive>(std::move(rules), config, std::move(name));
}

}  // namespace stig::live
