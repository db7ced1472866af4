// SPDX-License-Identifier: MIT
// What the readers of a robot file's parts share. Private to this folder.
//
// Bodies and joints have their places in the model's lists whether they are sound or not, so
// that a name which is there is never reported as unknown.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/form.h"
#include "robots/robot_model.h"
#include "robots/uses.h"

namespace stig::robots {

struct RobotParts {
  const YamlDocument& document;
  const BadNodes& bad;
  Diagnostics& out;
  RobotModel& model;
  const FileLoader& load;

  SourceRange range(const YamlNode& node) const { return document.range(node); }
  /// Adds the name when it is new in `seen`; otherwise says where it stood first.
  void claim_name(const FormView& view, std::string_view what,
                  std::vector<std::pair<std::string, SourceRange>>& seen) const;
  /// The body or joint that a key names; nothing when the key is bad, with an error when there
  /// is no such body or joint.
  std::optional<std::size_t> body(const FormView& view, std::string_view key) const;
  std::optional<std::size_t> joint(const YamlNode& node) const;
  /// A unit vector; when the one written has no length, an error and z.
  Vec3 direction(const FormView& view, std::string_view key, const Vec3& otherwise) const;
};

/// Every mapping of a list, also those in which something is wrong.
std::vector<FormView> entries(const FormView& view, std::string_view key, const BadNodes& bad);

/// Bodies and joints; devices, which name them; and whether the joints make a tree. Pieces of
/// bodies come after all bodies of the file, the joints that fix them before its joints.
void read_bodies(const FormView& root, const RobotParts& parts);
void read_joints(const FormView& root, const RobotParts& parts);
void read_devices(const FormView& root, const RobotParts& parts);
void check_tree(const RobotParts& parts);

}  // namespace stig::robots
