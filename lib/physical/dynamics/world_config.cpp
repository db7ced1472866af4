// SPDX-License-Identifier: MIT
// Checks come in an order in which each relies on those before: settings, bodies one by one, sizes
// against each other, joints, and at last what overlaps. A world is made of a config without
// problems alone, so the dynamics need not ask again.
#include "physical/dynamics/world_config.h"

#include <fmt/format.h>

#include <algorithm>

#include "physical/collision/broad_phase.h"
#include "physical/dynamics/number_checks.h"
#include "physical/dynamics/stock_step.h"
#include "physical/dynamics/world_settings.h"

namespace stig::physics {

namespace {

constexpr double kMostSpinStep = 0.001;  ///< s: facing spheres spin up and never settle above
/// m: poses in files are rounded, and the solver pushes so much apart without a jump.
constexpr double kMostOverlap = 1e-3;
constexpr double kMostStartSpeed = 100;  ///< m/s

/// No moment of a body is larger than the sum of the other two, as each is an integral of two
/// squares out of the same three; a flat body has equality, hence the margin. Zeros stand for
/// moments that follow from the shape. Written so that NaN is refused too.
bool moments_possible(const Vec3& i) {
  const double most = std::max({i.x, i.y, i.z});
  return i == Vec3{} || (positive(i.x) && positive(i.y) && positive(i.z) &&
                         2 * most <= (i.x + i.y + i.z) * (1 + 1e-9));
}

/// Whether the moments of a solid of this shape are those about its frame's axes. Bodies have a
/// diagonal inertia in the dynamics, so a hull that is askew in its frame has to be turned first
/// (hull_body).
bool is_principal(const Shape& shape) {
  if (shape.kind != ShapeKind::hull) return true;
  const Convex& hull = *shape.convex;
  const double squares = hull.squares.x + hull.squares.y + hull.squares.z;
  return length(hull.centre) <= 1e-6 * hull.radius && length(hull.products) <= 1e-6 * squares;
}

/// What is wrong with one body; empty: nothing.
std::string problem_of(const BodyDef& def, const WorldConfig& config) {
  const Vec3& h = def.shape.half;
  if (!positive(h.x) || !positive(h.y) || !positive(h.z)) return "has no extent";
  const bool needs_hull =
      def.shape.kind == ShapeKind::hull || def.shape.kind == ShapeKind::cylinder;
  if (needs_hull && !def.shape.convex) return "has no extent";
  if (def.shape.radius() > 10) return "is larger than 10 m";
  if (!positive(def.mass)) return "has a mass that is not positive";
  if (!moments_possible(def.inertia)) return "has moments of inertia that no body has";
  if (def.inertia == Vec3{} && !is_principal(def.shape)) {
    return "has a hull that is not about its centre of mass and along its principal axes, and no "
           "moments of inertia";
  }
  if (!is_finite(def.X_WB.p) || !is_unit(def.X_WB.q)) return "has a pose that is none";
  // A body that leaves the arena is taken out of the world: it would be gone at the first step.
  if (!inside_arena(def.X_WB.p, config.arena)) return "is outside of the arena";
  if (!(squared(def.velocity) <= kMostStartSpeed * kMostStartSpeed)) return "is too fast";
  if (!(squared(def.spin) <= 1e6)) return "spins too fast";
  if (!(def.axle == Vec3{}) && !is_unit(def.axle)) return "has an axle that is no unit vector";
  if (!(def.axle_friction >= 0 && def.axle_friction <= 1)) {
    return "has a friction along the axle that is not from 0 to 1";
  }
  for (const MagnetDef& magnet : def.magnets) {
    if (!is_finite(magnet.p_B) || !std::isfinite(magnet.moment) || !is_unit(magnet.direction) ||
        !std::isfinite(magnet.active) || !positive(magnet.inertia)) {
      return "has a magnet that is none";
    }
    if (length(magnet.p_B) > def.shape.radius()) return "has a magnet outside of it";
  }
  return {};
}

/// In the unit of the setting's key. Written so that NaN is refused too.
bool within(const Setting& setting, double value) {
  const double x = value / setting.unit;
  return (setting.above_low ? x > setting.low : x >= setting.low) && x <= setting.high;
}
bool possible(const Setting& setting, const auto& value) {
  if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
    return within(setting, static_cast<double>(value));
  } else {
    return static_cast<std::size_t>(value) < setting.words.size();
  }
}
bool possible(const Setting& /*setting*/, const bool& /*value*/) { return true; }
bool possible(const Setting& setting, const std::vector<FrictionPair>& pairs) {
  return std::all_of(pairs.begin(), pairs.end(),
                     [&](const FrictionPair& pair) { return within(setting, pair.coefficient); });
}

std::string problem_of(const Setting& setting) {
  if (!setting.words.empty()) return fmt::format("{} has no such value", setting.path());
  return fmt::format("{} must be {} {} and at most {}", setting.path(),
                     setting.above_low ? "above" : "at least", setting.low, setting.high);
}

/// Each by its own range, which its declaration has (world_settings.h); then what two of them have
/// to do with each other.
void check_settings(const WorldConfig& config, std::vector<ConfigProblem>& out) {
  visit_settings(
      [&out](const Setting& setting, const auto& value) {
        if (!possible(setting, value)) out.push_back({{}, problem_of(setting)});
      },
      config);
  const auto need = [&out](bool good, const char* text) {
    if (!good) out.push_back({{}, text});
  };
  need(!(config.magnet_contact > config.magnet_cutoff),
       "magnets touch at a distance of at most their cut-off");
  need(config.magnets == MagnetModel::quasi_static || !(config.step > kMostSpinStep),
       "integrated magnets need a step of at most 1 ms");
  need(config.bodies.size() <= kMostBodies, "there may be at most 20000 bodies");
}

/// The broad phase has one grid, with cells as large as the largest body: among far smaller ones
/// every pair would be a candidate.
void check_sizes(const WorldConfig& config, std::vector<ConfigProblem>& out) {
  if (config.bodies.empty()) return;
  const auto by_size = [](const BodyDef& a, const BodyDef& b) {
    return a.shape.radius() < b.shape.radius();
  };
  const auto [least, most] =
      std::minmax_element(config.bodies.begin(), config.bodies.end(), by_size);
  if (most->shape.radius() > kMostSizeRatio * least->shape.radius()) {
    out.push_back({{}, "the largest body is more than 200 times the smallest"});
  }
}

/// How far two shapes reach into each other, m; 0 where they do not.
double deepest(const Touch& touch) {
  double least = 0;
  for (int i = 0; i < touch.count; ++i) {
    least = std::min(least, touch.points[static_cast<std::size_t>(i)].gap);
  }
  return -least;
}

/// Bodies that are joined may reach into each other, and so may two that are fixed: nothing would
/// push them apart. Every other pair would fly apart in the first step.
void check_overlaps(const WorldConfig& config, std::vector<ConfigProblem>& out) {
  std::vector<std::uint32_t> numbers;
  std::vector<Bounds> bounds;
  double largest = 0;
  for (const BodyDef& def : config.bodies) {
    const double r = def.shape.radius();
    largest = std::max(largest, r);
    numbers.push_back(static_cast<std::uint32_t>(bounds.size()));
    bounds.push_back({def.X_WB.p - Vec3{r, r, r}, def.X_WB.p + Vec3{r, r, r}});
  }
  const std::vector<std::uint32_t> mechanism = mechanisms_of(config);
  for (const auto& [a, b] : candidate_pairs(cells_of(numbers, bounds, 2 * largest), {}, bounds)) {
    if (config.bodies[a].fixed && config.bodies[b].fixed) continue;
    if (mechanism[a] == mechanism[b]) continue;
    const BodyDef &one = config.bodies[a], &other = config.bodies[b];
    if (spawns_overlap(one.shape, one.X_WB, other.shape, other.X_WB)) {
      out.push_back({{a, b}, "overlap"});
    }
  }
  for (const std::uint32_t i : numbers) {
    if (!config.floor || config.bodies[i].fixed) continue;
    if (spawns_in_floor(config.bodies[i].shape, config.bodies[i].X_WB)) {
      out.push_back({{i}, "is in the floor"});
    }
  }
}

}  // namespace

