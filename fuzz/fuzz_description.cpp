// SPDX-License-Identifier: MIT
// Any bytes as URDF or SDF: diagnostics, or robots that their own reader takes.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "robots/robot_reader.h"
#include "support/uses.h"
#include "urdf/import_robot.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stig;
  const std::string text(data, data + size);
  Diagnostics diagnostics;
  const auto imported =
      urdf::import_description(std::make_shared<SourceFile>("input", text), "fuzz", diagnostics);
  if (imported.has_value() == diagnostics.has_errors()) std::abort();
  to_text(diagnostics);
  if (!imported) return 0;
  std::vector<std::string> robots;
  if (!imported->scene) robots.push_back(imported->text);
  for (const urdf::ImportedFile& part : imported->parts) {
    if (part.text.starts_with("stigc_robot")) robots.push_back(part.text);
  }
  for (const std::string& robot : robots) {
    Diagnostics found;
    if (!read_robot(std::make_shared<SourceFile>("robot", robot), found)) std::abort();
  }
  return 0;
}
