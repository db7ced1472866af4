// SPDX-License-Identifier: MIT
// Certificates of robots' work: what the compiler writes is accepted, what was changed is refused
// or still true. Truth is walked, structure by structure, with the compiler's sight and reach.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "compiler/block_figures.h"
#include "compiler/columns.h"
#include "compiler/lattice_walk.h"
#include "compiler/local_policy.h"
#include "compiler/work_proof.h"
#include "recheck/check_work.h"
#include "recheck/decide.h"
#include "support/shipped_robot.h"
#include "support/uses.h"

namespace stig {
namespace {

BlockModel the_block() {
  Diagnostics diagnostics;
  const auto block = read_block_file(STIG_SOURCE_DIR "/blocks/stigmergic.yaml", diagnostics);
  REQUIRE(block);
  return *block;
}

Figures figures_from(const std::string& robot) {
  return recheck::figures_of(shipped_robot(robot), the_block());
}
Abilities abilities_from(const std::string& robot) {
  return abilities_of(shipped_robot(robot), compiler::figures_of(the_block()));
}

struct Proved {
  std::string name;
  RuleSet rules;
  CompiledRules compiled;
  WorkCertificate certificate;
};

/// As compile finds it, or column by column; nothing where that proves nothing.
std::optional<Proved> proved(const std::string& path, bool column_by_column) {
  Proved out;
  out.name = path;
  out.rules = rule_set(STIG_SOURCE_DIR "/" + path);
  const Abilities robot = abilities_from("bebot.yaml");
  Diagnostics diagnostics;
  CompileOptions options;
  options.robots = 1;
  out.compiled = compile_rules(out.rules, robot, options, diagnostics);
  REQUIRE_MESSAGE(out.compiled.decision, to_text(diagnostics));
  if (column_by_column && !settle_locally(robot, {}, out.compiled)) return std::nullopt;
  const ControllerPlan plan = plan_controller(out.rules, robot, out.compiled);
  out.certificate = certificate_of_work(out.rules, out.compiled, plan);
  return out;
}

constexpr const char* kSets[] = {"rulesets/staircase.yaml",    "rulesets/stepped-pyramid.yaml",
                                 "tests/compiler/column.yaml", "tests/compiler/line.yaml",
                                 "tests/compiler/plate.yaml",  "tests/compiler/plus.yaml",
                                 "tests/compiler/tower.yaml",  "tests/compiler/u.yaml",
                                 "tests/compiler/wall.yaml",   "tests/compiler/ring.yaml"};

std::vector<Proved> all_proved() {
  std::vector<Proved> out;
  for (const char* path : kSets) {
    for (const bool column_by_column : {false, true}) {
      if (auto one = proved(path, column_by_column)) out.push_back(std::move(*one));
    }
  }
  return out;
}

TEST_CASE("a robot's measures, worked out anew, are those of the compiler") {
  for (const char* name : {"bebot.yaml", "builderbot.yaml", "builderbot-2019.yaml"}) {
    CAPTURE(name);
    const Figures anew = figures_from(name);
    const Abilities robot = abilities_from(name);
    CHECK(anew.levels() == robot.levels);
    CHECK(anew.carried_x == robot.carried_x);
    CHECK(anew.body_front == robot.body_front);
    CHECK(anew.body_back == robot.body_back);
    CHECK(anew.body_half_width == robot.body_half_width);
    CHECK(anew.effector_front == robot.effector_front);
    CHECK(anew.effector_half_width == robot.effector_half_width);
    CHECK(anew.lowest_bottom == robot.lowest);
    CHECK(anew.widest == robot.block.most_angle);
    CHECK(anew.magnets_close == doctest::Approx(robot.magnet_reach).epsilon(1e-6));
    CHECK(anew.eyes.size() == robot.cameras.size());
  }
}

TEST_CASE("checker and compiler agree how far the magnets of any block reach") {
  const RobotModel robot = shipped_robot("bebot.yaml");
  CHECK(rc::check([&] {
    BlockModel block = the_block();
    block.magnet_cutoff = *rc::gen::inRange(0, 46) * 0.001;
    block.friction = *rc::gen::inRange(0, 12) * 0.1;
    const double reach = abilities_of(robot, compiler::figures_of(block)).magnet_reach;
    RC_ASSERT(std::abs(recheck::figures_of(robot, block).magnets_close - reach) < 1e-6);
    RC_ASSERT(block.side - 2 * block.magnet_offset + reach <=
              std::max(block.magnet_cutoff, 0.01) + 1e-9);
  }));
}

/// What the compiler's sight says of a column from the looks that are named.
std::vector<std::int8_t> seen_from_looks(Sight& sight, const std::vector<WorkLook>& looks,
                                         const BrickSet& state, ApproachSide side, int u, int v) {
  const std::vector<Observation>& from = sight.look_from_each(state, side, u, v);
  std::vector<std::uint8_t> best(from.front().cells.size(), kUnseen);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Viewpoint& at = sight.viewpoints()[i];
    const bool used =
        std::find(looks.begin(), looks.end(), WorkLook{at.distance, at.lift}) != looks.end();
    if (!used) continue;
    for (std::size_t c = 0; c < best.size(); ++c) best[c] = std::max(best[c], from[i].cells[c]);
  }
  std::vector<std::int8_t> out;
  for (const std::uint8_t one : best) {
    out.push_back(one == kUnseen
                      ? kNotKnown
                      : static_cast<std::int8_t>(one == kSeenEmpty ? 0 : one - kSeenBrick));
  }
  return out;
}

TEST_CASE("checker and compiler see the same of any bricks, from any look") {
  const Abilities robot = abilities_from("bebot.yaml");
  const Figures anew = figures_from("bebot.yaml");
  CHECK(rc::check([&] {
    std::vector<PlacedBrick> bricks;
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        const int high = *rc::gen::inRange(0, 4);
        for (int z = 0; z < high; ++z) {
          bricks.push_back({{x, y, z}, static_cast<Colour>(*rc::gen::inRange(1, 5))});
        }
      }
    }
    bricks.push_back({{4, 4, 0}, 1});
    bricks.push_back({{4, 4, 1}, 1});
    bricks.push_back({{4, 4, 2}, 1});
    const TargetBricks target(bricks, 1);
    Sight sight(target, robot);
    const Viewpoint at = *rc::gen::elementOf(sight.viewpoints());
    const std::vector<WorkLook> looks = {{at.distance, at.lift}};
    recheck::View view(anew, looks, sight.levels());
    std::string shown;
    for (const NearCell& c : view.cells()) {
      const std::uint32_t one = target.brick_at(cell_from(ApproachSide::plus_x, {c.du, c.dv, c.z}));
      shown += one == TargetBricks::kNone ? '\0' : static_cast<char>(target.colour(one));
    }
    RC_ASSERT(view.known(shown) ==
              seen_from_looks(sight, looks, target.whole(), ApproachSide::plus_x, 0, 0));
  }));
}

