// SPDX-License-Identifier: MIT
#include "lua/lua_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <lua.hpp>

#include "base/text.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

// While a failure is told of, the limit is lifted by this much, since an error's message and
// traceback need memory too.
constexpr std::size_t kReserve = std::size_t{64} << 10;  ///< for the account of a failure
constexpr std::size_t kBytesPerInstruction = 32;         ///< of objects made
constexpr std::size_t kCollections = 32;                 ///< before as much as the limit was made
constexpr std::size_t kMostMessage = 2000;

/// What a protected call runs. lua_pcall takes a C function and a light pointer, so the body and
/// its argument travel in a struct that outlives the call.
struct Job {
  LuaBox::Body body;
  void* argument;
};

int run_job(lua_State* state) {
  const auto& job = *static_cast<const Job*>(lua_touserdata(state, 1));
  lua_settop(state, 0);
  lua_pushlightuserdata(state, job.argument);
  return job.body(state);
}

// The libraries are opened in protected mode and under the program's own limits: opening them can
// run out of memory like anything else.
int open_all(lua_State* state) {
  open_base(state);
  open_order(state);
  open_text(state);
  open_tables(state);
  open_math(state);
  open_coroutines(state);
  open_require(state);
  open_vectors(state);
  if (LuaBox::of(state).program().interface == InterfaceLevel::of_2019) {
    open_package(state);
    open_debug(state);
    open_io(state);
  }
  return 0;
}

}  // namespace

// There are thousands of blocks, with programs of a few lines: 1 MiB each is what a scene of blocks
// can afford.
LuaLimits block_limits() {
  LuaLimits limits;
  limits.instructions = 100'000;
  limits.memory = std::size_t{1} << 20;
  limits.object = std::size_t{256} << 10;
  return limits;
}

std::optional<LuaProgram> read_lua_program(const std::string& path, FileError& error) {
  auto text = read_file(path, kMostLuaSource, error);
  if (!text) return std::nullopt;
  return LuaProgram{path, std::move(*text)};
}

LuaBox::LuaBox(LuaProgram program, LuaSettings settings, void* user)
    : program_(std::move(program)),
      settings_(std::move(settings)),
      user_(user),
      // Streams are addressed by seed, run, purpose and agent, so programs of one run do not share
      // numbers, and none takes part in those of physics.
      key_(settings_.seed),
      random_(key_, settings_.run, Purpose::user, settings_.agent, 0) {}

LuaBox::~LuaBox() {
  if (state_ != nullptr) lua_close(state_);
}

LuaBox& LuaBox::of(lua_State* state) { return **static_cast<LuaBox**>(lua_getextraspace(state)); }

ControllerStatus LuaBox::run(Body body, void* argument) {
  assert(body != nullptr);
  const bool first = state_ == nullptr;
  budget_ = static_cast<std::int64_t>(settings_.limits.instructions);
  traceback_.clear();
  if (first) {
    state_ = lua_newstate(allocate, this);
    if (state_ == nullptr) return {false, settings_.id + ": no memory for a Lua state"};
    // The extra space is copied into every new coroutine by Lua, so that of() works in all of them.
    *static_cast<LuaBox**>(lua_getextraspace(state_)) = this;
    // Off for good: see lua_box.h. The box itself collects, after an amount of work that is the
    // same in every run.
    lua_gc(state_, LUA_GCSTOP);
  }
  // Set anew, so that counting starts at the same instruction of every call.
  lua_sethook(state_, count, LUA_MASKCOUNT, kHookInterval);
  // In a new state the libraries come first, in a call of their own, then the body.
  Job job{first ? open_all : body, argument};
  for (bool last = !first;; last = true) {
    lua_settop(state_, 0);
    lua_pushcfunction(state_, explain);
    lua_pushcfunction(state_, run_job);
    lua_pushlightuserdata(state_, &job);
    const int status = lua_pcall(state_, 1, 0, 1);
    // A stop that was caught and dropped within the program ends the call all the same.
    if (status != LUA_OK || stopped()) return {false, failure(status)};
    if (last) break;
    job.body = body;
  }
  lua_settop(state_, 0);
  // Between calls nothing of the program is on the stack, so a collection is cheap here.
  if (made_ >= settings_.limits.memory / kCollections) collect();
  new_random();
  return {};
}

// A stream of its own for each call: how many numbers one step takes does not shift the next one's.
void LuaBox::new_random() {
  random_ = Random(key_, settings_.run, Purpose::user, settings_.agent, ++epoch_);
}

void LuaBox::reseed(std::uint64_t key) {
  key_ = key;
  epoch_ = 0;
  random_ = Random(key_, settings_.run, Purpose::user, settings_.agent, 0);
}

std::string LuaBox::chunk_name(const std::string& path) {
  // Lua cuts longer names in the middle of a folder's.
  const std::string name =
      printable(path.size() < LUA_IDSIZE - 2 ? path : path.substr(path.rfind('/') + 1));
  if (std::find(files_.begin(), files_.end(), name) == files_.end()) files_.push_back(name);
  return "@" + name;
}

