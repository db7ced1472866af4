// SPDX-License-Identifier: MIT
#include "urdf/sdf_frames.h"

#include <fmt/format.h>

#include "base/text.h"
#include "urdf/gazebo.h"

namespace stig::urdf {

namespace {

constexpr std::string_view kModel = "__model__";

std::string attribute_or(const XmlNode* node, std::string_view key, const std::string& otherwise) {
  const XmlAttribute* found = node == nullptr ? nullptr : node->attribute(key);
  return found == nullptr || found->value.empty() ? otherwise : found->value;
}

}  // namespace

SdfFrames::SdfFrames(const XmlNode& model, const Reading& reading) : reading_(reading) {
  for (const XmlNode* link : model.all("link")) {
    add(*link, "", "", true);
    if (canonical_.empty()) canonical_ = attribute_or(link, "name", "");
  }
  canonical_ = attribute_or(&model, "canonical_link", canonical_);
  for (const XmlNode* joint : model.all("joint")) {
    const std::string child = child_text(*joint, "child");
    add(*joint, child, child, false);
  }
  for (const XmlNode* frame : model.all("frame")) {
    const std::string attached = attribute_or(frame, "attached_to", "");
    add(*frame, attached, attached, false);
  }
}

void SdfFrames::add(const XmlNode& node, const std::string& usual, const std::string& attached,
                    bool link) {
  const std::string name = reading_.name(node);
  if (name.empty()) return;
  const Frame frame{&node, pose_of(node, reading_),
                    attribute_or(node.child("pose"), "relative_to", usual), attached, link};
  if (frames_.emplace(name, frame).second) return;
  reading_.wrong(node.place, fmt::format("the name {} comes twice", in_quotes(name)));
}

void SdfFrames::say(const std::string& name, const std::string& message) const {
  const auto found = frames_.find(name);
  if (found == frames_.end() || !said_.insert(name).second) return;
  reading_.wrong(found->second.node->place,
                 fmt::format("the pose of {} is relative to {}", in_quotes(name), message));
}

Pose SdfFrames::pose(const std::string& name) const {
  Pose out;
  std::string at = name;
  // A joint to the world is refused elsewhere.
  for (std::size_t steps = 0; !at.empty() && at != kModel && at != "world"; ++steps) {
    const auto found = frames_.find(at);
    // A chain longer than there are frames goes in a circle.
    if (found == frames_.end() || steps > frames_.size()) {
      say(name, found == frames_.end() ? in_quotes(at) + ", which is not there" : "itself");
      return {};
    }
    out = found->second.X_TF * out;
    out.q = normalised(out.q);
    at = found->second.relative_to;
  }
  return out;
}

Pose SdfFrames::pose_within(const XmlNode& node, const std::string& link) const {
  const std::string to = attribute_or(node.child("pose"), "relative_to", link);
  if (to != kModel && frames_.count(to) == 0) {
    reading_.wrong(node.child("pose") == nullptr ? node.place : node.child("pose")->place,
                   fmt::format("there is no frame {}", in_quotes(to)));
    return {};
  }
  return pose(to) * pose_of(node, reading_);
}

std::optional<std::string> SdfFrames::link_of(const std::string& name) const {
  std::string at = name;
  for (std::size_t steps = 0; steps <= frames_.size(); ++steps) {
    if (at.empty() || at == kModel) at = canonical_;
    const auto found = frames_.find(at);
    if (found == frames_.end()) return std::nullopt;
    if (found->second.link) return at;
    at = found->second.attached_to;
  }
  return std::nullopt;
}

}  // namespace stig::urdf
