// SPDX-License-Identifier: MIT
// One thread owns the run and all that is not guarded by the mutex. It works in pieces of a
// hundredth of a second, between which it takes commands. The clock decides how far the run goes in
// a piece, and nothing else.
#include "live/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

namespace stig::live {

namespace {

using nlohmann::json;
using std::chrono::milliseconds;

constexpr milliseconds kPiece{10}, kBetweenStates{50}, kBetweenLooks{100}, kRest{20};
constexpr double kMostBehind =
    0.25;  ///< s: a run that is slower than it should be does not catch up
constexpr std::size_t kMostCheckpoints = 100, kMostNewsAtOnce = 64;
constexpr std::size_t kMostAsked = 64;
constexpr int kMostTold = 50;

std::string text_of(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}
std::string refused(const std::string& problem) {
  return text_of({{"ok", false}, {"problem", problem}});
}
std::string done() { return R"({"ok":true})"; }

/// JSON has no line ends, so an event is one line of data.
std::string event(const char* name, const std::string& data) {
  return fmt::format("event: {}\ndata: {}\n\n", name, data);
}

}  // namespace

LiveSession::LiveSession(LiveSettings settings, LiveLoad first)
    : settings_(std::move(settings)), paused_(settings_.paused), speed_(settings_.speed) {
  assert(first.run);
  files_ = first.files;
  watch_.watch(files_);
  trouble_ = first.trouble;
  begin(std::move(first.run));
}

void LiveSession::begin(std::unique_ptr<LiveRun> run) {
  run_ = std::move(run);
  auto page = std::make_shared<PageContent>();
  run_->add_to(*page);
  std::string data = page->data();
  const std::lock_guard lock(mutex_);
  ++number_;
  page_ = std::move(page);
  data_ = std::move(data);
  news_.clear();
  checkpoints_.clear();
  changed_ = true;
  advanced_ = Clock::now();
}

std::string LiveSession::work(const std::atomic<bool>& stop) {
  advanced_ = Clock::now();
  while (!stop.load(std::memory_order_relaxed)) {
    take_commands();
    look_at_files();
    go_on();
    publish();
    rest();
    const std::lock_guard lock(mutex_);
    if (closed_) break;
  }
  close();
  return run_->finish();
}

void LiveSession::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  for (Asked& one : asked_) one.answer.set_value(refused("the session has ended"));
  asked_.clear();
  asked_for_.notify_all();
  told_.notify_all();
}

std::string LiveSession::call(const LiveCommand& command) {
  std::future<std::string> answer;
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return refused("the session has ended");
    if (asked_.size() >= kMostAsked) return refused("too much is asked at once");
    asked_.push_back({command, {}});
    answer = asked_.back().answer.get_future();
    asked_for_.notify_all();
  }
  return answer.get();
}

void LiveSession::take_commands() {
  std::deque<Asked> asked;
  {
    const std::lock_guard lock(mutex_);
    asked.swap(asked_);
  }
  for (Asked& one : asked) {
    std::string answer = carry_out(one.command);
    changed_ = true;
    one.answer.set_value(std::move(answer));
  }
}

std::string LiveSession::carry_out(const LiveCommand& command) {
  switch (command.ask) {
    case LiveAsk::run:
    case LiveAsk::pause:
      paused_ = command.ask == LiveAsk::pause;
      advanced_ = Clock::now();
      return done();
    case LiveAsk::step:
      return step(command.number);
    case LiveAsk::speed:
      speed_ = command.speed;
      return done();
    case LiveAsk::checkpoint:
      return take_checkpoint();
    case LiveAsk::back:
      return go_back(command.number);
    case LiveAsk::hand: {
      const std::string problem = run_->work(command.action);
      return problem.empty() ? done() : refused(problem);
    }
    case LiveAsk::again: {
      LiveLoad load = settings_.load();
      trouble_ = load.trouble;
      if (!load.run) return refused("the files are not good");
      begin(std::move(load.run));
      return done();
    }
  }
  return refused("there is no such command");
}

std::string LiveSession::step(std::uint64_t count) {
  paused_ = true;
  run_->advance(static_cast<double>(count) * run_->one_step() * (1 + 1e-9),
                Clock::now() + std::chrono::seconds(2));
  return done();
}

std::string LiveSession::take_checkpoint() {
  LiveCheckpoint taken = run_->checkpoint();
  if (settings_.keep_checkpoint) {
    const std::string problem = settings_.keep_checkpoint(taken.bytes);
    if (!problem.empty()) return refused(problem);
  }
  const std::lock_guard lock(mutex_);
  if (checkpoints_.size() >= kMostCheckpoints) return refused("there are too many checkpoints");
  checkpoints_.push_back(std::move(taken));
  return text_of({{"ok", true}, {"checkpoint", checkpoints_.size()}});
}

