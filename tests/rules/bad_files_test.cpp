// SPDX-License-Identifier: MIT
// Every file in tests/bad says in comments what is wrong with it, on the line
// concerned: `# expect: R104 R105`. Inside a drawing a comment would be content, so
// `# expect@+2: R204` speaks of the second line after its own.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "base/file_io.h"
#include "rules/rule_reader.h"

namespace stig {

namespace {

/// Line and code, for every diagnostic of a file.
using Findings = std::multiset<std::pair<std::size_t, std::string>>;

std::vector<std::filesystem::path> bad_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(STIG_TESTS_DIR "/bad")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const std::filesystem::path& path) {
  FileError error;
  return read_file(path.string(), std::size_t{1} << 24, error).value();
}

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

}  // namespace

TEST_CASE("every bad file is told exactly what its comments say") {
  for (const auto& path : bad_files()) {
    CAPTURE(path.filename().string());
    const std::string text = text_of(path);
    Diagnostics diagnostics;
    const auto source = std::make_shared<SourceFile>(path.filename().string(), text);
    const bool read = read_rule_set(source, diagnostics).has_value();
    CHECK_MESSAGE(found(diagnostics) == expected(text), to_text(diagnostics));
    CHECK(read != diagnostics.has_errors());
    CHECK_FALSE(diagnostics.all().empty());
  }
}

TEST_CASE("every code of rule set files has a bad file named after it") {
  std::set<std::string> covered;
  for (const auto& path : bad_files()) {
    const std::string code = path.filename().string().substr(0, 4);
    for (const auto& [line, expected_code] : expected(text_of(path))) {
      if (expected_code == code) covered.insert(code);
    }
  }
  // These need a file that is missing, or too large to keep; hostile_input_test.cpp
  // has them.
  covered.insert({"R001", "R002", "R008"});
  for (const CodeInfo& code : all_codes()) {
    if (code.name[0] == 'R') CHECK_MESSAGE(covered.count(std::string(code.name)) == 1, code.name);
  }
}

}  // namespace stig
