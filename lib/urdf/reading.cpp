// SPDX-License-Identifier: MIT
#include "urdf/reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/degree.h"
#include "base/text.h"

namespace stig::urdf {

namespace {

// No robot is as large or as heavy; sums and products stay far from overflow.
constexpr double kLargest = 1e9;

/// Both formats have C's forms of numbers, which may begin with a plus.
std::optional<double> parsed_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  std::vector<std::string_view> out;
  while (true) {
    const std::size_t begin = text.find_first_not_of(kSpace);
    if (begin == text.npos) return out;
    text.remove_prefix(begin);
    const std::size_t end = std::min(text.find_first_of(kSpace), text.size());
    out.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

}  // namespace

Diagnostic& Reading::wrong(const SourceRange& where, std::string message) const {
  return out.add(Code::F431, where, std::move(message));
}
Diagnostic& Reading::no_counterpart(const SourceRange& where, std::string message) const {
  return out.add(Code::F432, where, std::move(message));
}
Diagnostic& Reading::left_out(const SourceRange& where, std::string message) const {
  return out.add(Code::F433, where, std::move(message));
}

void Reading::only(const XmlNode& node, std::initializer_list<std::string_view> known) const {
  for (const XmlNode& child : node.children) {
    if (std::find(known.begin(), known.end(), child.name) != known.end()) continue;
    if (child.name.starts_with("xacro:")) {
      no_counterpart(child.place, "macros of xacro: run xacro first, and import what it prints");
    } else {
      left_out(child.place, fmt::format("<{}> is left out", printable(child.name)));
    }
  }
}

std::string Reading::needed(const XmlNode& node, std::string_view attribute) const {
  const XmlAttribute* found = node.attribute(attribute);
  if (found != nullptr && !found->value.empty()) return found->value;
  wrong(node.place, fmt::format("<{}> without '{}'", printable(node.name), attribute));
  return {};
}

std::string Reading::name(const XmlNode& node) const { return needed(node, "name"); }

std::optional<std::vector<double>> Reading::numbers(const std::string& text,
                                                    const SourceRange& where,
                                                    std::size_t count) const {
  std::vector<double> values;
  for (const std::string_view word : words_of(text)) {
    const auto value = parsed_number(word);
    if (!value || std::isnan(*value)) {
      wrong(where, in_quotes(word) + " is no number");
      return std::nullopt;
    }
    if (std::abs(*value) > kLargest) {
      wrong(where, in_quotes(word) + " is too large");
      return std::nullopt;
    }
    values.push_back(*value);
  }
  if (values.size() == count) return values;
  wrong(where, fmt::format("{} here, {} needed", counted(values.size(), "number"), count));
  return std::nullopt;
}

double Reading::number(const XmlNode& node, std::string_view attribute,
                       std::optional<double> otherwise) const {
  const XmlAttribute* found = node.attribute(attribute);
  if (found == nullptr) {
    if (!otherwise) wrong(node.place, fmt::format("<{}> without '{}'", node.name, attribute));
    return otherwise.value_or(1);
  }
  const auto value = numbers(found->value, found->place, 1);
  return value ? value->front() : 1;
}

double Reading::child_number(const XmlNode& node, std::string_view child,
                             std::optional<double> otherwise) const {
  const XmlNode* found = node.child(child);
  if (found == nullptr) {
    if (!otherwise) wrong(node.place, fmt::format("<{}> without <{}>", node.name, child));
    return otherwise.value_or(1);
  }
  const auto value = numbers(found->text, found->text_place, 1);
  return value ? value->front() : 1;
}

Vec3 Reading::vector(const XmlNode& node, std::string_view attribute, const Vec3& otherwise) const {
  const XmlAttribute* found = node.attribute(attribute);
  if (found == nullptr) return otherwise;
  const auto v = numbers(found->value, found->place, 3);
  return v ? Vec3{(*v)[0], (*v)[1], (*v)[2]} : Vec3{1, 1, 1};
}

bool Reading::child_flag(const XmlNode& node, std::string_view child) const {
  const std::string text = child_text(node, child);
  return text == "true" || text == "1";
}

Vec3 Reading::direction(const Vec3& v, const SourceRange& where) const {
  if (length(v) > 1e-6) return normalised(v);
  wrong(where, "the direction has no length");
  return {0, 0, 1};
}

std::optional<Rgb> Reading::colour(const std::string& text, const SourceRange& where) const {
  // Transparency may be left away.
  const auto rgba = numbers(text, where, words_of(text).size() == 3 ? 3 : 4);
  if (!rgba) return std::nullopt;
  const auto byte = [](double share) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255));
  };
  return Rgb{byte((*rgba)[0]), byte((*rgba)[1]), byte((*rgba)[2])};
}

std::string child_text(const XmlNode& node, std::string_view child) {
  const XmlNode* found = node.child(child);
  return found == nullptr ? "" : found->text;
}

std::string file_name(const SourceRange& place) {
  const std::string& path = place.file->path();
  return path.substr(path.find_last_of('/') + 1);
}

Quat from_rpy(const Vec3& rpy) {
  return normalised(rotation({0, 0, rpy.z}) * rotation({0, rpy.y, 0}) * rotation({rpy.x, 0, 0}));
}

Vec3 degrees_zyx(const Quat& q) {
  const Mat3 r = matrix(q);
  // Near straight up or down only the sum or the difference of yaw and roll is known.
  const double level = std::hypot(r.x.x, r.x.y);
  const double pitch = std::atan2(-r.x.z, level);
  const double yaw = level > 1e-9 ? std::atan2(r.x.y, r.x.x) : std::atan2(-r.y.x, r.y.y);
  const double roll = level > 1e-9 ? std::atan2(r.y.z, r.z.z) : 0;
  return Vec3{yaw, pitch, roll} * (1 / kDegree);
}

std::string figure(double value) {
  return std::abs(value) < 1e-12 ? "0" : fmt::format("{:.10g}", value);
}

std::string figures(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", figure(v.x), figure(v.y), figure(v.z));
}

}  // namespace stig::urdf
