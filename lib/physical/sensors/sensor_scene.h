// SPDX-License-Identifier: MIT
// What sensors can perceive of a world at one moment: plain data that the caller fills from
// wherever bodies are, and the indices that make asking cheap. Sensors know nothing else of
// the world.
//
// Things of one block or robot share an `owner`: a tag is not hidden by its own block, a
// rangefinder does not see its own robot. Shapes and kinds are made once; obstacles and marked
// bodies are written anew each tick.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"
#include "physical/sensors/place_index.h"
#include "physical/sensors/sight_shape.h"
#include "physical/sensors/uses.h"

namespace stig::physics {

/// A square tag; its frame as in sensing/tag_pose.h.
struct TagMark {
  int id = 0;
  Pose X_BT;
  double side = 0;    ///< m
  double widest = 0;  ///< rad, between its normal and the line to a camera that reads it
};

struct LedMark {
  Vec3 p_B, normal_B;
  double widest = 0;  ///< rad; pi: it shines all around
};

/// What all bodies of one kind bear.
struct MarkedKind {
  std::vector<TagMark> tags;
  std::vector<LedMark> leds;
  double reach = 0;  ///< m, from the body's origin to its farthest mark; set by finish_kind
};
MarkedKind finish_kind(MarkedKind kind);

/// The same marks on each face of a cube: a tag in the middle and four LEDs about it.
struct FaceMarks {
  double cube_side = 0.055;
  double tag_side = 0.024, tag_proud = 0.001;  ///< m
  double led_offset = 0.02;                    ///< m, from the face's middle
  double tag_widest = 0, led_widest = 0;       ///< rad
};
/// Faces in the order of the block's radios: +x (north), -y (east), -x, +y, +z (top), -z. On the
/// four sides a tag's y is the block's z; on top its x is the block's x, and so below. LEDs of a
/// face: to the right, above, left, below. Tags are numbered by face. A side or offset of 0: none
/// of them.
MarkedKind cube_marks(const FaceMarks& marks);

struct SightObstacle {
  std::uint32_t shape = 0;  ///< place in SensorScene::shapes
  std::uint32_t owner = 0;
  Pose X_WS;
};

struct MarkedBody {
  std::uint32_t kind = 0;  ///< place in SensorScene::kinds
  std::uint32_t owner = 0;
  Pose X_WB;
  std::vector<Rgb> leds;  ///< black is unlit; missing ones too
};

struct SensorScene {
  bool floor = true;  ///< z = 0, which rangefinders see
  std::vector<SightShape> shapes;
  std::vector<MarkedKind> kinds;
  std::vector<SightObstacle> obstacles;
  std::vector<MarkedBody> marked;
};

/// An index of the scene at one moment. It refers to the scene, which must not change meanwhile;
/// any number of threads may ask.
struct SensorIndex {
  explicit SensorIndex(const SensorScene& scene_now);

  const SensorScene& scene;
  std::vector<Mat3> axes;  ///< of the obstacles
  PlaceIndex obstacles, marked;
};

}  // namespace stig::physics
