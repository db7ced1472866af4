// SPDX-License-Identifier: MIT
// What a robot learns of a structure by standing before one of its columns and looking.
//
// It stands aligned with the column's row, at a few distances, and moves the lift, and with it
// the camera, up and down. The tag of a face is seen by the cameras' rule (angle, four corners in
// the image, near and far, nothing before a corner). A brick is seen when the tag of one of its
// faces is, and enough of that face's LEDs, which tell its kind: with a tag alone it counts as
// unseen. A cell is seen to be empty when a tag of a brick there would be seen, or when the tag on
// top of the brick below it is, lit or not. Points within two per cent of the image's width of
// its edge do not count, since a robot stands a little off.
//
// The window around the column has the cells one step before, behind and beside it, at every
// level that the robot can build on and the one above.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "compiler/approach.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// What is known of one cell.
enum : std::uint8_t { kUnseen = 0, kSeenEmpty = 1, kSeenBrick = 2 };  ///< then colour + 2

/// A cell relative to a column: du towards the robot, dv to its left, z from the floor.
struct WindowCell {
  int du = 0, dv = 0, z = 0;
  auto operator<=>(const WindowCell&) const = default;
};

struct Observation {
  std::vector<std::uint8_t> cells;  ///< by window_index; kUnseen, kSeenEmpty or 2 + colour
  /// Not seen, but known from the robot's own turns since it began; none where it is not to count.
  std::optional<ApproachSide> side;
  bool operator==(const Observation&) const = default;
};

/// No cell farther from a column than so many steps, along or across, matters to what is seen.
inline constexpr int kFarthestSeen = 4;

inline constexpr int kWindowColumns = 9;
inline std::size_t window_index(const WindowCell& c) {
  return static_cast<std::size_t>(c.z * kWindowColumns + (c.du + 1) * 3 + (c.dv + 1));
}
WindowCell window_cell(std::size_t index);

/// A camera at a distance from the column's face, the lift at a height; m.
struct Viewpoint {
  double distance = 0, lift = 0;
};

/// A set of the cells around a column.
using CellWords = std::vector<std::uint64_t>;

/// A face's tag in a camera's view, were there a brick in the cell: what would stand before it.
struct TagLook {
  std::size_t cell = 0;  ///< by window_index
  bool on_top = false;
  CellWords hides_tag;               ///< or a corner of it
  std::vector<CellWords> hides_led;  ///< by LED in view
};

/// What can be seen of a column, by which of the cells around it are filled: bricks hide each
/// other whatever their colours are. Working it out takes long, so it is kept; whoever looks at
/// many colourings of a structure shares one of these.
class Visibility {
 public:
  /// `levels` of the window.
  Visibility(const Abilities& robot, int levels);

  /// What each viewpoint shows of the column in the middle of what is filled, '\0' or anything else
  /// a cell: kUnseen, kSeenEmpty or kSeenBrick by window_index.
  const std::vector<Observation>& of(const std::string& filled);
  int levels() const { return levels_; }
  const std::vector<Viewpoint>& viewpoints() const { return viewpoints_; }
  /// The window, and all around it that can hide some of it.
  std::vector<WindowCell> cells_that_matter() const;

 private:
  template <class Camera>
  void add_looks(const Camera& shot);
  Observation observe(const std::string& filled, const std::vector<TagLook>& looks) const;

  int levels_ = 0;
  int leds_needed_ = 1;  ///< of a face
  std::vector<Viewpoint> viewpoints_;
  std::vector<std::vector<TagLook>> looks_;  ///< by viewpoint
  std::unordered_map<std::string, std::vector<Observation>> known_;
};
/// Levels of the window for a target of so many.
int window_levels(const Abilities& robot, int target_levels);

class Sight {
 public:
  /// The target must outlive it.
  Sight(const TargetBricks& target, const Abilities& robot);
  Sight(const TargetBricks& target, std::shared_ptr<Visibility> visibility);

  /// What is seen of the column (u, v) from this side.
  const Observation& look(const BrickSet& state, ApproachSide side, int u, int v);
  /// The same from each of viewpoints() alone.
  const std::vector<Observation>& look_from_each(const BrickSet& state, ApproachSide side, int u,
                                                 int v);
  int levels() const { return visibility_->levels(); }
  std::vector<WindowCell> cells_that_matter() const { return visibility_->cells_that_matter(); }
  const std::vector<Viewpoint>& viewpoints() const { return visibility_->viewpoints(); }

 private:
  /// What stands around a column, and what is seen of it.
  struct Seen {
    std::vector<Observation> from;  ///< by viewpoint
    Observation all;
  };
  const Seen& seen(const BrickSet& state, ApproachSide side, int u, int v);
  /// Bricks of the target around a column, each with its place in the text of what stands there.
  using Around = std::vector<std::pair<std::uint16_t, std::uint32_t>>;
  const Around& around_column(ApproachSide side, int u, int v);
  Seen coloured(const std::string& around);

  const TargetBricks* target_;
  std::shared_ptr<Visibility> visibility_;
  std::unordered_map<std::string, Seen> known_;  ///< by what stands around the column
  std::array<std::map<std::pair<int, int>, Around>, kAllSides.size()> around_;  ///< by (u, v)
};

/// The level of the highest brick of the column itself, the one below its first empty cell,
/// and its colour, when they are known.
struct ColumnTop {
  int level = 0;
  Colour colour = 0;
};
std::optional<ColumnTop> column_top(const Observation& seen);

}  // namespace stig::compiler
