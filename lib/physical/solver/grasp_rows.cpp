// SPDX-License-Identifier: MIT
#include "physical/solver/grasp_rows.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "physical/solver/small_matrix.h"

namespace stig::physics {

namespace {

constexpr double kReach = 0.03;  ///< m: at which spins count as velocities

/// J: how the link moves where the body's centre is.
void fill_j(const SolverLink& link, const Vec3& p, GraspRow& row) {
  const Vec3 arm = p - link.p;
  for (std::size_t i = 0; i < row.dofs; ++i) {
    const Six column =
        six_of({link.columns[i].v + cross(link.columns[i].w, arm), link.columns[i].w});
    for (std::size_t k = 0; k < 6; ++k) row.j[k * row.dofs + i] = column[k];
  }
}

/// W = M⁻¹Jᵀ, row by row; M⁻¹ is the same by rows and by columns.
void fill_w(const double* inverse, GraspRow& row) {
  const std::size_t n = row.dofs;
  for (std::size_t k = 0; k < 6; ++k) {
    double* w = &row.w[k * n];
    std::fill_n(w, n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const double j = row.j[k * n + i];
      if (j == 0) continue;
      for (std::size_t m = 0; m < n; ++m) w[m] += j * inverse[i * n + m];
    }
  }
}

/// (J M⁻¹ Jᵀ + the body's own)⁻¹.
void fill_mass(GraspRow& row) {
  const std::size_t n = row.dofs;
  thread_local std::vector<double> m;
  m.assign(36, 0);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      for (std::size_t d = 0; d < n; ++d) m[i * 6 + k] += row.j[i * n + d] * row.w[k * n + d];
    }
  }
  const auto add = [](std::size_t i, std::size_t k, double x) { m[i * 6 + k] += x; };
  const Mat3& turn = row.body->inverse_inertia;
  const std::array<Vec3, 3> columns{turn * Vec3{1, 0, 0}, turn * Vec3{0, 1, 0},
                                    turn * Vec3{0, 0, 1}};
  for (std::size_t i = 0; i < 3; ++i) {
    add(i, i, row.body->inverse_mass);
    add(3 + i, 3, i == 0 ? columns[0].x : i == 1 ? columns[0].y : columns[0].z);
    if (i >= 1) add(3 + i, 4, i == 1 ? columns[1].y : columns[1].z);
    if (i == 2) add(5, 5, columns[2].z);
  }
  invert_positive(m, 6);
  std::copy(m.begin(), m.end(), row.mass.begin());
}

/// On the body; the mechanism takes the opposite.
void push(GraspRow& row, const Six& impulse) {
  const Twist twist = twist_of(impulse);
  row.body->v += twist.v * row.body->inverse_mass;
  row.body->w += row.body->inverse_inertia * twist.w;
  for (std::size_t k = 0; k < 6; ++k) {
    const double* w = &row.w[k * row.dofs];
    for (std::size_t i = 0; i < row.dofs; ++i) row.v[i] -= w[i] * impulse[k];
  }
}

/// The link's twist at the body's centre, less the body's.
Six lag(const GraspRow& row) {
  Six out = six_of({row.body->v * -1, row.body->w * -1});
  for (std::size_t k = 0; k < 6; ++k) {
    const double* j = &row.j[k * row.dofs];
    for (std::size_t i = 0; i < row.dofs; ++i) out[k] += j[i] * row.v[i];
  }
  return out;
}

double relax(GraspRow& row) {
  const Six behind = lag(row);
  Six impulse{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 6; ++k) impulse[i] += row.mass[i * 6 + k] * behind[k];
    row.impulse[i] += impulse[i];
  }
  push(row, impulse);
  double most = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    most = std::max(most, std::abs(behind[i]) * (i < 3 ? 1 : kReach));
  }
  return most;
}

}  // namespace

void make_grasp_rows(SolverTask& task, GraspRows& rows) {
  rows.resize(task.grasps.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const SolverGrasp& grasp = task.grasps[k];
    const std::int32_t number = task.bodies[grasp.link].link;
    assert(number >= 0 && task.bodies[grasp.body].inverse_mass > 0);
    const SolverLink& link = task.links[static_cast<std::size_t>(number)];
    const SolverMechanism& mechanism = task.mechanisms[link.mechanism];
    GraspRow& row = rows[k];
    row.v = mechanism.v;
    row.dofs = mechanism.dofs;
    row.body = &task.bodies[grasp.body];
    row.j.resize(6 * row.dofs);
    row.w.resize(6 * row.dofs);
    fill_j(link, row.body->p, row);
    fill_w(mechanism.inverse, row);
    fill_mass(row);
    row.impulse = six_of(
        {grasp.impulse.v * (1.0 / task.small_steps), grasp.impulse.w * (1.0 / task.small_steps)});
    row.sum = {};
  }
}

void apply_last_grasps(GraspRows& rows) {
  for (GraspRow& row : rows) push(row, row.impulse);
}

double relax_grasps(GraspRows& rows) {
  double most = 0;
  for (GraspRow& row : rows) most = std::max(most, relax(row));
  return most;
}

void add_up_grasps(GraspRows& rows) {
  for (GraspRow& row : rows) {
    for (std::size_t i = 0; i < 6; ++i) row.sum[i] += row.impulse[i];
  }
}

void keep_grasp_impulses(const GraspRows& rows, SolverTask& task) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    task.grasps[k].impulse = twist_of(rows[k].sum);
  }
}

}  // namespace stig::physics
