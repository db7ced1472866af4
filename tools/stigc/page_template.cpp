// SPDX-License-Identifier: MIT
#include "page_template.h"

#include <filesystem>

#include "base/file_io.h"
#include "shipped_files.h"

namespace stig::cli {
namespace {

constexpr std::size_t kMostTemplateBytes = std::size_t{1} << 24;

}  // namespace

std::optional<std::string> shipped_page_template() {
  FileError error;
  for (const std::string& folder : shipped_folders("viewer")) {
    auto text = read_file(folder + "/viewer.html", kMostTemplateBytes, error);
    if (text) return text;
  }
  return std::nullopt;
}

std::optional<std::string> page_template(const App& app) {
  auto text = shipped_page_template();
  if (text) return text;
  app.complain(
      "this program was built without its viewer, which takes node and npm: install them (Debian: "
      "nodejs, npm), then configure and build again, with access to npm's packages");
  return std::nullopt;
}

// Installed beside the viewer. Where it was built it has a folder of its own, and in the viewer's
// the name is that of a source.
std::string playground_path() {
  const std::string name = "/playground.html";
  std::error_code ignored;
  for (const std::string& folder : shipped_folders("playground")) {
    if (std::filesystem::exists(folder + name, ignored)) return folder + name;
  }
  for (const std::string& folder : shipped_folders("viewer")) {
    if (std::filesystem::exists(folder + "/package.json", ignored)) continue;
    if (std::filesystem::exists(folder + name, ignored)) return folder + name;
  }
  return {};
}

}  // namespace stig::cli
