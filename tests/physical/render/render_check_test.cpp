// SPDX-License-Identifier: MIT
// The simulated camera against a real reader of tags: pictures of tag36h11 are drawn as the
// camera takes them, libapriltag reads them, and both must tell the same. Seen with the exact
// rules alone: libapriltag has limits of its own where a tag's cells become as small as pixels.
#if STIG_WITH_APRILTAG
#include <doctest/doctest.h>

extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/apriltag_pose.h>
#include <apriltag/tag36h11.h>
}

#include <algorithm>
#include <cstdlib>

#include "base/random.h"
#include "physical/render/sensor_picture.h"
#include "physical/sensors/sensor_support.h"
#include "sensing/led_colour.h"
#include "sensing/tag_pose.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr double kTagSide = 0.024;
constexpr double kSheet = kTagSide * 10 / 8;  ///< with the white border of one cell

struct Detection {
  int id = 0;
  std::array<ImagePoint, 4> corners;
  Pose X_CT;  ///< by libapriltag
};

/// Detector and family, and what they have read.
class Reader {
 public:
  Reader() : family_(tag36h11_create()), detector_(apriltag_detector_create()) {
    apriltag_detector_add_family(detector_, family_);
    detector_->quad_decimate = 1;
  }
  ~Reader() {
    apriltag_detector_destroy(detector_);
    tag36h11_destroy(family_);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  TagCells cells(int id) const {
    image_u8_t* image = apriltag_to_image(family_, id);
    REQUIRE(image->width == 10);
    TagCells out{};
    for (int y = 0; y < 10; ++y) {
      for (int x = 0; x < 10; ++x) out[std::size_t(y * 10 + x)] = image->buf[y * image->stride + x];
    }
    image_u8_destroy(image);
    return out;
  }

  std::vector<Detection> read(const CameraPicture& picture, const CameraIntrinsics& camera) {
    image_u8_t* image = image_u8_create(unsigned(picture.width), unsigned(picture.height));
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        image->buf[y * image->stride + x] = std::uint8_t(std::lround(picture.grey(x, y)));
      }
    }
    zarray_t* found = apriltag_detector_detect(detector_, image);
    std::vector<Detection> out;
    for (int i = 0; i < zarray_size(found); ++i) {
      apriltag_detection_t* d = nullptr;
      zarray_get(found, i, &d);
      out.push_back(detection(*d, camera));
    }
    apriltag_detections_destroy(found);
    image_u8_destroy(image);
    return out;
  }

 private:
  /// Its pixels have whole numbers at their corners, OpenCV's in their middles. Its tags have
  /// y down and z away from the viewer.
  static Detection detection(apriltag_detection_t& d, const CameraIntrinsics& camera) {
    Detection out{d.id, {}, {}};
    for (std::size_t i = 0; i < 4; ++i) out.corners[i] = {d.p[i][0] - 0.5, d.p[i][1] - 0.5};
    apriltag_detection_info_t info{&d,        kTagSide,        camera.fx,
                                   camera.fy, camera.cx + 0.5, camera.cy + 0.5};
    apriltag_pose_t pose{};
    estimate_tag_pose(&info, &pose);
    const auto column = [&](unsigned j) {
      return Vec3{MATD_EL(pose.R, 0, j), MATD_EL(pose.R, 1, j), MATD_EL(pose.R, 2, j)};
    };
    out.X_CT.q = quaternion_of({column(0), -column(1), -column(2)});
    out.X_CT.p = {MATD_EL(pose.t, 0, 0), MATD_EL(pose.t, 1, 0), MATD_EL(pose.t, 2, 0)};
    std::free(pose.R);  // Debian's library keeps matd_destroy to itself; it is free()
    std::free(pose.t);
    return out;
  }

  apriltag_family_t* family_;
  apriltag_detector_t* detector_;
};

CameraPicture tag_picture(const Reader& reader, const CameraIntrinsics& camera, int id,
                          const Pose& X_CT) {
  CameraPicture picture(camera, {128, 128, 128});
  std::vector<ImagePoint> around;
  for (const Vec3& p : tag_corners(kSheet)) around.push_back(*project(camera, X_CT * p));
  const auto cells = reader.cells(id);
  paint(picture, camera, box_about(picture, around), 4, [&](const Vec3& way, const Vec3& ground) {
    return sheet_colour(cells, kTagSide, meet_plane(X_CT, way)).value_or(ground);
  });
  return picture;
}

double distance(const ImagePoint& a, const ImagePoint& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}
double corner_error(const std::array<ImagePoint, 4>& a, const std::array<ImagePoint, 4>& b) {
  double most = 0;
  for (std::size_t i = 0; i < 4; ++i) most = std::max(most, distance(a[i], b[i]));
  return most;
}

