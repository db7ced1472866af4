// SPDX-License-Identifier: MIT
// Everything here is taken from the world's poses and joints, and from what programs show to
// viewers (`robot.show`), never from what robots tell each other. Energy is mechanical work of
// motors, |force · velocity| summed over steps: no motor here gives any back.
#include "validate/robot_watch.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "validate/ideal_time.h"

namespace stig::validate {
namespace {

// Jitter of a robot at rest is far below, a step of work far above.
constexpr double kHair = 0.01;         ///< m, of motion that counts
constexpr double kStillSpeed = 0.1;    ///< rad/s of wheels
constexpr double kStillLift = 0.0005;  ///< m/s
constexpr double kUpright = 0.8;       ///< cosine of the tilt of a robot that stands, on its wheels

}  // namespace

double RobotRecord::idle_time() const {
  double out = 0;
  for (const TimeSpan& span : idle) out += span.to - span.from;
  return out;
}

RobotWatch::RobotWatch(const Simulation& run)
    : run_(run), step_(run.placed().config.step), robots_(run.scene().robots.size()) {
  // Poses at the start, so that standing still from the start on counts.
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i].record.name = run.scene().robots[i].name;
    robots_[i].place = run.crew()->robot_pose(run.world(), i).p;
  }
  const std::vector<WatchedHand> began = hands();
  for (std::size_t i = 0; i < robots_.size(); ++i) robots_[i].began = began[i];
}

const RobotModel& RobotWatch::model(std::size_t robot) const {
  assert(robot < robots_.size());
  return run_.scene().robot_models[run_.scene().robots[robot].model];
}

void RobotWatch::after_step() {
  const double now = run_.world().time();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    note_shown(i);
    note_motors(i);
    const Vec3 at = run_.crew()->robot_pose(run_.world(), i).p;
    if (length(at - robots_[i].place) < kHair) continue;
    robots_[i].place = at;
    last_motion_ = now;
  }
}

/// What its program showed in a step that it has made since.
void RobotWatch::note_shown(std::size_t robot) {
  Follow& follow = robots_[robot];
  // Controllers work every few steps of physics; what they showed is noted once.
  const std::uint64_t tick = run_.crew()->readings(robot).tick;
  if (tick == follow.tick) return;
  follow.tick = tick;
  RobotRecord& record = follow.record;
  const UserData& user = run_.crew()->commands(robot).user;
  for (const auto& [name, value] : user.numbers) {
    double& before = record.shown[name];
    // "busy" is a count that the library's programs keep; a rise is an event.
    if (name == "busy" && value > before) record.busy.push_back(run_.world().time());
    before = value;
  }
  for (const auto& [name, text] : user.texts) {
    if (name != "state" || text == record.state) continue;
    const double now = run_.world().time();
    if (!record.state.empty()) record.spent[record.state] += now - record.since;
    record.state = text;
    record.since = now;
  }
}

void RobotWatch::note_motors(std::size_t robot) {
  const RobotModel& robot_model = model(robot);
  const RobotBody& body = run_.placed().robots[robot];
  RobotRecord& record = robots_[robot].record;
  bool still = true;
  const auto work = [&](const AxisRef& axis, double slow) {
    const DofState state = run_.world().joint(body.joints[axis.joint])[axis.axis];
    // The state is asked of each axis, so a single wheel that turns is motion.
    still = still && std::abs(state.velocity) < slow;
    return std::abs(state.force * state.velocity) * step_;
  };
  if (robot_model.drive) {
    for (const auto* side : {&robot_model.drive->left, &robot_model.drive->right}) {
      for (const AxisRef& wheel : *side) record.energy.wheels += work(wheel, kStillSpeed);
    }
  }
  if (robot_model.lift) record.energy.lift += work(robot_model.lift->axis, kStillLift);
  if (still) record.still += step_;
  // The first pole stands for all: they are one circuit.
  bool current = false;
  if (robot_model.magnets && !robot_model.magnets->poles.empty()) {
    const BodyId pole = body.bodies[robot_model.magnets->poles.front().body];
    current = run_.world().current(pole, body.poles.front()) != 0;
  }
  if (current) record.energy.current_time += step_;
  note_rest(robots_[robot], still && !current);
}

void RobotWatch::note_rest(Follow& follow, bool rests) const {
  // Rest is collected until it ends, since only then is it known whether it was long enough.
  if (!rests) return end_rest(follow);
  const std::string& state = follow.record.state;
  if (follow.rest.empty() || follow.rest.back().first != state) follow.rest.emplace_back(state, 0);
  follow.rest.back().second += step_;
}

void RobotWatch::end_rest(Follow& follow) const {
  double seconds = 0;
  for (const auto& [state, part] : follow.rest) seconds += part;
  if (seconds > kIdleAfter) {
    const double now = run_.world().time();
    follow.record.idle.push_back({now - seconds, now});
    for (const auto& [state, part] : follow.rest) follow.record.idle_in[state] += part;
  }
  follow.rest.clear();
}

std::vector<WatchedHand> RobotWatch::hands() const {
  std::vector<WatchedHand> out;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    // Far above, in no block's reach: the hand of a robot without magnets.
    WatchedHand hand{{0, 0, 1e9}};
    const auto& magnets = model(i).magnets;
    if (magnets && !magnets->poles.empty()) {
      hand = {};
      for (const MagnetCircuitModel::Pole& pole : magnets->poles) {
        const BodyId id = run_.placed().robots[i].bodies[pole.body];
        const Shape& shape = run_.placed().config.bodies[static_cast<std::size_t>(id)].shape;
        hand.p_W += run_.world().state(id).X_WB.p - Vec3{0, 0, shape.half.z};
      }
      hand.p_W *= 1.0 / static_cast<double>(magnets->poles.size());
    }
    out.push_back(hand);
  }
  return out;
}

bool RobotWatch::out(std::size_t robot) const {
  const BodyState root = run_.world().state(run_.crew()->root_body(robot));
  const Pose X_WR = run_.crew()->robot_pose(run_.world(), robot);
  // Fallen by more than 60°: no robot here gets up by itself.
  return root.left || run_.crew()->failed(robot) || matrix(X_WR.q).z.z < kUpright;
}

bool RobotWatch::all_out() const {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (!out(i)) return false;
  }
  return true;
}

std::vector<RobotRecord> RobotWatch::finish(const Watch& watch) {
  std::vector<RobotRecord> records;
  const double now = run_.world().time();
  const std::vector<Haul> hauls = watch.hauls();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    // A rest that lasts to the end of the run ends there.
    end_rest(robots_[i]);
    RobotRecord record = robots_[i].record;
    if (!record.state.empty()) record.spent[record.state] += now - record.since;
    record.X_WR = run_.crew()->robot_pose(run_.world(), i);
    record.driven = run_.driven(i);
    record.failed = run_.crew()->failed(i);
    record.halted = run_.crew()->halted(i);
    record.left = run_.world().state(run_.crew()->root_body(i)).left;
    record.fallen = !record.left && matrix(record.X_WR.q).z.z < kUpright;
    record.holding = watch.holding(i);
    record.ideal = ideal_time(hauls, i, robots_[i].began.p_W, work_speeds(model(i)));
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace stig::validate
