// SPDX-License-Identifier: MIT
#include "compiler/sight.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace stig {

namespace {

// What stands around a column, as a text of states: enough to hide or be hidden.
constexpr int kBefore = 4, kBehind = 4, kBeside = 3;
constexpr int kRows = 2 * kBeside + 1, kDepth = kBefore + kBehind + 1;

std::size_t around_index(int du, int dv, int z) {
  return static_cast<std::size_t>((z * kDepth + du + kBehind) * kRows + dv + kBeside);
}

constexpr double kEdge = 0.02;  ///< of the image's width

/// Faces that a robot can see: towards it, the top, and both sides. Robot's frame: x ahead.
constexpr std::array<Vec3, 4> kFaces = {Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0},
                                        Vec3{0, -1, 0}};
constexpr std::size_t kTop = 1;

/// The bricks around a column and a camera before it.
class Scene {
 public:
  Scene(const std::string& around, const Abilities& robot, const CarriedCamera& camera,
        const Stance& stance)
      : around_(around), robot_(robot), camera_(camera) {
    X_RC_ = camera.X_RC;
    if (camera.lifted) X_RC_.p.z += stance.lift;
    column_x_ = X_RC_.p.x + stance.distance + robot.block.side / 2;
    X_CR_ = inverse(X_RC_);
  }

  /// Is the tag of this face seen, were there a brick in the cell? `lit`: one of its LEDs too.
  bool tag_seen(const WindowCell& cell, const Vec3& normal, bool* lit) const {
    const BlockLook& look = robot_.block;
    const Vec3 middle = centre(cell) + normal * (look.side / 2 + look.proud);
    if (!facing(middle, normal)) return false;
    const Vec3 right = std::abs(normal.z) > 0.5 ? Vec3{0, 1, 0} : Vec3{-normal.y, normal.x, 0};
    const Vec3 up = cross(normal, right);
    const double half = look.tag_side / 2;
    for (const double a : {-half, half}) {
      for (const double b : {-half, half}) {
        if (!point_seen(middle + right * a + up * b, cell)) return false;
      }
    }
    for (const Vec3& led : {right, -right, up, -up}) {
      const Vec3 p = middle + led * look.led_place;
      *lit = *lit || (facing(p, normal) && point_seen(p, cell));
    }
    return true;
  }

 private:
  Vec3 centre(const WindowCell& c) const {
    const double side = robot_.block.side;
    return {column_x_ - c.du * side, c.dv * side, (c.z + 0.5) * side};
  }
  bool facing(const Vec3& p, const Vec3& normal) const {
    const Vec3 to = X_RC_.p - p;
    return dot(to, normal) >= length(to) * std::cos(robot_.block.most_angle);
  }
  bool point_seen(const Vec3& p, const WindowCell& own) const {
    const Vec3 p_C = X_CR_ * p;
    if (p_C.z < camera_.near || p_C.z > camera_.far) return false;
    const auto pixel = project(camera_.intrinsics, p_C);
    const CameraIntrinsics& image = camera_.intrinsics;
    const double edge = kEdge * image.width;
    const bool inside = pixel && pixel->x >= edge && pixel->y >= edge &&
                        pixel->x < image.width - edge && pixel->y < image.height - edge;
    return inside && !hidden(p, own);
  }
  bool hidden(const Vec3& p, const WindowCell& own) const {
    for (int z = 0; z * kDepth * kRows < static_cast<int>(around_.size()); ++z) {
      for (int du = -kBehind; du <= kBefore; ++du) {
        for (int dv = -kBeside; dv <= kBeside; ++dv) {
          if (around_[around_index(du, dv, z)] == 0) continue;
          const WindowCell cell{du, dv, z};
          if (cell != own && crosses(p, centre(cell))) return true;
        }
      }
    }
    return false;
  }
  /// Does the way from the camera to p go through the brick about `middle`?
  bool crosses(const Vec3& p, const Vec3& middle) const {
    const double half = robot_.block.side / 2;
    const Vec3 from = X_RC_.p - middle, way = p - X_RC_.p;
    double enter = 0, leave = 1;
    const std::array<double, 3> f{from.x, from.y, from.z}, w{way.x, way.y, way.z};
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::abs(w[i]) < 1e-12) {
        if (std::abs(f[i]) >= half) return false;
        continue;
      }
      const double a = (-half - f[i]) / w[i], b = (half - f[i]) / w[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return leave - enter > 1e-9;
  }

