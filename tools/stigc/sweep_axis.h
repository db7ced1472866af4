// SPDX-License-Identifier: MIT
// The values that one parameter of a study takes: a list, or a range.
//
//     [1, 2, 4]      these
//     1..20          whole numbers from 1 to 20
//     0.1..0.9/5     five numbers at equal distances, both ends among them
//     0.1..0.9       any number in between: for samples alone
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/yaml.h"
#include "uses.h"

namespace stig::cli {

struct SweepValue {
  std::string text;  ///< as an option of the command line has it
  std::string yaml;  ///< in one line, as a file has it
  nlohmann::ordered_json json;
};

struct SweepAxis {
  std::string name;                ///< "agents", or a path: "rules.grow.probability"
  std::vector<SweepValue> values;  ///< empty: any between the bounds
  double low = 0, high = 0;
  bool is_path() const { return name.find('.') != name.npos; }
};

/// Nothing with `problem` set, in words.
std::optional<SweepAxis> read_axis(const YamlDocument& document, const YamlPair& pair,
                                   std::string& problem);
/// A single value of the plan, as options that do not vary have.
std::optional<SweepValue> read_value(const YamlDocument& document, const YamlNode& node);
/// One at random: each listed one is as likely as the others.
SweepValue draw_value(const SweepAxis& axis, Random& random);

}  // namespace stig::cli
