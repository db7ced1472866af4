// SPDX-License-Identifier: MIT
// What can be seen of a column. For every viewpoint, cell and face it is computed once
// which cells around would hide the tag or an LED (rays against cubes), as bit masks; an
// observation then is a few AND operations for each tag. Masks depend on the robot alone,
// so all structures and colourings share them.
#include "compiler/sight.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/degree.h"

namespace stig::compiler {

namespace {

/// What stands around a column, as a text of states: enough to hide or be hidden. Bricks
/// farther away than this hide nothing within the window from any viewpoint.
constexpr int kBefore = 4, kBehind = 4, kBeside = 3;
static_assert(std::max({kBefore, kBehind, kBeside}) <= kFarthestSeen);
constexpr int kRows = 2 * kBeside + 1, kDepth = kBefore + kBehind + 1;

std::size_t around_index(int du, int dv, int z) {
  assert(std::abs(dv) <= kBeside && du >= -kBehind && du <= kBefore);
  return static_cast<std::size_t>((z * kDepth + du + kBehind) * kRows + dv + kBeside);
}

constexpr int kFewestSteps = 5;        ///< between the heights that are looked from
constexpr double kEdge = 0.02;         ///< of the image's width
constexpr double kTilt = 5 * kDegree;  ///< of the widest angle at which a tag is read

/// Faces that a robot can see: towards it, the top, and both sides. Robot's frame: x ahead.
constexpr std::array<Vec3, 4> kFaces = {Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0},
                                        Vec3{0, -1, 0}};
constexpr std::size_t kTop = 1;

std::size_t around_cells(int levels) { return static_cast<std::size_t>(levels * kDepth * kRows); }

/// A camera before a column: what its place alone decides.
class Shot {
 public:
  Shot(const Abilities& robot, const CarriedCamera& camera, const Viewpoint& viewpoint, int levels)
      : robot_(robot), camera_(camera), levels_(levels) {
    X_RC_ = camera.X_RC;
    if (camera.lifted) X_RC_.p.z += viewpoint.lift;
    column_x_ = X_RC_.p.x + viewpoint.distance + robot.block.side / 2;
    X_CR_ = inverse(X_RC_);
  }

  /// The tag of this face, were there a brick in the cell; nothing when it is out of view.
  std::optional<TagLook> look_at(const WindowCell& cell, const Vec3& normal) const {
    const BlockLook& look = robot_.block;
    const Vec3 middle = centre(cell) + normal * (look.side / 2 + look.proud);
    if (!facing(middle, normal)) return std::nullopt;
    // The tag's axes lie in the face; its roll does not matter to the corners' visibility.
    const Vec3 right = std::abs(normal.z) > 0.5 ? Vec3{0, 1, 0} : Vec3{-normal.y, normal.x, 0};
    const Vec3 up = cross(normal, right);
    const double half = look.tag_side / 2;
    TagLook out;
    out.hides_tag.assign((around_cells(levels_) + 63) / 64, 0);
    for (const double a : {-half, half}) {
      for (const double b : {-half, half}) {
        const Vec3 corner = middle + right * a + up * b;
        if (!in_view(corner)) return std::nullopt;
        add_hiding(corner, cell, out.hides_tag);
      }
    }
    // LEDs lie on the face's axes, around the tag.
    for (const Vec3& led : {right, -right, up, -up}) {
      const Vec3 p = middle + led * look.led_place;
      if (!facing(p, normal) || !in_view(p)) continue;
      out.hides_led.emplace_back((around_cells(levels_) + 63) / 64, 0);
      add_hiding(p, cell, out.hides_led.back());
    }
    return out;
  }