std::string LiveSession::go_back(std::uint64_t number) {
  LiveCheckpoint to;
  {
    const std::lock_guard lock(mutex_);
    if (number > checkpoints_.size()) return refused("there is no such checkpoint");
    to = checkpoints_[number - 1];
    // Those who look begin anew, with the news up to then.
    ++number_;
    news_.clear();
  }
  run_->go_back(to);
  paused_ = true;
  return done();
}

void LiveSession::look_at_files() {
  const auto now = Clock::now();
  if (now - looked_ < kBetweenLooks) return;
  looked_ = now;
  if (!watch_.saved()) return;
  LiveLoad load = settings_.load();
  // A file that is no longer named may be named again once another one is mended.
  if (load.run) files_.clear();
  files_.insert(files_.end(), load.files.begin(), load.files.end());
  watch_.watch(files_);
  trouble_ = load.trouble;
  changed_ = true;
  if (load.run) begin(std::move(load.run));
}

void LiveSession::go_on() {
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - advanced_).count();
  advanced_ = now;
  if (paused_ || !run_->ended().empty()) return;
  const double before = run_->time();
  const double units = speed_ ? std::min(seconds, kMostBehind) * *speed_ * run_->rate() : 1e9;
  run_->advance(units, now + kPiece);
  changed_ = changed_ || run_->time() != before || !run_->ended().empty();
}

std::string LiveSession::state_json() const {
  const std::string why = run_->ended();
  json out{{"run", number_},      {"time", run_->time()},
           {"end", run_->end()},  {"mode", !why.empty() ? "ended" : paused_ ? "paused" : "running"},
           {"why", why},          {"speed", speed_ ? json(*speed_) : json()},
           {"trouble", trouble_}, {"checkpoints", json::array()}};
  for (const LiveCheckpoint& one : checkpoints_) out["checkpoints"].push_back(one.time);
  std::string text = text_of(out);
  // The run's own members come before the closing brace.
  text.pop_back();
  return text + "," + run_->state() + "}";
}

void LiveSession::publish() {
  const auto now = Clock::now();
  if (now - published_ < pause_) return;
  std::string news = run_->take_news();
  const std::lock_guard lock(mutex_);
  if (!news.empty()) news_.push_back("[" + std::move(news) + "]");
  if (!(changed_ || wanted_)) return;
  // What nobody sees is not written.
  published_ = now;
  if (lookers_ == 0) return;
  state_ = state_json();
  // Telling takes a fiftieth of the run's time at most.
  pause_ = std::max<Clock::duration>(kBetweenStates, kMostTold * (Clock::now() - now));
  ++state_number_;
  changed_ = wanted_ = false;
  told_.notify_all();
}

/// While there is nothing to do, until something is asked.
void LiveSession::rest() {
  if (!paused_ && !speed_ && run_->ended().empty()) return;
  std::unique_lock lock(mutex_);
  const bool idle = paused_ || !run_->ended().empty();
  asked_for_.wait_for(lock, idle ? kRest : kRest / 4,
                      [this] { return closed_ || !asked_.empty(); });
}

std::optional<std::string> LiveSession::checkpoint(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  if (number == 0 || number > checkpoints_.size()) return std::nullopt;
  return checkpoints_[number - 1].bytes;
}

LiveSession::Beginning LiveSession::beginning() const {
  const std::lock_guard lock(mutex_);
  return {number_, page_};
}

bool LiveSession::join() {
  const std::lock_guard lock(mutex_);
  if (lookers_ >= kMostLookers) return false;
  ++lookers_;
  wanted_ = true;
  return true;
}

void LiveSession::leave() {
  const std::lock_guard lock(mutex_);
  assert(lookers_ > 0);
  --lookers_;
}

std::optional<std::string> LiveSession::next(Looker& looker, milliseconds patience) {
  std::unique_lock lock(mutex_);
  told_.wait_for(lock, patience, [&] { return closed_ || looker.state != state_number_; });
  if (closed_) return std::nullopt;
  if (looker.state == state_number_) return ": nothing new\n\n";
  std::string out;
  if (looker.run != number_) {
    looker = {number_, looker.state, 0};
    out += event("scene", text_of({{"run", number_}, {"data", data_}}));
  }
  const std::size_t until = std::min(news_.size(), looker.news + kMostNewsAtOnce);
  for (; looker.news < until; ++looker.news) out += event("news", news_[looker.news]);
  // The state comes when all that led to it is told.
  if (looker.news == news_.size()) {
    looker.state = state_number_;
    out += event("state", state_);
  }
  return out;
}

}  // namespace stig::live
