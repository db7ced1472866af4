// SPDX-License-Identifier: MIT
// The tree of a YAML text, made of its parser's events. Parsers tell where things begin; ends are
// found in the text (yaml_places.h). Used by yaml.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/yaml.h"
#include "base/yaml_events.h"
#include "base/yaml_places.h"

namespace stig {

class YamlTree {
 public:
  /// `base`: bytes before what the parser is given.
  YamlTree(const SourceRef& source, std::size_t base, const YamlLimits& limits,
           Diagnostics& diagnostics);

  /// False when no more events are wanted: something was reported that ends all.
  bool take(const YamlEvent& event);

  bool stopped() const { return stopped_; }
  bool has_root() const { return has_root_; }
  YamlNode take_root() { return std::move(root_); }
  /// Where scalars stand, in rising order.
  const std::vector<ScalarSpan>& spans() const { return spans_; }

 private:
  struct Frame {
    YamlNode node;
    YamlNode key;
    bool has_key = false;
  };

  SourceRange range(std::size_t begin, std::size_t end) const;
  bool starts_with(std::size_t at, std::string_view what) const;
  std::size_t after_properties(std::size_t at, const std::string& tag);

  void begin_document(std::size_t at);
  void add_null();
  void add_alias(std::size_t at);
  void add_anchor(std::size_t at, const std::string& name);
  void add_scalar(std::size_t at, const YamlEvent& event);
  void place_scalar(YamlNode& node, bool not_plain);
  void place_block(YamlNode& node, std::size_t& span_begin);
  void open(YamlKind kind, std::size_t at, const YamlEvent& event);
  void close(char bracket);
  void count_node(std::size_t at);
  void put(YamlNode node);
  void report_duplicates(const YamlNode& mapping, bool in_list);

  SourceRef source_;
  std::string_view text_;
  std::size_t base_;
  const YamlLimits& limits_;
  Diagnostics& out_;
  std::vector<Frame> stack_;
  YamlNode root_;
  bool has_root_ = false;
  bool stopped_ = false;
  int documents_ = 0;
  std::size_t nodes_ = 0;
  std::size_t last_end_ = 0;
  std::vector<ScalarSpan> spans_;
};

}  // namespace stig
