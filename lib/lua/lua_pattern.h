// SPDX-License-Identifier: MIT
// Lua's patterns (manual of Lua 5.4, section 6.4.1), matched by steps that are counted: some
// patterns take time exponential in their length, and Lua's own matcher cannot be interrupted.
//
// Classes are those of ASCII.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lua/uses.h"

namespace stig::lua {

class LuaPattern {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr int kMostCaptures = 32;

  struct Capture {
    std::size_t begin = 0;
    std::size_t length = 0;
    enum class Kind : std::uint8_t { open, closed, position } kind = Kind::open;
  };

  /// `pattern` without its anchor. Gives up after `most_steps`.
  LuaPattern(std::string_view subject, std::string_view pattern, std::uint64_t most_steps)
      : subject_(subject), pattern_(pattern), most_steps_(most_steps) {}

  /// Where a match that begins at `start` ends, or kNone. After kNone, ask for problem().
  std::size_t match(std::size_t start);

  int captures() const { return count_; }
  const Capture& capture(int i) const { return captures_[static_cast<std::size_t>(i)]; }
  std::string_view subject() const { return subject_; }

  std::uint64_t steps() const { return steps_; }
  bool exhausted() const { return steps_ > most_steps_; }
  /// What is wrong with the pattern, or null.
  const char* problem() const { return problem_; }

 private:
  std::size_t follow(std::size_t s, std::size_t p);
  std::size_t follow_escape(std::size_t s, std::size_t p, bool& handled);
  std::size_t repeat_most(std::size_t s, std::size_t p, std::size_t next, std::size_t least);
  std::size_t repeat_least(std::size_t s, std::size_t p, std::size_t next);
  std::size_t open_capture(std::size_t s, std::size_t p, Capture::Kind kind);
  std::size_t close_capture(std::size_t s, std::size_t p);
  std::size_t balanced(std::size_t s, std::size_t p);
  std::size_t repeated_capture(std::size_t s, char digit);
  std::size_t item_end(std::size_t p);
  std::size_t set_end(std::size_t p);
  bool item_fits(std::size_t s, std::size_t p, std::size_t next);
  bool set_has(char c, std::size_t p, std::size_t end) const;
  bool step();
  std::size_t fail(const char* problem);

  std::string_view subject_, pattern_;
  std::uint64_t most_steps_, steps_ = 0;
  const char* problem_ = nullptr;
  int count_ = 0, depth_ = 0;
  std::array<Capture, kMostCaptures> captures_{};
};

}  // namespace stig::lua
