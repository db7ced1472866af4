// SPDX-License-Identifier: MIT
// The slow and sure way to a camera's picture, line of sight by line of sight, which tests compare
// with what read_camera says and with a real detector of tags. Lines are cut with every shape that
// may lie in their way; tiles keep that number small.
#include "physical/render/sensor_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

namespace stig::physics {

namespace {

// Small enough that few bodies fall into a tile's cone, large enough that finding them pays.
constexpr int kTile = 16;             ///< pixels
constexpr double kLedRadius = 0.002;  ///< m
constexpr Vec3 kSky{200, 205, 210}, kFloor{150, 150, 145}, kHousing{40, 40, 40},
    kBody{150, 155, 165};
constexpr Vec3 kSheetLight{230, 230, 230}, kSheetDark{25, 25, 25};

/// The 6 x 6 inner cells of the first tags of the family tag36h11 (Olson 2011, "AprilTag"), row by
/// row, the highest bit first, as its published tables have them.
constexpr std::array<std::uint64_t, 6> kTags = {0xd5d628584, 0xd97f18b49, 0xdd280910e,
                                                0xe479e9c98, 0xebcbca822, 0xf31dab3ac};

/// The normal of the face of a hull that a point of its surface lies in.
Vec3 hull_normal(const SightShape& hull, const Vec3& p) {
  const auto above = [&p](const HalfSpace& h) { return dot(h.normal, p) - h.offset; };
  const auto face =
      std::max_element(hull.planes.begin(), hull.planes.end(),
                       [&](const HalfSpace& a, const HalfSpace& b) { return above(a) < above(b); });
  return face->normal;
}

/// Unit, outwards, at a point of the shape's surface.
Vec3 normal_at(const SightShape& shape, const Vec3& p) {
  if (shape.type == ShapeType::sphere) return p * (1 / shape.half.x);
  if (shape.type == ShapeType::hull) return hull_normal(shape, p);
  const Vec3 share{std::abs(p.x) / shape.half.x, std::abs(p.y) / shape.half.y,
                   std::abs(p.z) / shape.half.z};
  if (shape.type == ShapeType::cylinder && std::hypot(share.x, share.y) >= share.z) {
    return normalised(Vec3{p.x, p.y, 0});
  }
  if (shape.type == ShapeType::cylinder) return {0, 0, p.z < 0 ? -1.0 : 1.0};
  if (share.x >= share.y && share.x >= share.z) return {p.x < 0 ? -1.0 : 1.0, 0, 0};
  if (share.y >= share.z) return {0, p.y < 0 ? -1.0 : 1.0, 0};
  return {0, 0, p.z < 0 ? -1.0 : 1.0};
}

/// Everything that bears on one line of sight, nearest first.
class ScenePainter {
 public:
  ScenePainter(const SensorScene& scene, const Pose& X_WC) : scene_(scene), X_WC_(X_WC) {
    std::set<std::uint32_t> blocks;
    // Marked bodies are drawn darker as housings, and then their tags and LEDs over them.
    for (const MarkedBody& one : scene.marked) blocks.insert(one.owner);
    for (const SightObstacle& one : scene.obstacles) {
      const Pose X_CS = inverse(X_WC) * one.X_WS;
      bodies_.push_back({&one, nullptr, X_CS, matrix(X_CS.q), inverse(X_CS).p,
                         length(scene.shapes[one.shape].half), blocks.contains(one.owner)});
    }
    for (const MarkedBody& one : scene.marked) {
      const Pose X_CB = inverse(X_WC) * one.X_WB;
      const MarkedKind& kind = scene.kinds[one.kind];
      bodies_.push_back({nullptr, &one, X_CB, matrix(X_CB.q), inverse(X_CB).p,
                         kind.reach + kLedRadius + longest_side(kind), true});
      for (const TagMark& tag : kind.tags) {
        if (tag.id >= static_cast<int>(cells_.size()) || tag.id < 0) continue;
        cells_[static_cast<std::size_t>(tag.id)] = tag_cells(tag.id);
      }
    }
  }

