// SPDX-License-Identifier: MIT
// Sensors and devices of a robot file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "robots/robot_parts.h"
#include "sensing/camera_view.h"

namespace stig {

namespace {

/// What a device asks of the axis that it uses.
struct AxisNeed {
  std::string_view what;  ///< the device
  bool angular = true;
  bool any = false;  ///< of movement and motor; otherwise a velocity motor
};

class DeviceReader {
 public:
  DeviceReader(const FormView& root, const RobotParts& parts)
      : root_(root), parts_(parts), model_(parts.model) {}

  void read() {
    if (root_.has("differential_drive")) read_drive(root_.form("differential_drive"));
    if (root_.has("lift")) read_lift(root_.form("lift"));
    if (root_.has("electromagnets")) read_electromagnets(root_.form("electromagnets"));
    read_list("cameras", model_.cameras, [this](const FormView& v) { return read_camera(v); });
    read_list("rangefinders", model_.rangefinders,
              [this](const FormView& v) { return read_rangefinder(v); });
    read_list("radios", model_.radios, [this](const FormView& v) {
      const std::size_t on = body(v);
      return RadioDevice{v.text("name"), on, place(v, on), v.number("range")};
    });
    read_list("leds", model_.leds, [this](const FormView& v) {
      const std::size_t on = body(v);
      return LedDevice{v.text("name"), on, place(v, on)};
    });
    read_list("actuators", model_.actuators, [this](const FormView& v) {
      const auto axis = static_cast<std::size_t>(v.number("axis", 1)) - 1;
      return ActuatorDevice{v.text("name"),
                            take_axis(v.find("joint"), axis, {"an actuator", true, true})};
    });
  }

 private:
  template <class Device, class Read>
  void read_list(std::string_view key, std::vector<Device>& out, Read read) {
    std::vector<std::pair<std::string, SourceRange>> seen;
    for (const FormView& view : entries(root_, key, parts_.bad)) {
      parts_.claim_name(view, key, seen);
      out.push_back(read(view));
    }
  }

  std::size_t body(const FormView& view) { return parts_.body(view, "body").value_or(kNoBody); }
  /// The place that `at` gives, in the frame of the body's middle.
  Vec3 place(const FormView& view, std::size_t body) {
    return view.vector("at") + (body == kNoBody ? Vec3{} : model_.bodies[body].p_BO);
  }

  AxisRef take_axis(const YamlNode* node, std::size_t axis, const AxisNeed& need) {
    if (node == nullptr) return {};
    const auto joint = parts_.joint(*node);
    if (!joint) return {};
    const std::vector<AxisModel>& axes = model_.joints[*joint].axes;
    if (axis >= axes.size()) {
      parts_.out
          .add(Code::P610, parts_.range(*node),
               axes.empty()
                   ? fmt::format("the joint {} is fixed: it has no axis", in_quotes(node->text))
                   : fmt::format("the joint {} has {} axes, not {}", in_quotes(node->text),
                                 axes.size(), axis + 1))
          .note(model_.joints[*joint].place, "the joint is here");
      return {};
    }
    check_fit(*node, axes[axis], need);
    claim_axis(*node, {*joint, axis}, need);
    return {*joint, axis};
  }

  void check_fit(const YamlNode& node, const AxisModel& axis, const AxisNeed& need) {
    const bool good = need.any
                          ? axis.actuator != ActuatorMode::none
                          : axis.actuator == ActuatorMode::velocity && axis.angular == need.angular;
    if (good) return;
    parts_.out.add(Code::P612, parts_.range(node),
                   need.any ? fmt::format("{} needs an axis with a motor", need.what)
                            : fmt::format("{} needs an axis that {} with 'actuator: velocity'",
                                          need.what, need.angular ? "turns" : "slides"));
  }

  void claim_axis(const YamlNode& node, const AxisRef& axis, const AxisNeed& need) {
    for (const Claim& claim : claims_) {
      if (claim.axis.joint != axis.joint || claim.axis.axis != axis.axis) continue;
      parts_.out
          .add(Code::P609, parts_.range(node),
               fmt::format("the axis of {} is used twice", in_quotes(node.text)))
          .note(claim.place, fmt::format("{} uses it here", claim.what));
      return;
    }
    claims_.push_back({axis, need.what, parts_.range(node)});
  }

