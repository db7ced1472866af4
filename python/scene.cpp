// SPDX-License-Identifier: MIT
// A scene that Python steps, with controllers of robots in Python: calls that take what a robot
// senses and return what it shall do.
//
// The lock is released while physics works; a controller takes it for as long as it is called. What
// a controller throws ends its robot, as a program's error does, and is thrown from step().
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "module.h"
#include "physical/simulation/simulation.h"
#include "run_line.h"
#include "scene_input.h"
#include "shipped_files.h"

namespace stig::python {
namespace {

namespace py = pybind11;
using namespace stig::physics;
using robots::ControllerStatus;
using robots::RobotCommands;
using robots::RobotReadings;

py::list camera_lists(const RobotReadings& readings) {
  py::list out;
  for (const auto& camera : readings.cameras) {
    py::list tags;
    for (const auto& tag : camera.tags) {
      py::dict one;
      one["id"] = tag.id;
      one["position"] = py::make_tuple(tag.p_CT.x, tag.p_CT.y, tag.p_CT.z);
      one["turn"] = py::make_tuple(tag.q_CT.w, tag.q_CT.x, tag.q_CT.y, tag.q_CT.z);
      tags.append(one);
    }
    out.append(tags);
  }
  return out;
}

py::dict readings_dict(const RobotReadings& readings) {
  py::dict out;
  out["tick"] = readings.tick;
  out["time"] = readings.time;
  out["wheels"] = py::make_tuple(readings.left_encoder, readings.right_encoder);
  out["magnet_voltage"] = readings.magnet_voltage;
  out["lift"] = readings.lift.position;
  py::list ranges, headings, joints;
  for (const auto& one : readings.rangefinders) ranges.append(one.proximity);
  for (const auto& one : readings.compasses) headings.append(one.heading);
  for (const auto& one : readings.joints) joints.append(one.position);
  out["rangefinders"] = ranges;
  out["compasses"] = headings;
  out["joints"] = joints;
  out["tags"] = camera_lists(readings);
  return out;
}

void take_lift(const py::handle& value, RobotCommands& commands) {
  using Kind = robots::LiftCommand::Kind;
  if (py::isinstance<py::str>(value)) {
    const auto word = value.cast<std::string>();
    if (word != "stop" && word != "calibrate") throw py::value_error("lift: " + word);
    commands.lift.kind = word == "stop" ? Kind::stop : Kind::calibrate;
  } else {
    commands.lift = {Kind::position, value.cast<double>()};
  }
}

void take_discharge(const py::handle& value, RobotCommands& commands) {
  const auto word = value.cast<std::string>();
  if (word == "constructive") {
    commands.discharge = robots::Discharge::constructive;
  } else if (word == "destructive") {
    commands.discharge = robots::Discharge::destructive;
  } else if (word == "disable") {
    commands.discharge = robots::Discharge::disable;
  } else {
    throw py::value_error("discharge: " + word);
  }
}

/// What is not in the dictionary stays as it is.
void take_commands(const py::object& from, RobotCommands& commands) {
  if (from.is_none()) return;
  for (const auto& [key, value] : from.cast<py::dict>()) {
    const auto name = key.cast<std::string>();
    if (name == "wheels") {
      commands.wheels = value.cast<std::pair<double, double>>();
    } else if (name == "lift") {
      take_lift(value, commands);
    } else if (name == "discharge") {
      take_discharge(value, commands);
    } else if (name == "log") {
      commands.log.push_back(value.cast<std::string>());
    } else if (name == "cameras") {
      for (auto& camera : commands.camera_enabled) camera = value.cast<bool>();
    } else {
      throw py::value_error("a robot has no command '" + name + "'");
    }
  }
}

/// A controller that is an object of Python's.
class PythonController final : public robots::RobotController {
 public:
  PythonController(py::object call, std::exception_ptr& thrown)
      : call_(std::move(call)), thrown_(thrown) {}
  ~PythonController() override {
    const py::gil_scoped_acquire lock;
    call_ = py::object();
  }
  ControllerStatus init(RobotCommands&) override { return {}; }
  ControllerStatus step(const RobotReadings& readings, RobotCommands& commands) override {
    const py::gil_scoped_acquire lock;
    try {
      take_commands(call_(readings_dict(readings)), commands);
      return {};
    } catch (const std::exception& error) {
      if (!thrown_) thrown_ = std::current_exception();
      return {false, error.what()};
    }
  }