  /// Looks only at what may be seen from now on: within an angle about a direction.
  void look_towards(const Vec3& way, double angle) {
    near_.clear();
    // An object of a radius at a distance fills an angle of its own; one about the eye fills all.
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Vec3& p = bodies_[i].X_CB.p;
      const double far = length(p), cosine = far > 0 ? dot(p, way) / far : 1;
      const double about = far > bodies_[i].radius ? std::asin(bodies_[i].radius / far) : 4;
      if (std::acos(std::clamp(cosine, -1.0, 1.0)) <= angle + about) near_.push_back(i);
    }
  }

  Vec3 operator()(const Vec3& way, const Vec3& /*ground*/) const {
    Seen seen{INFINITY, kSky};
    if (scene_.floor) look_at_floor(way, seen);
    for (const std::size_t i : near_) {
      bodies_[i].obstacle != nullptr ? look_at_shape(bodies_[i], way, seen)
                                     : look_at_marks(bodies_[i], way, seen);
    }
    return seen.colour;
  }

 private:
  struct Body {
    const SightObstacle* obstacle;
    const MarkedBody* marks;
    Pose X_CB;
    Mat3 r_CB;
    Vec3 p_BC;
    double radius;  ///< m
    bool is_block;
  };
  struct Seen {
    double depth;
    Vec3 colour;

    // Depth counts in lengths of the direction, whose z is 1: depths as a camera has them.
    void note(double nearer, const Vec3& c) {
      if (nearer > 0 && nearer < depth) depth = nearer, colour = c;
    }
  };

  static double longest_side(const MarkedKind& kind) {
    double most = 0;
    for (const TagMark& tag : kind.tags) most = std::max(most, tag.side);
    return most;
  }

  void look_at_floor(const Vec3& way, Seen& seen) const {
    // Lines that rise never meet the floor.
    const double down = rotate(X_WC_.q, way).z;
    if (down < 0) seen.note(-X_WC_.p.z / down, kFloor);
  }

  void look_at_shape(const Body& body, const Vec3& way, Seen& seen) const {
    const SightShape& shape = scene_.shapes[body.obstacle->shape];
    const Vec3 direction = body.r_CB.transposed(way);
    const auto hit = cut(shape, body.p_BC, direction);
    if (!hit || hit->in <= 0 || hit->in >= seen.depth) return;
    const Vec3 normal = normal_at(shape, body.p_BC + direction * hit->in);
    // A lamp beside the eye: the flatter the view, the darker the surface.
    const double light = 0.55 + 0.45 * std::abs(dot(normal, direction)) / length(direction);
    seen.note(hit->in, (body.is_block ? kHousing : kBody) * light);
  }

  void look_at_marks(const Body& body, const Vec3& way, Seen& seen) const {
    const MarkedKind& kind = scene_.kinds[body.marks->kind];
    for (const TagMark& tag : kind.tags) {
      const Pose X_CT = body.X_CB * tag.X_BT;
      // Tags are seen from in front only.
      if (dot(rotate(X_CT.q, {0, 0, 1}), way) >= 0) continue;
      const PlaneHit hit = meet_plane(X_CT, way);
      if (hit.depth >= seen.depth) continue;
      const bool known = tag.id >= 0 && tag.id < static_cast<int>(cells_.size());
      // A tag whose number is not in the table is a white sheet: present, and unreadable.
      const TagCells& cells = known ? cells_[static_cast<std::size_t>(tag.id)] : kBlank;
      if (const auto colour = sheet_colour(cells, tag.side, hit)) seen.note(hit.depth, *colour);
    }
    const Vec3 direction = body.r_CB.transposed(way);
    for (std::size_t l = 0; l < std::min(kind.leds.size(), body.marks->leds.size()); ++l) {
      const LedMark& led = kind.leds[l];
      const Rgb rgb = body.marks->leds[l];
      const double along = dot(direction, led.normal_B);
      // The face's plane, as the LED lies in it.
      const double t = dot(led.p_B - body.p_BC, led.normal_B) / along;
      if (rgb == Rgb{} || along >= 0) continue;
      if (length(body.p_BC + direction * t - led.p_B) > kLedRadius) continue;
      // On the face, which is as far.
      seen.note(t - 1e-9, {double(rgb.r), double(rgb.g), double(rgb.b)});
    }
  }

