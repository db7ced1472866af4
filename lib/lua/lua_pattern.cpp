// SPDX-License-Identifier: MIT
// A backtracking matcher after that of Lua (lstrlib.c), over views instead of zero-terminated
// texts. Every advance counts as a step; once steps run out or the pattern is malformed, all
// functions return kNone at once, and the caller tells which it was. Depth is bounded apart from
// steps: each capture and repetition is a C++ call.
#include "lua/lua_pattern.h"

#include <cassert>

namespace stig::lua {

namespace {

// As Lua's MAXCCALLS: enough for any pattern that somebody has written by hand.
constexpr int kMostDepth = 200;

bool within(char c, char low, char high) { return c >= low && c <= high; }
bool is_lower(char c) { return within(c, 'a', 'z'); }
bool is_upper(char c) { return within(c, 'A', 'Z'); }
bool is_digit(char c) { return within(c, '0', '9'); }
bool is_letter(char c) { return is_lower(c) || is_upper(c); }
bool is_graphic(char c) { return within(c, '!', '~'); }

/// Whether the character is of the class of a letter; a letter that names none is itself.
bool class_has(char c, char letter) {
  bool is_in = false;
  // Classes are the letters' lower case; an upper case letter is the complement.
  switch (static_cast<char>(letter | 0x20)) {
    case 'a':
      is_in = is_letter(c);
      break;
    case 'c':
      is_in = within(c, 0, 31) || c == 127;
      break;
    case 'd':
      is_in = is_digit(c);
      break;
    case 'g':
      is_in = is_graphic(c);
      break;
    case 'l':
      is_in = is_lower(c);
      break;
    case 'p':
      is_in = is_graphic(c) && !is_letter(c) && !is_digit(c);
      break;
    case 's':
      is_in = c == ' ' || within(c, '\t', '\r');
      break;
    case 'u':
      is_in = is_upper(c);
      break;
    case 'w':
      is_in = is_letter(c) || is_digit(c);
      break;
    case 'x':
      is_in = is_digit(c) || within(static_cast<char>(c | 0x20), 'a', 'f');
      break;
    default:
      return c == letter;
  }
  if (!is_letter(letter)) return c == letter;
  return is_upper(letter) ? !is_in : is_in;
}

bool at_most(char a, char b) {
  return static_cast<unsigned char>(a) <= static_cast<unsigned char>(b);
}

}  // namespace

std::size_t LuaPattern::match(std::size_t start) {
  assert(start <= subject_.size());
  // The steps go on counting over several calls: a budget is for one search, from all starts.
  count_ = depth_ = 0;
  return follow(start, 0);
}

std::size_t LuaPattern::fail(const char* problem) {
  if (problem_ == nullptr) problem_ = problem;
  return kNone;
}

bool LuaPattern::step() { return ++steps_ <= most_steps_ && problem_ == nullptr; }

/// Matches the rest of the pattern from p against the rest of the subject from s. In Lua's code
/// this is do_match: tail calls became turns of the loop, and so long patterns without repetitions
/// need no depth.
std::size_t LuaPattern::follow(std::size_t s, std::size_t p) {
  if (depth_ >= kMostDepth) return fail("pattern too complex");
  ++depth_;
  std::size_t end = kNone;
  for (;;) {
    if (!step()) break;
    if (p == pattern_.size()) {
      end = s;
      break;
    }
    const char c = pattern_[p];
    if (c == '(') {
      const bool position = p + 1 < pattern_.size() && pattern_[p + 1] == ')';
      end = position ? open_capture(s, p + 2, Capture::Kind::position)
                     : open_capture(s, p + 1, Capture::Kind::open);
      break;
    }
    if (c == ')') {
      end = close_capture(s, p + 1);
      break;
    }
    if (c == '$' && p + 1 == pattern_.size()) {
      end = s == subject_.size() ? s : kNone;
      break;
    }
    if (c == '%') {
      bool handled = false;
      const std::size_t after = follow_escape(s, p, handled);
      if (handled) {
        if (after == kNone) break;
        s = after;
        const char kind = pattern_[p + 1];
        p = kind == 'f' ? set_end(p + 2) : p + (kind == 'b' ? 4 : 2);
        continue;
      }
    }
    const std::size_t next = item_end(p);
    if (next == kNone) break;
    const char repeat = next < pattern_.size() ? pattern_[next] : '\0';
    if (repeat == '*' || repeat == '+') {
      end = repeat_most(s, p, next, repeat == '+' ? 1 : 0);
      break;
    }
    if (repeat == '-') {
      end = repeat_least(s, p, next);
      break;
    }
    const bool fits = item_fits(s, p, next);
    if (repeat == '?') {
      if (fits && (end = follow(s + 1, next + 1)) != kNone) break;
      p = next + 1;
      continue;
    }
    if (!fits) break;
    ++s;
    p = next;
  }
  --depth_;
  return end;
}

/// %b, %f and %1…%9: where the subject goes on, or kNone.
std::size_t LuaPattern::follow_escape(std::size_t s, std::size_t p, bool& handled) {
  const char c = p + 1 < pattern_.size() ? pattern_[p + 1] : '\0';
  handled = c == 'b' || c == 'f' || is_digit(c);
  if (c == 'b') return balanced(s, p + 2);
  if (is_digit(c)) return repeated_capture(s, c);
  if (c != 'f') return kNone;
  const std::size_t set = p + 2;
  if (set >= pattern_.size() || pattern_[set] != '[') return fail("missing '[' after '%f'");
  const std::size_t end = set_end(set);
  if (end == kNone) return kNone;
  // Beyond either end of the subject stands '\0', as the manual has it.
  const char before = s == 0 ? '\0' : subject_[s - 1];
  const char here = s < subject_.size() ? subject_[s] : '\0';
  return !set_has(before, set, end) && set_has(here, set, end) ? s : kNone;
}

std::size_t LuaPattern::repeat_most(std::size_t s, std::size_t p, std::size_t next,
                                    std::size_t least) {
  std::size_t n = 0;
  // Greedy: as many as fit, then back one by one until the rest matches.
  while (item_fits(s + n, p, next)) {
    ++n;
    if (!step()) return kNone;
  }
  for (;; --n) {
    if (n < least) return kNone;
    const std::size_t end = follow(s + n, next + 1);
    if (end != kNone || n == 0 || problem_ != nullptr || exhausted()) return end;
  }
}

std::size_t LuaPattern::repeat_least(std::size_t s, std::size_t p, std::size_t next) {
  // Lazy: the rest first, then one more.
  for (;; ++s) {
    const std::size_t end = follow(s, next + 1);
    if (end != kNone || problem_ != nullptr || exhausted()) return end;
    if (!item_fits(s, p, next)) return kNone;
  }
}

std::size_t LuaPattern::open_capture(std::size_t s, std::size_t p, Capture::Kind kind) {
  if (count_ >= kMostCaptures) return fail("too many captures");
  captures_[static_cast<std::size_t>(count_++)] = {s, 0, kind};
  // A capture counts only while the rest matches; on the way back it is taken away again.
  const std::size_t end = follow(s, p);
  if (end == kNone) --count_;
  return end;
}

std::size_t LuaPattern::close_capture(std::size_t s, std::size_t p) {
  // Parentheses nest, so the innermost open capture is the one that closes.
  int i = count_ - 1;
  while (i >= 0 && capture(i).kind != Capture::Kind::open) --i;
  if (i < 0) return fail("a ')' that closes nothing");
  Capture& closed = captures_[static_cast<std::size_t>(i)];
  closed.kind = Capture::Kind::closed;
  closed.length = s - closed.begin;
  const std::size_t end = follow(s, p);
  if (end == kNone) closed.kind = Capture::Kind::open;
  return end;
}

std::size_t LuaPattern::balanced(std::size_t s, std::size_t p) {
  if (p + 1 >= pattern_.size()) return fail("two characters are missing after '%b'");
  if (s >= subject_.size() || subject_[s] != pattern_[p]) return kNone;
  const char open = pattern_[p], close = pattern_[p + 1];
  std::size_t nested = 1;
  for (++s; s < subject_.size(); ++s) {
    if (!step()) return kNone;
    if (subject_[s] == close) {
      if (--nested == 0) return s + 1;
    } else if (subject_[s] == open) {
      ++nested;
    }
  }
  return kNone;
}

std::size_t LuaPattern::repeated_capture(std::size_t s, char digit) {
  const int i = digit - '1';
  if (i < 0 || i >= count_ || capture(i).kind == Capture::Kind::open) {
    return fail("a '%' and a digit that name no capture");
  }
  if (capture(i).kind == Capture::Kind::position) return kNone;
  const std::string_view text = subject_.substr(capture(i).begin, capture(i).length);
  // Comparing is a memcmp: cheap, but no free step.
  steps_ += text.size() / 16;
  return subject_.substr(s).starts_with(text) ? s + text.size() : kNone;
}

/// Where the single-character item that begins at p ends.
std::size_t LuaPattern::item_end(std::size_t p) {
  if (pattern_[p] == '[') return set_end(p);
  if (pattern_[p] != '%') return p + 1;
  return p + 1 < pattern_.size() ? p + 2 : fail("ends with '%'");
}

/// Where the set that begins at p ends, past its ']'. One right after '[' or '[^' is a member.
std::size_t LuaPattern::set_end(std::size_t p) {
  ++p;
  if (p < pattern_.size() && pattern_[p] == '^') ++p;
  for (bool first = true; p < pattern_.size(); first = false) {
    if (pattern_[p] == ']' && !first) return p + 1;
    p += pattern_[p] == '%' ? 2 : 1;
  }
  return fail("missing ']'");
}

bool LuaPattern::item_fits(std::size_t s, std::size_t p, std::size_t next) {
  if (s >= subject_.size()) return false;
  const char c = subject_[s];
  switch (pattern_[p]) {
    case '.':
      return true;
    case '%':
      return class_has(c, pattern_[p + 1]);
    case '[':
      // A set costs in proportion to its length.
      steps_ += (next - p) / 8;
      return set_has(c, p, next);
    default:
      return c == pattern_[p];
  }
}

/// Whether a character is in the set that spans [p, end). p to end are the brackets; a ']' right
/// after '[' or '[^' is a member, which set_end has seen to.
bool LuaPattern::set_has(char c, std::size_t p, std::size_t end) const {
  const std::size_t last = end - 1;  // of the ']'
  const bool negated = pattern_[p + 1] == '^';
  for (p += negated ? 2 : 1; p < last;) {
    if (pattern_[p] == '%' && p + 1 < last) {
      if (class_has(c, pattern_[p + 1])) return !negated;
      p += 2;
    } else if (p + 2 < last && pattern_[p + 1] == '-') {
      if (at_most(pattern_[p], c) && at_most(c, pattern_[p + 2])) return !negated;
      p += 3;
    } else {
      if (pattern_[p] == c) return !negated;
      ++p;
    }
  }
  return negated;
}

}  // namespace stig::lua
