// SPDX-License-Identifier: MIT
// stigc describe: what a robot is made of.
//
// The ending decides between a picture and a model, before the robot is read.
#include <fmt/format.h>

#include "commands.h"
#include "outputs.h"
#include "physical/render/robot_picture.h"
#include "robot_report.h"
#include "robots/robot_reader.h"

namespace stig::cli {
namespace {

/// Words of what is wrong with the picture's name, or empty.
std::string picture_problem(const std::string& path) {
  if (!path.ends_with(".png") && !path.ends_with(".glb")) {
    return fmt::format("'{}': pictures of robots are .png or .glb", printable(path));
  }
  return {};
}

int write_picture(const RobotModel& robot, const std::string& path, const App& app) {
  const bool model = path.ends_with(".glb");
  return write_output(path, model ? robot_glb(robot) : robot_png(robot), app);
}

}  // namespace

int run(const DescribeOptions& options, App& app) {
  const std::string problem = options.picture ? picture_problem(*options.picture) : "";
  if (!problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  Diagnostics diagnostics;
  const auto robot = read_robot_file(options.robot, diagnostics);
  app.report(diagnostics);
  // A robot with warnings is described, unless -W error says otherwise.
  if (!robot || app.invalid(diagnostics)) return kFailed;
  if (options.picture) {
    if (const int code = check_outputs({*options.picture}, app); code != kOk) return code;
  }
  app.print(options.json ? to_json(*robot) : to_text(*robot, app.color_out()));
  return options.picture ? write_picture(*robot, *options.picture, app) : kOk;
}

}  // namespace stig::cli