 private:
  py::object call_;
  std::exception_ptr& thrown_;
};

class PyScene {
 public:
  PyScene(const std::string& path, std::optional<std::uint64_t> seed, py::dict controllers)
      : controllers_(std::move(controllers)) {
    cli::Captured captured;
    cli::App app({}, captured);
    loaded_ = cli::read_loaded_scene(cli::shipped_name(path), seed, app);
    problem_ = captured.err;
    codes_ = captured.codes;
    if (!loaded_) return;
    ControllerFactory factory = lua_controllers();
    const auto lua = factory.robot;
    factory.robot = [this, lua](const Scene& scene, const PlacedScene& placed,
                                std::size_t robot) -> std::unique_ptr<robots::RobotController> {
      const std::string& name = scene.robots[robot].name;
      if (!controllers_.contains(name)) return lua(scene, placed, robot);
      return std::make_unique<PythonController>(controllers_[name.c_str()], thrown_);
    };
    run_ = std::make_unique<Simulation>(loaded_->scene, loaded_->placed, false, factory);
    hooks_.on_line = [this](const CrewLine& line) { lines_.emplace_back(line.who, line.text); };
  }

  bool ready() const { return run_ != nullptr; }
  const std::string& problem() const { return problem_; }
  const std::vector<std::string>& codes() const { return codes_; }
  double time() const { return run_->world().time(); }
  std::uint64_t hash() const { return run_->hash(); }

  /// Why it ended before its time; empty: it did not.
  std::string step(double seconds) {
    RunEnd end;
    {
      const py::gil_scoped_release others;
      end = run_->until(time() + seconds, hooks_);
    }
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
    return end == RunEnd::duration ? "" : std::string(to_string(end));
  }

  /// x y z and the quaternion w x y z of each body; NaN of those that have left the arena.
  py::array_t<double> poses() const {
    const World& world = run_->world();
    py::array_t<double> out({world.size(), std::size_t{7}});
    double* at = out.mutable_data();
    for (std::size_t i = 0; i < world.size(); ++i) {
      const BodyState state = world.state(BodyId{static_cast<std::uint32_t>(i)});
      const Pose& X = state.X_WB;
      for (const double value : {X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z}) {
        *at++ = state.left ? std::numeric_limits<double>::quiet_NaN() : value;
      }
    }
    return out;
  }

  /// x y z w x y z of each robot.
  std::map<std::string, std::array<double, 7>> robot_poses() const {
    std::map<std::string, std::array<double, 7>> out;
    const Crew* crew = run_->crew();
    for (std::size_t i = 0; crew != nullptr && i < crew->robots(); ++i) {
      const Pose X = crew->robot_pose(run_->world(), i);
      out[crew->robot_name(i)] = {X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z};
    }
    return out;
  }

  std::vector<std::pair<std::string, std::string>> take_lines() {
    return std::exchange(lines_, {});
  }
  std::vector<std::string> robot_names() const {
    std::vector<std::string> out;
    for (const auto& robot : loaded_->scene.robots) out.push_back(robot.name);
    return out;
  }
  double duration() const { return loaded_->scene.duration; }

 private:
  py::dict controllers_;
  std::optional<LoadedScene> loaded_;
  std::string problem_;
  std::vector<std::string> codes_;
  std::vector<std::pair<std::string, std::string>> lines_;
  std::exception_ptr thrown_;
  RunHooks hooks_;
  std::unique_ptr<Simulation> run_;
};

}  // namespace

void bind_scene(py::module_& module) {
  py::class_<PyScene>(module, "Scene")
      .def(py::init<const std::string&, std::optional<std::uint64_t>, py::dict>())
      .def_property_readonly("ready", &PyScene::ready)
      .def_property_readonly("problem", &PyScene::problem)
      .def_property_readonly("codes", &PyScene::codes)
      .def_property_readonly("time", &PyScene::time)
      .def_property_readonly("hash", &PyScene::hash)
      .def_property_readonly("duration", &PyScene::duration)
      .def_property_readonly("robot_names", &PyScene::robot_names)
      .def("step", &PyScene::step)
      .def("poses", &PyScene::poses)
      .def("robot_poses", &PyScene::robot_poses)
      .def("take_lines", &PyScene::take_lines);
}

}  // namespace stig::python