TEST_CASE("what compile writes is accepted, and reads back as itself") {
  const Figures robot = figures_from("bebot.yaml");
  std::size_t ordered = 0;
  for (const Proved& one : all_proved()) {
    CAPTURE(one.name);
    ordered += one.certificate.ordered ? 1 : 0;
    const WorkReport report = check_work(one.rules, robot, one.certificate);
    CHECK(report.refusal == "");
    Diagnostics diagnostics;
    const auto again =
        read_work_certificate("c", print_work_certificate(one.certificate), diagnostics);
    CHECK(to_text(diagnostics) == "");
    CHECK(again == one.certificate);
  }
  CHECK(ordered >= 5);
}

int below(std::size_t n) { return *rc::gen::inRange(0, static_cast<int>(n)); }

/// One change drawn by lot.
void change(WorkCertificate& c) {
  WorkNode& node = c.nodes[static_cast<std::size_t>(below(c.nodes.size()))];
  const std::size_t last = c.bricks.size() - 1;
  WorkBrick& brick = c.bricks[static_cast<std::size_t>(below(c.bricks.size()))];
  switch (below(12)) {
    case 0:
      node.kind = static_cast<WorkNode::Kind>(below(node.branches.empty() ? 6 : 4));
      if (node.kind == WorkNode::Kind::put && node.colour == 0) node.colour = 1;
      break;
    case 1:
      node.cell.du += below(2);
      node.cell.dv += below(3) - 1;
      node.cell.z += below(2);
      break;
    case 2:
      node.colour = static_cast<Colour>(1 + below(4));
      break;
    case 3:
      if (node.branches.empty()) break;
      node.branches[static_cast<std::size_t>(below(node.branches.size()))].first = {below(5)};
      break;
    case 4:
      if (!node.branches.empty()) node.branches.pop_back();
      break;
    case 5:
      brick.brick.brick = static_cast<Colour>(1 + below(4));
      break;
    case 6:
      brick.brick.at.x += below(3) - 1;
      brick.brick.at.z += below(2);
      break;
    case 7:
      c.bricks.pop_back();
      break;
    case 8:
      if (!brick.after.empty()) brick.after.erase(brick.after.begin() + below(brick.after.size()));
      break;
    case 9:
      brick.side = below(4);
      brick.column = {below(2) - 1, below(3) - 1, 0};
      break;
    case 10:
      if (c.looks.size() > 1) c.looks.pop_back();
      break;
    default:
      if (last > c.start) std::swap(c.bricks[last], c.bricks[c.start]);
  }
}

