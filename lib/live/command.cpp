// SPDX-License-Identifier: MIT
// Each key is taken out as it is read, and what is left over is an error: so a command says nothing
// that is not heard.
#include "live/command.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace stig::live {

namespace {

using nlohmann::json;

constexpr double kFarthest = 1000;  ///< m
constexpr std::uint64_t kMostSteps = 100'000;
constexpr double kSlowest = 0.01, kFastest = 1000;

/// Ends in read_command.
struct BadCommand : std::runtime_error {
  using std::runtime_error::runtime_error;
};

json taken(json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw BadCommand(fmt::format("'{}' is missing", key));
  json value = std::move(*found);
  object.erase(found);
  return value;
}

std::uint64_t whole(json& object, const char* key, std::uint64_t least, std::uint64_t most) {
  const json value = taken(object, key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() < least ||
      value.get<std::uint64_t>() > most) {
    throw BadCommand(fmt::format("'{}' is to be a whole number from {} to {}", key, least, most));
  }
  return value.get<std::uint64_t>();
}

double real(const json& value, const char* key, double least, double most) {
  const double x = value.is_number() ? value.get<double>() : NAN;
  if (!(x >= least && x <= most)) {
    throw BadCommand(fmt::format("'{}' is to be a number from {} to {}", key, least, most));
  }
  return x;
}

Vec3 place(json& object) {
  const json value = taken(object, "at");
  if (!value.is_array() || value.size() != 3) throw BadCommand("'at' is to be [x, y, z]");
  const auto part = [&](std::size_t i) { return real(value[i], "at", -kFarthest, kFarthest); };
  return {part(0), part(1), part(2)};
}

std::optional<Quat> turn(json& object) {
  if (!object.contains("yaw")) return std::nullopt;
  return rotation({0, 0, real(taken(object, "yaw"), "yaw", -10, 10)});
}

std::uint32_t thing(json& object, const char* key) {
  return static_cast<std::uint32_t>(whole(object, key, 0, 10'000'000));
}

HandAction moving(json& object) {
  HandAction out;
  out.kind = HandKind::place;
  out.robot = object.contains("robot");
  out.number = thing(object, out.robot ? "robot" : "block");
  out.at = place(object);
  out.turn = turn(object);
  return out;
}

HandAction dropping(json& object) {
  HandAction out;
  out.kind = HandKind::drop;
  out.at = place(object);
  out.turn = turn(object);
  return out;
}

LiveCommand command_from(const std::string& what, json& object) {
  LiveCommand out;
  const auto hand = [&out](const HandAction& action) {
    out.ask = LiveAsk::hand;
    out.action = action;
  };
  if (what == "run") return out;
  if (what == "pause") {
    out.ask = LiveAsk::pause;
  } else if (what == "again") {
    out.ask = LiveAsk::again;
  } else if (what == "checkpoint") {
    out.ask = LiveAsk::checkpoint;
  } else if (what == "step") {
    out.ask = LiveAsk::step;
    out.number = whole(object, "count", 1, kMostSteps);
  } else if (what == "speed") {
    out.ask = LiveAsk::speed;
    const json times = taken(object, "times");
    if (!times.is_null()) out.speed = real(times, "times", kSlowest, kFastest);
  } else if (what == "back") {
    out.ask = LiveAsk::back;
    out.number = whole(object, "checkpoint", 1, 1'000'000);
  } else if (what == "move") {
    hand(moving(object));
  } else if (what == "drop") {
    hand(dropping(object));
  } else if (what == "break") {
    hand({HandKind::halt, true, thing(object, "robot"), {}, {}});
  } else if (what == "mend") {
    hand({HandKind::mend, true, thing(object, "robot"), {}, {}});
  } else {
    throw BadCommand("'do' is no command");
  }
  return out;
}

}  // namespace

std::optional<LiveCommand> read_command(std::string_view text, std::string& problem) {
  problem = "it is no JSON object";
  if (text.size() > kMostCommandBytes) return std::nullopt;
  json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  try {
    const json what = taken(object, "do");
    if (!what.is_string()) throw BadCommand("'do' is to be a word");
    const LiveCommand out = command_from(what.get<std::string>(), object);
    if (!object.empty()) throw BadCommand("it has a key that the command does not have");
    problem.clear();
    return out;
  } catch (const BadCommand& bad) {
    problem = bad.what();
    return std::nullopt;
  }
}

}  // namespace stig::live
