// SPDX-License-Identifier: MIT
// What a robot knows of the cells around a column when it has looked from every place that the
// certificate names.
//
// The camera's rule: a tag is read when its middle and corners are in the picture, not nearer or
// farther than the camera sees, not too oblique, and with nothing before them; a brick's colour is
// known when enough of the LEDs around such a tag are seen too. A cell is known to be empty when
// the tag of a brick there would be read, or when the top of the brick below is. Two margins are
// given away, as robots do: 2 % of the picture's width at each edge, and 5° of the angle.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "recheck/figures.h"
#include "recheck/uses.h"
#include "recheck/work_certificate.h"

namespace stig::recheck {

inline constexpr std::int8_t kNotKnown = -1;

class View {
 public:
  View(const Figures& robot, const std::vector<WorkLook>& looks, int levels);

  int levels() const { return levels_; }
  /// Cells that a look can depend on.
  const std::vector<NearCell>& cells() const { return cells_; }
  /// By window(): kNotKnown, 0 or a colour, when the cells show this: 0 or a colour each.
  const std::vector<std::int8_t>& known(const std::string& shown);
  /// The place of a cell next to the column, or of its own, in what is known; -1 for others.
  int window(const NearCell& cell) const;

 private:
  /// A tag and what would hide it or its LEDs, as numbers of cells.
  struct Tag {
    NearCell of;
    bool on_top = false;
    std::vector<std::uint32_t> before_tag;
    std::vector<std::vector<std::uint32_t>> before_led;
  };
  class Camera;
  void add_tags(const Camera& camera);

  int levels_ = 0;
  int leds_needed_ = 1;
  std::vector<NearCell> cells_;
  std::vector<std::uint32_t> own_;  ///< number in cells_ by window()
  std::vector<Tag> tags_;
  std::unordered_map<std::string, std::vector<std::int8_t>> met_;
};

}  // namespace stig::recheck