// ---- Limits ----

// Lua's contract: old_size is the block's size, or, for a new block, a code of what it is for; a
// new size of 0 frees. Shrinking never fails, which Lua relies on.
void* LuaBox::allocate(void* user, void* block, std::size_t old_size, std::size_t new_size) {
  auto& box = *static_cast<LuaBox*>(user);
  const std::size_t before = block == nullptr ? 0 : old_size;
  if (new_size == 0) {
    box.used_ -= before;
    std::free(block);
    return nullptr;
  }
  if (new_size > before) {
    // Set by leave_hook alone, to fail an allocation on purpose.
    if (box.refusals_ > 0) {
      --box.refusals_;
      return nullptr;
    }
    if (!box.may_grow(block == nullptr, old_size, before, new_size)) return nullptr;
  }
  void* moved = std::realloc(block, new_size);
  if (moved != nullptr) box.used_ += new_size - before;
  return moved;
}

bool LuaBox::may_grow(bool is_new, std::size_t tag, std::size_t old_size, std::size_t new_size) {
  const LuaLimits& limits = settings_.limits;
  const std::size_t used = used_ + (new_size - old_size);
  // Being stopped, what remains to be done is to tell why; the reserve is for that.
  if (stopped()) return used <= limits.memory + kReserve;
  // Lua says what a new block is for: an object of a type, or 0, a part of one. How those parts
  // grow depends on hashes and so on addresses; only the objects count as work.
  if (is_new && tag != 0) {
    made_ += new_size;
    budget_ -= static_cast<std::int64_t>(new_size / kBytesPerInstruction);
    if (budget_ < 0) return starve(Stop::instructions);
    // 64 bytes for the head of a string object.
    if (tag == LUA_TSTRING && new_size > limits.string + 64) return starve(Stop::memory);
  }
  if (new_size > limits.object || used > limits.memory) return starve(Stop::memory);
  starved_ = false;
  return true;
}

/// Lua collects and tries again when it is refused; the second time is the end.
bool LuaBox::starve(Stop reason) {
  budget_ -= static_cast<std::int64_t>(used_ / 64);  // about what the collection takes
  // A refusal is no stop yet: Lua runs a full collection and asks again, and only if that is
  // refused too the program is over. may_grow clears the flag between.
  if (starved_) stop_ = reason;
  starved_ = true;
  return false;
}

void LuaBox::stop(lua_State* state, int level, Stop reason) {
  // The first reason is the one that is told; what the program does on its way out is not.
  if (!stopped()) {
    stop_ = reason;
    note_traceback(state, level);
    luaL_where(state, level);
    const LuaLimits& limits = settings_.limits;
    stop_message_ = lua_tostring(state, -1);
    stop_message_ +=
        reason == Stop::depth
            ? fmt::format("calls nested more than {} deep", limits.depth)
            : fmt::format("more than {} instructions in one call", limits.instructions);
    lua_pop(state, 1);
  }
  // From now on every instruction asks.
  // Handlers of errors and variables to be closed may still run Lua code; with an interval of one
  // instruction they do not get far.
  lua_sethook(state, count, LUA_MASKCOUNT, 1);
}

void LuaBox::charge(lua_State* state, std::uint64_t instructions) {
  // Charges are clamped so that the budget, a signed number, cannot wrap round.
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
  budget_ -= static_cast<std::int64_t>(std::min(instructions, kMost));
  if (budget_ >= 0 && !stopped()) {
    // Buffers of texts do not try again after a collection, so it had better come before.
    if (made_ >= settings_.limits.memory / kCollections) collect();
    return;
  }
  // Raised as an ordinary error here, since this is no hook: the caller is a C function in the
  // middle of its work.
  stop(state, 1, Stop::instructions);
  lua_pushlstring(state, stop_message_.data(), stop_message_.size());
  lua_error(state);
}

void LuaBox::count(lua_State* state, lua_Debug* frame) {
  LuaBox& box = of(state);
  if (!box.stopped()) box.budget_ -= kHookInterval;
  if (box.budget_ < 0 || box.stopped()) box.leave_hook(state, Stop::instructions);
  if (box.made_ >= box.settings_.limits.memory / kCollections) box.collect();
  // Lua's own limit on the depth of calls is one on the size of its stack; this one counts calls,
  // which is what a program's author can reckon with. lua_getstack says whether there is a frame
  // that deep.
  if (lua_getstack(state, box.settings_.limits.depth, frame) != 0) {
    box.leave_hook(state, Stop::depth);
  }
}

/// An ordinary error would call its handler here, where no instruction is counted. Being out of
/// memory has no handler.
void LuaBox::leave_hook(lua_State* state, Stop reason) {
  stop(state, 0, reason);
  // The allocation below fails both times, and Lua raises its error for being out of memory, which
  // skips the handler and unwinds to the nearest protected call.
  refusals_ = 2;  // Lua collects and tries once more
  lua_newuserdatauv(state, 1, 0);
}

