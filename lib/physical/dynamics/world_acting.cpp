// SPDX-License-Identifier: MIT
// What acts on bodies, for those who look on. Contacts' impulses are of a whole step, so
// that divided by its length they are the mean force.
#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

ContactForce acting(const Contact& contact, double step) {
  ContactForce out{BodyId{contact.a}, BodyId{contact.b}, {}, {}};
  double pushed = 0;
  Vec3 weighed;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contact.count); ++i) {
    const ContactPoint& point = contact.points[i];
    pushed += point.push;
    weighed += point.p_W * point.push;
    out.force += (contact.normal * point.push + point.friction) * (1 / step);
  }
  // Nothing pushes without a normal impulse: friction is at most a part of it.
  if (pushed > 0) out.p_W = weighed * (1 / pushed);
  return out;
}

}  // namespace

std::vector<ContactForce> World::contact_forces() const {
  std::vector<ContactForce> out;
  for (const Contact& contact : state_->contacts) {
    const ContactForce one = acting(contact, state_->config.step);
    if (!(one.force == Vec3{})) out.push_back(one);
  }
  return out;
}

std::vector<Vec3> World::magnet_forces() const { return physics::magnet_forces(*state_); }

}  // namespace stig::physics
