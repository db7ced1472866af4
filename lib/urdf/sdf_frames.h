// SPDX-License-Identifier: MIT
// Poses of an SDF model, each of which may be given relative to another (sdformat.org, "Pose frame
// semantics").
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "urdf/readers.h"
#include "urdf/uses.h"

namespace stig::urdf {

class SdfFrames {
 public:
  /// Links, joints and frames of the model, by their names.
  SdfFrames(const XmlNode& model, const Reading& reading);

  /// In the model's frame; the identity with an error where names lead nowhere or in a circle.
  Pose pose(const std::string& name) const;
  /// Of an element within a link, or of any with `relative_to`: in the model's frame.
  Pose pose_within(const XmlNode& node, const std::string& link) const;
  /// The link that a name means: itself, or the one that a frame is attached to.
  std::optional<std::string> link_of(const std::string& name) const;

 private:
  struct Frame {
    const XmlNode* node = nullptr;
    Pose X_TF;                ///< in that which it is relative to
    std::string relative_to;  ///< empty: the model
    std::string attached_to;  ///< of a frame or a joint; empty: the model
    bool link = false;
  };
  /// What is wrong with a name is said once.
  void say(const std::string& name, const std::string& message) const;
  void add(const XmlNode& node, const std::string& usual, const std::string& attached, bool link);

  std::map<std::string, Frame> frames_;
  std::string canonical_;  ///< the link that stands for the model
  mutable std::set<std::string> said_;
  const Reading& reading_;
};

}  // namespace stig::urdf
