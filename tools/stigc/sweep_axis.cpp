// SPDX-License-Identifier: MIT
// Numbers of ranges are written with 12 digits at most: 0.3, not 0.30000000000000004, which is as
// near as makes no difference and the same text on every machine.
#include "sweep_axis.h"

#include <fmt/format.h>

#include <cmath>

#include "base/form.h"

namespace stig::cli {
namespace {

constexpr double kMostValues = 1e6;

SweepValue number_value(double number) {
  const std::string text = fmt::format("{:.12g}", number);
  return {text, text, nlohmann::ordered_json::parse(text)};
}

/// A range's parts; `count` is 0 where none is written.
struct RangeText {
  double low = 0, high = 0, count = 0;
  bool whole = false;
};

std::optional<double> number_in(std::string_view text) {
  YamlNode node;
  node.kind = YamlKind::scalar;
  node.text = text;
  return number_of(node);
}

std::optional<RangeText> range_in(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == text.npos) return std::nullopt;
  const std::size_t slash = text.find('/', dots);
  const std::string_view high_text = text.substr(dots + 2, slash - std::min(slash, dots + 2));
  const auto low = number_in(text.substr(0, dots));
  const auto high = number_in(slash == text.npos ? text.substr(dots + 2) : high_text);
  const auto count = slash == text.npos ? std::optional(0.0) : number_in(text.substr(slash + 1));
  if (!low || !high || !count) return std::nullopt;
  const bool whole = text.substr(0, slash).find_first_of("eE") == text.npos &&
                     *low == std::floor(*low) && *high == std::floor(*high) &&
                     text.substr(0, dots).find('.') == text.npos;
  return RangeText{*low, *high, *count, whole};
}

/// The values between a range's ends.
bool add_range(const RangeText& range, SweepAxis& axis, std::string& problem) {
  if (range.high < range.low) {
    problem = "a range goes from the lower number to the higher one";
    return false;
  }
  const bool each = range.count == 0 && range.whole;
  const double count = each ? range.high - range.low + 1 : range.count;
  if (count > kMostValues || count != std::floor(count) || count < 0 ||
      (count == 1 && range.low != range.high)) {
    problem = "a range has at most 1000000 values, and more than one";
    return false;
  }
  axis.low = range.low;
  axis.high = range.high;
  for (double i = 0; i < count; ++i) {
    const double share = count > 1 ? i / (count - 1) : 0;
    axis.values.push_back(
        number_value(each ? range.low + i : range.low * (1 - share) + range.high * share));
  }
  return true;
}

}  // namespace

std::optional<SweepValue> read_value(const YamlDocument& document, const YamlNode& node) {
  const std::string source(document.source->text().substr(node.begin, node.end - node.begin));
  if (node.kind == YamlKind::scalar) {
    const bool plain = node.style == YamlStyle::plain;
    SweepValue value{node.text, plain ? source : yaml_text(node.text, true), node.text};
    if (number_of(node)) value.json = nlohmann::ordered_json::parse(node.text, nullptr, false);
    // What JSON has no number for, as "+1", stays a text.
    if (value.json.is_discarded()) value.json = node.text;
    if (plain && (node.text == "true" || node.text == "false")) value.json = node.text == "true";
    return value;
  }
  if (node.kind != YamlKind::sequence || node.style != YamlStyle::flow ||
      source.find('\n') != source.npos) {
    return std::nullopt;
  }
  // A list: parted by commas as an option, as it stands in a file.
  SweepValue value{"", source, nlohmann::ordered_json::array()};
  for (const YamlNode& item : node.items) {
    const auto part = item.kind == YamlKind::scalar ? read_value(document, item) : std::nullopt;
    if (!part) return std::nullopt;
    value.text += (value.text.empty() ? "" : ",") + part->text;
    value.json.push_back(part->json);
  }
  return value;
}

std::optional<SweepAxis> read_axis(const YamlDocument& document, const YamlPair& pair,
                                   std::string& problem) {
  SweepAxis axis;
  axis.name = pair.key.text;
  const YamlNode& node = pair.value;
  if (node.kind == YamlKind::scalar) {
    const auto range = range_in(node.text);
    if (range) return add_range(*range, axis, problem) ? std::optional(axis) : std::nullopt;
  }
  if (node.kind == YamlKind::sequence && !node.items.empty()) {
    for (const YamlNode& item : node.items) {
      auto value = read_value(document, item);
      if (!value) break;
      axis.values.push_back(std::move(*value));
    }
    if (axis.values.size() == node.items.size()) return axis;
  }
  problem = fmt::format("'{}' takes a list of values or a range, as [1, 2, 4], 1..20 or 0.1..0.9/5",
                        axis.name);
  return std::nullopt;
}

SweepValue draw_value(const SweepAxis& axis, Random& random) {
  if (!axis.values.empty()) return axis.values[random.below(axis.values.size())];
  return number_value(axis.low + (axis.high - axis.low) * random.unit());
}

}  // namespace stig::cli
