// SPDX-License-Identifier: MIT
// Tags are looked at once for all: which cells a line of sight passes does not depend on what
// stands there.
#include "recheck/view.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stig::recheck {

namespace {

constexpr int kAbout = 5;               ///< cells along and across that may hide something
constexpr int kNextTo = 2;              ///< and that matter to what is put there
constexpr double kEdge = 0.02;          ///< of the picture's width
constexpr double kOblique = M_PI / 36;  ///< 5°

/// Does the straight way from a to b pass through the cube about `middle`, more than along its
/// surface? Cut to what lies between two parallel faces, thrice.
bool passes(const Vec3& a, const Vec3& b, const Vec3& middle, double half) {
  double from = 0, to = 1;
  const std::array<double, 3> at{a.x - middle.x, a.y - middle.y, a.z - middle.z};
  const std::array<double, 3> way{b.x - a.x, b.y - a.y, b.z - a.z};
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(way[i]) < 1e-12) {
      if (std::abs(at[i]) >= half) return false;
      continue;
    }
    const double one = (half - at[i]) / way[i], other = (-half - at[i]) / way[i];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return to - from > 1e-9;
}

}  // namespace

/// One camera at one place before the column, in the robot's frame.
class View::Camera {
 public:
  Camera(const Figures& measures, const Eye& eye, const WorkLook& look)
      : robot(measures), eye_(eye) {
    X_RC_ = eye.X_RC;
    if (eye.lifted) X_RC_.p.z += look.lift;
    X_CR_ = inverse(X_RC_);
    column_ = X_RC_.p.x + look.distance + robot.side / 2;
  }

  Vec3 middle(const NearCell& c) const {
    return {column_ - c.du * robot.side, c.dv * robot.side, (c.z + 0.5) * robot.side};
  }
  /// On a face with this normal.
  bool sees(const Vec3& point, const Vec3& normal) const {
    return turned_to_it(point, normal) && in_picture(point);
  }
  bool turned_to_it(const Vec3& point, const Vec3& normal) const {
    const Vec3 way = X_RC_.p - point;
    return dot(way, normal) >= std::cos(robot.widest - kOblique) * length(way);
  }
  bool in_picture(const Vec3& point) const {
    const Vec3 p_C = X_CR_ * point;
    if (p_C.z < eye_.near || p_C.z > eye_.far) return false;
    const auto pixel = project(eye_.intrinsics, p_C);
    if (!pixel) return false;
    const double edge = kEdge * eye_.intrinsics.width;
    return std::min(pixel->x, pixel->y) >= edge && pixel->x < eye_.intrinsics.width - edge &&
           pixel->y < eye_.intrinsics.height - edge;
  }
  void add_hiding(const std::vector<NearCell>& cells, const NearCell& own, const Vec3& point,
                  std::vector<std::uint32_t>& out) const {
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
      if (cells[i] != own && passes(X_RC_.p, point, middle(cells[i]), robot.side / 2)) {
        out.push_back(i);
      }
    }
  }

  const Figures& robot;

 private:
  const Eye& eye_;
  Pose X_RC_, X_CR_;
  double column_ = 0;  ///< x of the column's middle
};

View::View(const Figures& robot, const std::vector<WorkLook>& looks, int levels)
    : levels_(levels), leds_needed_(robot.leds_needed) {
  std::vector<NearCell> all;
  for (int z = 0; z < levels; ++z) {
    for (int du = -kAbout; du <= kAbout; ++du) {
      for (int dv = -kAbout; dv <= kAbout; ++dv) all.push_back({du, dv, z});
    }
  }
  cells_ = all;
  for (const WorkLook& look : looks) {
    for (const Eye& eye : robot.eyes) add_tags(Camera(robot, eye, look));
  }
  // Cells that nothing depends on are left out, and the others numbered anew.
  std::vector<bool> matters(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    matters[i] = std::max(std::abs(all[i].du), std::abs(all[i].dv)) <= kNextTo;
  }
  for (const Tag& tag : tags_) {
    for (const std::uint32_t i : tag.before_tag) matters[i] = true;
    for (const auto& led : tag.before_led) {
      for (const std::uint32_t i : led) matters[i] = true;
    }
  }
  std::vector<std::uint32_t> anew(all.size());
  cells_.clear();
  own_.assign(static_cast<std::size_t>(9 * levels), 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    anew[i] = static_cast<std::uint32_t>(cells_.size());
    if (!matters[i]) continue;
    if (const int place = window(all[i]); place >= 0)
      own_[static_cast<std::size_t>(place)] = anew[i];
    cells_.push_back(all[i]);
  }
  for (Tag& tag : tags_) {
    for (std::uint32_t& i : tag.before_tag) i = anew[i];
    for (auto& led : tag.before_led) {
      for (std::uint32_t& i : led) i = anew[i];
    }
  }
}

void View::add_tags(const Camera& camera) {
  const Figures& robot = camera.robot;
  constexpr std::array<Vec3, 4> kNormals = {{{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, -1, 0}}};
  for (const NearCell& cell : cells_) {
    if (window(cell) < 0) continue;
    for (const Vec3& normal : kNormals) {
      const Vec3 middle = camera.middle(cell) + normal * (robot.side / 2 + robot.tag_proud);
      // Two directions in the face; a tag turned by a quarter is the same.
      const Vec3 a = normal.z != 0 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}, b = cross(normal, a);
      Tag tag{cell, normal.z != 0, {}, {}};
      bool seen = camera.turned_to_it(middle, normal);
      for (const auto& [i, k] : {std::pair(1, 1), {1, -1}, {-1, 1}, {-1, -1}}) {
        const Vec3 corner = middle + (a * i + b * k) * (robot.tag_side / 2);
        seen = seen && camera.in_picture(corner);
        if (seen) camera.add_hiding(cells_, cell, corner, tag.before_tag);
      }
      if (!seen) continue;
      for (const Vec3& way : {a, -a, b, -b}) {
        const Vec3 led = middle + way * robot.led_place;
        if (!camera.sees(led, normal)) continue;
        camera.add_hiding(cells_, cell, led, tag.before_led.emplace_back());
      }
      tags_.push_back(std::move(tag));
    }
  }
}

int View::window(const NearCell& c) const {
  if (std::abs(c.du) > 1 || std::abs(c.dv) > 1 || c.z < 0 || c.z >= levels_) return -1;
  return c.z * 9 + (c.du + 1) * 3 + c.dv + 1;
}

const std::vector<std::int8_t>& View::known(const std::string& shown) {
  const auto found = met_.find(shown);
  if (found != met_.end()) return found->second;
  const auto free = [&](const std::vector<std::uint32_t>& cells) {
    return std::all_of(cells.begin(), cells.end(), [&](std::uint32_t i) { return shown[i] == 0; });
  };
  std::vector<std::int8_t> out(own_.size(), kNotKnown);
  for (const Tag& tag : tags_) {
    if (!free(tag.before_tag)) continue;
    const auto place = static_cast<std::size_t>(window(tag.of));
    const auto there = static_cast<std::int8_t>(shown[own_[place]]);
    if (there == 0 ||
        std::count_if(tag.before_led.begin(), tag.before_led.end(), free) >= leds_needed_) {
      out[place] = there;
    }
    const int above = window({tag.of.du, tag.of.dv, tag.of.z + 1});
    if (there != 0 && tag.on_top && above >= 0) out[static_cast<std::size_t>(above)] = 0;
  }
  return met_.emplace(shown, std::move(out)).first->second;
}

}  // namespace stig::recheck
