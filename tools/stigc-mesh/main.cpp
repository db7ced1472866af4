// SPDX-License-Identifier: MIT
// stigc-mesh MODEL solid|shell AXIS side|bricks NUMBER, or MODEL convex AXIS pieces NUMBER: what
// stigc asks of a model, as JSON on standard output. People use `stigc voxelise` and `stigc
// convex`.
//
// Models come from others, and their readers are not ours: this process is bounded in memory and
// time, and has nothing to lose.
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "convex.h"
#include "voxelise.h"

namespace {

using namespace stig::meshes;
using Json = nlohmann::ordered_json;

constexpr rlim_t kMostMemory = rlim_t{8} << 30;  // bytes
constexpr rlim_t kMostSeconds = 600;             // of processor time
constexpr std::size_t kMostSeen = 2000;          // triangles that are looked at

void bound(int resource, rlim_t most) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_max, most);
  setrlimit(resource, &limit);
}

struct Request {
  std::string model;
  Grid grid;
  std::optional<std::size_t> bricks;
  std::optional<std::size_t> pieces;
};

bool read_request(int count, char** words, Request& out) {
  if (count != 6) return false;
  const std::string fill = words[2], axis = words[3], what = words[4];
  char* end = nullptr;
  const double number = std::strtod(words[5], &end);
  if (*end != 0 || !(number > 0) || !std::isfinite(number)) return false;
  const std::string letter = axis.substr(axis.starts_with('-') ? 1 : 0);
  if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z') return false;
  const bool convex = fill == "convex" && what == "pieces";
  if (!convex && fill != "solid" && fill != "shell") return false;
  if (!convex && what != "side" && what != "bricks") return false;
  out.model = words[1];
  out.grid = {letter[0] - 'x', axis.starts_with('-'), number,
              fill == "solid" ? Fill::solid : Fill::shell};
  if (convex) out.pieces = static_cast<std::size_t>(std::min(number, 1e3));
  if (what == "bricks") out.bricks = static_cast<std::size_t>(number);
  return true;
}

Json repairs_json(const Repairs& repairs) {
  return {{"duplicate_points", repairs.duplicate_points},
          {"degenerate_faces", repairs.degenerate_faces},
          {"split_points", repairs.split_points},
          {"turned_surfaces", repairs.turned_surfaces},
          {"holes", repairs.holes},
          {"flat_surfaces", repairs.flat_surfaces},
          {"crossing_faces", repairs.crossing_faces},
          {"solids", repairs.solids},
          {"hollows", repairs.hollows},
          {"volume", repairs.volume}};
}

int fail(const std::string& problem) {
  std::cout << Json{{"problem", problem}}.dump() << "\n";
  return 1;
}

/// The axes of the frame in which `up` is z, right-handed, as of cells.
void turn_up(Soup& soup, const Grid& grid) {
  std::array<std::size_t, 3> axes{};
  for (std::size_t k = 0; k < 3; ++k) {
    axes[k] = (static_cast<std::size_t>(grid.up) + 1 + k) % 3;
  }
  if (grid.down) std::swap(axes[0], axes[1]);
  for (Point& p : soup.points) {
    p = {p[axes[0]], p[axes[1]], grid.down ? -p[axes[2]] : p[axes[2]]};
  }
}

int print(const Json& answer) {
  std::cout << answer.dump() << std::endl;
  return std::cout.good() ? 0 : 3;
}

int run_convex(const Model& model, const Repairs& repairs, std::size_t faces, std::size_t most) {
  std::string problem;
  Pieces pieces;
  if (!decompose(model, most, pieces, problem)) return fail(problem);
  const MassSums mass = mass_of(model);
  const Model seen = simplified(model, kMostSeen);
  return print({{"faces", faces},
                {"repairs", repairs_json(repairs)},
                {"volume", mass.volume},
                {"center", mass.centre},
                {"squares", mass.squares},
                {"products", mass.products},
                {"pieces", pieces.corners},
                {"pieces_volume", pieces.volume},
                {"off", pieces.off},
                {"points", seen.points},
                {"triangles", seen.triangles}});
}

int run(const Request& request) {
  Soup soup;
  std::string problem;
  if (!read_model(request.model, soup, problem)) return fail(problem);
  const std::size_t faces = soup.faces.size();
  if (request.pieces) turn_up(soup, request.grid);
  Model model;
  Repairs repairs;
  if (!repair(std::move(soup), model, repairs, problem)) return fail(problem);
  if (request.pieces) return run_convex(model, repairs, faces, *request.pieces);
  Cells cells;
  const bool good = request.bricks ? voxelise_to(model, request.grid, *request.bricks,
                                                 repairs.volume, cells, problem)
                                   : voxelise(model, request.grid, cells, problem);
  if (!good) return fail(problem);
  return print({{"faces", faces},
                {"repairs", repairs_json(repairs)},
                {"side", cells.side},
                {"joined", cells.joined},
                {"parts_left_out", cells.parts_left_out},
                {"cells_left_out", cells.cells_left_out},
                {"on_floor", cells.on_floor},
                {"overhanging", cells.overhanging},
                {"cells", cells.cells}});
}

}  // namespace

int main(int count, char** words) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  bound(RLIMIT_AS, kMostMemory);
#endif
  bound(RLIMIT_CPU, kMostSeconds);
  Request request;
  if (!read_request(count, words, request)) {
    std::cerr << "stigc-mesh MODEL solid|shell [-]x|y|z side|bricks NUMBER\n"
                 "stigc-mesh MODEL convex [-]x|y|z pieces NUMBER\n"
                 "This program works for stigc: see stigc voxelise and convex --help.\n";
    return 2;
  }
  try {
    return run(request);
  } catch (const std::bad_alloc&) {
    return fail("takes more memory than there is");
  } catch (const std::exception& error) {
    return fail(std::string("could not be worked on: ") + error.what());
  }
}
