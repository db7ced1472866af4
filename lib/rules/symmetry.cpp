// SPDX-License-Identifier: MIT
#include "rules/symmetry.h"

#include <cassert>

namespace stig {
namespace {

/// a after b.
Orientation compose(const Orientation& a, const Orientation& b) {
  Orientation c;
  c.xx = a.xx * b.xx + a.xy * b.yx;
  c.xy = a.xx * b.xy + a.xy * b.yy;
  c.yx = a.yx * b.xx + a.yy * b.yx;
  c.yy = a.yx * b.xy + a.yy * b.yy;
  c.zz = a.zz * b.zz;
  return c;
}

Orientation quarter_or_sixth_turn(Lattice lattice) {
  Orientation turn;
  turn.xx = 0;
  turn.xy = -1;
  turn.yx = 1;
  turn.yy = lattice == Lattice::cubic ? 0 : 1;
  return turn;
}

Orientation mirror(Lattice lattice) {
  Orientation m;
  m.xx = -1;
  m.xy = lattice == Lattice::cubic ? 0 : -1;
  return m;
}

void finish(Orientation& g, const Neighbourhood& n, std::string name) {
  for (int i = 0; i < n.size; ++i) {
    const int image = n.index_of(g.apply(n.offsets[static_cast<std::size_t>(i)]));
    assert(image >= 0);
    g.image[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(image);
  }
  g.name = std::move(name);
}

}  // namespace

std::vector<Orientation> orientations(Lattice lattice, Symmetry symmetry, bool inversion) {
  const Neighbourhood& n = neighbourhood(lattice);
  const int turns = symmetry == Symmetry::none ? 1 : lattice == Lattice::cubic ? 4 : 6;
  const int mirrors = symmetry == Symmetry::rotations_mirrors ? 2 : 1;
  std::vector<Orientation> group;
  for (int flip = 0; flip < (inversion ? 2 : 1); ++flip) {
    for (int mirrored = 0; mirrored < mirrors; ++mirrored) {
      Orientation g = mirrored ? mirror(lattice) : Orientation{};
      for (int turn = 0; turn < turns; ++turn) {
        g.zz = flip ? -1 : 1;
        std::string name = std::to_string(turn * (lattice == Lattice::cubic ? 90 : 60)) + "°";
        if (mirrored) name = "mirrored " + name;
        if (flip) name += " upside down";
        finish(g, n, std::move(name));
        group.push_back(g);
        g = compose(quarter_or_sixth_turn(lattice), g);
      }
    }
  }
  return group;
}

std::string_view to_string(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::none:
      return "none";
    case Symmetry::rotations:
      return "rotations";
    case Symmetry::rotations_mirrors:
      return "rotations+mirrors";
  }
  assert(false);
  return "";
}

}  // namespace stig
