// SPDX-License-Identifier: MIT
// Every file in tests/bad_scenes says in comments what is wrong with it, as the files of
// tests/bad do: `# expect: R105` on the line concerned, `# expect@+2: S607` two lines on.
// Numbers of lines are those of the file that the report is about.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "physical/scene/scene.h"
#include "physical/support.h"

using namespace stig;

namespace {

constexpr const char* kFolder = STIG_TESTS_DIR "/bad_scenes";

std::string text_of(const std::string& path) {
  FileError error;
  return read_file(path, kMaxSceneBytes, error).value();
}

std::vector<std::string> bad_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Diagnostics read_bad(const std::string& name) {
  Diagnostics diagnostics;
  const auto source =
      std::make_shared<const SourceFile>(name, text_of(std::string(kFolder) + "/" + name));
  const auto scene = read_scene(
      source, disk_loader(kFolder, {STIG_SOURCE_DIR "/blocks", STIG_SOURCE_DIR "/robots"}),
      diagnostics);
  if (scene) CHECK_FALSE(place_scene(*scene, 1, diagnostics));
  return diagnostics;
}

/// "3 R105", for each line that expects something.
std::multiset<std::string> expected(const std::string& text) {
  std::multiset<std::string> out;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::size_t mark = line.find("# expect");
    if (mark == std::string::npos) continue;
    std::istringstream words(line.substr(mark + 8));
    int offset = 0;
    if (words.peek() == '@') words.get(), words >> offset;
    std::string word;
    for (words >> word; words >> word;) out.insert(fmt::format("{} {}", number + offset, word));
  }
  return out;
}

std::multiset<std::string> found(const Diagnostics& diagnostics) {
  std::multiset<std::string> out;
  for (const Diagnostic& d : diagnostics.all()) {
    REQUIRE(d.range);
    out.insert(fmt::format("{} {}", d.range.file->position(d.range.begin).line, info(d.code).name));
  }
  return out;
}

}  // namespace

TEST_CASE("every bad scene is told exactly what its comments say") {
  for (const std::string& name : bad_scenes()) {
    CAPTURE(name);
    const Diagnostics diagnostics = read_bad(name);
    CHECK_MESSAGE(found(diagnostics) == expected(text_of(std::string(kFolder) + "/" + name)),
                  to_text(diagnostics));
    CHECK(diagnostics.has_errors());
  }
}

TEST_CASE("every code of scenes has a bad file named after it") {
  const auto names = bad_scenes();
  for (const CodeInfo& code : all_codes()) {
    if (code.name[0] != 'S') continue;
    CHECK_MESSAGE(std::any_of(names.begin(), names.end(),
                              [&](const std::string& name) { return name.starts_with(code.name); }),
                  code.name);
  }
}

TEST_CASE("what overlaps is named, with both lines") {
  const std::string text = to_text(read_bad("S601-overlap.yaml"));
  CHECK(text.find("'first' and 'second' overlap") != std::string::npos);
  CHECK(text.find("S601-overlap.yaml:4:") != std::string::npos);
  CHECK(text.find("S601-overlap.yaml:3:") != std::string::npos);
}

TEST_CASE("huge scenes and deep ones get an answer") {
  const auto codes = [](const std::string& text) {
    Diagnostics diagnostics;
    read_scene(std::make_shared<const SourceFile>("big.yaml", text), memory_loader({}),
               diagnostics);
    return diagnostics.all().empty() ? std::string()
                                     : std::string(info(diagnostics.all()[0].code).name);
  };
  CHECK(codes(std::string(2'000'000, ' ')) == "R002");
  CHECK(codes("stigc_scene: 1\nblocks: " + std::string(100, '[')) == "R007");
  std::string many = "stigc_scene: 1\nblocks:\n";
  for (int i = 0; i < 30'000; ++i) many += "- {at: [0, 0, 1]}\n";
  CHECK(codes(many) == "R107");
}
