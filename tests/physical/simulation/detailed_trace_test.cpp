// SPDX-License-Identifier: MIT
// Traces in detail: what robots sensed and sent is in them, and the run is the same.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "physical/robots/crew_support.h"

namespace stig {
namespace {

using Json = nlohmann::json;

LoadedScene sending_robot() {
  return crew_scene(
      "stigc_scene: 1\n"
      "robots: [{file: bebot.yaml, name: r, program: p.lua}]\n"
      "blocks: [{at: [0.25, 0, 0.03], color: Q3}, {at: [0.25, 0.06, 0.0275]}]\n",
      {{"p.lua", R"(
local n = 0
function step()
  n = n + 1
  if n == 1 then robot.camera_system.enable() end
  if n == 3 then robot.simple_radios.nfc.send('2') end
end)"}});
}

std::string trace_bytes(const LoadedScene& loaded, bool detailed, std::uint64_t& hash) {
  std::string out;
  Simulation run(loaded.scene, loaded.placed);
  PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed, detailed),
                         [&](std::string_view bytes) { out += bytes; });
  run.record(writer);
  run.finish(run.until(1.2, {}));
  hash = run.hash();
  return out;
}

TEST_CASE("a detailed trace has what robots sense and send, and the run stays the same") {
  const LoadedScene loaded = sending_robot();
  std::uint64_t plain_hash = 0, detailed_hash = 0;
  const std::string plain = trace_bytes(loaded, false, plain_hash);
  const std::string detailed = trace_bytes(loaded, true, detailed_hash);
  CHECK(plain_hash == detailed_hash);
  CHECK(trace_of(plain).header.channels == std::vector<std::string>{"leds", "log", "show"});
  CHECK(frame_at(trace_of(plain), 200).bodies == frame_at(trace_of(detailed), 200).bodies);
  const auto senses = values_of(detailed, "senses");
  REQUIRE(senses.size() >= 4);
  const Json first = Json::parse(senses[0].bytes), third = Json::parse(senses[2].bytes);
  CHECK(first["ranges"].size() == loaded.scene.robot_models[0].rangefinders.size());
  CHECK(first["wheels"].size() == 2);
  CHECK(!first.contains("sent"));
  CHECK(senses[2].tick == 80);
  CHECK(third["sent"] == Json::parse(R"([[0, "2"]])"));
  const Json& camera = third["cameras"][0];
  REQUIRE(camera["tags"].size() >= 1);
  CHECK(camera["tags"][0][1].size() == 8);
  CHECK(camera["leds"].size() >= 1);
}

TEST_CASE("a detailed trace has where the magnets of blocks point") {
  std::uint64_t hash = 0;
  const auto magnets = values_of(trace_bytes(sending_robot(), true, hash), "magnets");
  REQUIRE(!magnets.empty());
  for (const TraceValue& value : magnets) {
    const Json parts = Json::parse(value.bytes);
    REQUIRE(parts.size() == 24);
    for (std::size_t i = 0; i < parts.size(); i += 3) {
      const double square = std::pow(parts[i].get<int>(), 2) +
                            std::pow(parts[i + 1].get<int>(), 2) +
                            std::pow(parts[i + 2].get<int>(), 2);
      CHECK(std::sqrt(square) == doctest::Approx(100).epsilon(0.02));
    }
  }
}

}  // namespace
}  // namespace stig
