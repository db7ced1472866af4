// SPDX-License-Identifier: MIT
// Programs that mean harm: each ends in a status, and only that.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "controllers/lua_fixture.h"
#include "support/uses.h"

namespace stig {
namespace {

LuaSettings small_settings() {
  LuaSettings settings = settings_of();
  settings.limits.instructions = 50'000;
  settings.limits.memory = std::size_t{1} << 20;
  settings.limits.object = std::size_t{256} << 10;
  return settings;
}

std::string fate(const std::string& text) {
  const bool compiled = text.starts_with('\x1b');
  Running robot((compiled ? "" : "function step() end ") + text, small_settings());
  if (robot.status.ok) robot.step();
  CHECK(robot.controller.memory() <= (std::size_t{1} << 20) + (std::size_t{64} << 10));
  const std::string first = robot.status.error;
  CHECK(robot.step().error == first);  // stays failed, or stays well
  return first;
}

void ends(const std::string& text, const std::string& reason) {
  CAPTURE(text);
  const std::string end = fate(text);
  CAPTURE(end);
  CHECK(end.find(reason) != std::string::npos);
}

constexpr const char* kTooLong = "more than 50000 instructions in one call (r1)";
constexpr const char* kTooMuch = "of memory";

TEST_CASE("loops without end are stopped, whatever catches errors") {
  for (const char* text : {
           "while true do end",
           "function step() while true do end end",
           "::a:: goto a",
           "repeat until false",
           "for i = 1, math.huge do end",
           "local function f() return f() end f()",
           "while true do pcall(function() while true do end end) end",
           "while true do pcall(error) end",
           "while true do xpcall(function() while true do end end, function() while true do end "
           "end) end",
           "xpcall(error, function() while true do end end)",
           "local t = setmetatable({}, {__index = function() while true do end end}) return t.x",
           "local t = setmetatable({}, {__add = function() while true do end end}) return t + 1",
           "local t = setmetatable({}, {__eq = function() while true do end end}) return t == "
           "setmetatable({}, getmetatable(t))",
           "setmetatable(_G, {__index = function(t, k) while true do end end}) return x",
           "print(setmetatable({}, {__tostring = function() while true do end end}))",
           "error(setmetatable({}, {__tostring = function() while true do end end}))",
           "for k in pairs(setmetatable({}, {__pairs = function() while true do end end})) do end",
           "local x <close> = setmetatable({}, {__close = function() while true do end end}) "
           "error('x')",
           "coroutine.wrap(function() while true do end end)()",
           "while true do coroutine.resume(coroutine.create(function() while true do end end)) end",
           "while true do coroutine.wrap(function() coroutine.yield() end)() end",
           "local co = coroutine.create(function() local x <close> = setmetatable({}, {__close = "
           "function() while true do end end}) coroutine.yield() end) "
           "coroutine.resume(co) while true do coroutine.close(co) end",
           "local f = coroutine.wrap(function() while true do pcall(coroutine.yield) end end) "
           "while true do pcall(f) end",
           "table.sort({3, 1, 2}, function() while true do end end)",
           "('x'):gsub('.', function() while true do end end)",
           "while true do load('return 1')() end",
           "load('while true do end')()",
           "while true do pcall(load, 'x = = ') end",
       }) {
    ends(text, kTooLong);
  }
}

TEST_CASE("work of library functions counts") {
  for (const char* text : {
           "('a'):rep(5000):find(('a*'):rep(20) .. 'b')",
           "('a'):rep(300):find(('a?'):rep(100) .. ('a'):rep(100) .. 'b')",
           "('a'):rep(60000):find('.-.-.-b')",
           "('('):rep(60000):find('%b()')  while true do ('('):rep(60000):find('%b()') end",
           "('a'):rep(3000):gsub('.-b', '')",
           "for x in ('a'):rep(60000):gmatch('.-b') do end",
           "local s = ('a'):rep(60000) while true do s:find('b', 1, true) end",
           "table.move({}, 1, math.maxinteger - 1, 2)",
           "table.concat(setmetatable({}, {__index = table.concat}), '', 1, math.maxinteger)",
           "table.insert(setmetatable({}, {__len = function() return 2 ^ 53 | 0 end}), 1, "
           "1)",
           "table.remove(setmetatable({}, {__len = function() return 2 ^ 53 | 0 end}), 1)",
           "table.sort(setmetatable({}, {__len = function() return 2 ^ 53 | 0 end}))",
           "local s = ('x'):rep(60000) while true do utf8.len(s) end",
           "local s = (' '):rep(60000) while true do tonumber(s) end",
           "local s = ('x'):rep(60000) while true do local t = s .. 'y' end",
           "local s = ('x'):rep(60000) while true do s:upper() end",
           "local t = {} for i = 1, 1000 do t[i] = i end while true do next(t) end",
           "local t = {} for i = 1, 1000 do t[i] = i end while true do pairs(t) end",
           "while true do print('x') end",
           "while true do pcall(require, 'nothing') end",
       }) {
    ends(text, kTooLong);
  }
}

TEST_CASE("lengths that no list has are refused") {
  for (const char* call :
       {"insert(t, 1)", "insert(t, 1, 1)", "remove(t)", "sort(t)", "concat(t)"}) {
    for (const char* size : {"math.maxinteger", "math.mininteger", "-1"}) {
      ends("local t = setmetatable({}, {__len = function() return " + std::string(size) +
               " end}) table." + call,
           "cannot have this length");
    }
  }
}

TEST_CASE("memory has an end, and meeting it is final") {
  for (const char* text : {
           "local t = {} for i = 1, 1e9 do t[i] = i end",
           "local t = {} while true do t = {t, t} end",
           "local s = 'x' while true do s = s .. s end",
           "local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(60000) .. i end",
           "local t = {} while true do t[#t + 1] = function() return t end end",
           "local t = {} while true do t[#t + 1] = coroutine.create(print) end",
           "local t = {} while true do pcall(function() t[#t + 1] = {1, 2, 3, 4, 5, 6, 7, 8} end) "
           "end",
           "local function f(...) return f(1, 2, 3, 4, 5, 6, 7, 8, ...) end f()",
           "local t = {} for i = 1, 60000 do t[i] = 'x' end return table.concat(t, "
           "('y'):rep(1000))",
           "string.pack('!16 c200000000', '')",
           "local t = {} while true do pcall(table.insert, t, ('x'):rep(30000) .. #t) end",
       }) {
    CAPTURE(text);
    const std::string end = fate(text);
    CAPTURE(end);
    CHECK((end.find(kTooMuch) != std::string::npos || end.find(kTooLong) != std::string::npos));
  }
  ends("local s = 'x' while true do s = s .. s end", kTooMuch);
  ends("local t = {} for i = 1, 1e9 do t[i] = i end", kTooMuch);
  ends("return ('x'):rep(1e9)", "string.rep: the text would have more than 65536 bytes");
  ends("return ('x'):rep(math.maxinteger, ('y'):rep(100))", "string.rep");
  CHECK(fate("return (''):rep(math.maxinteger)") == "");
  // What is thrown away is no reason to stop.
  CHECK(fate("for i = 1, 30 do local s = ('x'):rep(100):rep(200) .. i end") == "");
}

TEST_CASE("recursion has an end, with a place") {
  ends("local function f() return 1 + f() end\nf()",
       "test.lua:1: calls nested more than 5000 deep");
  ends("local function f() return 1 + f() end while true do pcall(f) end", "5000 deep");
  ends(
      "local t = setmetatable({}, {}) getmetatable(t).__index = function(t, k) return t[k] end "
      "return t.x",
      "overflow");
  ends("local s = ('x = ' .. ('('):rep(5000)) assert(load(s))", "overflow");
  ends("local function f() coroutine.wrap(f)() end f()", kTooLong);
  ends("string.gsub(('a'):rep(300), ('(a)'):rep(32) .. ('(a'):rep(10), '')", "malformed pattern");
  ends("return ('a'):rep(500):match(('a-'):rep(300) .. 'b')", "pattern too complex");
}

TEST_CASE("errors of any kind become text") {
  ends("error()", "an error that is a nil value (r1)");
  ends("error({})", "an error that is a table value (r1)");
  ends("error(setmetatable({}, {__tostring = function() return 'mine' end}))", "mine (r1)");
  ends("error(setmetatable({}, {__tostring = function() error('again') end}))", "__tostring fails");
  ends("error(setmetatable({}, {__tostring = function() return {} end}))", "__tostring fails");
  ends("error('a\\0b\\27[31m', 0)", "a\\x00b\\x1b[31m (r1)");
  ends("error(('x'):rep(60000))", "xxx (r1)");
  ends("x = = 1", "test.lua:1: unexpected symbol near '='");
  ends("\n\nlocal y = nil + 1", "test.lua:3: attempt to perform arithmetic on a nil value");
  ends("\033Lua", "attempt to load a binary chunk");
  ends("coroutine.yield()", "attempt to yield from outside a coroutine");
  ends("function step() coroutine.yield() end", "attempt to yield from outside a coroutine");
  ends(
      "local x <close> = setmetatable({}, {__close = function() error('late') end}) error('early')",
      "late");
}

TEST_CASE("what could reach the machine is not there") {
  for (const char* name : {"io", "os", "debug", "package", "dofile", "loadfile", "warn",
                           "string.dump", "rawequal and jit"}) {
    CHECK(fate("assert(not (" + std::string(name) + "))") == "");
  }
  ends("assert(load('\\27Lua'))", "attempt to load a binary chunk");
  ends("assert(load('\\27Lua', 'x', 'b'))", "attempt to load a binary chunk");
  CHECK(fate("assert(load('return a', 'x', 't', {a = 5})() == 5)") == "");
  ends("load(function() end)", "load: argument 1 (chunk) must be a text");
  ends("setmetatable({}, {__gc = function() while true do end end})", "no finalizers");
  ends("getmetatable('').__index = {}", "attempt to index a string value");
  ends("setmetatable('', {})", "table expected");
  CHECK(fate("assert(getmetatable(vector3()) == 'vector3' and not pcall(setmetatable, vector3(), "
             "{}))") == "");
  ends("string.find = nil return ('x'):find('x')", "attempt to call a nil value (method 'find')");
  CHECK(fate("setmetatable(_G, {__newindex = error, __index = error}) robot = nil") == "");
  ends("setmetatable(_G, {__metatable = 1}) setmetatable(_G, {})", "protected");
  ends("_G.pcall, _G.error = nil, nil while true do end", kTooLong);
}

TEST_CASE("require finds plain files beside the program and in folders there only") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "stig_lua_require";
  fs::remove_all(folder);
  fs::create_directories(folder / "in" / "part");
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
  };
  write("out.lua", "return 'out'");
  write("in/mod.lua", "count = (count or 0) + 1 return {name = ...}");
  write("in/none.lua", "");
  write("in/part/piece.lua", "return {near = require 'mod', name = ...}");
  write("in/self.lua", "require 'self'");
  write("in/bad.lua", "\n\nerror('broken')");
  write("in/loop.lua", "while true do end");
  write("in/binary.lua", "\x1bLua");
  write("in/large.lua", std::string(kMostLuaSource + 1, ' '));
  fs::create_symlink(folder / "out.lua", folder / "in/link.lua");
  fs::create_symlink("mod.lua", folder / "in/near.lua");
  fs::create_directory(folder / "in/dir.lua");
  fs::create_directory_symlink(folder, folder / "in/up");
  const auto run = [&](const std::string& text) {
    LuaController controller({(folder / "in/main.lua").string(), text}, {}, small_settings());
    RobotCommands commands;
    return controller.init(commands).error;
  };
  CHECK(run("local m = require 'mod' assert(m.name == 'mod' and require 'mod' == m and count == "
            "1)") == "");
  CHECK(run("assert(require 'none' == true and require 'near'.name == 'near')") == "");
  for (const char* name :
       {"../out", "/etc/passwd", "..", ".", "", "a/b", "a..b", ".a", "a.", "a\\\\b", "mod\\0x"}) {
    CAPTURE(name);
    CHECK(run("require '" + std::string(name) + "'").find("letters, digits") != std::string::npos);
  }
  // in a folder, from where names begin at the program all the same
  CHECK(run("local p = require 'part.piece' assert(p.name == 'part.piece' and p.near == require "
            "'mod')") == "");
  for (const char* name : {"link", "absent", "part.mod", "up.out"}) {
    CAPTURE(name);
    CHECK(run("require '" + std::string(name) + "'").find("there is no file") != std::string::npos);
  }
  write("in/marked.lua", "\xef\xbb\xbf#!/usr/bin/lua\nreturn 'marked'");
  write("in/hash.lua", "#\nerror('here')");
  CHECK(run("assert(require 'marked' == 'marked')") == "");
  CHECK(run("require 'hash'").find("hash.lua:2: here") != std::string::npos);
  CHECK(run("#!lua\nerror('main')").find("main.lua:2: main") != std::string::npos);
  CHECK(run("\xef\xbb\xbf"
            "error('main')")
            .find("main.lua:1: main") != std::string::npos);
  CHECK(run("assert(not load('#\\nx = 1'))") == "");  // what is no file
  LuaController whole({"main.lua", "local n = 'mod' require(n)", {}, true}, {}, small_settings());
  RobotCommands ignored;
  CHECK(whole.init(ignored).error.find("it must, as require 'mod'") != std::string::npos);
  CHECK(run("require(5)").find("must be a text") != std::string::npos);
  CHECK(run("require 'self'").find("requires itself") != std::string::npos);
  CHECK(run("require 'bad'").find("bad.lua:3: broken") != std::string::npos);
  CHECK(run("require 'dir'") != "");
  CHECK(run("require 'large'") != "");
  CHECK(run("require 'binary'").find("binary chunk") != std::string::npos);
  CHECK(run("pcall(require, 'loop')").find(kTooLong) != std::string::npos);
  fs::remove_all(folder);
}

