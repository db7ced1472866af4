// SPDX-License-Identifier: MIT
// Sensors and devices of a robot file, kind by kind.
#include "robots/device_parts.h"

namespace stig::robots {

namespace {

template <ListedKind Kind>
void read_list(const FormView& root, DeviceParts& parts) {
  std::vector<std::pair<std::string, SourceRange>> seen;
  for (const FormView& view : entries(root, Kind::key, parts.bad)) {
    parts.claim_name(view, Kind::key, seen);
    Kind::devices(parts.model).push_back(Kind::read(view, parts));
  }
}

}  // namespace

void read_devices(const FormView& root, const RobotParts& robot) {
  DeviceParts parts(robot);
  DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (ListedKind<Kind>) {
      read_list<Kind>(root, parts);
    } else if (root.has(Kind::key)) {
      Kind::devices(parts.model) = Kind::read(root.form(Kind::key), parts);
    }
  });
}

}  // namespace stig::robots
