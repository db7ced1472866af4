// SPDX-License-Identifier: MIT
#include "view/page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.h"

namespace stig::view {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kTitleMark = "@TITLE@", kDataMark = "@DATA@";
constexpr int kVersion = 1;  ///< of the data; the script refuses others

/// What stands between two words, of which the second comes after the first.
std::optional<std::string_view> between(std::string_view text, std::string_view before,
                                        std::string_view after) {
  const std::size_t found = text.find(before);
  if (found == std::string_view::npos) return std::nullopt;
  text.remove_prefix(found + before.size());
  const std::size_t end = text.find(after);
  if (end == std::string_view::npos) return std::nullopt;
  return text.substr(0, end);
}

}  // namespace

PageContent::PageContent(std::string title)
    : title_(std::move(title)),
      runs_(std::make_unique<Json>(Json::array())),
      target_(std::make_unique<Json>()) {}

PageContent::~PageContent() = default;

void PageContent::add(Json run) { runs_->push_back(std::move(run)); }

void PageContent::set_target(Json target) { *target_ = std::move(target); }

Json PageContent::json() const {
  Json json{{"version", kVersion}, {"title", title()}, {"runs", *runs_}};
  if (!target_->is_null()) json["target"] = *target_;
  return json;
}

std::string PageContent::data() const { return page_data(json(), columns_); }

std::string PageContent::title() const {
  if (!title_.empty() || runs_->empty()) return printable(title_);
  return runs_->front()["title"].get<std::string>();
}

bool PageContent::of_one_kind() const {
  return std::all_of(runs_->begin(), runs_->end(),
                     [&](const Json& run) { return run["kind"] == runs_->front()["kind"]; });
}

std::optional<std::string> page_of(std::string_view page_template, const PageContent& content) {
  const std::size_t title = page_template.find(kTitleMark);
  const std::size_t data = page_template.find(kDataMark);
  if (title == std::string_view::npos || data == std::string_view::npos || data < title) return {};
  const std::size_t behind_title = title + kTitleMark.size();
  std::string out(page_template.substr(0, title));
  out += escaped_markup(content.title());
  out += page_template.substr(behind_title, data - behind_title);
  out += content.data();
  out += page_template.substr(data + kDataMark.size());
  return out;
}

// The build escapes what within a script would end it: what is looked for is that of the page.
std::optional<PlayerParts> player_of(std::string_view page_template, const PageContent& content) {
  const auto script = between(page_template, "script-src ", ";");
  const auto style = between(page_template, "<style>", "</style>");
  const auto body = between(page_template, "<body>", "</body>");
  const std::size_t data = body ? body->find(kDataMark) : std::string_view::npos;
  if (!script || !style || data == std::string_view::npos) return std::nullopt;
  return PlayerParts{std::string(*script), std::string(*style),
                     std::string(body->substr(0, data)) + content.data() +
                         std::string(body->substr(data + kDataMark.size()))};
}

}  // namespace stig::view
