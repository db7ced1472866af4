// SPDX-License-Identifier: MIT
#pragma once

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <utility>

#include "robots/robot_reader.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {

/// A robot of robots/, which has to be without complaint.
inline RobotModel shipped_robot(const std::string& name) {
  Diagnostics diagnostics;
  const std::string path = "robots/" + name;
  auto robot = read_robot(std::make_shared<SourceFile>(path, project_file(path)), diagnostics);
  REQUIRE_MESSAGE(diagnostics.all().empty(), to_text(diagnostics));
  REQUIRE(robot);
  return std::move(*robot);
}

}  // namespace stig
