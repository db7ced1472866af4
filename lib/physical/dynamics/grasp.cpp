// SPDX-License-Identifier: MIT
#include "physical/dynamics/grasp.h"

#include <algorithm>
#include <cmath>

#include "physical/solver/six.h"
#include "physical/solver/small_matrix.h"

namespace stig::physics {

namespace {

constexpr int kMostTurns = 24;
constexpr double kSameNormal = 0.99;  ///< cosine
constexpr double kInside = 0.9;       ///< of a cone's friction, that is aimed at, so that turns end
constexpr double kSlack = 2e-4;  ///< of all pushes together, that a point may pull or slip more

/// A point, and the force that it gives the body.
struct Bearer {
  Vec3 place, normal;  ///< body frame; it pushes along the normal
  double friction = 0;
  Vec3 force;  ///< N·s
};

/// Calls with each point that touches, its contact, and 1, or -1 where the contact is the body's as
/// the second.
template <class Contacts, class Each>
void each_point(Contacts& contacts, std::uint32_t body, const Each& each) {
  for (auto& contact : contacts) {
    const double side = contact.a == body ? 1 : -1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.count); ++i) {
      if (contact.points[i].gap <= kTouching) each(contact, contact.points[i], side);
    }
  }
}

void list_bearers(const Grasp& grasp, std::vector<Bearer>& out) {
  out.clear();
  each_point(grasp.contacts, grasp.body,
             [&](const Contact& contact, const ContactPoint& point, double side) {
               const Vec3 force = contact.normal * point.push + point.friction;
               out.push_back({point.p_W, contact.normal * side, contact.friction, force * side});
             });
}

Twist sum_of(const std::vector<Bearer>& bearers) {
  Twist sum;
  for (const Bearer& one : bearers) {
    sum.v += one.force;
    sum.w += cross(one.place, one.force);
  }
  return sum;
}

Twist unit(std::size_t k) {
  Six out{};
  out[k] = 1;
  return twist_of(out);
}

void change(std::vector<Bearer>& bearers, const Twist& yz) {
  for (Bearer& one : bearers) one.force += yz.v + cross(yz.w, one.place);
}

/// The wrench for each unit of y and z. It is the same by rows and by columns.
std::vector<double> matrix_of(std::vector<Bearer> bearers) {
  std::vector<double> out(36, 0);
  for (std::size_t k = 0; k < 6; ++k) {
    for (Bearer& one : bearers) one.force = {};
    change(bearers, unit(k));
    const Six column = six_of(sum_of(bearers));
    for (std::size_t i = 0; i < 6; ++i) out[i * 6 + k] = column[i];
  }
  return out;
}

/// Whether it is that, as far as numbers go: points on a line have none.
bool is_inverse(const std::vector<double>& m, const std::vector<double>& inverse) {
  constexpr double kMostError = 1e-6;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      double sum = i == k ? -1 : 0;
      for (std::size_t j = 0; j < 6; ++j) sum += m[i * 6 + j] * inverse[j * 6 + k];
      if (!(std::abs(sum) < kMostError)) return false;  // so that NaN fails
    }
  }
  return true;
}

/// Whether there is a direction along which every force within the cones pushes. Otherwise points
/// could clamp the body between them with any force, and so hold anything: contacts know how hard
/// they press, but these forces are only looked for.
bool cannot_clamp(const std::vector<Bearer>& bearers) {
  std::vector<Vec3> normals;
  Vec3 along;
  for (const Bearer& one : bearers) {
    if (std::any_of(normals.begin(), normals.end(),
                    [&](const Vec3& other) { return dot(other, one.normal) > kSameNormal; })) {
      continue;
    }
    normals.push_back(one.normal);
    along += one.normal;
  }
  // A cone's farthest force from its normal is at the angle of friction.
  return std::all_of(bearers.begin(), bearers.end(), [&](const Bearer& one) {
    const double farthest = one.friction / std::sqrt(1 + one.friction * one.friction);
    return dot(one.normal, along) > farthest * length(along);
  });
}

/// Forces that add up to the impulse: of all such, the nearest.
void make_up(const Grasp& grasp, const Twist& impulse, std::vector<Bearer>& bearers) {
  const Twist now = sum_of(bearers);
  const Six lacking = six_of({impulse.v - now.v, impulse.w - now.w});
  Six yz{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 6; ++k) yz[i] += grasp.spread[i * 6 + k] * lacking[k];
  }
  change(bearers, twist_of(yz));
}

bool all_within(const std::vector<Bearer>& bearers) {
  double pushes = 0;
  for (const Bearer& one : bearers) pushes += std::abs(dot(one.normal, one.force));
  return std::all_of(bearers.begin(), bearers.end(), [&](const Bearer& one) {
    const double push = dot(one.normal, one.force);
    const double slide = length(one.force - one.normal * push);
    return push >= -kSlack * pushes &&
           slide <= one.friction * std::max(0.0, push) + kSlack * pushes;
  });
}

/// The nearest force within the cone.
Vec3 into_cone(const Bearer& one) {
  const double friction = kInside * one.friction, push = dot(one.normal, one.force);
  const Vec3 slide = one.force - one.normal * push;
  const double size = length(slide);
  if (size <= friction * push) return one.force;
  if (push <= -friction * size) return {};
  const double nearest = (push + friction * size) / (1 + friction * friction);
  return one.normal * nearest + slide * (friction * nearest / size);
}

}  // namespace

bool complete(Grasp& grasp) {
  std::vector<Bearer> bearers;
  list_bearers(grasp, bearers);
  if (!cannot_clamp(bearers)) return false;
  const std::vector<double> m = matrix_of(std::move(bearers));
  std::vector<double> inverse = m;
  invert_positive(inverse, 6);
  if (!is_inverse(m, inverse)) return false;
  std::copy(inverse.begin(), inverse.end(), grasp.spread.begin());
  return true;
}

Twist wrench_of(const Grasp& grasp) {
  std::vector<Bearer> bearers;
  list_bearers(grasp, bearers);
  return sum_of(bearers);
}

bool bear(Grasp& grasp, const Twist& impulse_B) {
  thread_local std::vector<Bearer> bearers;  // for its memory alone
  list_bearers(grasp, bearers);
  make_up(grasp, impulse_B, bearers);
  for (int turn = 0; !all_within(bearers); ++turn) {
    if (turn == kMostTurns) return false;
    for (Bearer& one : bearers) one.force = into_cone(one);
    make_up(grasp, impulse_B, bearers);
  }
  std::size_t next = 0;
  each_point(grasp.contacts, grasp.body,
             [&](const Contact& contact, ContactPoint& point, double side) {
               const Vec3 force = bearers[next++].force * side;
               const double push = dot(contact.normal, force);
               point.push = std::max(0.0, push);
               point.friction = force - contact.normal * push;
             });
  return true;
}

}  // namespace stig::physics
