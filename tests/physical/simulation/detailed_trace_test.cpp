// SPDX-License-Identifier: MIT
// Traces in detail: what robots sensed and sent is in them, and the run is the same.
#include <doctest/doctest.h>

#include <array>
#include <map>
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

TEST_CASE("a detailed trace has what contacts push: the floor carries what lies still") {
  std::uint64_t hash = 0;
  const LoadedScene loaded = sending_robot();
  std::map<std::uint32_t, Json> last;
  for (const TraceValue& value : values_of(trace_bytes(loaded, true, hash), "contacts")) {
    last[value.body] = Json::parse(value.bytes);
  }
  // Together: one of the two blocks hangs by its magnets on the other.
  double weight = 0, carried = 0;
  for (const auto& [body, contacts] : last) {
    if (!loaded.placed.bodies[body].block) continue;
    weight += loaded.placed.config.bodies[body].mass * loaded.placed.config.gravity;
    for (const Json& contact : contacts) {
      REQUIRE(contact.size() == 7);
      if (contact[0] != -1) continue;
      carried += contact[6].get<double>() / 10;
      CHECK(contact[3] == 0);
      CHECK(contact[1].get<double>() / 1e3 == doctest::Approx(0.25).epsilon(0.15));
    }
  }
  CHECK(weight > 2);
  CHECK(carried == doctest::Approx(weight).epsilon(0.05));
}

TEST_CASE("a detailed trace has what magnets do: as much one way as the other") {
  std::uint64_t hash = 0;
  std::map<std::uint32_t, Json> last;
  for (const TraceValue& value : values_of(trace_bytes(sending_robot(), true, hash), "pulls")) {
    last[value.body] = Json::parse(value.bytes);
  }
  double most = 0;
  std::array<double, 3> all{};
  for (const auto& [body, force] : last) {
    REQUIRE(force.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
      all[k] += force[k].get<double>();
      most = std::max(most, std::abs(force[k].get<double>()));
    }
  }
  CHECK(most > 0);
  for (const double part : all) CHECK(std::abs(part) <= static_cast<double>(last.size()));
}

}  // namespace
}  // namespace stig