struct Tally {
  int seen = 0, read = 0;
  double worst_corner = 0, sum_corner = 0, worst_place = 0, worst_turn = 0;
};

/// Random views with tilts in this range, through the rules and through pixels.
Tally compare(Reader& reader, CameraView view, double least_tilt, double most_tilt, int views,
              std::uint32_t stream) {
  Tally tally;
  for (int i = 0; i < views; ++i) {
    Random random(1, 0, Purpose::test, stream, std::uint64_t(i));
    const auto in = [&](double low, double high) { return low + (high - low) * random.unit(); };
    const int id = int(random.below(587));
    const double z = in(0.07, 0.5), tilt = in(least_tilt, most_tilt), axis = in(0, 6.28);
    const Vec3 p{in(-0.3, 0.3) * z, in(-0.14, 0.14) * z, z};
    const Quat q = kFacing * rotation(Vec3{std::cos(axis), std::sin(axis), 0} * tilt) *
                   rotation({0, 0, in(0, 6.28)});
    SensorScene scene = one_tag({p, q}, kTagSide, 75 * kDegree);
    scene.kinds[0].tags[0].id = id;
    const CameraSight sight = look(SensorIndex(scene), view, {});
    const CameraReading told = read_camera(scene, sight, view, {}, {});
    const auto found =
        reader.read(tag_picture(reader, view.intrinsics, id, {p, q}), view.intrinsics);
    if (told.tags.empty()) continue;
    ++tally.seen;
    CHECK(found.size() <= 1);
    if (found.empty()) continue;
    ++tally.read;
    CHECK(found[0].id == told.tags[0].id);
    const double error = corner_error(found[0].corners, told.tags[0].corners);
    tally.worst_corner = std::max(tally.worst_corner, error);
    tally.sum_corner += error;
    // From the same pixels both must find the same pose.
    const auto ours = estimate_tag_pose(view.intrinsics, found[0].corners, kTagSide);
    REQUIRE(ours);
    if (view.distorted) continue;  // which libapriltag knows nothing of
    const double turn = angle_of(conjugate(ours->X_CT.q) * found[0].X_CT.q);
    const double other = angle_of(conjugate(ours->X_CT_other.q) * found[0].X_CT.q);
    tally.worst_turn = std::max(tally.worst_turn, std::min(turn, other));
    tally.worst_place = std::max(tally.worst_place, length(ours->X_CT.p - found[0].X_CT.p) / z);
  }
  MESSAGE("tilt " << least_tilt / kDegree << " to " << most_tilt / kDegree << ": read "
                  << tally.read << " of " << tally.seen << ", corners "
                  << tally.sum_corner / tally.read << " px, at most " << tally.worst_corner
                  << "; place " << tally.worst_place << ", turn " << tally.worst_turn / kDegree);
  return tally;
}

/// As detect_led does it.
std::uint8_t colour_at(CameraPicture& picture, const ImagePoint& pixel) {
  LedWindow window(pixel);
  for (int y = int(pixel.y) - 4; y <= int(pixel.y) + 4; ++y) {
    for (int x = int(pixel.x) - 4; x <= int(pixel.x) + 4; ++x) {
      if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
      const Vec3& p = picture.at(x, y);
      window.add({double(x), double(y)},
                 to_yuv({std::uint8_t(p.x), std::uint8_t(p.y), std::uint8_t(p.z)}));
    }
  }
  return window.colour();
}

/// A heap of blocks in all colours before the camera, some hiding others.
SensorScene heap(Random& random, std::uint32_t blocks) {
  const auto in = [&](double low, double high) { return low + (high - low) * random.unit(); };
  SensorScene scene;
  for (std::uint32_t i = 0; i < blocks; ++i) {
    const Vec3 p{0.16 + 0.075 * (i % 4), 0.075 * (i / 4) - 0.11, 0.0275 + 0.055 * double(i % 2)};
    add_block(scene, {p, rotation({0, 0, in(-0.3, 0.3)})}, i + 1,
              led_rgb(std::uint8_t(1 + random.below(4))));
  }
  return scene;
}

struct SceneTally {
  std::size_t tags = 0, tags_read = 0, leds = 0, leds_right = 0, beyond = 0;
  double worst_corner = 0;
};

ImagePoint middle(const std::array<ImagePoint, 4>& c) {
  return {(c[0].x + c[1].x + c[2].x + c[3].x) / 4, (c[0].y + c[1].y + c[2].y + c[3].y) / 4};
}

