// SPDX-License-Identifier: MIT
// One self-contained page from a template that the build makes of tools/viewer, and runs.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "view/page_data.h"
#include "view/uses.h"

namespace stig::view {

/// Runs to be shown together. Each is an object of `runs`, see lattice_run.h.
class PageContent {
 public:
  /// Without a title: that of the first run.
  explicit PageContent(std::string title = {});
  ~PageContent();
  PageContent(const PageContent&) = delete;
  PageContent& operator=(const PageContent&) = delete;

  PageColumns& columns() { return columns_; }
  const PageColumns& columns() const { return columns_; }
  void add(nlohmann::ordered_json run);
  /// A structure that runs are held against, see lattice_run.h.
  void set_target(nlohmann::ordered_json target);
  std::string title() const;
  /// Do all runs count time alike, as they must to be shown together?
  bool of_one_kind() const;
  /// All but the columns.
  nlohmann::ordered_json json() const;
  /// As the page holds it.
  std::string data() const;

 private:
  std::string title_;
  std::unique_ptr<nlohmann::ordered_json> runs_, target_;
  PageColumns columns_;
};

/// The page; nothing when the template has no place for title and data.
std::optional<std::string> page_of(std::string_view page_template, const PageContent& content);

/// What another page takes to show runs in a part of itself.
struct PlayerParts {
  std::string script;  ///< its script, as a content security policy names it
  std::string style;   ///< but for the margin of `body`, of the player's elements alone
  std::string body;    ///< the player with its data and its script
};

/// Cut out of the template; nothing when it is damaged.
std::optional<PlayerParts> player_of(std::string_view page_template, const PageContent& content);

}  // namespace stig::view
