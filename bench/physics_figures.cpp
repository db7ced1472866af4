// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <thread>

#include "base/random.h"
#include "physical/let_down.h"
#include "physical/trials.h"
#include "physics_rows.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

std::string in_mm(double metres) { return fmt::format("{:.3g} mm", metres * 1e3); }
std::string in_degrees(double angle) { return fmt::format("{:.2g}°", angle / kDegree); }
std::string in_percent(double part) { return fmt::format("{:.2g} %", part * 100); }
bool within(double value, double bound) { return std::abs(value) <= bound; }

/// The worst error of the axial pull against the table of the paper's parameters, less half
/// a unit in the table's last place.
Rows axial_force(const BlockModel& block) {
  const struct {
    double distance, equal, electro, last;
  } table[] = {{0.010, 2.38, 5.23, 0.01},   {0.0125, 0.97, 2.14, 0.01},
               {0.015, 0.47, 1.03, 0.01},   {0.0175, 0.25, 0.56, 0.01},
               {0.020, 0.149, 0.327, 1e-3}, {0.030, 0.029, 0.065, 1e-3}};
  double worst = 0;
  const double own = block.magnet_moment(), other = 165 * kMomentPerField;
  for (const auto& row : table) {
    const auto error = [&row](double m0, double m1, double expected) {
      const double force = -dipole_wrench({m0, 0, 0}, {m1, 0, 0}, {row.distance, 0, 0}).force.x;
      return std::max(0.0, std::abs(force - expected) - row.last / 2) / expected;
    };
    worst = std::max({worst, error(own, own, row.equal), error(own, other, row.electro)});
  }
  return {{"axial force, 75 against 75 and 165 at six distances", "1 %, beyond rounding",
           in_percent(worst), "", within(worst, 0.01)}};
}

std::string stock_click_time(const BlockModel& block, double friction) {
  WorldConfig config = pair_scene(block, 0.010, friction);
  config.solver = SolverKind::stock;
  config.frictions.push_back({kFloorMaterial, kFloorMaterial, friction});
  const Click out = click(config, block.side);
  return out.time < 0 ? "never" : fmt::format("{:.3f} s", out.time);
}

Rows clicks(const BlockModel& block) {
  Rows rows;
  const BlockModel real = with_moment(block, 0.117);
  const struct {
    const char* name;
    const BlockModel& block;
    double friction, bound;
  } cases[] = {{"paper's strength", block, 0.05, 0.25}, {"paper's strength", block, 0.2, 0.25},
               {"paper's strength", block, 0.5, 0.25},  {"0.117 A·m²", real, 0.05, 1},
               {"0.117 A·m²", real, 0.15, 1},           {"0.117 A·m²", real, 0.185, 1}};
  for (const auto& one : cases) {
    const Click out = click(pair_scene(one.block, 0.010, one.friction), one.block.side);
    rows.push_back({fmt::format("click from 10 mm, {}, μ {}", one.name, one.friction),
                    fmt::format("< {} s", one.bound),
                    out.time < 0 ? "never" : fmt::format("{:.3f} s", out.time),
                    stock_click_time(one.block, one.friction),
                    out.time > 0 && out.time < one.bound});
  }
  return rows;
}

Row nine_bodies_row(const BlockModel& block, double friction, const std::vector<double>& degrees,
                    const char* angles, double most) {
  const ModelGap worst = compare_magnet_models(block, friction, degrees);
  return {
      fmt::format("quasi-static against nine bodies, turned by {}, μ {}", angles, friction),
      fmt::format("30 %, {}, 0.2°", in_mm(most)),
      fmt::format("{}, {}, {}", in_percent(worst.time), in_mm(worst.way), in_degrees(worst.yaw)),
      "", worst.time < 0.3 && worst.way < most && worst.yaw < 0.2 * kDegree};
}

Rows nine_bodies(const BlockModel& block) {
  Rows rows;
  for (const double friction : {0.05, 0.15, 0.2}) {
    rows.push_back(nine_bodies_row(block, friction, {0, 5}, "0 and 5°", 3e-4));
    rows.push_back(nine_bodies_row(block, friction, {10}, "10°", 1e-3));
  }
  return rows;
}

