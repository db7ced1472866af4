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

}  // namespace

PageContent::PageContent(std::string title)
    : title_(std::move(title)), runs_(std::make_unique<Json>(Json::array())) {}

PageContent::~PageContent() = default;

void PageContent::add(Json run) { runs_->push_back(std::move(run)); }

std::string PageContent::data() const {
  return page_data({{"version", kVersion}, {"title", title()}, {"runs", *runs_}}, columns_);
}

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

}  // namespace stig::view
