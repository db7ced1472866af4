// SPDX-License-Identifier: MIT
// Points of a mechanism are gone through with its velocities at hand, whatever the number of its
// degrees of freedom, and come out to the bit as each by itself.
#include "physical/solver/solver_rows.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <random>

using namespace stig;

namespace {

/// A mechanism of three links, of which the floor bears two and a free body meets two, with any
/// numbers: what is a mechanism does not matter here.
struct Meeting {
  std::size_t dofs;
  std::mt19937_64 random;
  std::vector<double> inverse, v, kick, way;
  std::vector<Twist> columns;
  SolverTask task;

  explicit Meeting(std::size_t its_dofs)
      : dofs(its_dofs), random(its_dofs), v(numbers(dofs)), kick(dofs), way(dofs) {
    const std::vector<double> half = numbers(dofs * dofs);
    inverse.resize(dofs * dofs);
    for (std::size_t i = 0; i < dofs; ++i) {
      for (std::size_t k = 0; k < dofs; ++k) {
        inverse[i * dofs + k] = (half[i * dofs + k] + half[k * dofs + i]) / 20;
      }
      inverse[i * dofs + i] += 3;
    }
    columns.resize(3 * dofs);
    // The first link has the first degrees of freedom, the second some in the middle besides, the
    // third all.
    for (std::size_t i = 0; i < dofs; ++i) {
      if (i < 6) columns[i] = twist();
      if (i < 6 || i / 2 == 4) columns[dofs + i] = twist();
      columns[2 * dofs + i] = twist();
    }
    task.mechanisms.push_back({dofs, inverse.data(), v.data(), kick.data(), way.data()});
    task.bodies.resize(5);  // the ground, three links, one that is free
    for (std::size_t i = 1; i < 4; ++i) {
      task.bodies[i].link = static_cast<std::int32_t>(i - 1);
      SolverLink link;
      link.columns = &columns[(i - 1) * dofs];
      task.links.push_back(link);
    }
    SolverBody& loose = task.bodies[4];
    loose.v = vec();
    loose.w = vec();
    loose.inverse_mass = 2;
    loose.inverse_inertia = {{30, 0, 0}, {0, 40, 0}, {0, 0, 50}};
    for (const auto& [a, b] : {std::pair{1U, 0U}, {2U, 0U}, {3U, 0U}, {1U, 4U}, {3U, 4U}}) {
      meet(a, b);
    }
  }

  std::vector<double> numbers(std::size_t count) {
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<double> out(count);
    for (double& one : out) one = number(random);
    return out;
  }
  Vec3 vec() {
    const auto n = numbers(3);
    return {n[0], n[1], n[2]};
  }
  Twist twist() {
    const Vec3 linear = vec();
    return {linear, vec()};
  }

  void meet(std::uint32_t a, std::uint32_t b) {
    Contact contact;
    contact.a = a;
    contact.b = b;
    contact.normal = {0, 0, 1};
    contact.count = 3;
    for (ContactPoint& point : contact.points) {
      point.p_W = vec();
      point.gap = numbers(1)[0] * 1e-3;
      point.push = 0.01;
      point.friction = {0.001, -0.002, 0};
    }
    task.contacts.push_back(contact);
    task.slots.emplace_back(a, b);
  }
};

/// The same rows, each point by itself.
Rows one_by_one(Rows rows) {
  rows.runs.clear();
  for (std::uint32_t i = 0; i < rows.points.size(); ++i) {
    rows.points[i].kind = RowKind::any;
    rows.runs.push_back({i, i + 1});
  }
  return rows;
}

/// What comes of some sweeps: velocities, those of the free body, impulses and gaps.
std::vector<double> swept(Meeting& meeting, Rows rows) {
  const std::vector<double> v = meeting.v;
  const SolverBody loose = meeting.task.bodies[4];
  std::vector<double> out;
  apply_last_rows(rows, meeting.task);
  for (int i = 0; i < 3; ++i) {
    out.push_back(sweep_rows(rows, meeting.task, 1e3));
    follow_row_gaps(rows, meeting.task, 1e-3);
  }
  out.insert(out.end(), meeting.v.begin(), meeting.v.end());
  const SolverBody& now = meeting.task.bodies[4];
  for (const Vec3& one : {now.v, now.w}) out.insert(out.end(), {one.x, one.y, one.z});
  for (const RowPoint& point : rows.points) {
    out.insert(out.end(), {point.push, point.slide[0], point.slide[1], point.gap});
  }
  std::copy(v.begin(), v.end(), meeting.v.begin());
  meeting.task.bodies[4] = loose;
  return out;
}

}  // namespace

TEST_CASE("runs of a mechanism's points, for any number of degrees of freedom, to the bit") {
  for (std::size_t dofs = 1; dofs <= kMostMechanismDofs; ++dofs) {
    CAPTURE(dofs);
    Meeting meeting(dofs);
    Rows rows;
    make_rows(meeting.task, rows);
    REQUIRE(rows.points.size() == 15);
    for (const RowPoint& point : rows.points) CHECK(point.kind != RowKind::any);
    CHECK(rows.runs.size() <= 5);
    const std::vector<double> together = swept(meeting, rows);
    const std::vector<double> apart = swept(meeting, one_by_one(rows));
    REQUIRE(together.size() == apart.size());
    CHECK(std::abs(together[0]) > 0);
    CHECK(std::memcmp(together.data(), apart.data(), together.size() * sizeof(double)) == 0);
  }
}

TEST_CASE("two mechanisms that meet are gone through point by point") {
  Meeting meeting(8);
  std::vector<double> v(8), kick(8), way(8);
  meeting.task.mechanisms.push_back({8, meeting.inverse.data(), v.data(), kick.data(), way.data()});
  SolverLink link = meeting.task.links[0];
  link.mechanism = 1;
  meeting.task.links.push_back(link);
  meeting.task.bodies.emplace_back().link = 3;
  meeting.meet(1, 5);
  Rows rows;
  make_rows(meeting.task, rows);
  CHECK(rows.points.back().kind == RowKind::any);
  CHECK(rows.points.back().held == 2);
}