  inline static const TagCells kBlank = tag_cells(-1);
  const SensorScene& scene_;
  Pose X_WC_;
  std::vector<Body> bodies_;
  std::array<TagCells, kTags.size()> cells_{};
  std::vector<std::size_t> near_;
};

/// The largest angle from the tile's middle to a corner; all round where the lens has no inverse.
double angle_about(const CameraIntrinsics& camera, const PixelBox& box, Vec3& middle) {
  // Any angle beyond π means "all bodies".
  const auto centre = unproject(camera, {(box.x0 + box.x1) / 2.0, (box.y0 + box.y1) / 2.0});
  if (!centre) return 4;
  middle = normalised(*centre);
  double most = 0;
  for (const double x : {box.x0 - 0.5, box.x1 + 0.5}) {
    for (const double y : {box.y0 - 0.5, box.y1 + 0.5}) {
      const auto corner = unproject(camera, {x, y});
      if (!corner) return 4;
      most = std::max(most, std::acos(std::min(1.0, dot(normalised(*corner), middle))));
    }
  }
  return most * 1.05;  // bent sides
}

}  // namespace

TagCells tag_cells(int id) {
  TagCells out;
  out.fill(true);
  if (id < 0 || id >= static_cast<int>(kTags.size())) return out;
  // The outermost ring is the white border, the next the black frame; 6 × 6 cells are within.
  for (std::size_t y = 1; y < 9; ++y) {
    for (std::size_t x = 1; x < 9; ++x) {
      const bool inner = x > 1 && x < 8 && y > 1 && y < 8;
      const std::size_t bit = inner ? 35 - ((y - 2) * 6 + x - 2) : 0;
      out[y * 10 + x] = inner && (kTags[static_cast<std::size_t>(id)] >> bit & 1) == 1;
    }
  }
  return out;
}

std::optional<Vec3> sheet_colour(const TagCells& cells, double side, const PlaneHit& hit) {
  const double sheet = side * 10 / 8;  // a tag is measured without its border
  const double column = (hit.x / sheet + 0.5) * 10, row = (0.5 - hit.y / sheet) * 10;
  if (hit.depth <= 0 || column < 0 || column >= 10 || row < 0 || row >= 10) return std::nullopt;
  const bool light =
      cells[static_cast<std::size_t>(static_cast<int>(row) * 10 + static_cast<int>(column))];
  return light ? kSheetLight : kSheetDark;
}

// Bent by the lens as everything is: lines of sight come from unproject.
CameraPicture camera_picture(const SensorScene& scene, const CameraIntrinsics& camera,
                             const Pose& X_WC, int samples) {
  assert(samples > 0);
  CameraPicture picture(camera, kSky);
  ScenePainter painter(scene, X_WC);
  for (int y = 0; y < picture.height; y += kTile) {
    for (int x = 0; x < picture.width; x += kTile) {
      const PixelBox box{x, y, std::min(x + kTile, picture.width) - 1,
                         std::min(y + kTile, picture.height) - 1};
      Vec3 middle;
      const double angle = angle_about(camera, box, middle);
      painter.look_towards(middle, angle);
      paint(picture, camera, box, samples, painter);
    }
  }
  return picture;
}

Image whole_numbers(const CameraPicture& picture) {
  Image out{picture.width, picture.height, {}};
  const auto whole = [](double x) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0, 255.0)));
  };
  for (const Vec3& p : picture.pixels) out.pixels.push_back({whole(p.x), whole(p.y), whole(p.z)});
  return out;
}

}  // namespace stig::physics