Vec3 inertia_of(const BodyDef& def) {
  if (!(def.inertia == Vec3{})) return def.inertia;
  const Vec3& h = def.shape.half;
  if (def.shape.kind == ShapeKind::sphere) return Vec3{1, 1, 1} * (0.4 * def.mass * h.x * h.x);
  if (def.shape.kind == ShapeKind::cylinder) {
    // Solid, about its middle; z is along the axis.
    const double across = def.mass * (h.x * h.x / 4 + h.z * h.z / 3);
    return {across, across, def.mass * h.x * h.x / 2};
  }
  if (def.shape.kind == ShapeKind::hull) {
    // Integrals of x², y² and z² over the hull, for a density of one.
    const Vec3& q = def.shape.convex->squares;
    return Vec3{q.y + q.z, q.x + q.z, q.x + q.y} * (def.mass / def.shape.convex->volume);
  }
  // A box of half sides h has m/3 (h_y² + h_z²) about x, and so on.
  const double m = def.mass / 3;
  return {m * (h.y * h.y + h.z * h.z), m * (h.x * h.x + h.z * h.z), m * (h.x * h.x + h.y * h.y)};
}

BodyDef solid_body(const Shape& shape, double mass, const Vec3& place) {
  BodyDef def;
  def.shape = shape;
  def.mass = mass;
  def.X_WB.p = place;
  return def;
}

