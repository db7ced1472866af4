// SPDX-License-Identifier: MIT
// Conversions of scalars whose shape and range the schema has checked (base/form.h): a value
// that does not fit the type cannot come here, so none of these functions reports anything.
#include "rules/plain_reader.h"

#include <array>
#include <cassert>

namespace stig::rules {

namespace {

std::int64_t whole_number(const YamlNode& node) {
  return static_cast<std::int64_t>(number_of(node).value());
}

std::array<std::int32_t, 3> triple(const YamlNode& node) {
  assert(node.items.size() == 3);
  std::array<std::int32_t, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = static_cast<std::int32_t>(whole_number(node.items[i]));
  }
  return out;
}

}  // namespace

const YamlNode* PlainReader::good(const YamlNode& mapping, std::string_view path) const {
  // A bad mapping makes all that is within it bad, so the check goes down the path.
  const std::size_t slash = path.find('/');
  const YamlNode* value = mapping.find(path.substr(0, slash));
  if (value == nullptr || !is_good(*value)) return nullptr;
  return slash == std::string_view::npos ? value : good(*value, path.substr(slash + 1));
}

SourceRange PlainReader::key_range(const YamlNode& mapping, std::string_view key) const {
  for (const YamlPair& pair : mapping.pairs) {
    if (pair.key.text == key) return document_.range(pair.key);
  }
  return {};
}

void PlainReader::read_value(const YamlNode& node, const FormKey& key, bool& value) {
  value = node.text == (key.kind == FormKind::choice ? key.words.front() : "true");
}

void PlainReader::read_value(const YamlNode& node, const FormKey& /*key*/, int& value) {
  value = static_cast<int>(whole_number(node));
}

void PlainReader::read_value(const YamlNode& node, const FormKey& /*key*/, std::int64_t& value) {
  value = whole_number(node);
}

void PlainReader::read_value(const YamlNode& node, const FormKey& /*key*/, double& value) {
  value = number_of(node).value();
}

void PlainReader::read_value(const YamlNode& node, const FormKey& /*key*/, std::string& value) {
  // A folded or literal block ends in a line end that its author did not mean.
  value = node.text.substr(0, node.text.find_last_not_of(" \t\r\n") + 1);
}

void PlainReader::read_value(const YamlNode& node, const FormKey& /*key*/, Offset& value) {
  const auto numbers = triple(node);
  value = {numbers[0], numbers[1], numbers[2]};
}

void PlainReader::read_value(const YamlNode& node, const FormKey& key, Cell& value) {
  Offset from_origin;
  read_value(node, key, from_origin);
  value = Cell{} + from_origin;
}

void PlainReader::read_value(const YamlNode& node, const FormKey& /*key*/,
                             std::vector<std::string>& value) {
  for (const YamlNode& word : node.items) value.push_back(word.text);
}

}  // namespace stig::rules
