// SPDX-License-Identifier: MIT
// What a user should read first after a run that did not end well: each finding is one sentence,
// with the figures that decide, in the order of how much they explain. First what was pushed out
// and what was against the rules, then what ended the run and where each robot was, then the
// bricks.
#include "validate/findings.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "base/degree.h"
#include "rules/cell_text.h"

namespace stig::validate {
namespace {

// The programs' approach begins there (docs/behaviours.md).
constexpr double kComesBy = 0.40;  ///< m: robots come straight at a site from 0.30 m

/// Of one structure, without its number.
std::vector<std::string> of_bricks(const RuleSet& rules, const Judgement& judgement) {
  std::vector<std::string> out;
  for (const BrickCheck& brick : judgement.bricks) {
    const Led wanted = led_of(rules, brick.wanted);
    if (!brick.block) {
      out.push_back("missing: " + brick_text(rules, wanted, brick.cell));
      continue;
    }
    if (!brick.coloured) {
      out.push_back(fmt::format("the brick at {} shows {}, not {}", cell_text(brick.cell),
                                to_string(brick.led), to_string(wanted)));
    }
    if (!brick.close) {
      out.push_back(fmt::format("the brick at {} is off by {:.1f} mm and {:.1f}°",
                                cell_text(brick.cell), length(brick.off) * 1e3,
                                brick.turn / kDegree));
    }
  }
  // Two bricks may each be close to the lattice and still be off against each other.
  for (const LooseJoint& joint : judgement.loose) {
    out.push_back(
        fmt::format("the bricks at {} and {} are off against each other by {:.1f} mm and {:.1f}°",
                    cell_text(joint.a), cell_text(joint.b), joint.way * 1e3, joint.turn / kDegree));
  }
  for (const StrayBrick& stray : judgement.extra) {
    out.push_back(stray.in_cell ? "too much: " + brick_text(rules, stray.led, stray.cell)
                                : fmt::format("in the way: {}, {:.1f} mm off it and turned {:.1f}°",
                                              brick_text(rules, stray.led, stray.cell),
                                              length(stray.off) * 1e3, stray.yaw / kDegree));
  }
  return out;
}

/// The bricks that left their places together, the first time that any did: what came after may
/// have its cause there. Empty: none has.
std::string first_to_leave(const Trial& trial, std::size_t structure) {
  constexpr double kTogether = 1;  // s
  std::vector<BrickEvent> gone;
  for (const BrickEvent& event : trial.events) {
    if (event.kind != BrickEvent::Kind::left || event.structure != structure) continue;
    if (gone.empty() || event.time <= gone.front().time + kTogether) gone.push_back(event);
  }
  if (gone.empty()) return {};
  std::string cells;
  for (const BrickEvent& event : gone) {
    cells += (cells.empty() ? "" : &event == &gone.back() ? " and " : ", ") + cell_text(event.cell);
  }
  return gone.size() == 1
             ? fmt::format("the brick at {} left its place at {:.0f} s", cells, gone.front().time)
             : fmt::format("the bricks at {} left their places at {:.0f} s", cells,
                           gone.front().time);
}

/// The nearest place that a brick is missing from, as seen from above, where that is so near that
/// robots who fill it come by.
std::string missing_near(const BuildTarget& target, const Trial& trial, const Vec3& at) {
  // Nothing is said of robots that are far from any gap.
  std::string out;
  double least = kComesBy;
  for (std::size_t i = 0; i < trial.judgements.size(); ++i) {
    for (const BrickCheck& brick : trial.judgements[i].bricks) {
      const Vec3 away = centre_of(target.sites[i], brick.cell) - at;
      const double way = std::hypot(away.x, away.y);
      if (brick.block || way >= least) continue;
      out = fmt::format(", {:.2f} m from the missing brick at {}{}", way, cell_text(brick.cell),
                        of_structure(target, i));
      least = way;
    }
  }
  return out;
}

/// What a robot is at that cannot go on, or where it is in its program. The gravest first: a robot
/// that has left is not also "in state …".
std::string plight_of(const RobotRecord& robot, const Trial& trial) {
  const std::string at = robot.state.empty() ? "" : fmt::format(" in state '{}'", robot.state);
  if (robot.left) return "has left the arena";
  if (robot.fallen) return "lies on its side" + at;
  if (robot.halted) return "was stopped for good" + at;
  if (!robot.failed) {
    return robot.state.empty()
               ? "shows no state"
               : fmt::format("is in state '{}' since {:.0f} s", robot.state, robot.since);
  }
  std::string what = "has stopped: its program failed";
  // The program's own message, of what was kept of the log.
  for (const TrialLine& line : trial.lines) {
    if (line.failure && line.who == robot.name) what += " (" + line.text + ")";
  }
  return what;
}

void of_robot(const BuildTarget& target, const RobotRecord& robot, const Trial& trial,
              std::vector<std::string>& out) {
  std::string text = robot.name + " " + plight_of(robot, trial);
  if (robot.holding) text += ", with a block";
  if (!robot.left && (robot.fallen || robot.failed)) {
    text += fmt::format(", at ({:.2f}, {:.2f}) m", robot.X_WR.p.x, robot.X_WR.p.y) +
            missing_near(target, trial, robot.X_WR.p);
  }
  out.push_back(std::move(text));
}

/// Why it ended as it did; nothing of a run that ended since all stood.
void of_end(const BuildTarget& target, const Trial& trial, std::vector<std::string>& out) {
  switch (trial.end) {
    case TrialEnd::spoilt:
      out.push_back(
          fmt::format("ended at {:.0f} s: a wrong brick had stood for five minutes, and no robot "
                      "had put it right",
                      trial.time));
      break;
    case TrialEnd::stuck:
      out.push_back(fmt::format("nothing went on at {:.0f} s", trial.time));
      break;
    case TrialEnd::time:
      out.push_back(fmt::format("time was out at {:.0f} s", trial.time));
      break;
    case TrialEnd::script:
      out.push_back("the scene's script ended the run: " + trial.message);
      break;
    case TrialEnd::script_failed:
      out.push_back("the scene's script failed: " + trial.message);
      break;
    case TrialEnd::diverged:
      out.push_back(trial.message);
      break;
    case TrialEnd::interrupted:
      out.push_back(fmt::format("interrupted at {:.0f} s", trial.time));
      break;
    case TrialEnd::built:
      return;
  }
  out.insert(out.end(), trial.cannot.begin(), trial.cannot.end());
  // What a script broke explains what robots did.
  out.insert(out.end(), trial.broken.begin(), trial.broken.end());
  // Every robot is accounted for: the one that is at fault may be any.
  for (const RobotRecord& robot : trial.robots) of_robot(target, robot, trial, out);
  if (trial.loose.empty()) out.emplace_back("no loose block lies in the arena");
  // Dark blocks are ordinary stock; one that shows a colour was let go on its way.
  for (const WatchedBlock& block : trial.loose) {
    if (block.led == Led::off) continue;
    out.push_back(fmt::format("a block that shows {} lies loose at ({:.2f}, {:.2f}) m{}",
                              to_string(block.led), block.X_WB.p.x, block.X_WB.p.y,
                              missing_near(target, trial, block.X_WB.p)));
  }
  out.insert(out.end(), trial.caches.begin(), trial.caches.end());
}

}  // namespace

std::vector<std::string> findings_of(const BuildTarget& target, const Trial& trial) {
  assert(target.rules != nullptr);
  std::vector<std::string> out;
  // Of several structures each sentence says of which it is.
  const auto number = [&](std::size_t i) {
    return trial.judgements.size() > 1 ? fmt::format("structure {}: ", i + 1) : "";
  };
  for (std::size_t i = 0; i < trial.judgements.size(); ++i) {
    if (trial.judgements[i].verdict == BuildVerdict::complete) continue;
    const std::string gone = first_to_leave(trial, i);
    if (!gone.empty()) out.push_back(number(i) + gone);
  }
  for (std::size_t i = 0; i < trial.judgements.size(); ++i) {
    const auto& against = trial.judgements[i].against;
    if (against) out.push_back(number(i) + "against the rules: " + against->reason);
  }
  // Complete structures need no account of how the run ended.
  if (trial.verdict() != BuildVerdict::complete) of_end(target, trial, out);
  for (std::size_t i = 0; i < trial.judgements.size(); ++i) {
    for (const std::string& one : of_bricks(*target.rules, trial.judgements[i])) {
      out.push_back(number(i) + one);
    }
  }
  return out;
}

}  // namespace stig::validate
