// SPDX-License-Identifier: MIT
// Devices that a script breaks: what programs read then, and that runs go on when brought back.
#include <doctest/doctest.h>

#include <cmath>

#include "physical/robots/crew_support.h"
#include "support/uses.h"

using namespace stig;

namespace {

using Said = std::vector<std::string>;

const std::string kOneBlock =
    "robots: [{file: bebot.yaml, name: r, program: p.lua}]\n"
    "blocks: [{name: b, at: [0.30, 0, 0.0275], color: Q3}]\n";
/// Says, once a second after the lift has risen, how many tags are seen and what the four LEDs of
/// the first tag show.
constexpr const char* kLooks = R"(
local n = 0
function init() robot.camera_system.enable() robot.lift_system.set_position(0.135) end
function step()
  n = n + 1
  if n < 16 or n % 5 ~= 1 then return end
  local camera, shown = robot.camera_system, ''
  local tag = camera.tags[1]
  for i, place in ipairs { {1, 0}, {0, 1}, {-1, 0}, {0, -1} } do
    if tag then
      local led = vector3(0.02 * place[1], 0.02 * place[2], 0)
      shown = shown .. string.format('%d', camera.detect_led(
        led:rotate(tag.orientation) + tag.position))
    end
  end
  log(#camera.tags > 0, ' ', shown)
end)";

Said looked(const std::string& script, double duration = 6.5, const std::string& more = {}) {
  return Scripted(kOneBlock + more, script, duration, {{"p.lua", kLooks}}).said;
}

/// How often a letter is in what was said last.
std::ptrdiff_t last_count(const Said& said, char letter) {
  REQUIRE_FALSE(said.empty());
  return std::count(said.back().begin(), said.back().end(), letter);
}

/// A robot above a block, which it tells to show Q2 in each step; the block answers.
const std::string kTalk =
    "robots: [{file: bebot.yaml, name: r, program: p.lua}]\n"
    "blocks: [{name: b, at: [0.093755, 0, 0.0275]}]\nblock_program: b.lua\n";
const std::map<std::string, std::string> kTalkers = {{"p.lua", R"(
local n = 0
function step()
  n = n + 1
  robot.electromagnet_system.set_discharge_mode('constructive')
  local nfc = robot.simple_radios.nfc
  for _, message in ipairs(nfc.recv) do log('robot hears ', #message) end
  if n % 2 == 1 then nfc.send { 50 } end
end)"},
                                                     {"b.lua", R"(
local n = 0
function step()
  n = n + 1
  for name, radio in pairs(robot.simple_radios) do
    for _, message in ipairs(radio.recv) do
      log('block hears')
      robot.directional_leds.set_all_colors('blue')
    end
    if n % 2 == 0 then radio.send { 1, 2, 3 } end
  end
end)"}};

std::size_t heard_by(const Scripted& run, const std::string& who) {
  return static_cast<std::size_t>(std::count_if(
      run.said.begin(), run.said.end(), [&](const auto& line) { return line.starts_with(who); }));
}

}  // namespace

TEST_CASE("a covered camera sends empty pictures until it is uncovered, whatever its noise") {
  const Said said = looked(
      "function on_step(world)\n"
      "  if world.time() == 3.4 then world.set_camera('r', false) end\n"
      "  if world.time() == 5.4 then world.set_camera('r', true) end\n"
      "end",
      6.5, "noise: {false_tags: 1, false_leds: 1}\n");
  REQUIRE(said.size() == 4);
  CHECK(said[0].starts_with("true"));
  CHECK(said[1] == "false ");
  CHECK(said[2] == "false ");
  CHECK(said[3].starts_with("true"));
}

TEST_CASE("pictures that were taken before the camera was covered still arrive") {
  const auto seen = [](const std::string& latency) {
    return looked("function on_step(world) world.set_camera('r', world.time() < 3.8) end", 4.1,
                  "noise: {camera_latency: " + latency + "}\n");
  };
  // The picture of 4 s is one from before the cover when it takes two steps of 0.2 s.
  CHECK(seen("0").back() == "false ");
  CHECK(seen("2").back() == "true 3333");
}

TEST_CASE("dead LEDs stay dark whatever is set; repaired ones shine when next set") {
  const auto shown = [](const std::string& call) {
    return looked("function on_start(world) " + call + " end", 3.5);
  };
  CHECK(last_count(shown(""), '3') == 4);
  CHECK(last_count(shown("world.set_leds('b', false)"), '0') == 4);
  // One of each face, whatever face the robot sees.
  CHECK(last_count(shown("world.set_leds('b', false, 2)"), '0') == 1);
  CHECK(last_count(shown("world.set_leds('b', false, 2) world.set_leds('b', false, 4)"), '0') == 2);
  CHECK(last_count(shown("world.set_leds('b', false) world.set_color('b', 2)"), '0') == 4);
  const auto repaired = [](const std::string& call) {
    return looked(
        "function on_step(world)\n"
        "  if world.time() == 1 then world.set_leds('b', false) end\n"
        "  if world.time() == 2 then world.set_leds('b', true) " +
            call +
            " end\n"
            "end",
        3.5);
  };
  CHECK(last_count(repaired(""), '0') == 4);
  CHECK(last_count(repaired("world.set_color('b', 2)"), '2') == 4);
  // Exactly one of the faces, and one LED of it.
  std::ptrdiff_t dark = 0;
  for (const char* face : {"1", "2", "3", "4", "5", "6"}) {
    dark += last_count(shown("world.set_leds('b', false, nil, " + std::string(face) + ")"), '0');
    dark += last_count(shown("world.set_leds('b', false, 1, " + std::string(face) + ")"), '0');
  }
  CHECK(dark == 5);
}

TEST_CASE("scripts see what LEDs show, and a block's program cannot light dead ones") {
  const Scripted out(kTalk, R"(
function on_start(world) world.set_leds('b', false, nil, 5) end
function on_end(world)
  local b = world.block(1)
  log(b.color, ' ', b.faces[1], ' ', b.faces[5])
end)",
                     3, kTalkers);
  REQUIRE(heard_by(out, "block") > 0);
  CHECK(out.said.back() == "4.0 4 0");
}

TEST_CASE("a dead radio neither sends nor receives, nor keeps others from it") {
  const auto talk = [](const std::string& call) {
    return Scripted(kTalk, "function on_start(world) " + call + " end", 3, kTalkers);
  };
  const Scripted sound = talk("");
  CHECK(heard_by(sound, "block") > 3);
  CHECK(heard_by(sound, "robot") > 3);
  for (const char* who : {"r", "b"}) {
    CAPTURE(who);
    const Scripted dead = talk("world.set_radio('" + std::string(who) + "', false)");
    CHECK(heard_by(dead, "block") == 0);
    CHECK(heard_by(dead, "robot") == 0);
  }
  const Scripted mended = Scripted(
      kTalk, "function on_step(world) world.set_radio('b', world.time() > 1.5) end", 3, kTalkers);
  CHECK(heard_by(mended, "block") > 0);
  CHECK(heard_by(mended, "block") < heard_by(sound, "block"));
}

TEST_CASE("a robot whose right wheels hardly hold goes to the right") {
  const auto y = [](const std::string& factor) {
    const Scripted out(
        "robots: [{file: bebot.yaml, name: r, program: p.lua}]\n",
        "function on_start(world)\n"
        "  world.set_friction('r/front right wheel', " +
            factor +
            ")\n"
            "  world.set_friction('r/rear right wheel', " +
            factor +
            ")\n"
            "end\n"
            "function on_end(world) world.measure('y', world.robot(1).position.y) end",
        3,
        {{"p.lua",
          "function step()\n"
          "  robot.differential_drive.set_target_velocity(0.1, -0.1)\n"
          "end"}});
    return out.run.measures().at("y");
  };
  CHECK(std::abs(y("1")) < 1e-3);
  CHECK(y("0") < -0.02);
}

TEST_CASE("runs with broken devices are brought back as if they had never stopped") {
  const LoadedScene loaded = Scripted::scripted_scene(kTalk, R"(
function on_step(world)
  local t = world.time()
  world.set_camera('r', t < 0.4)
  world.set_radio('b', t < 1)
  world.set_leds('b', t < 0.6, 3)
  world.set_friction('r/front left wheel', t < 0.8 and 1 or 0.5)
end)",
                                                      kTalkers);
  Simulation straight(loaded.scene, loaded.placed);
  const CrewRun whole = recorded(straight, loaded, 2);
  for (const double at : {0.3, 0.5, 0.7, 0.9, 1.105}) check_brought_back(loaded, at, 2, whole);
}

