// SPDX-License-Identifier: MIT
#include "urdf/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "urdf/moments.h"

namespace stig::urdf {

namespace {

template <class Named>
std::optional<std::size_t> place_in(const std::vector<Named>& all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  if (found == all.end()) return std::nullopt;
  return static_cast<std::size_t>(found - all.begin());
}

/// The joint that carries each link, or none.
std::vector<const Joint*> joints_above(const Description& robot) {
  std::vector<const Joint*> out(robot.links.size());
  for (const Joint& joint : robot.joints) out[joint.child] = &joint;
  return out;
}

class FrameFolder {
 public:
  FrameFolder(Description& robot, const Reading& reading)
      : robot_(robot),
        reading_(reading),
        order_(tree_order(robot, reading)),
        above_(joints_above(robot)),
        carrier_(robot.links.size()),
        gone_(robot.links.size()) {}

  bool fold() {
    if (order_.empty()) {
      if (robot_.links.empty()) reading_.wrong(robot_.place, "it has no links");
      return false;
    }
    find_carriers();
    if (!carrier_[order_[0]]) {
      reading_.wrong(robot_.place, "no link of it has a mass");
      return false;
    }
    std::vector<Joint> kept;
    for (const std::size_t link : order_) {
      if (above_[link] != nullptr && !keep(*above_[link], kept)) return false;
    }
    for (const Joint* joint : idle_) {
      reading_.left_out(joint->place, fmt::format("the joint {} moves nothing that has a mass",
                                                  in_quotes(joint->name)));
    }
    move_devices();
    renumber(std::move(kept));
    return true;
  }

 private:
  bool massive(std::size_t link) const { return robot_.links[link].massive; }

  void find_carriers() {
    // Of frames at the root: the first link with mass that is fixed to them.
    std::vector<bool> at_root(robot_.links.size());
    std::optional<std::size_t> heir;
    for (const std::size_t link : order_) {
      const Joint* joint = above_[link];
      const bool below_root = joint == nullptr || (joint->axes.empty() && at_root[joint->parent] &&
                                                   !massive(joint->parent));
      at_root[link] = below_root;
      if (below_root && massive(link) && !heir) heir = link;
    }
    for (const std::size_t link : order_) {
      if (massive(link)) {
        carrier_[link] = link;
      } else if (at_root[link]) {
        carrier_[link] = heir;
      } else if (above_[link]->axes.empty()) {
        carrier_[link] = carrier_[above_[link]->parent];
      }
    }
  }

  /// A joint between what has mass stays, between the links that carry.
  bool keep(const Joint& joint, std::vector<Joint>& kept) {
    const std::size_t child = joint.child;
    if (gone_[joint.parent]) {
      if (massive(child)) {
        reading_.no_counterpart(
            robot_.links[joint.parent].place,
            fmt::format("the link {} has no mass, and a joint moves it: give it an <inertial>, or "
                        "one joint with both axes",
                        in_quotes(robot_.links[joint.parent].name)));
        return false;
      }
      gone_[child] = true;
      return true;
    }
    if (!massive(child)) {
      if (joint.axes.empty()) return true;
      gone_[child] = true;
      idle_.push_back(&joint);
      return true;
    }
    Joint out = joint;
    out.parent = carrier_[joint.parent].value_or(child);
    if (out.parent != child) kept.push_back(std::move(out));
    return true;
  }

  template <class Device>
  void move(std::vector<Device>& devices, Pose Device::*pose) {
    std::vector<Device> out;
    for (Device& one : devices) {
      if (gone_[one.link]) {
        reading_.left_out(robot_.links[one.link].place,
                          fmt::format("the sensor {} is on a link that has no mass and is moved",
                                      in_quotes(one.name)));
        continue;
      }
      const std::size_t to = carrier_[one.link].value_or(one.link);
      one.*pose = inverse(robot_.links[to].X_ML) * robot_.links[one.link].X_ML * (one.*pose);
      one.link = to;
      out.push_back(std::move(one));
    }
    devices = std::move(out);
  }
  void move_devices() {
    move(robot_.cameras, &Camera::X_LC);
    move(robot_.rays, &SingleRay::X_LR);
  }