  std::vector<AxisRef> wheels(const FormView& view, std::string_view key) {
    std::vector<AxisRef> out;
    const YamlNode* list = view.find(key);
    if (list == nullptr) return out;
    for (const YamlNode& name : list->items) {
      out.push_back(take_axis(&name, 0, {"a wheel", true, false}));
    }
    if (!list->items.empty()) return out;
    parts_.out.add(Code::R107, parts_.document.head(*list),
                   fmt::format("'{}' names no wheel, it takes at least 1", key));
    return out;
  }

  void read_drive(const FormView& view) {
    DriveModel drive;
    drive.left = wheels(view, "left");
    drive.right = wheels(view, "right");
    drive.wheel_radius = view.number("wheel_radius");
    drive.track = view.number("track");
    drive.most_speed = view.number("most_speed");
    drive.most_acceleration = view.number("most_acceleration", 1);
    model_.drive = std::move(drive);
  }

  void read_lift(const FormView& view) {
    LiftModel lift;
    lift.axis = take_axis(view.find("joint"), 0, {"a lift", false, false});
    const std::vector<double> switches = view.numbers("switches");
    if (switches.size() == 2) {
      lift.low = switches[0];
      lift.high = switches[1];
      if (lift.low >= lift.high) {
        parts_.out.add(Code::P616, parts_.range(*view.find("switches")),
                       "the bottom switch is not below the top one");
      }
    }
    read_lift_speeds(view, lift);
    lift.tolerance = lift.speeds.empty() ? 0 : lift.speeds.back().first;
    lift.inactive_below = view.number("inactive_below", lift.tolerance);
    model_.lift = std::move(lift);
  }

  void read_lift_speeds(const FormView& view, LiftModel& lift) {
    for (const FormView& speed : view.forms("speeds")) {
      const double above = speed.number("above");
      if (!lift.speeds.empty() && above >= lift.speeds.back().first) {
        parts_.out.add(Code::P616, parts_.document.head(speed.node()),
                       "the speeds of a lift are listed by falling errors");
      }
      lift.speeds.emplace_back(above, speed.number("speed"));
    }
  }

  void read_electromagnets(const FormView& view) {
    MagnetCircuitModel magnets;
    for (const FormView& pole : entries(view, "poles", parts_.bad)) {
      // Unlike other devices' places, the middle: that is where a coil's dipole is.
      const std::size_t on = body(pole);
      magnets.poles.push_back({on, pole.has("at") ? place(pole, on) : Vec3{},
                               parts_.direction(pole, "direction", {0, 0, 1})});
    }
    magnets.passive = view.number("passive");
    magnets.active = view.number("active");
    magnets.charge_limit = view.number("charge_limit");
    magnets.charge_per_second = view.number("charge_per_second");
    magnets.discharge_per_second = view.number("discharge_per_second");
    magnets.relax_rate = view.number("relax_rate");
    magnets.sink_rate = view.number("sink_rate");
    magnets.sink_level = view.number("sink_level");
    model_.magnets = std::move(magnets);
  }

  /// Optical frame: z along `look`, y as much against `up` as can be.
  Quat looking(const FormView& view) {
    const Vec3 z = parts_.direction(view, "look", {1, 0, 0});
    const Vec3 up = parts_.direction(view, "up", {0, 0, 1});
    Vec3 x = cross(z, up);
    if (length(x) < 1e-6) {
      x = perpendicular(z);
      if (view.has("look") && !view.has("up")) {
        parts_.out.add(Code::P611, parts_.range(*view.find("look")),
                       "a camera that looks straight up or down needs 'up'");
      } else if (view.has("up")) {
        parts_.out.add(Code::P611, parts_.range(*view.find("up")),
                       "what is up for a camera cannot be where it looks");
      }
    }
    x = normalised(x);
    return quaternion_of({x, cross(z, x), z});
  }

  CameraDevice read_camera(const FormView& view) {
    CameraDevice camera;
    camera.name = view.text("name");
    camera.body = body(view);
    camera.X_BC = {place(view, camera.body), looking(view)};
    camera.near = view.number("near");
    camera.far = view.number("far", 1);
    if (view.has("near") && view.has("far") && camera.near >= camera.far) {
      parts_.out.add(Code::P611, parts_.range(*view.find("near")),
                     "the camera sees nothing: 'near' is not below 'far'");
    }
    read_intrinsics(view, camera.intrinsics);
    check_view(view, camera);
    return camera;
  }

