// SPDX-License-Identifier: MIT
#include "voxelise.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "inside.h"

namespace stig::meshes {

namespace {

/// A box of cells, and where in the model each is.
struct Box {
  CellPlace size{};
  Point low{};                ///< of the grid, in the model
  std::array<int, 3> axes{};  ///< the model's axis that each of the grid's runs along
  bool down = false;
  double side = 1;

  std::size_t count() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
           static_cast<std::size_t>(size[2]);
  }
  std::size_t index(const CellPlace& c) const {
    return (static_cast<std::size_t>(c[2]) * static_cast<std::size_t>(size[1]) +
            static_cast<std::size_t>(c[1])) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(c[0]);
  }
  bool has(const CellPlace& c) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (c[k] < 0 || c[k] >= size[k]) return false;
    }
    return true;
  }
  /// The corner of a cell, `part` of a side from its lowest.
  Point place(const CellPlace& c, double part) const {
    Point out{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(axes[k]);
      // Counted from the other end where the axis points down.
      const double along = k == 2 && down ? size[2] - c[2] - part : c[k] + part;
      out[axis] = low[axis] + along * side;
    }
    return out;
  }
};

/// Of the lengths that a grid covers, as little more than the model's as whole cells allow.
int cells_along(double length, double side) {
  // A model whose length is a whole number of cells but for rounding takes that number.
  return std::max(1, static_cast<int>(std::ceil(length / side - 1e-6)));
}

std::optional<Box> box_of(const Model& model, const Grid& grid, std::string& problem) {
  Point low = model.points.front(), high = low;
  for (const Point& p : model.points) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  Box box;
  box.side = grid.side;
  box.down = grid.down;
  // A right-handed frame: x, y, z follow each other also when another axis points up. Turned over,
  // two axes are exchanged, so that the model is not mirrored.
  box.axes = {(grid.up + 1) % 3, (grid.up + 2) % 3, grid.up};
  if (grid.down) std::swap(box.axes[0], box.axes[1]);
  double all = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(box.axes[k]);
    all *= std::ceil((high[axis] - low[axis]) / grid.side) + 1;
  }
  if (!(all <= kMostCells)) {
    problem = "the box about the model has more than 2e7 cells of that side";
    return std::nullopt;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(box.axes[k]);
    const double length = high[axis] - low[axis];
    box.size[k] = cells_along(length, grid.side);
    const double spare = box.size[k] * grid.side - length;
    box.low[axis] = k < 2 ? low[axis] - spare / 2 : grid.down ? low[axis] - spare : low[axis];
  }
  return box;
}

template <class Visit>
void each_cell(const Box& box, Visit visit) {
  for (int z = 0; z < box.size[2]; ++z) {
    for (int y = 0; y < box.size[1]; ++y) {
      for (int x = 0; x < box.size[0]; ++x) visit(CellPlace{x, y, z});
    }
  }
}

std::vector<bool> filled_cells(const Inside& inside, const Box& box, Fill fill) {
  std::vector<bool> out(box.count());
  each_cell(box, [&](const CellPlace& c) {
    if (fill == Fill::solid) {
      out[box.index(c)] = inside.winding(box.place(c, 0.5)) > 0;
      return;
    }
    Point low = box.place(c, 0), high = box.place(c, 1);
    for (std::size_t k = 0; k < 3; ++k) {
      if (low[k] > high[k]) std::swap(low[k], high[k]);
    }
    out[box.index(c)] = inside.touches(low, high);
  });
  return out;
}

