// SPDX-License-Identifier: MIT
#include "lua/lua_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <lua.hpp>

#include "base/text.h"
#include "lua/lua_libraries.h"

namespace stig {

namespace {

constexpr std::size_t kReserve = std::size_t{64} << 10;  ///< for the account of a failure
constexpr std::size_t kBytesPerInstruction = 32;         ///< of objects made
constexpr std::size_t kCollections = 32;                 ///< before as much as the limit was made
constexpr std::size_t kMostMessage = 2000;

/// What a protected call runs.
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

int open_all(lua_State* state) {
  open_base(state);
  open_order(state);
  open_text(state);
  open_tables(state);
  open_math(state);
  open_coroutines(state);
  open_require(state);
  open_vectors(state);
  return 0;
}

}  // namespace

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
      key_(settings_.seed),
      random_(key_, settings_.run, Purpose::user, settings_.agent, 0) {}

LuaBox::~LuaBox() {
  if (state_ != nullptr) lua_close(state_);
}

LuaBox& LuaBox::of(lua_State* state) { return **static_cast<LuaBox**>(lua_getextraspace(state)); }

ControllerStatus LuaBox::run(Body body, void* argument) {
  const bool first = state_ == nullptr;
  budget_ = static_cast<std::int64_t>(settings_.limits.instructions);
  traceback_.clear();
  if (first) {
    state_ = lua_newstate(allocate, this);
    if (state_ == nullptr) return {false, settings_.id + ": no memory for a Lua state"};
    *static_cast<LuaBox**>(lua_getextraspace(state_)) = this;
    lua_gc(state_, LUA_GCSTOP);
  }
  // Set anew, so that counting starts at the same instruction of every call.
  lua_sethook(state_, count, LUA_MASKCOUNT, kHookInterval);
  Job job{first ? open_all : body, argument};
  for (bool last = !first;; last = true) {
    lua_settop(state_, 0);
    lua_pushcfunction(state_, explain);
    lua_pushcfunction(state_, run_job);
    lua_pushlightuserdata(state_, &job);
    const int status = lua_pcall(state_, 1, 0, 1);
    if (status != LUA_OK || stopped()) return {false, failure(status)};
    if (last) break;
    job.body = body;
  }
  lua_settop(state_, 0);
  if (made_ >= settings_.limits.memory / kCollections) collect();
  new_random();
  return {};
}

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

void* LuaBox::allocate(void* user, void* block, std::size_t old_size, std::size_t new_size) {
  auto& box = *static_cast<LuaBox*>(user);
  const std::size_t before = block == nullptr ? 0 : old_size;
  if (new_size == 0) {
    box.used_ -= before;
    std::free(block);
    return nullptr;
  }
  if (new_size > before) {
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
  if (stopped()) return used <= limits.memory + kReserve;
  // Lua says what a new block is for: an object of a type, or 0, a part of one. How those parts
  // grow depends on hashes and so on addresses; only the objects count as work.
  if (is_new && tag != 0) {
    made_ += new_size;
    budget_ -= static_cast<std::int64_t>(new_size / kBytesPerInstruction);
    if (budget_ < 0) return starve(Stop::instructions);
    if (tag == LUA_TSTRING && new_size > limits.string + 64) return starve(Stop::memory);
  }
  if (new_size > limits.object || used > limits.memory) return starve(Stop::memory);
  starved_ = false;
  return true;
}

/// Lua collects and tries again when it is refused; the second time is the end.
bool LuaBox::starve(Stop reason) {
  budget_ -= static_cast<std::int64_t>(used_ / 64);  // about what the collection takes
  if (starved_) stop_ = reason;
  starved_ = true;
  return false;
}

void LuaBox::stop(lua_State* state, int level, Stop reason) {
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
  lua_sethook(state, count, LUA_MASKCOUNT, 1);
}

void LuaBox::charge(lua_State* state, std::uint64_t instructions) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
  budget_ -= static_cast<std::int64_t>(std::min(instructions, kMost));
  if (budget_ >= 0 && !stopped()) {
    // Buffers of texts do not try again after a collection, so it had better come before.
    if (made_ >= settings_.limits.memory / kCollections) collect();
    return;
  }
  stop(state, 1, Stop::instructions);
  lua_pushlstring(state, stop_message_.data(), stop_message_.size());
  lua_error(state);
}

void LuaBox::count(lua_State* state, lua_Debug* frame) {
  LuaBox& box = of(state);
  if (!box.stopped()) box.budget_ -= kHookInterval;
  if (box.budget_ < 0 || box.stopped()) box.leave_hook(state, Stop::instructions);
  if (box.made_ >= box.settings_.limits.memory / kCollections) box.collect();
  if (lua_getstack(state, box.settings_.limits.depth, frame) != 0) {
    box.leave_hook(state, Stop::depth);
  }
}

/// An ordinary error would call its handler here, where no instruction is counted. Being out of
/// memory has no handler.
void LuaBox::leave_hook(lua_State* state, Stop reason) {
  stop(state, 0, reason);
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
  if (box.stopped()) return 1;
  if (lua_type(state, 1) != LUA_TSTRING) {
    if (luaL_getmetafield(state, 1, "__tostring") != LUA_TNIL) {
      lua_pushvalue(state, 1);
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
  traceback_ = mapped(traceback_.substr(0, kMostMessage));
  text = mapped(text.substr(0, kMostMessage));
  last_failure_ = placed(text);
  return printable(text + " (" + settings_.id + ")");
}

/// A message's "file:line: " taken off, where the file is one that was loaded.
LuaFailure LuaBox::placed(std::string_view text) const {
  for (const std::string& file : files_) {
    if (!text.starts_with(file + ":")) continue;
    std::string_view rest = text.substr(file.size() + 1);
    LuaFailure out{file, 0, {}};
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

/// Each "file:line:" of a text, through the line map.
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

}  // namespace stig
