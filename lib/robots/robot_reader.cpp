// SPDX-License-Identifier: MIT
// A robot file is read in five passes: the form of its values, bodies, joints (which name bodies),
// the tree that they make, then devices (which name both). Each goes on after errors, so a user
// sees all that is wrong at once; names are looked up only where they exist.
#include "robots/robot_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/load.h"
#include "base/text.h"
#include "robots/robot_forms.h"
#include "robots/robot_parts.h"

namespace stig::robots {

namespace {

// A misspelt name gets the nearest one as its suggestion.
template <class Named>
std::string_view nearest_name(const std::string& name, const std::vector<Named>& all) {
  std::vector<std::string_view> names;
  for (const Named& one : all) names.push_back(one.name);
  return nearest(name, names);
}

template <class Named>
std::optional<std::size_t> place_of(const std::string& name, const std::vector<Named>& all) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  if (found == all.end()) return std::nullopt;
  return static_cast<std::size_t>(found - all.begin());
}

template <class Named>
std::optional<std::size_t> named(const RobotParts& parts, const YamlNode& node, Code code,
                                 std::string_view what, const std::vector<Named>& all) {
  const auto place = place_of(node.text, all);
  if (!place) {
    Diagnostic& diagnostic = parts.out.add(
        code, parts.range(node), fmt::format("unknown {} {}", what, in_quotes(node.text)));
    // add returns a diagnostic that is dropped once the list is full; working out a suggestion for
    // it would cost time that a hostile file could spend.
    if (!parts.out.full()) diagnostic.suggest(std::string(nearest_name(node.text, all)));
  }
  return place;
}

RobotModel read_model(const YamlDocument& document, const BadNodes& bad, Diagnostics& out,
                      const FileLoader& load) {
  RobotModel model;
  const FormView root(document.root, bad);
  model.name = root.text("name");
  model.title = root.text("title");
  model.source = root.text("source");
  model.control_period = root.number("control_period", model.control_period);
  model.program = root.text("program");
  const RobotParts parts{document, bad, out, model, load};
  read_bodies(root, parts);
  read_joints(root, parts);
  check_tree(parts);
  read_devices(root, parts);
  return model;
}

}  // namespace

void RobotParts::claim_name(const FormView& view, std::string_view what,
                            std::vector<std::pair<std::string, SourceRange>>& seen) const {
  const YamlNode* node = view.find("name");
  if (node == nullptr) return;
  const auto first = std::find_if(seen.begin(), seen.end(),
                                  [&](const auto& one) { return one.first == node->text; });
  if (first == seen.end()) {
    seen.emplace_back(node->text, range(*node));
    return;
  }
  out.add(Code::P603, range(*node),
          fmt::format("two {} are called {}", what, in_quotes(node->text)))
      .note(first->second, "the first is here");
}

std::optional<std::size_t> RobotParts::body(const FormView& view, std::string_view key) const {
  const YamlNode* node = view.find(key);
  if (node == nullptr) return std::nullopt;
  return named(*this, *node, Code::P601, "body", model.bodies);
}

std::optional<std::size_t> RobotParts::joint(const YamlNode& node) const {
  return named(*this, node, Code::P602, "joint", model.joints);
}

Vec3 RobotParts::direction(const FormView& view, std::string_view key,
                           const Vec3& otherwise) const {
  const YamlNode* node = view.find(key);
  if (node == nullptr) return otherwise;
  const Vec3 v = view.vector(key);
  // Below a micrometre the direction would be rounding. What is returned instead is unit, so that
  // what is read after it stays sound.
  if (length(v) > 1e-6) return normalised(v);
  out.add(Code::P613, range(*node), fmt::format("'{}' has no length", key));
  return {0, 0, 1};
}

std::vector<FormView> entries(const FormView& view, std::string_view key, const BadNodes& bad) {
  std::vector<FormView> out;
  // Like FormView::forms, but it keeps entries that hold bad values: their names are known, and
  // what refers to them must not be reported as unknown.
  const YamlNode* list = view.node().find(key);
  if (list == nullptr || list->kind != YamlKind::sequence) return out;
  for (const YamlNode& item : list->items) {
    if (item.kind == YamlKind::mapping) out.emplace_back(item, bad);
  }
  return out;
}

std::optional<RobotModel> read_robot(SourceRef source, Diagnostics& diagnostics,
                                     const FileLoader& load) {
  assert(source != nullptr);
  Diagnostics own;
  std::optional<RobotModel> model;
  // Depth and number of nodes are bounded before anything is read: files come from anywhere.
  if (const auto document = parse_yaml(std::move(source), {kMaxRobotFileBytes, 12, 50'000}, own)) {
    const BadNodes bad = check_form(*document, robot_form(), own);
    if (document->root.kind == YamlKind::mapping) {
      model =
          read_model(*document, bad, own, load ? load : loader_beside(document->source->path()));
    }
  }
  diagnostics.append(own);
  return own.has_errors() ? std::nullopt : model;
}

std::optional<RobotModel> read_robot_file(const std::string& path, Diagnostics& diagnostics) {
  SourceRef source = load_source(path, kMaxRobotFileBytes, diagnostics);
  return source ? read_robot(std::move(source), diagnostics) : std::nullopt;
}

std::string robot_schema() {
  return form_schema(robot_form(), "stigc robot, version 1",
                     "A robot: bodies, joints, sensors and devices. Metres, kilograms, degrees.");
}

}  // namespace stig::robots