Rows alignment(const BlockModel& block) {
  const double chosen = SceneFriction{}.blocks;
  double way = 0, yaw = 0;
  for (const double height : {0.001, 0.002, 0.005, 0.010, 0.020}) {
    const Misfit end = dropped_on_column(block, height, chosen);
    way = std::max(way, std::hypot(end.p.x, end.p.y));
    yaw = std::max(yaw, std::abs(end.yaw));
  }
  return {{fmt::format("dropped 4 mm and 5° off onto a column, from 1 to 20 mm, μ {}", chosen),
           "1.1 mm, 1°", fmt::format("{}, {}", in_mm(way), in_degrees(yaw)), "",
           way < 1.1e-3 && yaw < kDegree}};
}

/// What a mound would ask for; nothing is held to it, see docs/compiler.md.
Rows let_down(const BlockModel& block) {
  constexpr int kTrials = 100;
  constexpr double kAside = 6e-3, kNear = 2e-3;
  const std::pair<Surroundings, const char*> places[] = {
      {Surroundings::floor_beside, "beside a column"},
      {Surroundings::floor_beside_behind, "beside a column, one behind"},
      {Surroundings::top_beside_behind, "beside a column, one behind, on a block"}};
  Rows rows;
  for (const auto& [where, name] : places) {
    for (const SceneFriction& friction : {kUsualFriction, kFrictionOfFile}) {
      const std::vector<LetDown> ends = let_down_aside(block, where, kAside, friction, kTrials);
      const auto near = std::count_if(ends.begin(), ends.end(),
                                      [](const LetDown& end) { return end.way < kNear; });
      rows.push_back({fmt::format("let down 6 mm aside {}, μ {} of blocks, {} of the floor", name,
                                  friction.blocks, friction.floor),
                      "",
                      fmt::format("{} of {} within 2 mm; half {}, 9 of 10 {}, all {}", near,
                                  kTrials, in_mm(ends[kTrials / 2 - 1].way),
                                  in_mm(ends[kTrials * 9 / 10 - 1].way), in_mm(ends.back().way)),
                      "", true});
    }
  }
  return rows;
}

Rows sliding(const BlockModel& block) {
  const double theory = 0.25 / (2 * 0.3 * 9.8);
  double worst = 0;
  [[maybe_unused]] double stock = 0;
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double way = sliding_stop(block, 0.3, degrees * kDegree);
    worst = std::max(worst, std::abs(way / theory - 1));
  }
  std::string other;
  for (int degrees = 0; degrees < 90; degrees += 15) {
    const double way = sliding_stop(block, 0.3, degrees * kDegree, SolverKind::stock);
    stock = std::max(stock, std::abs(way / theory - 1));
  }
  other = in_percent(stock);
  return {{"stop of a slide against v²/2μg, 24 directions", "4 %", in_percent(worst), other,
           worst < 0.04}};
}

Rows motion(const BlockModel&) {
  BodyDef def = solid_body(Shape::box({0.1, 0.2, 0.35}), 1, {0, 0, 20});
  def.velocity = {1, -2, 3};
  def.spin = {3, 2, 1};
  WorldConfig config;
  config.bodies = {def};
  World world(config);
  const Vec3 inertia = inertia_of(def);
  const auto momentum = [&] {
    const BodyState s = world.state(BodyId{0});
    const Mat3 r = matrix(s.X_WB.q);
    return r * scaled(inertia, r.transposed(s.spin));
  };
  const Vec3 before = momentum();
  const double energy = world.energy();
  run_for(world, config, 1);
  const double fall = length(world.state(BodyId{0}).X_WB.p - Vec3{1, -2, 20 + 3 - 4.9});
  const double turn = length(momentum() - before) / length(before);
  const double change = std::abs(world.energy() / energy - 1);
  return {{"free fall for 1 s", "1 nm", fmt::format("{:.1g} m", fall), "", fall < 1e-9},
          {"spinning top for 1 s: angular momentum", "10⁻¹⁰", fmt::format("{:.1g}", turn), "",
           turn < 1e-10},
          {"the same: energy", "10⁻⁴", fmt::format("{:.1g}", change), "", change < 1e-4}};
}

Rows newton(const BlockModel& block) {
  // Two blocks that attract each other in the air: their momenta are opposite.
  WorldConfig config = settled_pair(block, 0.010, 0.2, 5 * kDegree, 1);
  config.floor = false;
  config.gravity = 0;
  World world(config);
  run_for(world, config, 0.5);
  Vec3 sum;
  for (const std::uint32_t i : {0U, 1U}) sum += world.state(BodyId{i}).velocity * block.mass();
  const double work = magnet_work_error();
  return {{"pair of blocks that attract, collide and hold: momentum", "10⁻¹² kg m/s",
           fmt::format("{:.1g}", length(sum)), "", length(sum) < 1e-12},
          {"work of magnets against the energy lost, step 0.05 ms", "2 %", in_percent(work), "",
           work < 0.02}};
}

