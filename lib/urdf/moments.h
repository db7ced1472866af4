// SPDX-License-Identifier: MIT
// Moments of inertia, and links as bodies of robot files.
//
// A body there is a solid whose middle is that of its mass, with moments along its own axes. A link
// may have its middle of mass anywhere, and products of inertia. Where it has one solid that fits,
// it is one body. Otherwise its mass is that of a cube of 2 mm in the middle of mass, along the
// principal axes, and its solids, fixed to that, have a billionth of the mass each; the cube's
// moments are what these leave. Bodies that are fixed to each other are simulated as one, so mass,
// middle and moments of the whole are those of the link.
#pragma once

#include <string>
#include <vector>

#include "urdf/description.h"
#include "urdf/uses.h"

namespace stig::urdf {

/// Files have few digits: by this share moments and axes may be off.
inline constexpr double kMomentSlack = 1e-4;

/// The tensor is rotated_diagonal(matrix(q), moments).
struct Principal {
  Vec3 moments;
  Quat q;
};
/// By Jacobi's rotations. The tensor is symmetric.
Principal principal_moments(const Mat3& tensor);
/// R t R^T.
Mat3 turned_tensor(const Quat& q, const Mat3& tensor);

struct Piece {
  std::string name;
  Solid solid;  ///< where it is: in X_LB
  double mass = 0;
  Vec3 moments;
  Pose X_LB;            ///< of its middle
  bool kernel = false;  ///< a cube that stands for the mass
};

/// The first is called as the link is, the others "LINK shape 1" and so on.
std::vector<Piece> pieces_of(const Link& link, const Reading& reading);

}  // namespace stig::urdf
