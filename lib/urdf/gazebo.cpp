// SPDX-License-Identifier: MIT
#include "urdf/gazebo.h"

#include <fmt/format.h>

#include <cmath>

#include "base/degree.h"
#include "base/text.h"

namespace stig::urdf {

namespace {

void read_distortion(const XmlNode& camera, Camera& out, const Reading& reading) {
  const XmlNode* node = camera.child("distortion");
  if (node == nullptr) return;
  const auto k = [&](const char* name) { return reading.child_number(*node, name, 0); };
  // OpenCV's order.
  out.distortion = {k("k1"), k("k2"), k("p1"), k("p2"), k("k3")};
}

void read_intrinsics(const XmlNode& camera, Camera& out, const Reading& reading) {
  const XmlNode* lens = camera.child("lens");
  const XmlNode* node = lens == nullptr ? nullptr : lens->child("intrinsics");
  if (lens != nullptr && node == nullptr) {
    reading.left_out(lens->place, "of <lens> only <intrinsics> goes over");
  }
  if (node == nullptr) return;
  for (const char* name : {"fx", "fy", "cx", "cy"}) {
    out.intrinsics.push_back(reading.child_number(*node, name));
  }
}

void read_camera(const XmlNode& sensor, Camera out, Description& robot, const Reading& reading) {
  const XmlNode* camera = sensor.child("camera");
  if (camera == nullptr) {
    reading.wrong(sensor.place, "a camera without <camera>");
    return;
  }
  out.angle = reading.child_number(*camera, "horizontal_fov", 1.047);
  if (!(out.angle > 0 && out.angle < 3.1)) {
    reading.no_counterpart(camera->place, "cameras see less than 177° from side to side");
    return;
  }
  if (const XmlNode* image = camera->child("image")) {
    out.width = reading.child_number(*image, "width", 320);
    out.height = reading.child_number(*image, "height", 240);
  }
  if (const XmlNode* clip = camera->child("clip")) {
    out.near = reading.child_number(*clip, "near", 0.1);
    out.far = reading.child_number(*clip, "far", 100);
  }
  if (const XmlNode* noise = camera->child("noise")) {
    reading.left_out(noise->place, "<noise> is left out: it is of scenes, in their key 'noise'");
  }
  read_distortion(*camera, out, reading);
  read_intrinsics(*camera, out, reading);
  robot.cameras.push_back(std::move(out));
}

/// 1 where the element says nothing.
double samples(const XmlNode* scan, const char* name, const Reading& reading) {
  const XmlNode* way = scan == nullptr ? nullptr : scan->child(name);
  return way == nullptr ? 1 : reading.child_number(*way, "samples", 1);
}

void read_ray(const XmlNode& sensor, SingleRay out, Description& robot, const Reading& reading) {
  const XmlNode* ray = sensor.child("ray");
  if (ray == nullptr) ray = sensor.child("lidar");
  const XmlNode* range = ray == nullptr ? nullptr : ray->child("range");
  if (range == nullptr) {
    reading.wrong(sensor.place, "a sensor of rays without <range>");
    return;
  }
  const XmlNode* scan = ray->child("scan");
  if (samples(scan, "horizontal", reading) > 1 || samples(scan, "vertical", reading) > 1) {
    reading.left_out(
        sensor.place,
        fmt::format("the scanner {} is left out: rangefinders have one ray", in_quotes(out.name)));
    return;
  }
  out.range = reading.child_number(*range, "max");
  robot.rays.push_back(std::move(out));
}

std::optional<double> optional_number(const XmlNode& node, std::initializer_list<const char*> names,
                                      double factor, const Reading& reading) {
  for (const char* name : names) {
    if (node.child(name) == nullptr) continue;
    const double value = reading.child_number(node, name) * factor;
    if (value > 0) return value;
  }
  return std::nullopt;
}

std::vector<std::string> texts(const XmlNode& node, std::initializer_list<const char*> names) {
  std::vector<std::string> out;
  for (const char* name : names) {
    for (const XmlNode* one : node.all(name)) out.push_back(one->text);
  }
  return out;
}

}  // namespace

Pose pose_of(const XmlNode& node, const Reading& reading) {
  const XmlNode* pose = node.child("pose");
  if (pose == nullptr || pose->text.empty()) return {};
  const XmlAttribute* format = pose->attribute("rotation_format");
  const bool quaternion = format != nullptr && format->value == "quat_xyzw";
  const auto v = reading.numbers(pose->text, pose->text_place, quaternion ? 7 : 6);
  if (!v) return {};
  const Vec3 p{(*v)[0], (*v)[1], (*v)[2]};
  if (quaternion) {
    const Quat q{(*v)[6], (*v)[3], (*v)[4], (*v)[5]};
    const double size = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (size > 1e-12) return {p, normalised(q)};
    reading.wrong(pose->text_place, "the quaternion has no length");
    return {};
  }
  const XmlAttribute* degrees = pose->attribute("degrees");
  const bool in_degrees = degrees != nullptr && (degrees->value == "true" || degrees->value == "1");
  return {p, from_rpy(Vec3{(*v)[3], (*v)[4], (*v)[5]} * (in_degrees ? kDegree : 1))};
}

void read_sensor(const XmlNode& sensor, std::size_t link, const Pose& X_LS, Description& robot,
                 const Reading& reading) {
  const std::string type = reading.needed(sensor, "type");
  const std::string name = reading.name(sensor);
  if (type == "camera" || type == "wideanglecamera") {
    read_camera(sensor, {.name = name, .link = link, .X_LC = X_LS}, robot, reading);
  } else if (type == "ray" || type == "gpu_ray" || type == "lidar" || type == "gpu_lidar") {
    read_ray(sensor, {.name = name, .link = link, .X_LR = X_LS}, robot, reading);
  } else if (!type.empty()) {
    reading.left_out(sensor.place, fmt::format("the sensor {} of the kind {} is left out",
                                               in_quotes(name), in_quotes(type)));
  }
}

void read_plugin(const XmlNode& plugin, Description& robot, const Reading& reading) {
  const XmlAttribute* file = plugin.attribute("filename");
  const XmlAttribute* name = plugin.attribute("name");
  const std::string words =
      (file == nullptr ? "" : file->value) + " " + (name == nullptr ? "" : name->value);
  Drive drive;
  drive.left = texts(plugin, {"left_joint", "leftJoint"});
  drive.right = texts(plugin, {"right_joint", "rightJoint"});
  if (drive.left.empty() || drive.right.empty()) {
    reading.left_out(plugin.place, fmt::format("the plugin {} is left out",
                                               in_quotes(file == nullptr ? words : file->value)));
    return;
  }
  if (robot.drive) {
    reading.no_counterpart(plugin.place, "a second differential drive");
    return;
  }
  drive.place = plugin.place;
  drive.radius = optional_number(plugin, {"wheel_radius"}, 1, reading);
  if (!drive.radius) {
    drive.radius = optional_number(plugin, {"wheel_diameter", "wheelDiameter"}, 0.5, reading);
  }
  drive.track = optional_number(plugin, {"wheel_separation", "wheelSeparation"}, 1, reading);
  drive.speed = optional_number(plugin, {"max_linear_velocity"}, 1, reading);
  drive.acceleration = optional_number(plugin, {"max_linear_acceleration"}, 1, reading);
  drive.torque = optional_number(plugin, {"max_wheel_torque", "wheelTorque"}, 1, reading);
  robot.drive = std::move(drive);
}

}  // namespace stig::urdf