TEST_CASE("every fault is part of the hash, and none when it is over") {
  const auto hash = [](const std::string& call) {
    return Scripted(kOneBlock, "function on_start(world) " + call + " end", 0.1,
                    {{"p.lua", "function step() end"}})
        .run.hash();
  };
  const std::uint64_t sound = hash("");
  for (const char* call : {"world.set_camera('r', %)", "world.set_radio('r', %)",
                           "world.set_radio('b', %)", "world.set_leds('b', %, 1)"}) {
    CAPTURE(call);
    std::string off = call, on = call;
    off.replace(off.find('%'), 1, "false"), on.replace(on.find('%'), 1, "true");
    CHECK(hash(off) != sound);
    CHECK(hash(on) == sound);
  }
  CHECK(hash("world.set_friction('b', 0.5)") != sound);
  CHECK(hash("world.set_friction('b', 1)") == sound);
}

TEST_CASE("what is broken is told, robots first") {
  const Scripted out(kOneBlock, R"(
function on_start(world)
  world.set_leds('b', false, 2)
  world.set_radio('b', false)
  world.set_camera('r', false)
  world.set_radio('r', false)
end)",
                     0.5, {{"p.lua", "function step() end"}});
  CHECK(out.run.crew()->broken() ==
        Said{"the cameras of r see nothing", "the radios of r neither send nor receive",
             "the radios of b neither send nor receive", "6 of 24 LEDs of b are dead"});
}

TEST_CASE("nonsense about devices ends the run and says where") {
  const auto message = [](const std::string& call) {
    const Scripted out(kOneBlock, "function on_step(world) " + call + " end", 1,
                       {{"p.lua", "function step() end"}});
    CHECK(out.run.script_failed());
    return out.run.message();
  };
  const auto says = [&](const std::string& call, const std::string& text) {
    CAPTURE(call);
    CHECK_MESSAGE(message(call).find(text) != std::string::npos, message(call));
  };
  says("world.set_camera('b', false)", "'b' is no robot");
  says("world.set_camera('r')", "(on) must be true or false, and is missing");
  says("world.set_camera('r', 1)", "(on) must be true or false, and is 1");
  says("world.set_radio('x', false)", "nothing is called 'x'");
  says("world.set_radio('r', nil)", "true or false");
  says("world.set_leds('r', false)", "'r' is no block");
  says("world.set_leds('b', false, 5)", "(led) must be a whole number from 1 to 4");
  says("world.set_leds('b', false, 1, 7)", "(face) must be a whole number from 1 to 6");
  says("world.set_friction('r', 0.5)", "nothing is called 'r'");
  says("world.set_friction('b', -1)", "factor must be from 0 to 10");
  says("world.set_friction('b', 0/0)", "factor");
}
