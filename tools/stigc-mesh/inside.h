// SPDX-License-Identifier: MIT
// How often closed surfaces go round a place: the sign of every decision is exact for the numbers
// that the model has.
#pragma once

#include <memory>

#include "model.h"

namespace stig::meshes {

class Inside {
 public:
  /// The model must outlive it.
  explicit Inside(const Model& model);
  ~Inside();
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

  /// The winding number: 0 outside, 1 in a solid, more where solids overlap; a place on a surface
  /// counts as in it.
  int winding(const Point& place) const;
  /// Whether a surface passes through the box, or touches it.
  bool touches(const Point& low, const Point& high) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace stig::meshes
