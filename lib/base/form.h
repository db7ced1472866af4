// SPDX-License-Identifier: MIT
// The form of a data file, as one table of keys: rule sets, blocks, robots, scenes.
//
//     const Form& wheel_form() {
//       static const Form form{"wheel", {
//         {.name = "radius", .kind = FormKind::number, .required = true,
//          .doc = "Metres.", .low = 0, .high = 1, .above_low = true}}};
//       return form;
//     }
//     const BadNodes bad = check_form(document, wheel_form(), diagnostics);
//     FormView wheel(document.root, bad);
//     const double radius = wheel.number("radius", 0.02);
//
// Two readers share the table: check_form holds a file to it and reports every diagnostic
// R1xx, form_schema prints it as JSON Schema draft 7 for editors. What a table cannot say
// (names that are not defined, bodies that overlap) is the caller's to check. A format with
// values of a kind that no other has describes them by a ValueKind: rules/rule_kinds.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "base/vec.h"
#include "base/yaml.h"

namespace stig {

/// What a key's value is.
enum class FormKind : std::uint8_t {
  text,      ///< any text, several lines too
  name,      ///< text of one line, not empty
  colour,    ///< "#rrggbb"
  choice,    ///< one of `words`
  boolean,   ///< true or false
  integer,   ///< low..high
  number,    ///< low..high, or above low when `above_low`
  version,   ///< the number `high`, of the file format
  numbers,   ///< list of `least` to `most` numbers low..high; three make a vector
  integers,  ///< the same, whole
  names,     ///< list of names
  choices,   ///< list of `words`
  form,      ///< mapping with the keys of `form`
  forms,     ///< list of such mappings
  map,       ///< mapping whose keys are of the kind `own`, and its values as `entry` says
  own,       ///< of the kind `own`
  anything   ///< the caller's business
};

struct Form;
struct FormKey;
class NodeChecks;

/// A kind of value that belongs to one format.
struct ValueKind {
  /// Is the node such a value? Reports it and marks it as bad when it is not.
  bool (*check)(NodeChecks& checks, const YamlNode& node, const FormKey& key) = nullptr;
  std::string_view schema = {};   ///< JSON Schema; "$ref" may name what form_schema is given
  std::string_view pattern = {};  ///< of those that are keys of a map: a regular expression
};

struct FormKey {
  std::string_view name;
  FormKind kind = FormKind::text;
  bool required = false;
  std::string_view doc = {};  ///< one line, for people and editors
  double low = -1e6, high = 1e6;
  bool above_low = false;
  std::vector<std::string_view> words = {};
  const Form* form = nullptr;
  std::size_t least = 0, most = SIZE_MAX;  ///< entries of a list or map
  const ValueKind* own = nullptr;
  const FormKey* entry = nullptr;
  /// What is said to be expected, where a list or map is and something else is found.
  std::string_view wanted = {};
};

struct Form {
  std::string_view title;  ///< "wheel", as in "unknown key 'raduis' in a wheel"
  std::vector<FormKey> keys;
  std::string_view example = {};  ///< the least that such a mapping may be
};

/// Nodes with an error of their own or inside; readers leave them alone.
using BadNodes = std::unordered_set<const YamlNode*>;

/// Reports every R1xx of a file.
BadNodes check_form(const YamlDocument& document, const Form& form, Diagnostics& diagnostics);
/// The same of a part of a file: adds to `bad`, and says whether the node is sound.
bool check_form(const YamlDocument& document, const YamlNode& node, const Form& form,
                Diagnostics& diagnostics, BadNodes& bad);

/// JSON Schema draft 7 of the form, with a newline at the end. `definitions`: a JSON object of
/// those that schemas of the format's own kinds refer to.
std::string form_schema(const Form& form, std::string_view title, std::string_view description,
                        std::string_view definitions = "{}");

/// A plain scalar as a number: decimal digits, sign, point, exponent. Nothing for
/// anything else, quoted numbers, infinities and numbers too large for a double.
std::optional<double> number_of(const YamlNode& node);

/// Reads the values of a mapping that has been checked: what is absent or bad has the
/// default. The node and the set must outlive it.
class FormView {
 public:
  FormView(const YamlNode& node, const BadNodes& bad) : node_(&node), bad_(&bad) {}

  const YamlNode& node() const { return *node_; }
  /// The sound value of a key, or nullptr.
  const YamlNode* find(std::string_view key) const;
  bool has(std::string_view key) const { return find(key) != nullptr; }

  double number(std::string_view key, double otherwise = 0) const;
  bool flag(std::string_view key, bool otherwise = false) const;
  /// Without spaces at its end.
  std::string text(std::string_view key, std::string_view otherwise = {}) const;
  std::vector<double> numbers(std::string_view key) const;
  /// Three numbers.
  Vec3 vector(std::string_view key, const Vec3& otherwise = {}) const;
  std::vector<std::string> names(std::string_view key) const;
  /// The mapping under a key; an empty one when it is absent.
  FormView form(std::string_view key) const;
  /// The sound mappings of a list.
  std::vector<FormView> forms(std::string_view key) const;

 private:
  const YamlNode* node_;
  const BadNodes* bad_;
};

}  // namespace stig