TEST_CASE("a failure stops its robot only, and its log has the way there") {
  Running bad("local function f() error('here') end\nfunction step()\n  f()\nend"),
      good("function step() log(1) end");
  bad.step();
  good.step();
  CHECK(bad.status.error == "test.lua:1: here (r1)");
  CHECK(joined(bad.commands.log) ==
        "error: test.lua:1: here (r1)\nstack traceback:\n\t[C]: in function 'error'\n\ttest.lua:1: "
        "in upvalue 'f'\n\ttest.lua:3: in function 'step'");
  CHECK(good.status.ok);
  CHECK(joined(good.commands.log) == "1");
}

TEST_CASE("lines of a generated program are told as those of its source") {
  LuaSettings settings = settings_of();
  settings.line_map = [](const std::string& file, int line) {
    CHECK(file == "test.lua");
    using Place = std::pair<std::string, int>;
    return line == 2 ? std::optional<Place>({"rules.yaml", 40}) : std::nullopt;
  };
  Running robot("local function f()\n error('here') end\nf()", settings);
  CHECK(robot.status.error == "rules.yaml:40: here (r1)");
  CHECK(robot.commands.log.at(3) == "\trules.yaml:40: in local 'f'");
  CHECK(robot.commands.log.at(4) == "\ttest.lua:3: in main chunk");
}

TEST_CASE("states that hold half-run coroutines and closing variables are thrown away in peace") {
  Running robot(
      "local x <close> = setmetatable({}, {__close = function() error('x') end})\n"
      "keep = coroutine.wrap(function() local y <close> = setmetatable({}, {__close = error}) "
      "coroutine.yield() end)\n"
      "keep() function step() keep() keep() end");
  robot.step();
}

TEST_CASE("limits that leave no room at all") {
  for (const std::size_t memory : {0, 1000, 5000, 10'000, 20'000, 30'000, 40'000}) {
    LuaSettings settings = settings_of();
    settings.limits.memory = memory;
    CHECK(!Running("x = ('y'):rep(60000)", settings).status.ok);
  }
  for (const std::uint64_t instructions : {0, 1, 10, 100, 1000}) {
    LuaSettings settings = settings_of();
    settings.limits.instructions = instructions;
    CHECK(!Running("for i = 1, 1e6 do end", settings).status.ok);
  }
}

}  // namespace
}  // namespace stig
