// SPDX-License-Identifier: MIT
#include "support/bad_files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "support/golden.h"
#include "support/uses.h"

namespace stig {

namespace {

void expect_line(const std::string& line, std::size_t number, Findings& out) {
  const std::size_t mark = line.find("# expect");
  if (mark == std::string::npos) return;
  std::istringstream words(line.substr(mark + 8));
  if (words.peek() == '@') {
    int offset = 0;
    words.get();
    words >> offset;
    number = static_cast<std::size_t>(static_cast<int>(number) + offset);
  }
  std::string word;
  words >> word;
  REQUIRE(word == ":");
  while (words >> word) out.emplace(number, word);
}

}  // namespace

std::vector<std::string> bad_files(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(STIG_SOURCE_DIR "/" + folder)) {
    files.push_back(entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Findings expected(const std::string& text) {
  Findings out;
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) expect_line(line, number, out);
  return out;
}

Findings found(const Diagnostics& diagnostics) {
  Findings out;
  for (const Diagnostic& d : diagnostics.all()) {
    REQUIRE(d.range);
    out.emplace(d.range.file->position(d.range.begin).line, std::string(info(d.code).name));
  }
  return out;
}

}  // namespace stig