void LuaBox::collect() {
  lua_gc(state_, LUA_GCCOLLECT);
  made_ = 0;
}

// ---- Failures ----

/// Handler of errors that reach the edge: any value becomes text.
int LuaBox::explain(lua_State* state) {
  LuaBox& box = of(state);
  // After a stop no Lua code may run, not even __tostring.
  if (box.stopped()) return 1;
  if (lua_type(state, 1) != LUA_TSTRING) {
    if (luaL_getmetafield(state, 1, "__tostring") != LUA_TNIL) {
      lua_pushvalue(state, 1);
      // pcall: an error inside the handler would count as an error while handling an error.
      const bool told = lua_pcall(state, 1, 1, 0) == LUA_OK && lua_isstring(state, -1);
      if (!told) lua_pushfstring(state, "an error whose __tostring fails");
    } else {
      lua_pushfstring(state, "an error that is a %s value", luaL_typename(state, 1));
    }
    lua_replace(state, 1);
    lua_settop(state, 1);
  }
  box.note_traceback(state, 1);
  return 1;
}

void LuaBox::note_traceback(lua_State* state, int level) {
  constexpr std::string_view kOutside = "\n\t[C]: in ?";  // whoever called the program
  luaL_traceback(state, state, nullptr, level);
  traceback_ = lua_tostring(state, -1);
  if (traceback_.ends_with(kOutside)) traceback_.resize(traceback_.size() - kOutside.size());
  lua_pop(state, 1);
}

std::string LuaBox::failure(int status) {
  std::string text;
  // On top of the stack is what explain has left.
  const bool has_text = status != LUA_OK && lua_type(state_, -1) == LUA_TSTRING;
  if (has_text) text.assign(lua_tostring(state_, -1), lua_rawlen(state_, -1));
  // The second is what buffers of texts say.
  if (stop_ == Stop::memory || (!stopped() && text == "not enough memory")) {
    const LuaLimits& limits = settings_.limits;
    text = fmt::format(
        "{}: more than {} KiB of memory, or {} KiB in one list or stack of calls, or {} KiB in "
        "one string",
        chunk_name(program_.path).substr(1), limits.memory >> 10, limits.object >> 10,
        limits.string >> 10);
  } else if (!stop_message_.empty()) {
    text = stop_message_;
  } else if (stopped()) {
    text = fmt::format("{}: more than {} instructions in one call",
                       chunk_name(program_.path).substr(1), settings_.limits.instructions);
  } else if (status == LUA_ERRERR) {
    text = chunk_name(program_.path).substr(1) + ": an error while an error was being handled";
  } else if (!has_text) {
    text = "an error that is no text";
  }
  lua_settop(state_, 0);
  // A line map may put names in place of lines, but the text is cut first: names are short, and the
  // amount of work stays bounded.
  traceback_ = mapped(traceback_.substr(0, kMostMessage));
  text = mapped(text.substr(0, kMostMessage));
  last_failure_ = placed(text);
  return printable(text + " (" + settings_.id + ")");
}

/// A message's "file:line: " taken off, where the file is one that was loaded.
LuaFailure LuaBox::placed(std::string_view text) const {
  // Names of files may hold colons, so the known names are tried instead of splitting the text.
  for (const std::string& file : files_) {
    if (!text.starts_with(file + ":")) continue;
    std::string_view rest = text.substr(file.size() + 1);
    LuaFailure out{file, 0, {}};
    // At most nine digits: the text may be the program's own, and a number in it as long as it
    // likes.
    const std::size_t colon = std::min(rest.find_first_not_of("0123456789"), std::size_t{9});
    if (colon > 0 && colon < rest.size() && rest[colon] == ':') {
      out.line = std::stoul(std::string(rest.substr(0, colon)));
      rest.remove_prefix(colon + 1);
    }
    if (rest.starts_with(' ')) rest.remove_prefix(1);
    out.what = printable(rest);
    return out;
  }
  return {{}, 0, printable(text)};
}

/// Each "file:line:" of a text, through the line map. For generated programs: whoever wrote the
/// rules is told the line of the rules.
std::string LuaBox::mapped(std::string text) const {
  if (!settings_.line_map) return text;
  for (const std::string& file : files_) {
    std::size_t at = 0;
    while ((at = text.find(file + ":", at)) != std::string::npos) {
      const std::size_t digits = at + file.size() + 1;
      std::size_t end = digits;
      while (end < text.size() && end < digits + 9 && text[end] >= '0' && text[end] <= '9') ++end;
      const auto place =
          end > digits ? settings_.line_map(file, std::stoi(text.substr(digits, end - digits)))
                       : std::nullopt;
      if (!place) {
        // No entry for that line: the text stays, and the search goes on behind it.
        at = digits;
        continue;
      }
      const std::string there = fmt::format("{}:{}", place->first, place->second);
      text.replace(at, end - at, there);
      at += there.size();
    }
  }
  return text;
}

}  // namespace stig::lua
