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

#include "physical/scene/scene_programs.h"
#include "physical/support.h"
#include "support/uses.h"

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
  const auto placed = scene ? place_scene(*scene, 1, diagnostics) : std::nullopt;
  if (placed) check_programs(*scene, *placed, diagnostics);
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

TEST_CASE("a program is reported once, with the key that names it first and what may be meant") {
  const std::string text = to_text(read_bad("S611-misnamed-step.yaml"));
  CHECK(text.find("misnamed.lua:2:1: error[S611]: there is no function 'step', which each step "
                  "calls: is 'on_step' meant to be 'step'?") != std::string::npos);
  CHECK(text.find("S611-misnamed-step.yaml:4:16: note: ") != std::string::npos);
}

TEST_CASE("programs are tried with what they require, in their sandbox, and as they will run") {
  const auto codes = [](const std::string& scene, const std::vector<SceneFile>& more) {
    std::vector<SceneFile> files = more;
    files.push_back({"stigmergic.yaml", text_of(STIG_SOURCE_DIR "/blocks/stigmergic.yaml")});
    files.push_back({"bebot.yaml", text_of(STIG_SOURCE_DIR "/robots/bebot.yaml")});
    Diagnostics out;
    const auto read = read_scene(
        std::make_shared<const SourceFile>(
            "s.yaml", "stigc_scene: 1\nblocks: [{at: [2, 0, 0.0275], color: off}]\n" + scene),
        memory_loader(std::move(files)), out);
    const auto placed = read ? place_scene(*read, 1, out) : std::nullopt;
    REQUIRE_MESSAGE(placed, to_text(out));
    check_programs(*read, *placed, out);
    std::string all;
    for (const Diagnostic& one : out.all()) {
      all += fmt::format("{} {}:{} ", info(one.code).name, one.range.file->path(),
                         one.range.file->position(one.range.begin).line);
    }
    return all;
  };
  const std::string blocks = "block_program: b.lua\n";
  CHECK(codes(blocks, {{"b.lua", "function step() end"}}).empty());
  CHECK(codes(blocks, {{"b.lua", "function init() step = print end"}}).empty());
  CHECK(codes(blocks, {{"b.lua", "\nlocal function step() end"}}) == "S611 b.lua:1 ");
  CHECK(codes(blocks, {{"b.lua", "while true do end"}}) == "S610 b.lua:1 ");
  CHECK(codes(blocks, {{"b.lua", "step = require 'm'"}, {"m.lua", "\nreturn ="}}) ==
        "S610 m.lua:2 ");
  CHECK(codes(blocks, {{"b.lua", "error(nil)"}}) == "S610 b.lua:1 ");
  const std::string robots =
      "robots: [{file: bebot.yaml, at: [0, 0], program: r.lua, params: {fast: true}}, "
      "{file: bebot.yaml, at: [1, 0], program: r.lua}]\nblock_program: b.lua\n";
  const SceneFile good{"b.lua", "function step() end"};
  CHECK(codes(robots, {good, {"r.lua", "function step() robot.lift_system.stop() end"}}).empty());
  CHECK(codes(robots, {good, {"r.lua", "\nstep = robot.params.fast and print"}}) ==
        "S611 r.lua:1 ");
  CHECK(codes("script: e.lua\n", {{"e.lua", "function on_end(world) world.stop('') end"}}).empty());
  CHECK(codes("script: e.lua\n", {{"e.lua", "\nfunction step() end"}}) == "S611 e.lua:2 ");
  CHECK(codes("script: e.lua\n", {{"e.lua", "\n)"}}) == "S610 e.lua:2 ");
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
