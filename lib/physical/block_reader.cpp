// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/file_io.h"
#include "base/text.h"
#include "base/yaml.h"
#include "physical/block.h"

namespace stig {

namespace {

constexpr std::size_t kMaxBlockFileBytes = std::size_t{1} << 16;

/// A number that a mapping must have, and where it goes.
struct NumberKey {
  std::string_view name;
  double BlockModel::*value;
  double least, most;
};
constexpr NumberKey kBodyNumbers[] = {
    {"side", &BlockModel::side, 1e-3, 10},
    {"mass", &BlockModel::body_mass, 1e-6, 1e5},
    {"friction", &BlockModel::friction, 0, 10},
};
constexpr NumberKey kMagnetNumbers[] = {
    {"offset", &BlockModel::magnet_offset, 1e-6, 10},
    {"radius", &BlockModel::magnet_radius, 1e-6, 10},
    {"mass", &BlockModel::magnet_mass, 0, 1e5},
    {"field", &BlockModel::magnet_field, 0, 1e6},
    {"cutoff", &BlockModel::magnet_cutoff, 1e-6, 10},
};

/// The number that a plain scalar is, or nothing.
std::optional<double> number(const YamlNode& node) {
  if (node.kind != YamlKind::scalar || node.style != YamlStyle::plain) return std::nullopt;
  double value = 0;
  const char* end = node.text.data() + node.text.size();
  const auto [at, error] = std::from_chars(node.text.data(), end, value);
  if (error != std::errc() || at != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

class Reader {
 public:
  Reader(const YamlDocument& document, Diagnostics& out) : document_(document), out_(out) {}

  BlockModel read() {
    const YamlNode& root = document_.root;
    if (!is_mapping(root, "a block file")) return {};
    check_keys(root, {"stigc_block", "name", "title", "source", "body", "magnets"});
    check_version(root);
    block_.name = text(root, "name", true);
    block_.title = text(root, "title", false);
    block_.source = text(root, "source", false);
    read_numbers(root, "body", kBodyNumbers, true);
    read_numbers(root, "magnets", kMagnetNumbers, false);
    check_fit(root);
    return std::move(block_);
  }

 private:
  void error(Code code, const YamlNode& node, std::string message) {
    if (node.kind != YamlKind::broken) out_.add(code, document_.head(node), std::move(message));
  }

  bool is_mapping(const YamlNode& node, std::string_view what) {
    if (node.kind == YamlKind::mapping) return true;
    error(Code::R103, node, fmt::format("{} must be a mapping", what));
    return false;
  }

  void check_keys(const YamlNode& node, const std::vector<std::string_view>& known) {
    for (const YamlPair& pair : node.pairs) {
      if (std::find(known.begin(), known.end(), pair.key.text) != known.end()) continue;
      Diagnostic& diagnostic = out_.add(Code::R101, document_.range(pair.key),
                                        fmt::format("unknown key {}", in_quotes(pair.key.text)));
      diagnostic.suggest(std::string(nearest(pair.key.text, known)));
    }
  }

  const YamlNode* required(const YamlNode& node, std::string_view key) {
    const YamlNode* value = node.find(key);
    if (value == nullptr) error(Code::R102, node, fmt::format("the key '{}' is missing", key));
    return value;
  }

  void check_version(const YamlNode& root) {
    const YamlNode* version = required(root, "stigc_block");
    if (version == nullptr || number(*version) == 1) return;
    error(Code::R108, *version, "this program reads block files of version 1");
  }

  std::string text(const YamlNode& node, std::string_view key, bool needed) {
    const YamlNode* value = needed ? required(node, key) : node.find(key);
    if (value == nullptr) return {};
    if (value->kind != YamlKind::scalar) {
      error(Code::R103, *value, fmt::format("'{}' takes a text", key));
      return {};
    }
    return value->text.substr(0, value->text.find_last_not_of(" \t\r\n") + 1);
  }

  template <std::size_t N>
  void read_numbers(const YamlNode& root, std::string_view name, const NumberKey (&keys)[N],
                    bool needed) {
    const YamlNode* node = needed ? required(root, name) : root.find(name);
    if (node == nullptr || !is_mapping(*node, fmt::format("'{}'", name))) return;
    std::vector<std::string_view> known;
    for (const NumberKey& key : keys) known.push_back(key.name);
    check_keys(*node, known);
    for (const NumberKey& key : keys) {
      if (const YamlNode* value = required(*node, key.name)) read_number(*value, key);
    }
  }

  void read_number(const YamlNode& node, const NumberKey& key) {
    const std::optional<double> value = number(node);
    if (!value) return error(Code::R103, node, fmt::format("'{}' takes a number", key.name));
    if (*value < key.least || *value > key.most) {
      return error(Code::R105, node,
                   fmt::format("'{}' is from {} to {}", key.name, key.least, key.most));
    }
    block_.*key.value = *value;
  }

  /// Magnets lie inside the body; the block's own ones ignore each other.
  void check_fit(const YamlNode& root) {
    if (!block_.has_magnets() || out_.has_errors()) return;
    if (block_.magnet_offset + block_.magnet_radius > block_.side / 2) {
      error(Code::R105, *root.find("magnets")->find("offset"),
            "the magnets stick out of the block: offset and radius together are at most half "
            "its side");
    }
    if (block_.magnet_cutoff > 2 * block_.magnet_offset) {
      error(Code::R105, *root.find("magnets")->find("cutoff"),
            "a block's own magnets would feel each other: the cut-off is at most twice the "
            "offset");
    }
  }

  const YamlDocument& document_;
  Diagnostics& out_;
  BlockModel block_;
};

}  // namespace

std::optional<BlockModel> read_block(SourceRef source, Diagnostics& diagnostics) {
  Diagnostics own;
  std::optional<BlockModel> block;
  if (const auto document = parse_yaml(std::move(source), {kMaxBlockFileBytes, 8, 1000}, own)) {
    block = Reader(*document, own).read();
  }
  diagnostics.append(own);
  return own.has_errors() ? std::nullopt : block;
}

std::optional<BlockModel> read_block_file(const std::string& path, Diagnostics& diagnostics) {
  FileError error;
  auto bytes = read_file(path, kMaxBlockFileBytes, error);
  auto source = std::make_shared<const SourceFile>(path, bytes ? std::move(*bytes) : "");
  if (bytes) return read_block(std::move(source), diagnostics);
  diagnostics.add(error.too_large ? Code::R002 : Code::R001, {std::move(source), 0, 0},
                  error.message);
  return std::nullopt;
}

}  // namespace stig
