// SPDX-License-Identifier: MIT
// What the readers of URDF and SDF share: values of XML elements, and the three kinds of things
// that are said of them.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/rgb.h"
#include "base/vec.h"
#include "urdf/uses.h"
#include "urdf/xml.h"

namespace stig::urdf {

struct Reading {
  Diagnostics& out;

  /// The file is wrong in itself (F431).
  Diagnostic& wrong(const SourceRange& where, std::string message) const;
  /// The robot would be another without it (F432).
  Diagnostic& no_counterpart(const SourceRange& where, std::string message) const;
  /// It may be left out (F433).
  Diagnostic& left_out(const SourceRange& where, std::string message) const;
  /// Every child element that is called otherwise is left out.
  void only(const XmlNode& node, std::initializer_list<std::string_view> known) const;

  /// A text that has to be there: an attribute, or what a child element holds.
  std::string name(const XmlNode& node) const;
  std::string needed(const XmlNode& node, std::string_view attribute) const;

  /// So many finite numbers, white space between; nothing with an error when there are others.
  std::optional<std::vector<double>> numbers(const std::string& text, const SourceRange& where,
                                             std::size_t count) const;
  /// Of an attribute (URDF) or a child element's text (SDF). `otherwise` when it is not there;
  /// without `otherwise`, an error. After an error 1, of which nobody complains again.
  double number(const XmlNode& node, std::string_view attribute,
                std::optional<double> otherwise = std::nullopt) const;
  double child_number(const XmlNode& node, std::string_view child,
                      std::optional<double> otherwise = std::nullopt) const;
  Vec3 vector(const XmlNode& node, std::string_view attribute, const Vec3& otherwise) const;
  bool child_flag(const XmlNode& node, std::string_view child) const;
  /// A unit vector; z with an error when it has no length.
  Vec3 direction(const Vec3& v, const SourceRange& where) const;
  /// "r g b a" in [0, 1].
  std::optional<Rgb> colour(const std::string& text, const SourceRange& where) const;
};

/// The child's text; empty when there is none.
std::string child_text(const XmlNode& node, std::string_view child);
/// Of the file, without its folder.
std::string file_name(const SourceRange& place);
/// About fixed x, y, z: as both formats have it.
Quat from_rpy(const Vec3& rpy);
/// Degrees about z, the new y and the new x, as robot and scene files have it.
Vec3 degrees_zyx(const Quat& q);
/// A number as robot and scene files have it: 10 digits, what is below 1e-12 is 0.
std::string figure(double value);
std::string figures(const Vec3& v);

}  // namespace stig::urdf
