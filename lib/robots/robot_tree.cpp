// SPDX-License-Identifier: MIT
// Joints make a tree of all bodies: no body has two parents or carries itself, none is apart.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/text.h"
#include "robots/robot_parts.h"

namespace stig::robots {

namespace {

class Tree {
 public:
  explicit Tree(const RobotParts& parts) : parts_(parts), above_(bodies().size()) {}

  void check() {
    // A joint whose body is unknown leaves gaps in the tree: then bodies that seem apart may well
    // be joined by it, and nothing is said of them.
    for (const JointModel& joint : parts_.model.joints) {
      if (joint.parent == kNoBody || joint.child == kNoBody) {
        whole_ = false;
      } else {
        add(joint);
      }
    }
    for (std::size_t body = 0; body < above_.size(); ++body) check_cycle(body);
    if (whole_) check_apart();
  }

 private:
  const std::vector<BodyModel>& bodies() const { return parts_.model.bodies; }
  std::string name(std::size_t body) const { return in_quotes(bodies()[body].name); }

  void add(const JointModel& joint) {
    // The first joint that carries a body keeps it, so that further messages refer to that one.
    const JointModel*& above = above_[joint.child];
    if (above != nullptr) {
      whole_ = false;
      parts_.out
          .add(Code::P605, joint.place,
               fmt::format("the body {} has two parents, {} and {}", name(joint.child),
                           name(above->parent), name(joint.parent)))
          .note(above->place, "its other joint is here");
    } else {
      above = &joint;
    }
  }

  /// Reports a cycle at the body of it that comes first in the file.
  void check_cycle(std::size_t first) {
    assert(first < above_.size());
    std::string path = name(first);
    std::size_t body = first;
    // Follows parents upwards, at most as many steps as there are bodies: a path into a cycle that
    // does not hold `first` would never end.
    for (std::size_t steps = 0; above_[body] != nullptr && steps < above_.size(); ++steps) {
      body = above_[body]->parent;
      path += " on " + name(body);
      // A body of the cycle with a lower number has reported it, or will be found from there.
      if (body < first) return;
      if (body == first) {
        whole_ = false;
        parts_.out.add(Code::P606, above_[first]->place,
                       fmt::format("the joints go in a circle: {}", path));
        return;
      }
    }
  }

  /// The bodies that no joint carries, besides the first.
  void check_apart() {
    const std::size_t root = parts_.model.root();
    for (std::size_t body = 0; body < above_.size(); ++body) {
      if (above_[body] != nullptr || body == root || is_second(body)) continue;
      parts_.out.add(
          Code::P607, bodies()[body].place,
          fmt::format("the body {} is joined to nothing that leads to {}", name(body), name(root)));
    }
  }

  /// Is it the second of its name, which joints could not mean? Reported already.
  bool is_second(std::size_t body) const {
    return std::any_of(bodies().begin(), bodies().begin() + static_cast<std::ptrdiff_t>(body),
                       [&](const BodyModel& one) { return one.name == bodies()[body].name; });
  }

  const RobotParts& parts_;
  std::vector<const JointModel*> above_;  ///< the joint that carries a body
  bool whole_ = true;                     ///< every joint could be followed
};

}  // namespace

void check_tree(const RobotParts& parts) { Tree(parts).check(); }

}  // namespace stig::robots