Rows ten_minutes(const BlockModel& block) {
  const WorldConfig config = pyramid_scene(block);
  World world(config);
  run_for(world, config, 1);
  const std::size_t awake = world.awake_count();
  run_for(world, config, 599);
  const double drift = largest_drift(world, config);
  return {{"pyramid with magnets, 10 minutes; awake after 1 s", "0.1 mm; 0",
           fmt::format("{}; {}", in_mm(drift), awake), "", drift < 1e-4 && awake == 0}};
}

Row column_row(const char* what, const Creep& creep, double way, double turn) {
  return {what, fmt::format("{}, {}", in_mm(way), in_degrees(turn)),
          fmt::format("{}, {}", in_mm(creep.way), in_degrees(creep.turn)), "",
          creep.way < way && creep.turn < turn};
}

Rows columns(const BlockModel& block) {
  return {column_row("column of 10 kept awake, each off by 1 mm and 2°: creep in 10 s",
                     awake_column(block, 10), 1e-4, 0.1 * kDegree),
          column_row("the same of 20", awake_column(block, 20), 1e-4, 0.1 * kDegree),
          column_row("the same of 20, without magnets", awake_column(without_magnets(block), 20),
                     2e-3, 0.5 * kDegree)};
}

Rows pushing(const BlockModel& block) {
  const double with = pushed_pyramid(block, true), without = pushed_pyramid(block, false);
  return {{"pyramid pushed, with against without sleep", "1 %",
           fmt::format("{} against {}", in_mm(with), in_mm(without)), "",
           within(with / without - 1, 0.01)}};
}

Row break_row(const char* what, const BreakLoad& load) {
  return {what, fmt::format("{:.2f} N ± 10 %", load.computed),
          fmt::format("{:.2f} N", load.measured), "",
          within(load.measured / load.computed - 1, 0.1)};
}

Rows breaking(const BlockModel& block) {
  return {break_row("load that pulls a hanging block off", hanging_load(block)),
          break_row("load that breaks a cantilever of two, μ 0.5", cantilever_load(block)),
          break_row("load that breaks a bridge of five, μ 0.5", bridge_load(block))};
}

Rows snagging(const BlockModel& block) {
  const Slide slide = row_along_row(block);
  const bool held = slide.drawn < 1e-4 && slide.rise < 1e-4 && slide.pitch < 0.1 * kDegree &&
                    within(slide.moved / 0.11 - 1, 0.01);
  return {
      {"row of 4 pushed 110 mm along a row of 8: lower row drawn, rise, tilt",
       "0.1 mm, 0.1 mm, 0.1°",
       fmt::format("{}, {}, {}", in_mm(slide.drawn), in_mm(slide.rise), in_degrees(slide.pitch)),
       "", held}};
}

Rows same_bytes(const BlockModel& block) {
  const WorldConfig config = loose_blocks(block, STIG_SOURCE_DIR "/scenes/drops/loose_100.csv");
  constexpr int kSteps = 250;
  // Another tick in each run of the program.
  Random random(static_cast<std::uint64_t>(std::time(nullptr)), 0, Purpose::start, 0, 0);
  const auto at = static_cast<int>(random.unit() * kSteps);
  World first(config), second(config);
  for (int i = 0; i < at; ++i) static_cast<void>(first.step());
  const bool resumed = second.resume(first.checkpoint());
  // One in this thread, the other beside it.
  std::thread other([&] {
    for (int i = at; i < kSteps; ++i) static_cast<void>(second.step());
  });
  other.join();
  for (int i = at; i < kSteps; ++i) static_cast<void>(first.step());
  return {{fmt::format("100 blocks that fall: in another thread, resumed at tick {}", at),
           "same bytes", resumed && first.hash() == second.hash() ? "same" : "different", "",
           resumed && first.hash() == second.hash()}};
}

}  // namespace

const std::vector<Trial> kFigureTrials = {
    {"axial-force", axial_force}, {"click", clicks},          {"nine-bodies", nine_bodies},
    {"alignment", alignment},     {"let-down", let_down},     {"sliding", sliding},
    {"motion", motion},           {"newton", newton},         {"ten-minutes", ten_minutes},
    {"columns", columns},         {"pushing", pushing},       {"breaking", breaking},
    {"snagging", snagging},       {"same-bytes", same_bytes},
};

}  // namespace stig::bench
