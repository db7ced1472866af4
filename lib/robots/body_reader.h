// SPDX-License-Identifier: MIT
// A rigid body of a file: its shape, mass, place and looks. Robots have such, and so have scenes,
// as obstacles.
#pragma once

#include <string_view>
#include <vector>

#include "base/form.h"
#include "robots/robot_model.h"
#include "robots/uses.h"

namespace stig::robots {

/// The keys of a body, the first its name; it is at most so many metres from where places count.
std::vector<FormKey> shape_keys(double far);

/// What a body's file leaves open.
struct BodyDefaults {
  std::string_view material = "robot";
  bool weightless = false;  ///< neither mass nor density need be there: then its mass is 0
};

struct BodyFile {
  const YamlDocument& document;
  Diagnostics& out;
  const FileLoader& load;  ///< of the files that bodies name
};

/// The body, and after it, when it takes several, its pieces: bodies fixed to it, whose masses and
/// moments make up those of the whole. Problems are reported; what is returned then has defaults.
std::vector<BodyModel> read_body(const FormView& view, const BodyFile& file,
                                 const BodyDefaults& defaults);

}  // namespace stig::robots
