// SPDX-License-Identifier: MIT
#include "urdf/import_robot.h"

#include <fmt/format.h>

#include "base/text.h"
#include "urdf/readers.h"
#include "urdf/robot_text.h"
#include "urdf/sdf_world.h"

namespace stig::urdf {

namespace {

/// The one robot of a file.
ImportedDescription as_robot(Description robot, const Reading& reading) {
  if (reading.out.has_errors() || !fold_frames(robot, reading)) return {};
  return {false, robot_text(robot, file_name(robot.place), reading).text, {}};
}

ImportedDescription import_sdf(const XmlNode& root, const std::string& stem,
                               const Reading& reading) {
  const auto worlds = root.all("world"), models = root.all("model");
  if (worlds.size() + models.size() != 1) {
    reading.wrong(root.place, "one <world> or one <model> has to stand in <sdf>");
    return {};
  }
  reading.only(root, {"world", "model"});
  if (worlds.size() == 1) return import_world(*worlds[0], stem, reading);
  SdfModel model = read_sdf_model(*models[0], reading);
  if (model.fixed || model.ground) {
    reading.no_counterpart(models[0]->place, "a static model is no robot");
    return {};
  }
  return as_robot(std::move(model.robot), reading);
}

}  // namespace

bool is_description(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != text.npos && text[first] == '<';
}

std::optional<ImportedDescription> import_description(const SourceRef& source,
                                                      const std::string& stem,
                                                      Diagnostics& diagnostics) {
  Diagnostics own;
  const Reading reading{own};
  std::optional<ImportedDescription> out;
  if (const auto root = parse_xml(source, own)) {
    if (root->name == "robot") {
      out = as_robot(read_urdf(*root, reading), reading);
    } else if (root->name == "sdf" || root->name == "gazebo") {
      out = import_sdf(*root, stem, reading);
    } else {
      reading.wrong(root->place,
                    fmt::format("<{}> is neither <robot> (URDF) nor <sdf>", printable(root->name)));
    }
  }
  diagnostics.append(own);
  if (own.has_errors()) return std::nullopt;
  return out;
}

}  // namespace stig::urdf
