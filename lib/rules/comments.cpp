// SPDX-License-Identifier: MIT
// Ties the comments of a file to the elements of the rule set, so that `stigc fmt` can
// print a rule set from its meaning without losing them. Elements are listed with their
// places in the file's order; each comment goes to the nearest by bisection. The list
// follows what the printer puts on lines of its own (rule_printer.cpp); the two have to
// agree, and a test reformats files with comments everywhere.
#include "rules/comments.h"

#include <algorithm>
#include <string_view>

namespace stig::rules {

namespace {

/// `inner_end`: a comment before it is inside the element; 0 for elements that have others
/// inside them. A path names an element in the way the printer asks for it: "rules/3/when".
struct Element {
  std::string path;
  std::uint32_t begin;
  std::uint32_t inner_end = 0;
};

bool is_one_of(std::string_view key, std::initializer_list<std::string_view> keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Keys of mappings that are printed one a line.
void add_keys(const YamlNode& mapping, const std::string& prefix, std::vector<Element>& out) {
  for (const YamlPair& pair : mapping.pairs)
    out.push_back({prefix + pair.key.text, pair.key.begin, pair.value.end});
}

/// The elements that the printer puts on lines of their own, in the file's order.
std::vector<Element> elements_of(const YamlNode& root) {
  std::vector<Element> out;
  for (const YamlPair& pair : root.pairs) {
    const std::string& key = pair.key.text;
    // These hold other elements, so a comment within them belongs to one of those.
    const bool parted =
        is_one_of(key, {"bricks", "legend", "physical", "expect", "start", "rules"});
    out.push_back({key, pair.key.begin, parted ? 0 : pair.value.end});
    if (is_one_of(key, {"bricks", "legend", "physical", "expect"})) {
      add_keys(pair.value, key + "/", out);
    }
    if (!is_one_of(key, {"start", "rules"})) continue;
    for (std::size_t i = 0; i < pair.value.items.size(); ++i) {
      const YamlNode& item = pair.value.items[i];
      const std::string path = key + "/" + std::to_string(i);
      out.push_back({path, item.begin, key == "start" ? item.end : 0});
      if (key == "rules") add_keys(item, path + "/", out);
    }
  }
  return out;
}

}  // namespace

std::vector<Comment> place_comments(const YamlDocument& document) {
  std::vector<Comment> comments;
  if (document.comments.empty()) return comments;
  const std::vector<Element> elements = elements_of(document.root);
  for (const YamlComment& found : document.comments) {
    const auto after =
        std::upper_bound(elements.begin(), elements.end(), found.begin,
                         [](std::uint32_t at, const Element& e) { return at < e.begin; });
    Comment comment;
    // A trailing comment before any element has nothing to stand behind.
    comment.trailing = found.trailing && after != elements.begin();
    if (comment.trailing) {
      comment.element = std::prev(after)->path;
    } else if (after == elements.begin()) {
      comment.element = "stigc";
    } else if (found.begin < std::prev(after)->inner_end) {
      comment.element = std::prev(after)->path;
    } else if (after != elements.end()) {
      comment.element = after->path;
    }  // else it stays empty, which is the end of the file
    comment.text = document.source->text().substr(found.begin, found.end - found.begin);
    comments.push_back(std::move(comment));
  }
  return comments;
}

}  // namespace stig::rules
