// SPDX-License-Identifier: MIT
// Each question leaves its answer in the record, and only the answer: asked again in the same order
// the same script gets the same, and needs no world.
#include "physical/simulation/script_record.h"

#include "base/byte_members.h"

namespace stig::physics {

namespace {

/// drop's: the place, or why there is none.
struct Dropped {
  bool good = false;
  std::uint64_t place = 0;
  std::string problem;
};

/// find's.
struct Found {
  bool good = false, robot = false;
  std::uint64_t place = 0;
};

// Lists of members serve both directions (base/byte_members.h).
void each_member(auto& each, EitherWay<ScriptBlock> auto& block) {
  each(block.name), each_member(each, block.X_WB), each(block.colour);
  for (auto& face : block.faces) each(face);
  each(block.left), each(block.lattice), each(block.x), each(block.y), each(block.z);
}
void each_member(auto& each, EitherWay<ScriptRobot> auto& robot) {
  each(robot.name), each_member(each, robot.X_WR), each(robot.failed), each(robot.halted);
  each(robot.driven);
}
void each_member(auto& each, EitherWay<Dropped> auto& dropped) {
  each(dropped.good), each(dropped.place), each(dropped.problem);
}
void each_member(auto& each, EitherWay<Found> auto& found) {
  each(found.good), each(found.robot), each(found.place);
}

}  // namespace

template <class Value>
Value RecordedWorld::noted(Value value) const {
  BytesOut out;
  // const, which is what tells writing from reading.
  each_member(out, std::as_const(value));
  record_ += out.take();
  return value;
}

template <class Value>
Value ReplayedWorld::taken() const {
  Value value{};
  BytesIn in(in_);
  each_member(in, value);
  return value;
}

double RecordedWorld::time() const { return noted(world_.time()); }
std::uint64_t RecordedWorld::seed() const { return noted(world_.seed()); }
std::size_t RecordedWorld::blocks() const { return noted(std::uint64_t{world_.blocks()}); }
std::size_t RecordedWorld::robots() const { return noted(std::uint64_t{world_.robots()}); }
ScriptBlock RecordedWorld::block(std::size_t place) const { return noted(world_.block(place)); }
ScriptRobot RecordedWorld::robot(std::size_t place) const { return noted(world_.robot(place)); }
std::optional<ScriptThing> RecordedWorld::find(std::string_view name) const {
  const auto thing = world_.find(name);
  noted(thing ? Found{true, thing->robot, thing->place} : Found{});
  return thing;
}
bool RecordedWorld::push(ScriptThing thing, const Vec3& force, double seconds) {
  return noted(world_.push(thing, force, seconds));
}
std::string RecordedWorld::place(ScriptThing thing, const Vec3& at,
                                 const std::optional<Quat>& turn) {
  return noted(world_.place(thing, at, turn));
}
bool RecordedWorld::set_friction(std::string_view body, double factor) {
  return noted(world_.set_friction(body, factor));
}
std::optional<std::size_t> RecordedWorld::drop(const Pose& X_WB, std::string& problem) {
  const auto place = world_.drop(X_WB, problem);
  noted(Dropped{place.has_value(), place.value_or(0), problem});
  return place;
}

// Answers come in the order of the questions: arguments need not be compared, as the same script
// asks the same.
double ReplayedWorld::time() const { return taken<double>(); }
std::uint64_t ReplayedWorld::seed() const { return taken<std::uint64_t>(); }
std::size_t ReplayedWorld::blocks() const { return taken<std::uint64_t>(); }
std::size_t ReplayedWorld::robots() const { return taken<std::uint64_t>(); }
ScriptBlock ReplayedWorld::block(std::size_t /*place*/) const { return taken<ScriptBlock>(); }
ScriptRobot ReplayedWorld::robot(std::size_t /*place*/) const { return taken<ScriptRobot>(); }
std::optional<ScriptThing> ReplayedWorld::find(std::string_view /*name*/) const {
  const auto found = taken<Found>();
  if (!found.good) return std::nullopt;
  return ScriptThing{found.robot, found.place};
}
bool ReplayedWorld::push(ScriptThing /*thing*/, const Vec3& /*force*/, double /*seconds*/) {
  return taken<bool>();
}
std::string ReplayedWorld::place(ScriptThing /*thing*/, const Vec3& /*at*/,
                                 const std::optional<Quat>& /*turn*/) {
  return taken<std::string>();
}
bool ReplayedWorld::set_friction(std::string_view /*body*/, double /*factor*/) {
  return taken<bool>();
}
std::optional<std::size_t> ReplayedWorld::drop(const Pose& /*X_WB*/, std::string& problem) {
  const auto dropped = taken<Dropped>();
  problem = dropped.problem;
  if (!dropped.good) return std::nullopt;
  return dropped.place;
}

}  // namespace stig::physics
