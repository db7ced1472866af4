// SPDX-License-Identifier: MIT
// What a world answers to a script, written down and said again. A script's own state cannot be
// saved; but given the same answers once more, a fresh one comes to the same state.
#pragma once

#include <map>

#include "base/bytes.h"
#include "lua/lua_script.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

/// Passes everything on to the world, and appends its answers to `record`.
class RecordedWorld final : public ScriptWorld {
 public:
  RecordedWorld(ScriptWorld& world, std::string& record) : world_(world), record_(record) {}

  double time() const override;
  std::uint64_t seed() const override;
  std::size_t blocks() const override;
  ScriptBlock block(std::size_t place) const override;
  std::size_t robots() const override;
  ScriptRobot robot(std::size_t place) const override;
  std::optional<ScriptThing> find(std::string_view name) const override;
  bool push(ScriptThing thing, const Vec3& force, double seconds) override;
  std::string place(ScriptThing thing, const Vec3& at, const std::optional<Quat>& turn) override;
  void halt(std::size_t robot) override { world_.halt(robot); }
  void set_colour(std::size_t block, int colour) override { world_.set_colour(block, colour); }
  void set_camera(std::size_t robot, bool alive) override { world_.set_camera(robot, alive); }
  void set_radio(ScriptThing thing, bool alive) override { world_.set_radio(thing, alive); }
  void set_leds(std::size_t block, std::uint32_t which, bool alive) override {
    world_.set_leds(block, which, alive);
  }
  bool set_friction(std::string_view body, double factor) override;
  std::optional<std::size_t> drop(const Pose& X_WB, std::string& problem) override;
  void stop(std::string reason) override { world_.stop(std::move(reason)); }
  void measure(std::string name, double value) override { world_.measure(std::move(name), value); }

 private:
  template <class Value>
  Value noted(Value value) const;

  ScriptWorld& world_;
  std::string& record_;
};

/// Answers as a record says; what the script does to it has no effect, but that measures and
/// stops are kept. The reader is bad after a call of a script that asked for something else.
class ReplayedWorld final : public ScriptWorld {
 public:
  explicit ReplayedWorld(ByteReader& record) : in_(record) {}

  double time() const override;
  std::uint64_t seed() const override;
  std::size_t blocks() const override;
  ScriptBlock block(std::size_t place) const override;
  std::size_t robots() const override;
  ScriptRobot robot(std::size_t place) const override;
  std::optional<ScriptThing> find(std::string_view name) const override;
  bool push(ScriptThing thing, const Vec3& force, double seconds) override;
  std::string place(ScriptThing thing, const Vec3& at, const std::optional<Quat>& turn) override;
  void halt(std::size_t /*robot*/) override {}
  void set_colour(std::size_t /*block*/, int /*colour*/) override {}
  void set_camera(std::size_t /*robot*/, bool /*alive*/) override {}
  void set_radio(ScriptThing /*thing*/, bool /*alive*/) override {}
  void set_leds(std::size_t /*block*/, std::uint32_t /*which*/, bool /*alive*/) override {}
  bool set_friction(std::string_view body, double factor) override;
  std::optional<std::size_t> drop(const Pose& X_WB, std::string& problem) override;
  void stop(std::string reason) override { stopped = std::move(reason); }
  void measure(std::string name, double value) override { measures[std::move(name)] = value; }

  std::map<std::string, double> measures;
  std::optional<std::string> stopped;

 private:
  template <class Value>
  Value taken() const;

  ByteReader& in_;
};

}  // namespace stig::physics
