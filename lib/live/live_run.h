// SPDX-License-Identifier: MIT
// A run that goes on while somebody looks at it, of either kind (pose_live.h, lattice_live.h).
//
// A session (session.h) steps it, and hands on what it says. All calls come from one thread. What
// is done with a run does not depend on the clock: pieces of any length add up to the same run.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "live/uses.h"
#include "physical/trace/hand_action.h"
#include "view/page.h"

namespace stig::live {

/// A run taken down, to go back to.
struct LiveCheckpoint {
  double time = 0;    ///< of the run
  std::string bytes;  ///< of a file that other commands read
  std::size_t mark = 0;
};

class LiveRun {
 public:
  virtual ~LiveRun() = default;

  /// The run as it was at its beginning, as pages show it.
  virtual void add_to(PageContent& page) const = 0;
  /// s, or bricks placed.
  virtual double time() const = 0;
  virtual double end() const = 0;       ///< when it ends at the latest; 0: not known
  virtual double rate() const = 0;      ///< units of time in a second at speed 1
  virtual double one_step() const = 0;  ///< units of time

  /// Goes on by so many units of time at most, and returns soon after `until`.
  virtual void advance(double units, std::chrono::steady_clock::time_point until) = 0;
  /// Why it has ended, in words; empty: it has not.
  virtual std::string ended() const = 0;

  /// How it stands, as members of a JSON object, without braces: "bodies": […].
  virtual std::string state() const = 0;
  /// What has happened since the last call, as entries of a JSON array, without brackets.
  virtual std::string take_news() = 0;

  /// What is in the way, as a sentence; empty: it is done.
  virtual std::string work(const HandAction& action) = 0;
  virtual LiveCheckpoint checkpoint() = 0;
  /// Becomes what it was then. All news come again.
  virtual void go_back(const LiveCheckpoint& checkpoint) = 0;
  /// Ends it: the bytes of its trace.
  virtual std::string finish() = 0;
};

}  // namespace stig::live
