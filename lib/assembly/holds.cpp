// SPDX-License-Identifier: MIT
// Bricks are numbered as a search in depth meets them (J. Hopcroft and R. Tarjan 1973). What is met
// by way of one brick, and from where no face leads back past it, is a part beyond it.
#include "assembly/holds.h"

#include <algorithm>
#include <cassert>

#include "assembly/faces.h"

namespace stig::assembly {

namespace {

class Search {
 public:
  explicit Search(const TargetBricks& target)
      : target_(target), number_(target.bricks(), kNew), low_(target.bricks(), 0) {
    out_.beyond.resize(target.bricks());
  }

  Parts from(std::uint32_t root) {
    enter(root);
    // Without recursion: paths may be as long as there are bricks.
    while (!way_.empty()) {
      Step& step = way_.back();
      if (step.next < kFaces.size()) {
        const Cell beside = target_.cell(step.brick) + kFaces[step.next++];
        look(step.brick, target_.brick_at(beside));
        continue;
      }
      const std::uint32_t done = step.brick;
      way_.pop_back();
      if (!way_.empty()) leave(done, way_.back().brick);
    }
    return std::move(out_);
  }

 private:
  static constexpr std::uint32_t kNew = ~std::uint32_t{0};
  struct Step {
    std::uint32_t brick = 0;
    std::size_t next = 0;  ///< face to go on with
  };

  std::uint32_t met() const { return static_cast<std::uint32_t>(out_.order.size()); }

  void enter(std::uint32_t brick) {
    number_[brick] = low_[brick] = met();
    out_.order.push_back(brick);
    way_.push_back({brick});
  }

  void look(std::uint32_t brick, std::uint32_t other) {
    if (other == TargetBricks::kNone) return;
    if (number_[other] == kNew) {
      enter(other);
    } else {
      low_[brick] = std::min(low_[brick], number_[other]);
    }
  }

  void leave(std::uint32_t done, std::uint32_t before) {
    low_[before] = std::min(low_[before], low_[done]);
    if (low_[done] >= number_[before]) out_.beyond[before].emplace_back(number_[done], met());
  }

  const TargetBricks& target_;
  Parts out_;
  std::vector<std::uint32_t> number_, low_;  ///< by brick: its own, and the least it leads back to
  std::vector<Step> way_;
};

}  // namespace

Parts parts_from(const TargetBricks& target, std::uint32_t root) {
  assert(root < target.bricks());
  return Search(target).from(root);
}

}  // namespace stig::assembly
