// SPDX-License-Identifier: MIT
// A camera's keys are those of OpenCV's model, so that a calibration can be copied from its output.
// What is wrong with a camera is said here, where the file's lines are known: the view that a run
// makes of it (sensing/camera_view.h) then cannot fail.
#include "robots/device_camera.h"

#include <fmt/format.h>

#include "robots/device_parts.h"
#include "robots/robot_description.h"
#include "sensing/camera_view.h"

namespace stig::robots {

namespace {

using namespace keys;

FormKey resolution() {
  FormKey key = numbers("resolution", "Pixels, width and height.", 2, 2, 1, 16384);
  key.kind = FormKind::integers;
  return key;
}

/// Optical frame: z along `look`, y as much against `up` as can be.
Quat looking(const FormView& view, const DeviceParts& parts) {
  // Images have y downwards, so x of the frame points to the right of the picture.
  const Vec3 z = parts.direction(view, "look", {1, 0, 0});
  const Vec3 up = parts.direction(view, "up", {0, 0, 1});
  Vec3 x = cross(z, up);
  if (length(x) < 1e-6) {
    x = perpendicular(z);
    if (view.has("look") && !view.has("up")) {
      parts.out.add(Code::P611, parts.range(*view.find("look")),
                    "a camera that looks straight up or down needs 'up'");
    } else if (view.has("up")) {
      parts.out.add(Code::P611, parts.range(*view.find("up")),
                    "what is up for a camera cannot be where it looks");
    }
  }
  x = normalised(x);
  return quaternion_of({x, cross(z, x), z});
}

void read_distortion(const FormView& view, const DeviceParts& parts, CameraIntrinsics& camera) {
  std::vector<double> d = view.numbers("distortion");
  if (!d.empty() && d.size() != 4 && d.size() != 5 && d.size() != 8 && d.size() != 12) {
    parts.out.add(Code::R107, parts.document.head(*view.find("distortion")),
                  fmt::format("'distortion' has {} entries, it takes 4, 5, 8 or 12", d.size()));
  }
  // OpenCV has four lengths of this list; what is left out is zero.
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

void read_intrinsics(const FormView& view, const DeviceParts& parts, CameraIntrinsics& camera) {
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
  read_distortion(view, parts, camera);
}

/// The robot's crew makes the same view of it.
void check_view(const FormView& view, const DeviceParts& parts, const CameraDevice& camera) {
  for (const auto* key : {"near", "far", "resolution", "focal_length", "principal_point"}) {
    if (!view.has(key)) return;
  }
  const YamlNode* distortion = view.find("distortion");
  if (camera.near >= camera.far || (distortion == nullptr) != !view.node().find("distortion")) {
    return;  // said already
  }
  if (make_view(camera.intrinsics, camera.near, camera.far)) return;
  if (distortion != nullptr) {
    parts.out.add(Code::P611, parts.range(*distortion),
                  "the distortion has no inverse at the image's borders: no direction is seen "
                  "there");
  } else {
    parts.out.add(Code::P611, parts.range(*view.find("focal_length")),
                  "the focal length is too short: the image's borders would look at right "
                  "angles to the camera's axis");
  }
}

}  // namespace

const Form& CameraKind::form() {
  static const Form kForm{
      noun,
      {device_name(), on_body(), at(),
       required(vector("look", "The direction it looks in, body's frame.", kFar)),
       vector("up", "What is up in its image (default: z).", kFar), required(resolution()),
       required(numbers("focal_length", "Pixels, of x and y.", 2, 2, 1e-3, 1e6)),
       required(numbers("principal_point", "Pixels, from the upper left.", 2, 2, -1e6, 1e6)),
       numbers("distortion", "As OpenCV has it: k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 s2 s3 s4]]].", 4, 12,
               -1e6, 1e6),
       required(above_zero("near", "Nothing nearer is seen, metres.", 1000)),
       required(above_zero("far", "Nothing farther is seen, metres.", 1000))}};
  return kForm;
}

CameraDevice CameraKind::read(const FormView& view, DeviceParts& parts) {
  CameraDevice camera;
  camera.name = view.text("name");
  camera.body = parts.on_body(view);
  camera.X_BC = {parts.place(view, camera.body), looking(view, parts)};
  camera.near = view.number("near");
  camera.far = view.number("far", 1);
  if (view.has("near") && view.has("far") && camera.near >= camera.far) {
    parts.out.add(Code::P611, parts.range(*view.find("near")),
                  "the camera sees nothing: 'near' is not below 'far'");
  }
  read_intrinsics(view, parts, camera.intrinsics);
  check_view(view, parts, camera);
  return camera;
}

std::string CameraKind::description(const RobotModel& robot) {
  if (robot.cameras.empty()) return {};
  const CameraDevice& camera = robot.cameras.front();
  return fmt::format("   camera = {{ anchor = {{ {} }}, focal = {:.6g} }},\n",
                     described_place(robot.bodies[camera.body].X_RB.p), camera.intrinsics.fx);
}

}  // namespace stig::robots
