// SPDX-License-Identifier: MIT
// The keys of a rule set file, as one table.
//
// Two share it that know nothing else of a file: check_shape, which holds a file to it and
// reports every diagnostic R1xx, and json_schema, which prints it as JSON Schema draft 7 for
// editors. The reader of plain values and the printer take from it what belongs to the members
// of RuleSet (key_field.h). What the table cannot say (symbols that are not defined, rules that
// contradict each other) are diagnostics R2xx and R3xx; a schema cannot see them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/form.h"
#include "rules/rule_set.h"

namespace stig {

/// What a key's value is.
enum class ValueKind : std::uint8_t {
  text,      ///< any text
  name,      ///< text of one line, not empty
  symbol,    ///< a symbol of the drawings, quoted or not (`3` is the text "3")
  colour,    ///< "#rrggbb"
  choice,    ///< one of `words`
  boolean,   ///< true or false
  integer,   ///< low..high
  number,    ///< low..high, or above low when `above_low`
  drawing,   ///< text of several lines
  cell,      ///< three integers low..high
  symbols,   ///< list of symbols, drawing symbols such as "." included
  choices,   ///< list of `words`
  object,    ///< mapping with the keys of `object`
  objects,   ///< list of such mappings
  bricks,    ///< mapping symbol -> `object`
  legend,    ///< mapping symbol -> list of symbols
  by_stage,  ///< mapping stage number -> integer low..high
};

enum class ObjectKind : std::uint8_t {
  rule_set,
  brick,
  start_entry,
  rule,
  height,
  count,
  box,
  physical,
  expect,
};

struct KeySchema {
  std::string_view name;
  ValueKind kind = ValueKind::text;
  bool required = false;
  std::string_view doc;  ///< one line, for people and editors
  double low = 0, high = 0;
  bool above_low = false;
  std::vector<std::string_view> words = {};
  ObjectKind object = ObjectKind::rule_set;
  std::size_t least = 0, most = SIZE_MAX;  ///< entries of a list or mapping
};

struct ObjectSchema {
  ObjectKind kind;
  std::string_view title;    ///< "rule", as in "unknown key 'plaec' in a rule"
  std::string_view example;  ///< the least that such a mapping may be
  std::vector<KeySchema> keys;
};

const ObjectSchema& object_schema(ObjectKind kind);
/// Of a key that is there; `a/b` is the key b of the mapping under a (key_field.h).
const KeySchema& key_schema(ObjectKind kind, std::string_view path);

/// The version of the file format that is read.
inline constexpr int kFormatVersion = 1;
inline constexpr int kMaxRules = 20'000;
inline constexpr std::size_t kMaxSymbolLength = 16;  ///< code points

/// Symbols with a meaning of their own in drawings; no brick may take them.
bool is_reserved_symbol(std::string_view symbol);

/// JSON Schema draft 7 of the file format, with a newline at the end.
std::string json_schema();
/// The same, which offers these symbols of bricks where one is wanted. It refuses no others, since
/// a palette grows while its file is written.
std::string json_schema(const std::vector<std::string>& symbols);

/// Reports every R1xx of a file.
BadNodes check_shape(const YamlDocument& document, Diagnostics& diagnostics);

}  // namespace stig