  void renumber(std::vector<Joint> joints) {
    std::vector<std::size_t> number(robot_.links.size());
    std::vector<Link> links;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      number[i] = links.size();
      if (massive(i)) links.push_back(std::move(robot_.links[i]));
    }
    for (Joint& joint : joints) {
      joint.parent = number[joint.parent];
      joint.child = number[joint.child];
    }
    for (Camera& camera : robot_.cameras) camera.link = number[camera.link];
    for (SingleRay& ray : robot_.rays) ray.link = number[ray.link];
    robot_.links = std::move(links);
    robot_.joints = std::move(joints);
  }

  Description& robot_;
  const Reading& reading_;
  std::vector<std::size_t> order_;
  std::vector<const Joint*> above_;
  std::vector<std::optional<std::size_t>> carrier_;  ///< of each link, one with mass
  std::vector<const Joint*> idle_;                   ///< joints that move nothing
  std::vector<bool> gone_;  ///< frames that a joint moves, and what is on them
};

}  // namespace

std::optional<std::size_t> Description::link(std::string_view called) const {
  return place_in(links, called);
}
std::optional<std::size_t> Description::joint(std::string_view called) const {
  return place_in(joints, called);
}

void set_mass(Link& link, double mass, const Pose& X_LI, const std::vector<double>& six,
              const SourceRange& where, const Reading& reading) {
  link.massive = true;
  link.p_LC = X_LI.p;
  if (!(mass > 0)) {
    reading.wrong(where, fmt::format("the mass of {} is not above zero", in_quotes(link.name)));
    return;
  }
  // A share of it has to be a mass as well.
  constexpr double kLeastMass = 1e-9;  // kg
  if (mass < kLeastMass) {
    reading.wrong(where, fmt::format("the mass of {} is below 1e-9 kg", in_quotes(link.name)));
    return;
  }
  link.mass = mass;
  const Mat3 tensor{{six[0], six[1], six[2]}, {six[1], six[3], six[4]}, {six[2], six[4], six[5]}};
  const Principal principal = principal_moments(tensor);
  const Vec3& m = principal.moments;
  const double most = std::max({m.x, m.y, m.z}), least = std::min({m.x, m.y, m.z});
  // Flat bodies are at the limit, and files have few digits.
  if (!(least > 0) || 2 * most > (m.x + m.y + m.z) * (1 + kMomentSlack)) {
    reading.wrong(where, fmt::format("no body has the moments of {}: along its principal axes they "
                                     "are {}, and each has to be above zero and at most the sum of "
                                     "the others",
                                     in_quotes(link.name), figures(m)));
    return;
  }
  link.moments = turned_tensor(X_LI.q, tensor);
}

std::vector<std::size_t> tree_order(const Description& robot, const Reading& reading) {
  std::vector<const Joint*> above(robot.links.size());
  std::vector<std::vector<std::size_t>> below(robot.links.size());
  for (const Joint& joint : robot.joints) {
    if (above[joint.child] != nullptr) {
      reading
          .wrong(joint.place, fmt::format("the link {} has two parents",
                                          in_quotes(robot.links[joint.child].name)))
          .note(above[joint.child]->place, "its other joint is here");
      return {};
    }
    above[joint.child] = &joint;
    below[joint.parent].push_back(joint.child);
  }
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (above[i] != nullptr) continue;
    if (!order.empty()) {
      reading
          .wrong(robot.links[i].place,
                 fmt::format("no joint leads to the link {}", in_quotes(robot.links[i].name)))
          .note(robot.links[order[0]].place, "another root is here");
      return {};
    }
    order.push_back(i);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    order.insert(order.end(), below[order[i]].begin(), below[order[i]].end());
  }
  if (order.size() == robot.links.size()) return order;
  std::vector<bool> reached(robot.links.size());
  for (const std::size_t link : order) reached[link] = true;
  const auto first = std::find(reached.begin(), reached.end(), false) - reached.begin();
  const Joint& joint = *above[static_cast<std::size_t>(first)];
  reading.wrong(joint.place, fmt::format("the joints go in a circle: {} hangs on itself",
                                         in_quotes(robot.links[joint.child].name)));
  return {};
}

bool fold_frames(Description& description, const Reading& reading) {
  return FrameFolder(description, reading).fold();
}

}  // namespace stig::urdf
