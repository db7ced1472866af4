// SPDX-License-Identifier: MIT
// What the readers of devices share, and the keys that several kinds have. Private to this folder.
#pragma once

#include "robots/form_keys.h"
#include "robots/robot_parts.h"
#include "robots/uses.h"

namespace stig::robots {

/// What a device asks of the axis that it uses.
struct AxisNeed {
  std::string_view what;  ///< the device
  bool angular = true;
  bool any = false;  ///< of movement and motor; otherwise a velocity motor
};

class DeviceParts : public RobotParts {
 public:
  explicit DeviceParts(const RobotParts& parts) : RobotParts(parts) {}

  /// The body that `body` names; kNoBody when there is none.
  std::size_t on_body(const FormView& view) const;
  /// The place that `at` gives, in the frame of the body's middle.
  Vec3 place(const FormView& view, std::size_t body) const;
  /// The axis of the joint that the node names, which no other device may use from then on.
  AxisRef take_axis(const YamlNode* node, std::size_t axis, const AxisNeed& need);

 private:
  struct Claim {
    AxisRef axis;
    std::string_view what;
    SourceRange place;
  };

  void check_fit(const YamlNode& node, const AxisModel& axis, const AxisNeed& need) const;
  void claim_axis(const YamlNode& node, const AxisRef& axis, const AxisNeed& need);

  std::vector<Claim> claims_;
};

namespace keys {

inline FormKey device_name() {
  return required(words("name", FormKind::name, "What programs call it."));
}
inline FormKey on_body() {
  return required(words("body", FormKind::name, "The body it is fixed to."));
}
inline FormKey at() {
  return vector("at", "Where, metres, body's frame (default: its origin).", kFar);
}

}  // namespace keys

}  // namespace stig::robots
