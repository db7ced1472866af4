// SPDX-License-Identifier: MIT
// The keys of a file format, as a table that two readers share: check_shape holds a file
// to it and reports diagnostics R1xx, yaml_schema prints it as JSON Schema draft 7 for
// editors. A table is made of constants; objects refer to each other by address.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/yaml.h"

namespace stig {

/// What a key's value is.
enum class YamlType : std::uint8_t {
  text,      ///< any text
  name,      ///< text of one line, not empty
  number,    ///< low..high, or above low when `above_low`
  integer,   ///< the same, whole
  boolean,   ///< true or false
  choice,    ///< one of `words`
  numbers,   ///< list of `least` to `most` numbers low..high
  integers,  ///< the same, whole
  object,    ///< mapping with the keys of `object`
  objects,   ///< list of such mappings
};

struct YamlObject;

struct YamlKey {
  std::string_view name;
  YamlType type = YamlType::text;
  std::string_view doc;  ///< one line, for people and editors
  bool required = false;
  double low = 0, high = 0;
  bool above_low = false;
  std::size_t least = 0, most = SIZE_MAX;  ///< entries of a list
  std::vector<std::string_view> words = {};
  const YamlObject* object = nullptr;
};

struct YamlObject {
  std::string_view title;  ///< "scene", as in "unknown key 'sede' in a scene"
  std::vector<YamlKey> keys;
};

/// Reports what is unlike the table in a node and all below it. True: nothing. A number
/// whose key begins with "stigc_" is a version and is reported as R108.
bool check_shape(const YamlDocument& document, const YamlNode& node, const YamlObject& object,
                 Diagnostics& diagnostics);

std::string yaml_schema(const YamlObject& root, std::string_view title,
                        std::string_view description);

// Values of a mapping that was found good; `otherwise` when the key is not there.
double number_or(const YamlNode& mapping, std::string_view key, double otherwise);
bool flag_or(const YamlNode& mapping, std::string_view key, bool otherwise);
std::string text_or(const YamlNode& mapping, std::string_view key, std::string_view otherwise);
std::vector<double> numbers_or(const YamlNode& mapping, std::string_view key,
                               std::vector<double> otherwise);

}  // namespace stig
