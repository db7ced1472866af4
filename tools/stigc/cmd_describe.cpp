// SPDX-License-Identifier: MIT
// stigc describe: what a robot is made of.
#include <fmt/format.h>

#include "base/file_io.h"
#include "commands.h"
#include "outputs.h"
#include "physical/render/robot_picture.h"
#include "robot_report.h"
#include "robots/robot_reader.h"

namespace stig {
namespace {

/// Words of what is wrong with the picture's name, or empty.
std::string picture_problem(const std::string& path) {
  if (!path.ends_with(".png") && !path.ends_with(".glb")) {
    return fmt::format("'{}': pictures of robots are .png or .glb", printable(path));
  }
  return folder_problem(path);
}

int write_picture(const RobotModel& robot, const std::string& path, const App& app) {
  FileError error;
  const bool model = path.ends_with(".glb");
  if (!write_file(path, model ? robot_glb(robot) : robot_png(robot), error)) {
    app.complain(error.message);
    return kRunFailed;
  }
  app.say(fmt::format("wrote {}", printable(path)));
  return kOk;
}

}  // namespace

int run(const DescribeOptions& options, App& app) {
  std::string problem = options.picture ? picture_problem(*options.picture) : "";
  if (problem.empty()) problem = same_file_problem({options.picture}, {options.robot});
  if (!problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  Diagnostics diagnostics;
  const auto robot = read_robot_file(options.robot, diagnostics);
  app.report(diagnostics);
  if (!robot || app.invalid(diagnostics)) return kFailed;
  app.print(options.json ? to_json(*robot) : to_text(*robot, app.color_out()));
  return options.picture ? write_picture(*robot, *options.picture, app) : kOk;
}

}  // namespace stig