  const std::string& around_;
  const Abilities& robot_;
  const CarriedCamera& camera_;
  Pose X_RC_, X_CR_;
  double column_x_ = 0;
};

}  // namespace

WindowCell window_cell(std::size_t index) {
  const int i = static_cast<int>(index);
  return {i / 3 % 3 - 1, i % 3 - 1, i / kWindowColumns};
}

Sight::Sight(const TargetStates& target, const Abilities& robot)
    : target_(&target), robot_(&robot), levels_(std::min(robot.levels, target.levels()) + 1) {
  constexpr int kLifts = 6;
  for (const double distance : {0.08, 0.10, 0.14, 0.20}) {
    for (int i = 0; i < kLifts; ++i) {
      stances_.push_back({distance, robot.lift_travel * i / (kLifts - 1)});
    }
  }
}

const Sight::Seen& Sight::seen(const BrickSet& state, ApproachSide side, int u, int v) {
  std::string around(static_cast<std::size_t>(levels_ * kDepth * kRows), '\0');
  for (int z = 0; z < levels_; ++z) {
    for (int du = -kBehind; du <= kBefore; ++du) {
      for (int dv = -kBeside; dv <= kBeside; ++dv) {
        const Cell cell = cell_from(side, {u + du, v + dv, z + target_->floor_level()});
        const std::uint32_t brick = target_->brick_at(cell);
        if (brick == TargetStates::kNone || !state.has(brick)) continue;
        around[around_index(du, dv, z)] = static_cast<char>(target_->colour(brick));
      }
    }
  }
  const auto found = known_.find(around);
  if (found != known_.end()) return found->second;
  Seen out;
  for (const Stance& stance : stances_) out.from.push_back(observe(around, stance));
  out.all = out.from.front();
  for (const Observation& one : out.from) {
    for (std::size_t i = 0; i < one.cells.size(); ++i) {
      out.all.cells[i] = std::max(out.all.cells[i], one.cells[i]);
    }
  }
  return known_.emplace(std::move(around), std::move(out)).first->second;
}

const Observation& Sight::look(const BrickSet& state, ApproachSide side, int u, int v) {
  return seen(state, side, u, v).all;
}

const std::vector<Observation>& Sight::look_from_each(const BrickSet& state, ApproachSide side,
                                                      int u, int v) {
  return seen(state, side, u, v).from;
}

Observation Sight::observe(const std::string& around, const Stance& stance) const {
  Observation out;
  out.cells.assign(static_cast<std::size_t>(levels_ * kWindowColumns), kUnseen);
  for (const CarriedCamera& camera : robot_->cameras) {
    const Scene scene(around, *robot_, camera, stance);
    for (std::size_t i = 0; i < out.cells.size(); ++i) {
      const WindowCell cell = window_cell(i);
      const auto state = static_cast<std::uint8_t>(around[around_index(cell.du, cell.dv, cell.z)]);
      for (std::size_t face = 0; face < kFaces.size(); ++face) {
        bool lit = false;
        if (!scene.tag_seen(cell, kFaces[face], &lit)) continue;
        if (state == 0) {
          out.cells[i] = kSeenEmpty;
        } else if (lit) {
          out.cells[i] = static_cast<std::uint8_t>(kSeenBrick + state);
        }
        const WindowCell above{cell.du, cell.dv, cell.z + 1};
        if (state != 0 && face == kTop && above.z < levels_) {
          out.cells[window_index(above)] = kSeenEmpty;
        }
      }
    }
  }
  return out;
}

std::optional<ColumnTop> column_top(const Observation& seen) {
  const int levels = static_cast<int>(seen.cells.size()) / kWindowColumns;
  std::optional<ColumnTop> top;
  for (int z = 0; z < levels; ++z) {
    const std::uint8_t state = seen.cells[window_index({0, 0, z})];
    if (state == kSeenEmpty) return top;
    // Above the highest level nothing is ever put.
    if (state == kUnseen) return z == levels - 1 ? top : std::nullopt;
    top = ColumnTop{z, static_cast<Colour>(state - kSeenBrick)};
  }
  return top;
}

}  // namespace stig
