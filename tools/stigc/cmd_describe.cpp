// SPDX-License-Identifier: MIT
// stigc describe: what a robot is made of.
#include "commands.h"
#include "controllers/robot_reader.h"
#include "robot_report.h"

namespace stig {

int run(const DescribeOptions& options, App& app) {
  Diagnostics diagnostics;
  const auto robot = read_robot_file(options.robot, diagnostics);
  app.report(diagnostics);
  if (!robot || app.invalid(diagnostics)) return kFailed;
  app.print(options.json ? to_json(*robot) : to_text(*robot, app.color_out()));
  return kOk;
}

}  // namespace stig