/// Whether a tag was read that the rules leave out for a corner beside the image, whose edges
/// the reader prolongs, or for an angle beyond the limit.
bool is_beyond_limits(const Detection& d, const SensorScene& scene, const CameraView& view,
                      const Pose& X_WC) {
  for (const MarkedBody& m : scene.marked) {
    const TagMark& tag = scene.kinds[m.kind].tags[std::size_t(d.id)];
    const Pose X_CT = inverse(X_WC) * m.X_WB * tag.X_BT;
    const auto centre = project(view.intrinsics, X_CT.p);
    if (!centre || distance(*centre, middle(d.corners)) > 6) continue;
    const double cosine = -dot(rotate(X_CT.q, {0, 0, 1}), X_CT.p) / length(X_CT.p);
    if (cosine > 0 && cosine < std::cos(tag.widest)) return true;
    for (const Vec3& p : tag_corners(tag.side)) {
      if (!image_of(view, X_CT * p)) return true;
    }
  }
  return false;
}

void compare_scene(Reader& reader, const CameraView& view, std::uint64_t number,
                   SceneTally& tally) {
  Random random(2, 0, Purpose::test, 0, number);
  const SensorScene scene = heap(random, 16);
  const Pose X_WC = tilted_camera({0, 0.1 * random.unit() - 0.05, 0.27}, 0.4 * random.unit() - 0.2);
  const CameraSight sight = look(SensorIndex(scene), view, X_WC);
  CameraPicture picture = camera_picture(scene, view.intrinsics, X_WC, 2);
  const auto found = reader.read(picture, view.intrinsics);
  tally.tags += sight.tags.size();
  for (const Detection& d : found) {
    const auto told = std::find_if(sight.tags.begin(), sight.tags.end(), [&](const SeenTag& t) {
      return corner_error(d.corners, t.corners) < 3;
    });
    if (told == sight.tags.end()) {
      ++tally.beyond;
      CHECK(is_beyond_limits(d, scene, view, X_WC));
      continue;
    }
    ++tally.tags_read;
    CHECK(d.id == scene.kinds[0].tags[told->tag].id);
    tally.worst_corner = std::max(tally.worst_corner, corner_error(d.corners, told->corners));
  }
  for (const SeenLed& seen : sight.leds) {
    const Yuv light = to_yuv(scene.marked[seen.body].leds[seen.led]);
    ++tally.leds;
    if (colour_at(picture, seen.pixel) == classify_led(light.u, light.v)) ++tally.leds_right;
  }
}

}  // namespace

TEST_CASE("the tags of blocks are those of tag36h11") {
  const Reader reader;
  for (int id = 0; id < 6; ++id) CHECK(tag_cells(id) == reader.cells(id));
}

TEST_CASE("libapriltag reads from pictures what the simulated camera tells") {
  Reader reader;
  const Tally near = compare(reader, paper_view(), 0, 60 * kDegree, 60, 1);
  CHECK(near.seen > 40);
  CHECK(near.read == near.seen);
  CHECK(near.worst_corner < 0.5);
  CHECK(near.worst_place < 0.005);  // of the distance
  CHECK(near.worst_turn < 3 * kDegree);
  const Tally steep = compare(reader, paper_view(), 60 * kDegree, 75 * kDegree, 40, 2);
  CHECK(steep.seen > 15);
  CHECK(steep.read >= steep.seen - 1);
  CHECK(steep.worst_corner < 0.5);
}

TEST_CASE("through a lens that distorts, too") {
  Reader reader;
  CameraIntrinsics bent = paper_view().intrinsics;
  bent.k1 = -0.25;
  bent.k2 = 0.1;
  bent.p1 = 0.003;
  const Tally tally = compare(reader, *make_view(bent, 0.05, 0.5), 0, 60 * kDegree, 40, 3);
  CHECK(tally.read == tally.seen);
  // The reader takes the bent edges of near tags for straight.
  CHECK(tally.worst_corner < 0.75);
}

TEST_CASE("in a heap of blocks the picture shows the tags and colours that are told") {
  Reader reader;
  SceneTally tally;
  // So far that the rules' reach is not what makes them differ.
  const CameraView view = *make_view(paper_view().intrinsics, 0.05, 2);
  for (std::uint64_t i = 0; i < 4; ++i) compare_scene(reader, view, i, tally);
  MESSAGE("tags " << tally.tags_read << " of " << tally.tags << ", beyond the limits "
                  << tally.beyond << ", corners at most " << tally.worst_corner << " px; LEDs "
                  << tally.leds_right << " of " << tally.leds);
  CHECK(tally.tags > 15);
  CHECK(tally.tags_read * 10 >= tally.tags * 9);
  CHECK(tally.worst_corner < 0.75);
  CHECK(tally.leds > 60);
  CHECK(tally.leds_right * 50 >= tally.leds * 49);
}
#endif
