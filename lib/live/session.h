// SPDX-License-Identifier: MIT
// A run that is looked at: steps it, takes commands, and tells those who look how it stands.
//
// The session works in the thread that calls `work`; everything else may be called from any thread.
// Whoever looks gets events as text of server-sent events: `scene` at the beginning of a run,
// `news` of what has happened, all of it, and `state`, of which only the latest is kept: who reads
// slowly sees fewer, and holds up nobody.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "live/command.h"
#include "live/file_watch.h"
#include "live/live_run.h"

namespace stig::live {

inline constexpr std::size_t kMostLookers = 8;

/// A run as its files have it now.
struct LiveLoad {
  std::unique_ptr<LiveRun> run;    ///< null when they are not good
  std::string trouble;             ///< diagnostics, as text
  std::vector<std::string> files;  ///< that were read, or looked for
};

struct LiveSettings {
  std::function<LiveLoad()> load;
  /// Takes the bytes of a checkpoint; returns what is in the way. May be empty.
  std::function<std::string(const std::string&)> keep_checkpoint;
  bool paused = false;
  std::optional<double> speed = 1;  ///< times the usual; nothing: as fast as it goes
};

/// Somebody who looks, and what has been told already.
struct Looker {
  std::uint64_t run = 0, state = 0;
  std::size_t news = 0;
};

class LiveSession {
 public:
  /// The first load has a run.
  LiveSession(LiveSettings settings, LiveLoad first);

  /// Until `stop` is set, or `close` is called. Returns the bytes of the trace.
  std::string work(const std::atomic<bool>& stop);
  void close();

  /// Carries a command out, and answers as JSON: {"ok": true} and what belongs to it, or
  /// {"ok": false, "problem": "…"}.
  std::string call(const LiveCommand& command);
  /// The bytes of the checkpoint of that number, from 1.
  std::optional<std::string> checkpoint(std::uint64_t number) const;

  /// The run as it began, as data for a page.
  struct Beginning {
    std::uint64_t run = 0;
    std::shared_ptr<const PageContent> page;
  };
  Beginning beginning() const;

  /// False: there are kMostLookers.
  bool join();
  void leave();
  /// What is new for somebody, as text of events, after a while at most; a comment when there is
  /// nothing. Nothing once the session is closed.
  std::optional<std::string> next(Looker& looker, std::chrono::milliseconds patience);

 private:
  using Clock = std::chrono::steady_clock;
  struct Asked {
    LiveCommand command;
    std::promise<std::string> answer;
  };

  void take_commands();
  std::string carry_out(const LiveCommand& command);
  std::string step(std::uint64_t count);
  std::string take_checkpoint();
  std::string go_back(std::uint64_t number);
  void look_at_files();
  void begin(std::unique_ptr<LiveRun> run);
  void go_on();
  void publish();
  std::string state_json() const;
  void rest();

  LiveSettings settings_;
  std::unique_ptr<LiveRun> run_;
  FileWatch watch_;
  std::vector<std::string> files_;
  std::string trouble_;
  bool paused_ = false, changed_ = true;
  std::optional<double> speed_;
  Clock::time_point advanced_{}, published_{}, looked_{};
  Clock::duration pause_{};  ///< between two states

  mutable std::mutex mutex_;  ///< of all below
  std::condition_variable asked_for_, told_;
  std::deque<Asked> asked_;
  std::vector<LiveCheckpoint> checkpoints_;
  std::uint64_t number_ = 0;  ///< of the run, from 1
  std::shared_ptr<const PageContent> page_;
  std::string data_;  ///< of the page
  std::vector<std::string> news_;
  std::string state_;
  std::uint64_t state_number_ = 0;
  std::size_t lookers_ = 0;
  bool wanted_ = false, closed_ = false;
};

}  // namespace stig::live
