// SPDX-License-Identifier: MIT
#include "view/page.h"

#include <nlohmann/json.hpp>

#include "base/text.h"

namespace stig {

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
  return page_data({{"version", kVersion}, {"title", printable(title_)}, {"runs", *runs_}},
                   columns_);
}

std::optional<std::string> page_of(std::string_view page_template, const PageContent& content) {
  const std::size_t title = page_template.find(kTitleMark);
  const std::size_t data = page_template.find(kDataMark);
  if (title == std::string_view::npos || data == std::string_view::npos || data < title) return {};
  const std::size_t behind_title = title + kTitleMark.size();
  std::string out(page_template.substr(0, title));
  out += escaped_markup(printable(content.title()));
  out += page_template.substr(behind_title, data - behind_title);
  out += content.data();
  out += page_template.substr(data + kDataMark.size());
  return out;
}

}  // namespace stig