/// Walks what one robot builds that follows the certificate's decisions: does it end in the
/// structure of the rules, and only there, with each placement right and within reach?
struct TrueWalk {
  const Proved& of;
  const WorkCertificate& certificate;
  Abilities robot = abilities_from("bebot.yaml");
  Sight sight{*of.compiled.target, robot};
  recheck::View view{figures_from("bebot.yaml"), certificate.looks, sight.levels()};
  std::set<BrickSet> seen = {};

  bool from(const BrickSet& state) {
    if (!seen.insert(state).second) return true;
    const TargetStates& target = *of.compiled.target;
    bool moved = false;
    for (const int number : certificate.sides) {
      const ApproachSide side = *parse_side(kSideNames[static_cast<std::size_t>(number)]);
      for (const auto& [v, u] : columns_before(target, state, side)) {
        const auto known = seen_from_looks(sight, certificate.looks, state, side, u, v);
        const auto put = recheck::decide(certificate, view, known, number);
        if (!put) continue;
        const Cell cell = cell_from(
            side, {u + put->cell.du, v + put->cell.dv, put->cell.z + target.floor_level()});
        const std::uint32_t brick = target.brick_at(cell);
        if (brick == TargetBricks::kNone || state.has(brick) ||
            target.colour(brick) != put->colour || !target.rule_for(state, brick) ||
            reach(target, state, cell, side, robot).obstruction != Obstruction::none) {
          return false;
        }
        BrickSet after = state;
        after.add(brick);
        if (!from(after)) return false;
        moved = true;
      }
    }
    return moved || target.complete(state);
  }
};

std::set<PlacedBrick> structure_of(const WorkCertificate& certificate) {
  std::set<PlacedBrick> out;
  for (const WorkBrick& one : certificate.bricks) out.insert(one.brick);
  return out;
}

TEST_CASE("changed certificates are refused, or what they claim is true") {
  const Figures robot = figures_from("bebot.yaml");
  const std::vector<Proved> all = all_proved();
  int accepted = 0, refused = 0;
  CHECK(rc::check([&] {
    for (int i = 0; i < 10; ++i) {
      const Proved& one = all[static_cast<std::size_t>(below(all.size()))];
      WorkCertificate changed = one.certificate;
      change(changed);
      if (changed == one.certificate) continue;
      const WorkReport report = check_work(one.rules, robot, changed);
      RC_ASSERT(report.accepted == report.refusal.empty());
      (report.accepted ? accepted : refused) += 1;
      if (!report.accepted) continue;
      RC_ASSERT(structure_of(changed) == structure_of(one.certificate));
      TrueWalk walk{one, changed};
      RC_ASSERT(walk.from(one.compiled.target->start()));
    }
  }));
  CHECK(accepted > 10);
  CHECK(refused > 100);
}

