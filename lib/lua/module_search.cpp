// SPDX-License-Identifier: MIT
#include "lua/module_search.h"

#include <algorithm>

namespace stig::lua {

namespace {

constexpr std::size_t kMostPart = 128;        ///< bytes of a name or of a template
constexpr std::size_t kMostNames = 500;       ///< of one program, with all its modules
constexpr std::size_t kMostTemplates = 2000;  ///< bytes of all

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

/// Whether each part between slashes is a plain name that may hold dots, but is not made of them.
bool is_plain_path(std::string_view path) {
  for (std::size_t at = 0; at <= path.size();) {
    const std::string_view part = path.substr(at, path.find('/', at) - at);
    const auto fits = [](char c) { return is_plain(c) || c == '.'; };
    if (!std::all_of(part.begin(), part.end(), fits)) return false;
    if (part.find_first_not_of('.') == part.npos) return false;
    at += part.size() + 1;
  }
  return true;
}

/// The file of a template, from the folder that it is tried in; empty: of none.
std::string filled(std::string_view one, std::string_view name) {
  if (one.starts_with("./")) one.remove_prefix(2);
  if (one.size() > kMostPart || one.find('?') == one.npos) return {};
  std::string out;
  for (const char c : one) {
    if (c == '?') {
      out += name;
    } else {
      out += c;
    }
  }
  return is_plain_path(out) ? out : std::string{};
}

/// Calls with each text between quotes that ends in its line.
template <class Each>
void each_quoted(std::string_view text, Each each) {
  for (std::size_t at = text.find_first_of("'\""); at != text.npos;) {
    const auto close = text.find_first_of(text[at] == '"' ? "\"\n" : "'\n", at + 1);
    if (close == text.npos) return;
    if (text[close] != '\n') each(text.substr(at + 1, close - at - 1));
    at = text.find_first_of("'\"", close + 1);
  }
}

}  // namespace

bool is_module_search_name(std::string_view name) {
  if (name.empty() || name.size() > kMostPart) return false;
  bool part = false;  // whether a part has begun
  for (const char c : name) {
    const bool between = c == '.' || c == '/';
    if (between ? !part : !is_plain(c)) return false;
    part = !between;
  }
  return part;
}

std::vector<std::string> module_candidates(std::string_view name, std::string_view templates,
                                           std::string_view program_path) {
  std::vector<std::string> out;
  if (!is_module_search_name(name)) return out;
  std::string in_folders(name);
  std::replace(in_folders.begin(), in_folders.end(), '.', '/');
  const std::string folder(program_path.substr(0, program_path.rfind('/') + 1));
  const auto add = [&out](std::string file) {
    if (std::find(out.begin(), out.end(), file) == out.end()) out.push_back(std::move(file));
  };
  for (std::size_t at = 0; at < std::min(templates.size(), kMostTemplates);) {
    const std::string_view one = templates.substr(at, templates.find(';', at) - at);
    at += one.size() + 1;
    const std::string file = filled(one, in_folders);
    if (file.empty()) continue;
    add(file);
    add(folder + file);
  }
  return out;
}

// A template may be one of several in a text, with semicolons between or before them.
void WrittenModules::add_text(std::string_view text) {
  each_quoted(text, [this](std::string_view quoted) {
    if (quoted.find('?') == quoted.npos) return add_name(quoted);
    const bool fits = templates.size() + quoted.size() < kMostTemplates;
    if (!fits || templates.find(quoted) != templates.npos) return;
    if (!quoted.starts_with(';')) templates += ';';
    templates += quoted;
  });
}

void WrittenModules::add_name(std::string_view name) {
  if (names.size() == kMostNames || !is_module_search_name(name)) return;
  if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
}

}  // namespace stig::lua