constexpr std::array<CellPlace, 6> kFaces{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

CellPlace moved(const CellPlace& c, const CellPlace& by) {
  return {c[0] + by[0], c[1] + by[1], c[2] + by[2]};
}

/// For each filled cell the number of its face-connected part from 1, and the parts' sizes.
std::vector<std::uint32_t> parts_of(const Box& box, const std::vector<bool>& filled,
                                    std::vector<std::size_t>& sizes) {
  std::vector<std::uint32_t> part(filled.size(), 0);
  sizes.assign(1, 0);
  each_cell(box, [&](const CellPlace& first) {
    if (!filled[box.index(first)] || part[box.index(first)] != 0) return;
    const auto number = static_cast<std::uint32_t>(sizes.size());
    sizes.push_back(0);
    std::deque<CellPlace> open{first};
    part[box.index(first)] = number;
    for (; !open.empty(); open.pop_front()) {
      ++sizes[number];
      for (const CellPlace& face : kFaces) {
        const CellPlace next = moved(open.front(), face);
        if (!box.has(next) || !filled[box.index(next)] || part[box.index(next)] != 0) continue;
        part[box.index(next)] = number;
        open.push_back(next);
      }
    }
  });
  return part;
}

/// Fills a way of one or two cells between parts that touch at an edge or a corner alone; the
/// number of cells.
std::size_t join_diagonals(const Box& box, std::vector<bool>& filled) {
  std::size_t joined = 0;
  for (bool more = true; more;) {
    more = false;
    std::vector<std::size_t> sizes;
    const std::vector<std::uint32_t> part = parts_of(box, filled, sizes);
    if (sizes.size() <= 2) break;
    each_cell(box, [&](const CellPlace& c) {
      if (more || !filled[box.index(c)]) return;
      for (int i = 0; i < 27; ++i) {
        const CellPlace by{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        const CellPlace other = moved(c, by);
        if (!box.has(other) || !filled[box.index(other)]) continue;
        if (part[box.index(other)] == part[box.index(c)]) continue;
        // Along z last: the cells stand lowest.
        CellPlace at = c;
        for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
          if (by[k] == 0) continue;
          at[k] += by[k];
          if (filled[box.index(at)]) continue;
          filled[box.index(at)] = true;
          ++joined;
        }
        more = true;
        return;
      }
    });
  }
  return joined;
}

/// Takes away all but the largest part, the first of several as large.
void keep_largest(const Box& box, std::vector<bool>& filled, Cells& out) {
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = parts_of(box, filled, sizes);
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  const auto kept = static_cast<std::uint32_t>(largest - sizes.begin());
  out.parts_left_out = sizes.size() <= 2 ? 0 : sizes.size() - 2;
  for (std::size_t i = 0; i < filled.size(); ++i) {
    if (!filled[i] || part[i] == kept) continue;
    filled[i] = false;
    ++out.cells_left_out;
  }
}

bool voxelise_in(const Model& model, const Inside& inside, const Grid& grid, Cells& out,
                 std::string& problem) {
  const auto box = box_of(model, grid, problem);
  if (!box) return false;
  out = {};
  out.side = grid.side;
  std::vector<bool> filled = filled_cells(inside, *box, grid.fill);
  out.joined = join_diagonals(*box, filled);
  keep_largest(*box, filled, out);
  int lowest = box->size[2];
  each_cell(*box, [&](const CellPlace& c) {
    if (!filled[box->index(c)]) return;
    lowest = std::min(lowest, c[2]);
    out.cells.push_back(c);
    const CellPlace under = moved(c, {0, 0, -1});
    if (c[2] > lowest && !filled[box->index(under)]) ++out.overhanging;
    if (c[2] == lowest) ++out.on_floor;
  });
  for (CellPlace& c : out.cells) c[2] -= lowest;
  if (out.cells.empty()) {
    problem = "no cell of that side has its middle in the model; take smaller ones, or --shell";
  } else if (out.cells.size() > kMostBricks) {
    problem = "the model takes more than a million cells of that side";
  }
  return problem.empty();
}

}  // namespace

bool voxelise(const Model& model, const Grid& grid, Cells& cells, std::string& problem) {
  return voxelise_in(model, Inside(model), grid, cells, problem);
}

bool voxelise_to(const Model& model, Grid grid, std::size_t bricks, double volume, Cells& cells,
                 std::string& problem) {
  const Inside inside(model);
  // A shell's number of cells grows with the square, so the first guess may be far off: the bounds
  // are wide.
  const double guess = std::cbrt(volume / static_cast<double>(bricks));
  double low = guess / 8, high = guess * 8;
  std::optional<Cells> best;
  const auto distance = [&](const Cells& one) {
    const auto have = static_cast<double>(one.cells.size()), want = static_cast<double>(bricks);
    return std::abs(have - want);
  };
  for (int i = 0; i < 24; ++i) {
    grid.side = i == 0 ? guess : std::sqrt(low * high);
    Cells tried;
    std::string why;
    const bool good = voxelise_in(model, inside, grid, tried, why);
    if (good && (!best || distance(tried) < distance(*best))) best = tried;
    if (good && tried.cells.size() == bricks) break;
    // No cell filled means cells too large, anything else that fails cells too small.
    const bool too_few = good ? tried.cells.size() < bricks : tried.cells.empty();
    (too_few ? high : low) = grid.side;
    if (high / low < 1.0005) break;
  }
  if (!best) {
    problem = "no side of cells gives about so many bricks";
    return false;
  }
  cells = std::move(*best);
  return true;
}

}  // namespace stig::meshes
