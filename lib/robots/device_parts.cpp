// SPDX-License-Identifier: MIT
#include "robots/device_parts.h"

#include <fmt/format.h>

#include <cassert>

#include "base/text.h"

namespace stig::robots {

std::size_t DeviceParts::on_body(const FormView& view) const {
  return body(view, "body").value_or(kNoBody);
}

Vec3 DeviceParts::place(const FormView& view, std::size_t body) const {
  assert(body == kNoBody || body < model.bodies.size());
  return view.vector("at") + (body == kNoBody ? Vec3{} : model.bodies[body].p_BO);
}

AxisRef DeviceParts::take_axis(const YamlNode* node, std::size_t axis, const AxisNeed& need) {
  if (node == nullptr) return {};
  const auto found = joint(*node);
  if (!found) return {};
  const std::vector<AxisModel>& axes = model.joints[*found].axes;
  if (axis >= axes.size()) {
    out.add(Code::P610, range(*node),
            axes.empty()
                ? fmt::format("the joint {} is fixed: it has no axis", in_quotes(node->text))
                : fmt::format("the joint {} has {} axes, not {}", in_quotes(node->text),
                              axes.size(), axis + 1))
        .note(model.joints[*found].place, "the joint is here");
    return {};
  }
  check_fit(*node, axes[axis], need);
  claim_axis(*node, {*found, axis}, need);
  return {*found, axis};
}

void DeviceParts::check_fit(const YamlNode& node, const AxisModel& axis,
                            const AxisNeed& need) const {
  const bool good = need.any
                        ? axis.actuator != ActuatorMode::none
                        : axis.actuator == ActuatorMode::velocity && axis.angular == need.angular;
  if (good) return;
  out.add(Code::P612, range(node),
          need.any ? fmt::format("{} needs an axis with a motor", need.what)
                   : fmt::format("{} needs an axis that {} with 'actuator: velocity'", need.what,
                                 need.angular ? "turns" : "slides"));
}

void DeviceParts::claim_axis(const YamlNode& node, const AxisRef& axis, const AxisNeed& need) {
  for (const Claim& claim : claims_) {
    if (claim.axis.joint != axis.joint || claim.axis.axis != axis.axis) continue;
    out.add(Code::P609, range(node),
            fmt::format("the axis of {} is used twice", in_quotes(node.text)))
        .note(claim.place, fmt::format("{} uses it here", claim.what));
    return;
  }
  claims_.push_back({axis, need.what, range(node)});
}

}  // namespace stig::robots