 private:
  Vec3 centre(const WindowCell& c) const {
    const double side = robot_.block.side;
    return {column_x_ - c.du * side, c.dv * side, (c.z + 0.5) * side};
  }
  /// Here too a margin is given away; robots keep a part of it (perception/line_of_sight.lua), so
  /// that they do not take for empty what they see too obliquely.
  bool facing(const Vec3& p, const Vec3& normal) const {
    const Vec3 to = X_RC_.p - p;
    return dot(to, normal) >= length(to) * std::cos(robot_.block.most_angle - kTilt);
  }
  /// A margin of the image is given away, since a robot never stands exactly where it
  /// should.
  bool in_view(const Vec3& p) const {
    const Vec3 p_C = X_CR_ * p;
    if (p_C.z < camera_.near || p_C.z > camera_.far) return false;
    const auto pixel = project(camera_.intrinsics, p_C);
    const CameraIntrinsics& image = camera_.intrinsics;
    const double edge = kEdge * image.width;
    return pixel && pixel->x >= edge && pixel->y >= edge && pixel->x < image.width - edge &&
           pixel->y < image.height - edge;
  }
  /// Adds the cells where a brick would stand before p.
  void add_hiding(const Vec3& p, const WindowCell& own, CellWords& out) const {
    for (int z = 0; z < levels_; ++z) {
      for (int du = -kBehind; du <= kBefore; ++du) {
        for (int dv = -kBeside; dv <= kBeside; ++dv) {
          const WindowCell cell{du, dv, z};
          if (cell == own || !crosses(p, centre(cell))) continue;
          const std::size_t i = around_index(du, dv, z);
          out[i / 64] |= std::uint64_t{1} << (i % 64);
        }
      }
    }
  }
  /// Does the way from the camera to p go through the brick about `middle`? The slab method
  /// (T. Kay and J. Kajiya 1986): the ray's parameters of entry and exit over three pairs
  /// of planes. Grazing contacts do not count.
  bool crosses(const Vec3& p, const Vec3& middle) const {
    const double half = robot_.block.side / 2;
    const Vec3 from = X_RC_.p - middle, way = p - X_RC_.p;
    const std::array<double, 3> f{from.x, from.y, from.z}, w{way.x, way.y, way.z};
    for (std::size_t i = 0; i < 3; ++i) {  // most bricks are nowhere near
      if (std::min(f[i], f[i] + w[i]) > half || std::max(f[i], f[i] + w[i]) < -half) return false;
    }
    double enter = 0, leave = 1;
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

  const Abilities& robot_;
  const CarriedCamera& camera_;
  int levels_ = 0;
  Pose X_RC_, X_CR_;
  double column_x_ = 0;
};

bool any_filled(const CellWords& cells, const CellWords& filled) {
  std::uint64_t both = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) both |= cells[i] & filled[i];
  return both != 0;
}

CellWords words_of(const std::string& filled) {
  CellWords out((filled.size() + 63) / 64, 0);
  for (std::size_t i = 0; i < filled.size(); ++i) {
    if (filled[i] != 0) out[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  return out;
}

}  // namespace

WindowCell window_cell(std::size_t index) {
  const int i = static_cast<int>(index);
  return {i / 3 % 3 - 1, i % 3 - 1, i / kWindowColumns};
}

int window_levels(const Abilities& robot, int target_levels) {
  return std::min(robot.levels, target_levels) + 1;
}

Visibility::Visibility(const Abilities& robot, int levels)
    : levels_(levels), leds_needed_(robot.block.leds_needed) {
  // Distances in m from the camera to the column's face, and heights of the lift from its lowest
  // to its highest, no farther apart than levels are.
  const int steps =
      std::max(kFewestSteps, static_cast<int>(robot.lift_travel / robot.block.side) + 1);
  for (const double distance : {0.08, 0.10, 0.14, 0.20}) {
    for (int i = 0; i <= steps; ++i) {
      viewpoints_.push_back({distance, robot.lift_travel * i / steps});
    }
  }
  for (const Viewpoint& viewpoint : viewpoints_) {
    looks_.emplace_back();
    for (const CarriedCamera& camera : robot.cameras)
      add_looks(Shot(robot, camera, viewpoint, levels));
  }
}

template <class Camera>
void Visibility::add_looks(const Camera& shot) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(levels_ * kWindowColumns); ++i) {
    for (std::size_t face = 0; face < kFaces.size(); ++face) {
      std::optional<TagLook> look = shot.look_at(window_cell(i), kFaces[face]);
      if (!look) continue;
      look->cell = i;
      look->on_top = face == kTop;
      looks_.back().push_back(std::move(*look));
    }
  }
}

/// Enumerations of situations need to vary only these cells: no other can change a view.
std::vector<WindowCell> Visibility::cells_that_matter() const {
  CellWords hiding((around_cells(levels_) + 63) / 64, 0);
  const auto add = [&](const CellWords& cells) {
    for (std::size_t i = 0; i < hiding.size(); ++i) hiding[i] |= cells[i];
  };
  for (const std::vector<TagLook>& looks : looks_) {
    for (const TagLook& look : looks) {
      add(look.hides_tag);
      for (const CellWords& led : look.hides_led) add(led);
    }
  }
  std::vector<WindowCell> out;
  for (int z = 0; z < levels_; ++z) {
    for (int du = -kBehind; du <= kBefore; ++du) {
      for (int dv = -kBeside; dv <= kBeside; ++dv) {
        const std::size_t i = around_index(du, dv, z);
        const bool in_window = std::abs(du) <= 1 && std::abs(dv) <= 1;
        if (in_window || (hiding[i / 64] >> (i % 64) & 1U) != 0) out.push_back({du, dv, z});
      }
    }
  }
  return out;
}

