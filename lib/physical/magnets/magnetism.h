// SPDX-License-Identifier: MIT
// Magnets as point dipoles (Thomaszewski et al. 2008, "Magnets in motion"), and free
// spherical magnets that turn towards the local field.
//
// Moments are in A·m². The paper on stigmergic blocks (Allwright et al. 2017) gives its
// magnets a "field" of 75 in units of its own; kMomentPerField of
// robots/block.h translates.
//
// A sphere of 3 mm that faces another at contact swings with a period of some 3.5 ms.
// Integrating that needs steps far below a millisecond, and the bearings' friction, which
// nobody knows, decides how the swing ends. So free spheres are quasi-static by default:
// their directions relax towards the field (relax_magnets), forces act on the blocks, and
// the spheres' torque is lost in their bearings. The integrated swing (spin_magnets) is
// there to hold this against.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace stig::physics {

/// μ0 / 4π, in N/A².
inline constexpr double kDipoleConstant = 1e-7;

/// What one dipole does to another; the other feels -force, and `torque_on_other`.
struct DipoleWrench {
  Vec3 force;            ///< N
  Vec3 torque;           ///< N·m, about the dipole's own centre
  Vec3 torque_on_other;  ///< N·m, about the other's
};

/// Dipole m0 at r = p0 - p1 from dipole m1; |r| > 0.
DipoleWrench dipole_wrench(const Vec3& m0, const Vec3& m1, const Vec3& r);
/// Field in tesla at r from dipole m1.
Vec3 dipole_field(const Vec3& m1, const Vec3& r);
/// Potential energy of the pair, J: zero far apart, lowest when aligned.
double dipole_energy(const Vec3& m0, const Vec3& m1, const Vec3& r);

/// A magnet of a body: `owner` numbers the body; magnets of one body ignore each other.
struct Magnet {
  std::uint32_t owner = 0;
  bool free = true;     ///< turns towards the field; otherwise its direction is given
  Vec3 p_W;             ///< m
  Vec3 direction;       ///< unit, world frame
  double moment = 0.2;  ///< A·m², negative: reversed
  Vec3 spin{};          ///< rad/s, world frame; of a free one that is integrated
};

/// Two magnets of different owners within the cut-off, i < j.
struct MagnetPair {
  std::uint32_t i, j;
  Vec3 r;  ///< from j to i, m
};

/// Magnets that one body owns: [begin, end) of the list, in a ball about `centre`. Owners
/// stand in the order of their magnets.
struct MagnetOwner {
  std::uint32_t begin = 0, end = 0;
  Vec3 centre;
  bool awake = true;
};

/// All pairs nearer than `cutoff` in which at least one owner is awake, in rising order of
/// (owner of i, owner of j, i, j).
/// Owners are found in a grid of cells of cut-off + 2 `radius`, the largest distance of a
/// magnet from its owner's centre.
std::vector<MagnetPair> magnet_pairs(const std::vector<Magnet>& magnets,
                                     const std::vector<MagnetOwner>& owners, double radius,
                                     double cutoff);

struct Relaxation {
  double time = 0.003;  ///< s, of the exponential approach to the field's direction
  int sweeps = 2;       ///< a step
};

/// Free magnets of awake owners turn towards the field of those they are paired with, one
/// after the other (in Jacobi order, all at once, two of them can flip for ever). A magnet
/// that points exactly against the field is nudged first.
void relax_magnets(std::vector<Magnet>& magnets, const std::vector<MagnetPair>& pairs,
                   const std::vector<MagnetOwner>& owners, double dt, const Relaxation& relaxation);

/// A sphere's ball joint.
struct Bearing {
  double inertia = 3.6e-9;  ///< kg m², of the sphere about its centre
  double damping = 0;       ///< N·m·s: torque for a difference of spins of 1 rad/s
};

/// Turns one free magnet for a step under a torque (N·m), by symplectic Euler; friction is
/// implicit, against a body with that spin. Returns the torque of friction on the body.
///
/// This is the nine-body block of the paper without its nine bodies, and exactly so: a ball
/// joint in a sphere's centre of mass passes on forces alone, so the block moves as if the
/// sphere were a point of its mass there; and a sphere's moments are equal, so it turns by
/// I dw/dt = T, whatever its place does.
Vec3 spin_magnet(Magnet& magnet, const Vec3& torque, const Vec3& body_spin, const Bearing& bearing,
                 double dt);

}  // namespace stig::physics