TEST_CASE("what holds for one robot is not accepted for any number") {
  const auto lock = proved("tests/compiler/refused/P713-lock.yaml", false);
  REQUIRE(lock);
  const Figures robot = figures_from("bebot.yaml");
  CHECK(lock->certificate.crowd == recheck::WorkCrowd::one);
  CHECK(check_work(lock->rules, robot, lock->certificate).accepted);
  WorkCertificate more = lock->certificate;
  more.crowd = recheck::WorkCrowd::any;
  CHECK(check_work(lock->rules, robot, more).refusal.starts_with("when others have put theirs"));
}

TEST_CASE("what holds for robots with sides of their own is not accepted for any number") {
  const Figures robot = figures_from("bebot.yaml");
  for (const bool column_by_column : {false, true}) {
    const auto ring = proved("tests/compiler/ring.yaml", column_by_column);
    REQUIRE(ring);
    CHECK(ring->certificate.ordered == column_by_column);
    CHECK(ring->certificate.crowd == recheck::WorkCrowd::one_a_side);
    CHECK(check_work(ring->rules, robot, ring->certificate).accepted);
    WorkCertificate more = ring->certificate;
    more.crowd = recheck::WorkCrowd::any;
    CHECK(check_work(ring->rules, robot, more).refusal.find("may shut a robot in") !=
          std::string::npos);
  }
}

TEST_CASE("a certificate is for its robot and its block") {
  const auto stairs = proved("rulesets/staircase.yaml", false);
  Figures robot = figures_from("bebot.yaml");
  CHECK(check_work(stairs->rules, robot, stairs->certificate).accepted);
  robot.lift_travel = 0.1;
  CHECK_FALSE(check_work(stairs->rules, robot, stairs->certificate).accepted);
  robot = figures_from("bebot.yaml");
  robot.widest = 0.5;
  CHECK_FALSE(check_work(stairs->rules, robot, stairs->certificate).accepted);
  robot = figures_from("bebot.yaml");
  robot.magnets_close = 0;
  CHECK_FALSE(check_work(stairs->rules, robot, stairs->certificate).accepted);
}

constexpr const char* kHead =
    "stigc-work-certificate 1\nrules 0123456789abcdef\nrobots one\nsides +x\n";
constexpr const char* kFoot = "bricks 1 start 1 walked\n0 0 0 1\nend\n";

TEST_CASE("what is no certificate is said where it is wrong") {
  const std::string head = kHead, foot = kFoot, claims = "stigc-work-certificate 1\nrules ";
  std::string looks;
  for (int i = 0; i < 257; ++i) looks += "look 0.1 0\n";
  for (const std::string& text :
       {std::string(), std::string("stigc-work-certificate 2\n"), claims + "12\n",
        claims + "0123456789abcdef\nrobots some\n",
        claims + "0123456789abcdef\nrobots one\nsides +z\n",
        claims + "0123456789abcdef\nrobots one\nsides +x +x\nnothing\n" + foot,
        claims + "0123456789abcdef\r\nrobots one\nsides +x\nnothing\n" + foot,
        head + "ask side 1\n", head + "look 0.1 nan\n", head + looks + "nothing\n" + foot,
        head + "put 0 0 4 2\n" + foot,
        head + "ask side 2\nis 0\nnothing\nis 0\nput 0 0 0 2\n" + foot,
        head + "ask side 1\nis 2 2\nnothing\n" + foot,
        head + "nothing\nbricks 4000000000 start 1 walked\n0 0 0 1\nend\n",
        head + "nothing\n" + foot + "more\n"}) {
    CAPTURE(text);
    Diagnostics diagnostics;
    CHECK_FALSE(read_work_certificate("c", text, diagnostics));
    CHECK(diagnostics.has_errors());
  }
  Diagnostics diagnostics;
  CHECK(read_work_certificate("c", head + "look 0.1 0\nask side 1\nis 0 2\nput 0 0 0 2\n" + foot,
                              diagnostics));
}

}  // namespace
}  // namespace stig
