// SPDX-License-Identifier: MIT
// What differs from Lua's own libraries, and that the rest does not.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <lua.hpp>

#include "controllers/lua_fixture.h"
#include "support/uses.h"

namespace stig {
namespace {

TEST_CASE("pairs and next go through a table in an order of their own") {
  const std::string table =
      "local t = {10, 20, [5] = 1, b = 1, a = 2, [true] = 1, [false] = 0, [-1] = 1, [0.5] = 1, "
      "['10'] = 1, [0] = 1, [print] = 1} local s = '' ";
  const std::string in_order = "1 2 5 -1 0 0.5 10 a b false true function: #1 ";
  CHECK(said(table + "for k in pairs(t) do s = s .. tostring(k) .. ' ' end print(s)") == in_order);
  CHECK(said(table + "for k in next, t do s = s .. tostring(k) .. ' ' end print(s)") == in_order);
  CHECK(said(table + "for k, v in pairs(t) do t[k] = nil end print(next(t))") == "nil");
  CHECK(said("local t = {a = 1, b = 2, c = 3} for k in pairs(t) do t.b = nil log(k) end") ==
        "a\nc");
  CHECK(
      said("for k, v in pairs(setmetatable({}, {__pairs = function(t) return next, {x = 5} end})) "
           "do print(k, v) end") == "x\t5");
  CHECK(said("pairs({[print] = 1, [{}] = 2})").find("have no order") != std::string::npos);
  CHECK(said("next({[print] = 1, [{}] = 2})").find("have no order") != std::string::npos);
  CHECK(said("pairs()").find("bad argument #1 to 'pairs'") != std::string::npos);
}

TEST_CASE("no address is ever printed") {
  CHECK(said("local t = {} print(t, print, coroutine.create(print), t)") ==
        "table: #1\tfunction: #2\tthread: #3\ttable: #1");
  CHECK(said("print(('%s %5s|%-4s|'):format({}, true, nil))") == "table: #1  true|nil |");
  CHECK(said("print(setmetatable({}, {__name = 'Thing'}))") == "Thing: #1");
  CHECK(said("print(('%p'):format({}))").find("%p is not known") != std::string::npos);
  CHECK(said("print(('%d %5.1f %x %q %%'):format(3, 2.25, 255, 'a\\nb'))") ==
        "3   2.2 ff \"a\\\nb\" %");
  CHECK(said("print(tostring(1), tostring(1.0), tostring(nil), tostring('x'), 2^53)") ==
        "1\t1.0\tnil\tx\t9.007199254741e+15");
}

TEST_CASE("random numbers are the seed's, the robot's and the call's") {
  const auto draw = [](std::uint64_t seed, std::uint32_t agent, const std::string& text) {
    LuaSettings settings = settings_of();
    settings.seed = seed;
    settings.agent = agent;
    Running robot(text, settings);
    robot.step();
    CHECK(robot.status.error == "");
    return joined(robot.commands.log);
  };
  const std::string text =
      "function step() print(math.random(), math.random(100), math.random(-5, 5)) end";
  CHECK(draw(1, 2, text) == draw(1, 2, text));
  CHECK(draw(1, 2, text) != draw(2, 2, text));
  CHECK(draw(1, 2, text) != draw(1, 3, text));
  const std::string again =
      "function step() math.randomseed(5) local a = math.random() "
      "math.randomseed(5) print(a == math.random()) end";
  CHECK(draw(1, 2, again) == "true");
  CHECK(said("for i = 1, 1000 do local x = math.random(3) assert(x >= 1 and x <= 3) "
             "x = math.random() assert(x >= 0 and x < 1) end math.random(0) "
             "math.random(math.mininteger, math.maxinteger)") == "");
  CHECK(said("math.random(0, -1)").find("empty") != std::string::npos);
}

TEST_CASE("the table library does what Lua's does") {
  CHECK(said(R"(
    local t = {1, 2, 3}
    table.insert(t, 4) table.insert(t, 1, 0)
    assert(table.concat(t, ',') == '0,1,2,3,4')
    assert(table.remove(t) == 4 and table.remove(t, 1) == 0 and table.concat(t) == '123')
    assert(table.remove({}) == nil and table.remove({}, 0) == nil and table.remove({5}, 2) == nil)
    assert(not pcall(table.insert, t, 9, 1) and not pcall(table.insert, t) and not pcall(table.remove, t, 9))
    assert(table.concat({1, 2.5, 'x'}, '-', 2) == '2.5-x' and table.concat({}, 'x') == '')
    assert(not pcall(table.concat, {{}}))
    local p = table.pack(1, nil, 3) assert(p.n == 3 and p[3] == 3)
    assert(select('#', table.unpack({1, nil, 3}, 1, 3)) == 3 and table.unpack({4, 5}, 2) == 5)
    assert(not pcall(table.unpack, {}, 1, 1e8) and not pcall(table.unpack, {}, math.mininteger, math.maxinteger))
    local m = table.move({1, 2, 3}, 2, 3, 1) assert(m[1] == 2 and m[2] == 3 and m[3] == 3)
    m = table.move({1, 2, 3}, 1, 3, 2) assert(m[2] == 1 and m[4] == 3)
    m = table.move({1, 2}, 1, 2, 1, {}) assert(m[2] == 2)
    local s = {} for i = 1, 500 do s[i] = (i * 7919) % 503 end
    table.sort(s) for i = 2, 500 do assert(s[i - 1] <= s[i]) end
    table.sort(s, function(a, b) return a > b end) assert(s[1] > s[500])
    table.sort(s, function() return true end)   -- nonsense, but it ends
    assert(not pcall(table.sort, {1, 'x'}))
    local r = {{1, 'a'}, {0, 'b'}, {1, 'c'}, {0, 'd'}}
    table.sort(r, function(x, y) return x[1] < y[1] end)   -- stable
    assert(r[1][2] .. r[2][2] .. r[3][2] .. r[4][2] == 'bdac')
  )") == "");
}

TEST_CASE("pcall, xpcall, load and coroutines are as Lua has them") {
  CHECK(said(R"(
    assert('10' + 1 == 11 and '3' * '4' == 12 and not pcall(function() return 'x' + 1 end))
    assert(select('#', pcall(function() return 1, nil end)) == 3)
    local ok, e = pcall(error, {5}) assert(not ok and e[1] == 5)
    assert(select(2, xpcall(error, function(m) return m .. '!' end, 'x')) == 'x!')
    assert(select(2, xpcall(function(a) return a end, print, 7)) == 7)
    local f, problem = load('x =') assert(not f and problem:find('unexpected'))
    local co = coroutine.wrap(function(a) local b = coroutine.yield(a + 1) pcall(coroutine.yield, b) return 'end' end)
    assert(co(1) == 2 and co(5) == 5 and co() == 'end' and not pcall(co))
    local dead = coroutine.create(function() error('x') end)
    local ok, e = coroutine.resume(dead) assert(not ok and e:find('x') and coroutine.status(dead) == 'dead')
    assert(coroutine.close(coroutine.create(print)))
    assert(not pcall(coroutine.close, coroutine.running()))
    local ok, e = pcall(coroutine.wrap(function() local c <close> = setmetatable({}, {__close = function(_, m) log(m) end}) error('why', 0) end))
    assert(not ok and e == 'why')
    assert(collectgarbage('count') > 0 and collectgarbage() == 0 and collectgarbage('step', 9) == 0)
    assert(tonumber('0x10') == 16 and tonumber('z', 36) == 35 and tonumber('x') == nil)
  )") == "why");
}

/// Lua's own library, in a state without any limits.
std::string plain_lua(const std::string& text) {
  lua_State* state = luaL_newstate();
  luaL_openlibs(state);
  std::string result;
  if (luaL_dostring(state, text.c_str()) == LUA_OK) {
    result = lua_tostring(state, -1);
  } else {
    result = "error";
  }
  lua_close(state);
  return result;
}

std::string boxed(const std::string& text) {
  Running robot("print((function() " + text + " end)())");
  return robot.status.ok ? joined(robot.commands.log) : "error";
}

TEST_CASE("patterns match as Lua's do") {
  CHECK(rc::check("find, match, gmatch and gsub agree with Lua's own", [] {
    const std::vector<std::string> pieces{
        "a",  "b", ".", "%a", "%d", "%w", "%S", "[ab]", "[^a]",   "[a-b1]", "[%d_]", "(", ")", "()",
        "%1", "*", "+", "-",  "?",  "^",  "$",  "%b()", "%f[%w]", "%%",     "%.",    "]", "[", "%"};
    std::string pattern, subject;
    const int n = *rc::gen::inRange(0, 8), m = *rc::gen::inRange(0, 12);
    for (int i = 0; i < n; ++i) pattern += pieces[*rc::gen::inRange<std::size_t>(0, pieces.size())];
    for (int i = 0; i < m; ++i) subject += *rc::gen::elementOf(std::string("aabb1 ().%_"));
    const int start = *rc::gen::inRange(-3, 5);
    const std::string script = "local s, p, i = [==[" + subject + "]==], [==[" + pattern +
                               "]==], " + std::to_string(start) + R"(
      local out = {}
      local function note(...) for k = 1, select('#', ...) do out[#out + 1] = tostring((select(k, ...))) end out[#out + 1] = '|' end
      note(pcall(string.find, s, p, i)) note(pcall(string.match, s, p, i))
      note(pcall(string.gsub, s, p, '<%0>')) note(pcall(string.gsub, s, p, '<%1>', 2))
      note(pcall(string.gsub, s, p, {a = 'x', b = false})) note(pcall(string.find, s, p, i, true))
      note(pcall(function() for x, y in s:gmatch(p) do note(x, y) end end))
      for k, v in ipairs(out) do if k > 1 and out[k - 1] == 'false' then out[k] = 'failed' end end
      return table.concat(out, ' '))";
    RC_ASSERT(boxed(script) == plain_lua(script));
  }));
}

TEST_CASE("weak tables lose their keys at the same moment in every run") {
  const std::string text = R"(
    weak = setmetatable({}, {__mode = 'k'})
    n = 0
    function step()
      for i = 1, 300 do weak[{}] = 1 local s = 'x' .. i .. n end
      n = n + 1
      local count = 0
      weak.mark = nil
      for i = 1, 10 do _G['name' .. (n * i) % 37] = n % 3 > 0 and n or nil end
      print(collectgarbage('count'))
    end)";
  const auto run = [&] {
    LuaSettings settings = settings_of();
    settings.limits = block_limits();
    Running robot(text, settings);
    std::string all;
    for (int i = 0; i < 50; ++i) {
      CHECK(robot.step().error == "");
      all += joined(robot.commands.log) + "\n";
    }
    return all;
  };
  const std::string first = run();
  const std::vector<std::string> elsewhere(100, std::string(1000, 'x'));  // moves addresses
  CHECK(run() == first);
}

TEST_CASE("vectors") {
  CHECK(said(R"(
    local function near(a, b) return math.abs(a - b) < 1e-12 end
    local v, w = vector3(1, 2, 3), vector3(4, 5, 6)
    assert(v + w == vector3(5, 7, 9) and w - v == vector3(3, 3, 3) and -v == vector3(-1, -2, -3))
    assert(v * 2 == vector3(2, 4, 6) and 2 * v == v * 2 and v / 2 == vector3(0.5, 1, 1.5))
    assert(v:dot(w) == 32 and near(v:length(), 14 ^ 0.5))
    local c = vector3(v) assert(c:cross(w) == c and c == vector3(-3, 6, -3))
    assert(v ~= w and v ~= 5 and vector3(v) == v and vector3() == vector3(0, 0, 0))
    v.x = 7 assert(v.x == 7 and v.nothing == nil and not pcall(function() v.a = 1 end))
    assert(not pcall(function() v.x = 'y' end) and not pcall(vector3, 1, 2) and not pcall(vector3, 1, 2, 'z'))
    assert('at ' .. vector3(1, 2.5, -0.0) == 'at 1.0,2.5,0.0')
    local u = vector3(0, 3, 0) assert(u:normalize() == u and u == vector3(0, 1, 0))
    assert(vector3():normalize() == vector3())
    assert(near(vector3(1, 0, 0):angle(vector3(0, 0, 2)), math.pi / 2))
    local q = quaternion(math.pi / 2, vector3(0, 0, 2))
    local r = vector3(1, 0, 0) assert(r:rotate(q) == r and near(r.y, 1) and near(r.x, 0))
    local angle, axis = (q * q):toangleaxis() assert(near(angle, math.pi) and near(axis.z, 1))
    local z, y, x = (quaternion(0.3, vector3(0, 0, 1)) * quaternion(0.2, vector3(0, 1, 0)) * quaternion(0.1, vector3(1, 0, 0))):toeulerangles()
    assert(near(z, 0.3) and near(y, 0.2) and near(x, 0.1))
    assert((q * q:inverse()) == quaternion() or near((q * q:inverse()).w, 1))
    assert(quaternion(q) == q and quaternion(1, 0, 0, 0) == quaternion())
    local t = vector3(1, 0, 0):rotate(quaternion(vector3(1, 0, 0), vector3(0, 0, -4))) assert(near(t.z, -1))
    t = vector3(1, 0, 0):rotate(quaternion(vector3(1, 0, 0), vector3(-1, 0, 0))) assert(near(t.x, -1))
    assert(not pcall(quaternion, 1, vector3()) and not pcall(quaternion, 1, 2, 3))
    local a = vector2(3, 4) assert(a:length() == 5 and a:dot(vector2(1, 1)) == 7 and a + a == a * 2)
    assert(near(vector2(0, 2):angle(), math.pi / 2) and near(vector2(1, 0):angle(vector2(0, -1)), -math.pi / 2))
    assert(near(vector2(1, 0):rotate(math.pi).x, -1) and tostring(vector2(1, 2)) == '1.0,2.0')
    assert(not pcall(function() return a + v end) and not pcall(function() return a * a end))
  )") == "");
}

}  // namespace
}  // namespace stig
