// SPDX-License-Identifier: MIT
#include "robots/robot_description.h"

#include <fmt/format.h>

namespace stig::robots {

namespace {

/// A table with an entry for each device, of the figures that it lists.
template <class Kind>
std::string description_of_fields(const RobotModel& robot) {
  const auto& devices = Kind::devices(robot);
  if (devices.empty()) return {};
  std::string out = fmt::format("   {} = {{\n", Kind::key);
  for (const auto& device : devices) {
    std::string figures;
    const auto add = [&](const char* name, const auto& value, const char* /*unit*/) {
      figures += fmt::format("{}{} = {:.6g}", figures.empty() ? "" : ", ", name, value);
    };
    Kind::Device::fields(add, device);
    out += fmt::format("      [{}] = {{ {} }},\n", lua_quoted(device.name), figures);
  }
  return out + "   },\n";
}

}  // namespace

std::string lua_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\{:03}", static_cast<int>(static_cast<unsigned char>(c)));
    } else {
      out += c;
    }
  }
  return out + "'";
}

std::string described_place(const Vec3& p) {
  return fmt::format("x = {:.6g}, y = {:.6g}, z = {:.6g}", p.x, p.y, p.z);
}

std::string robot_description(const RobotModel& robot) {
  std::string out = fmt::format("{{\n   name = {},\n", lua_quoted(robot.name));
  DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (requires { Kind::description(robot); }) {
      out += Kind::description(robot);
    } else if constexpr (ListedKind<Kind>) {
      if constexpr (HasFigures<typename Kind::Device>) out += description_of_fields<Kind>(robot);
    }
  });
  return out + "}";
}

}  // namespace stig::robots