BodyDef hull_body(const std::vector<Vec3>& points, double mass, const Pose& X_WP) {
  const PrincipalHull hull = principal_hull(points);
  BodyDef def = solid_body(Shape::hull(hull.points), mass);
  def.inertia = hull.inertia * (mass / hull.volume);
  def.X_WB = X_WP * hull.X_PB;
  return def;
}

BodyDef block_body(const BlockModel& block, const Pose& X_WB) {
  BodyDef def;
  def.shape = Shape::box({block.side, block.side, block.side});
  def.mass = block.mass();
  def.inertia = Vec3{1, 1, 1} * block.inertia();
  def.X_WB = X_WB;
  // The magnets' masses and moments are in the block's already: they are free to turn, not to move.
  for (const Vec3& place : block.magnet_places()) {
    def.magnets.push_back(
        {place, block.magnet_moment(), true, {0, 0, 1}, 0, block.magnet_inertia()});
  }
  return def;
}

bool spawns_overlap(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  const Placed one{a, X_WA.p, matrix(X_WA.q)}, other{b, X_WB.p, matrix(X_WB.q)};
  return length(X_WA.p - X_WB.p) < a.radius() + b.radius() &&
         deepest(touch(one, other, 0)) > kMostOverlap;
}

bool spawns_in_floor(const Shape& shape, const Pose& X_WB) {
  return deepest(touch_floor({shape, X_WB.p, matrix(X_WB.q)}, 0)) > kMostOverlap;
}

bool inside_arena(const Vec3& p, double arena) {
  return std::abs(p.x) <= arena && std::abs(p.y) <= arena && std::abs(p.z) <= arena;
}

std::vector<ConfigProblem> find_problems_apart(const WorldConfig& config) {
  std::vector<ConfigProblem> out;
  check_settings(config, out);
  // Bodies are held against the settings, which must be sound for that.
  if (!out.empty()) return out;
  for (std::size_t i = 0; i < config.bodies.size(); ++i) {
    std::string problem = problem_of(config.bodies[i], config);
    if (!problem.empty()) out.push_back({{static_cast<std::uint32_t>(i)}, std::move(problem)});
  }
  check_sizes(config, out);
  if (!out.empty()) return out;
  if (config.solver == SolverKind::stock) {
    if (std::string problem = problem_of_stock(config); !problem.empty()) {
      return {{{}, std::move(problem)}};
    }
  }
  for (std::string& problem : problems_of_joints(config)) {
    out.push_back({{}, std::move(problem)});
  }
  return out;
}

std::vector<ConfigProblem> find_problems(const WorldConfig& config) {
  std::vector<ConfigProblem> out = find_problems_apart(config);
  if (out.empty()) check_overlaps(config, out);
  return out;
}

std::vector<std::string> problems_of(const WorldConfig& config) {
  std::vector<std::string> out;
  for (const auto& [bodies, what] : find_problems(config)) {
    if (bodies.empty()) out.push_back(what);
    if (bodies.size() == 1) out.push_back(fmt::format("body {} {}", bodies[0], what));
    if (bodies.size() == 2) {
      out.push_back(fmt::format("bodies {} and {} {}", bodies[0], bodies[1], what));
    }
  }
  return out;
}

}  // namespace stig::physics
