// SPDX-License-Identifier: MIT
// The list of all kinds of devices (device.h). What robots' files may hold, what programs read
// and find in Lua, the bytes of readings, `stigc describe` and experiments for ARGoS go through it.
//
// Its order is that of keys in the schema and of devices in reports. Errors of sensors are drawn
// at a device's number among all that its robot has, counted along the list: a kind that comes
// later leaves those before it as they are.
#pragma once

#include <concepts>

#include "robots/device_actuator.h"
#include "robots/device_camera.h"
#include "robots/device_compass.h"
#include "robots/device_drive.h"
#include "robots/device_electromagnets.h"
#include "robots/device_led.h"
#include "robots/device_lift.h"
#include "robots/device_radio.h"
#include "robots/device_rangefinder.h"
#include "robots/uses.h"

namespace stig::robots {

template <class... Kinds>
struct KindList {
  struct Devices : Kinds::Devices... {};
  struct Readings : Kinds::Readings... {};
  /// Calls f(Kind{}) for each.
  static void each(auto&& f) { (f(Kinds{}), ...); }
  template <class Kind>
  static constexpr bool has = (std::same_as<Kind, Kinds> || ...);
};

using DeviceKinds = KindList<DriveKind, LiftKind, ElectromagnetsKind, CameraKind, RangefinderKind,
                             RadioKind, LedKind, ActuatorKind, CompassKind>;

/// A robot may have several, each with a name.
template <class Kind>
concept ListedKind = requires {
  typename Kind::Device;
};
/// Each of them tells its program something.
template <class Kind>
concept ReadKind = ListedKind<Kind> && requires {
  typename Kind::Reading;
};
/// Sensors that perceive how their body is placed and moves, and nothing else.
template <class Kind>
concept BodySensor = ReadKind<Kind> && requires {
  &Kind::sense;
};

struct AnyFigure {
  void operator()(auto&&...) const {}
};
/// A few figures, each with a name and a unit.
template <class Type>
concept HasFigures = requires(Type& value) {
  Type::fields(AnyFigure{}, value);
};

/// What a device reads before anything has been measured.
template <ReadKind Kind>
typename Kind::Reading reading_before(const typename Kind::Device& device) {
  if constexpr (requires { Kind::before(device); }) {
    return Kind::before(device);
  } else {
    return {};
  }
}

/// The number of a kind's first device among all of the robot's.
template <ListedKind Wanted>
std::size_t first_number(const auto& robot) {
  std::size_t count = 0;
  bool before = true;
  DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (std::same_as<Kind, Wanted>) before = false;
    if constexpr (ListedKind<Kind>) count += before ? Kind::devices(robot).size() : 0;
  });
  return count;
}

}  // namespace stig::robots