const std::vector<Observation>& Visibility::of(const std::string& filled) {
  const auto found = known_.find(filled);
  if (found != known_.end()) return found->second;
  std::vector<Observation> out;
  for (const std::vector<TagLook>& looks : looks_) out.push_back(observe(filled, looks));
  return known_.emplace(filled, std::move(out)).first->second;
}

Observation Visibility::observe(const std::string& filled,
                                const std::vector<TagLook>& looks) const {
  Observation out;
  assert(filled.size() == around_cells(levels_));
  out.cells.assign(static_cast<std::size_t>(levels_ * kWindowColumns), kUnseen);
  const CellWords bricks = words_of(filled);
  for (const TagLook& look : looks) {
    if (any_filled(look.hides_tag, bricks)) continue;
    const WindowCell cell = window_cell(look.cell);
    if (filled[around_index(cell.du, cell.dv, cell.z)] == 0) {
      out.cells[look.cell] = kSeenEmpty;
      continue;
    }
    // A brick whose tag is seen without enough of its LEDs is of no known kind and counts as
    // unseen.
    const auto lit = std::count_if(look.hides_led.begin(), look.hides_led.end(),
                                   [&](const CellWords& led) { return !any_filled(led, bricks); });
    if (lit >= leds_needed_) out.cells[look.cell] = kSeenBrick;
    // A visible top also shows that the cell above is empty.
    const WindowCell above{cell.du, cell.dv, cell.z + 1};
    if (look.on_top && above.z < levels_) out.cells[window_index(above)] = kSeenEmpty;
  }
  return out;
}

Sight::Sight(const TargetBricks& target, const Abilities& robot)
    : Sight(target, std::make_shared<Visibility>(robot, window_levels(robot, target.levels()))) {}

Sight::Sight(const TargetBricks& target, std::shared_ptr<Visibility> visibility)
    : target_(&target), visibility_(std::move(visibility)) {
  assert(visibility_ != nullptr);
}

const Sight::Around& Sight::around_column(ApproachSide side, int u, int v) {
  const auto [at, added] = around_[static_cast<std::size_t>(side)].try_emplace({u, v});
  if (!added) return at->second;
  for (int z = 0; z < levels(); ++z) {
    for (int du = -kBehind; du <= kBefore; ++du) {
      for (int dv = -kBeside; dv <= kBeside; ++dv) {
        const Cell cell = cell_from(side, {u + du, v + dv, z + target_->floor_level()});
        const std::uint32_t brick = target_->brick_at(cell);
        if (brick == TargetBricks::kNone) continue;
        at->second.emplace_back(static_cast<std::uint16_t>(around_index(du, dv, z)), brick);
      }
    }
  }
  return at->second;
}

/// Views are cached by what stands around the column: few different surroundings occur.
const Sight::Seen& Sight::seen(const BrickSet& state, ApproachSide side, int u, int v) {
  std::string around(around_cells(levels()), '\0');
  for (const auto& [place, brick] : around_column(side, u, v)) {
    if (state.has(brick)) around[place] = static_cast<char>(target_->colour(brick));
  }
  const auto found = known_.find(around);
  if (found != known_.end()) return found->second;
  Seen out = coloured(around);
  return known_.emplace(std::move(around), std::move(out)).first->second;
}

Sight::Seen Sight::coloured(const std::string& around) {
  std::string filled = around;
  for (char& cell : filled) cell = cell == 0 ? '\0' : '\1';
  Seen out;
  out.from = visibility_->of(filled);
  for (Observation& one : out.from) {
    for (std::size_t i = 0; i < one.cells.size(); ++i) {
      if (one.cells[i] != kSeenBrick) continue;
      const WindowCell cell = window_cell(i);
      const char colour = around[around_index(cell.du, cell.dv, cell.z)];
      one.cells[i] = static_cast<std::uint8_t>(kSeenBrick + static_cast<std::uint8_t>(colour));
    }
  }
  // What is known from some viewpoint is known: the greatest value counts.
  out.all = out.from.front();
  for (const Observation& one : out.from) {
    for (std::size_t i = 0; i < one.cells.size(); ++i) {
      out.all.cells[i] = std::max(out.all.cells[i], one.cells[i]);
    }
  }
  return out;
}

const Observation& Sight::look(const BrickSet& state, ApproachSide side, int u, int v) {
  return seen(state, side, u, v).all;
}

const std::vector<Observation>& Sight::look_from_each(const BrickSet& state, ApproachSide side,
                                                      int u, int v) {
  return seen(state, side, u, v).from;
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

}  // namespace stig::compiler
