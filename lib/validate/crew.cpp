// SPDX-License-Identifier: MIT
#include "validate/crew.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "validate/set_up.h"

namespace stig::validate {

bool is_builder(const Scene& scene, const RobotSpawn& robot) {
  return robot.program < scene.programs.size() &&
         scene.programs[robot.program].path == kControllerFile;
}

const LuaValue* param_of(const RobotSpawn& robot, std::string_view name) {
  const auto found = std::find_if(robot.params.begin(), robot.params.end(),
                                  [&](const auto& one) { return one.first == name; });
  return found == robot.params.end() ? nullptr : &found->second;
}

std::optional<std::vector<ApproachSide>> sides_in(const LuaValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return std::nullopt;
  std::vector<ApproachSide> out;
  std::istringstream words(*text);
  for (std::string word; words >> word;) {
    const auto side = parse_side(word);
    if (!side) return std::nullopt;
    out.push_back(*side);
  }
  return out.empty() ? std::nullopt : std::optional(std::move(out));
}

}  // namespace stig::validate
