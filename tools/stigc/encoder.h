// SPDX-License-Identifier: MIT
// A film from pictures, made by the program ffmpeg where there is one.
//
// It is started without a shell, reads pictures from a pipe and writes into a file that has no
// name, so that no name of the user's reaches it and nothing is left behind whatever happens.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>

#include "app.h"
#include "child_process.h"
#include "uses.h"

namespace stig::cli {

/// Where ffmpeg is, by PATH.
std::optional<std::string> find_ffmpeg();

class Encoder {
 public:
  Encoder() = default;
  /// Ends a program that still runs.
  ~Encoder();
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  /// `ending` is .mp4, .webm or .gif. Each of the following is false with `problem` set on failure.
  bool start(const std::string& program, const std::string& ending, double fps,
             std::string& problem);
  bool add(std::string_view png, std::string& problem);
  /// Waits for the film and moves it to its place, whole or not at all.
  bool finish(const std::string& path, std::string& problem);

 private:
  std::string words() const;

  OpenFile film_, words_;  ///< what the program writes, and what it says
  int pipe_ = -1;
  pid_t process_ = -1;
};

}  // namespace stig::cli