  /// The robot's crew makes the same view of it.
  void check_view(const FormView& view, const CameraDevice& camera) {
    for (const auto* key : {"near", "far", "resolution", "focal_length", "principal_point"}) {
      if (!view.has(key)) return;
    }
    const YamlNode* distortion = view.find("distortion");
    if (camera.near >= camera.far || (distortion == nullptr) != !view.node().find("distortion")) {
      return;  // said already
    }
    if (make_view(camera.intrinsics, camera.near, camera.far)) return;
    if (distortion != nullptr) {
      parts_.out.add(Code::P611, parts_.range(*distortion),
                     "the distortion has no inverse at the image's borders: no direction is seen "
                     "there");
    } else {
      parts_.out.add(Code::P611, parts_.range(*view.find("focal_length")),
                     "the focal length is too short: the image's borders would look at right "
                     "angles to the camera's axis");
    }
  }

  void read_intrinsics(const FormView& view, CameraIntrinsics& camera) {
    const auto pair = [&](std::string_view key) {
      auto v = view.numbers(key);
      v.resize(2, 1);
      return v;
    };
    camera.width = static_cast<int>(pair("resolution")[0]);
    camera.height = static_cast<int>(pair("resolution")[1]);
    camera.fx = pair("focal_length")[0];
    camera.fy = pair("focal_length")[1];
    camera.cx = pair("principal_point")[0];
    camera.cy = pair("principal_point")[1];
    std::vector<double> d = view.numbers("distortion");
    if (!d.empty() && d.size() != 4 && d.size() != 5 && d.size() != 8 && d.size() != 12) {
      parts_.out.add(Code::R107, parts_.document.head(*view.find("distortion")),
                     fmt::format("'distortion' has {} entries, it takes 4, 5, 8 or 12", d.size()));
    }
    d.resize(12);
    double* const to[] = {&camera.k1,
                          &camera.k2,
                          &camera.p1,
                          &camera.p2,
                          &camera.k3,
                          &camera.k4,
                          &camera.k5,
                          &camera.k6,
                          &camera.thin_prism[0],
                          &camera.thin_prism[1],
                          &camera.thin_prism[2],
                          &camera.thin_prism[3]};
    for (std::size_t i = 0; i < d.size(); ++i) *to[i] = d[i];
  }

  RangeDevice read_rangefinder(const FormView& view) {
    using Calibration = RangeDevice::Calibration;
    RangeDevice device;
    device.name = view.text("name");
    device.body = body(view);
    device.p_B = place(view, device.body);
    device.direction = parts_.direction(view, "look", {1, 0, 0});
    device.range = view.number("range");
    const std::string calibration = view.text("calibration", "metres");
    device.calibration = calibration == "power"       ? Calibration::power
                         : calibration == "quadratic" ? Calibration::quadratic
                                                      : Calibration::metres;
    const std::vector<double> c = view.numbers("coefficients");
    std::copy(c.begin(), c.end(), device.coefficients.begin());
    check_coefficients(view, device.calibration, c.size());
    return device;
  }

  void check_coefficients(const FormView& view, RangeDevice::Calibration calibration,
                          std::size_t count) {
    using Calibration = RangeDevice::Calibration;
    const std::size_t wanted = calibration == Calibration::metres  ? 0
                               : calibration == Calibration::power ? 2
                                                                   : 3;
    const YamlNode* node = view.node().find("coefficients");
    if (count == wanted || (node != nullptr && !view.has("coefficients"))) return;
    parts_.out.add(node == nullptr ? Code::R102 : Code::R107,
                   parts_.document.head(node == nullptr ? view.node() : *node),
                   fmt::format("this calibration takes {} coefficients", wanted));
  }

  struct Claim {
    AxisRef axis;
    std::string_view what;
    SourceRange place;
  };

  const FormView& root_;
  const RobotParts& parts_;
  RobotModel& model_;
  std::vector<Claim> claims_;
};

}  // namespace

void read_devices(const FormView& root, const RobotParts& parts) {
  DeviceReader(root, parts).read();
}

}  // namespace stig
