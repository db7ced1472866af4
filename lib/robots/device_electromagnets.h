// SPDX-License-Identifier: MIT
// Electromagnets of the end-effector, poles on one circuit. robot_devices.h has its charge.
#pragma once

#include <optional>

#include "robots/device.h"
#include "robots/uses.h"

namespace stig::robots {

/// Charge follows its own dynamics, the current is the charge while discharging, with the mode's
/// sign.
struct MagnetCircuitModel {
  struct Pole {
    std::size_t body = 0;
    Vec3 p_B;        ///< of the dipole, body frame
    Vec3 direction;  ///< unit, body frame
  };
  std::vector<Pole> poles;
  double passive = 0, active = 0;  ///< field = passive + active · current, the paper's unit
  // How the charge changes: robot_devices.h, for both generations.
  double charge_limit = 0;
  double charge_per_second = 0;          ///< linear charging (G17)
  double discharge_per_second = 0;       ///< exponential: charge' = -rate · charge (G17)
  double relax_rate = 0;                 ///< exponential charging towards the limit (G21)
  double sink_rate = 0, sink_level = 0;  ///< while discharging: -sink_rate (charge - level) (G21)
};

struct ElectromagnetsKind {
  using Model = MagnetCircuitModel;
  struct Devices {
    std::optional<MagnetCircuitModel> magnets;
  };
  struct Readings {
    double magnet_voltage = 0;  ///< of the electromagnets' charge, in the profile's unit
  };
  static constexpr const char* key = "electromagnets";
  static constexpr const char* doc = "Poles on one circuit.";
  static constexpr const char* argos_sensor = "builderbot_electromagnet_system";
  static constexpr const char* argos_actuator = "builderbot_electromagnet_system";
  static auto& devices(auto& robot) { return robot.magnets; }
  static void reading_members(auto& each, auto& readings) { each(readings.magnet_voltage); }
  static const Form& form();
  static MagnetCircuitModel read(const FormView& view, DeviceParts& parts);
  static std::string description(const RobotModel& robot);
};

}  // namespace stig::robots
