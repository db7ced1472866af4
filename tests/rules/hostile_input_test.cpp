// SPDX-License-Identifier: MIT
// Inputs made to hurt: each ends in the diagnostic named, with little memory. That it
// ends in little time too is for ctest's limit and the benchmarks to see.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "rules/rule_reader.h"
#include "support/uses.h"

namespace stig {

namespace {

std::string repeated(std::string_view what, std::size_t bytes) {
  std::string out;
  while (out.size() + what.size() <= bytes) out += what;
  return out;
}

/// The first code reported.
std::string verdict(std::string text) {
  Diagnostics diagnostics;
  const bool read =
      read_rule_set(std::make_shared<SourceFile>("hostile", std::move(text)), diagnostics)
          .has_value();
  CHECK(read != diagnostics.has_errors());
  CHECK(diagnostics.all().size() <= Diagnostics::kMostKept);
  // Rendering must be as safe as reading.
  CHECK(to_text(diagnostics).size() < 1'000'000);
  return diagnostics.all().empty() ? "" : std::string(info(diagnostics.all()[0].code).name);
}

constexpr std::size_t kFull = kMaxRuleFileBytes;
constexpr const char* kHead = "stigc: 1\nname: x\nlattice: cubic\n";

}  // namespace

TEST_CASE("deep nesting") {
  for (const char* open : {"[", "{a: ", "[{", "- ", "? ", "a: - ", ": "}) {
    CAPTURE(open);
    const std::string code = verdict(repeated(open, kFull));
    CHECK((code == "R007" || code == "R006"));
  }
  std::string blocks;
  for (std::size_t i = 0; i < 1000; ++i) blocks += std::string(i, ' ') + "a:\n";
  CHECK(verdict(blocks) == "R007");
}

TEST_CASE("too many values") {
  CHECK(verdict(repeated("- \n", kFull)) == "R008");
  CHECK(verdict(repeated("a:\n", kFull)) == "R008");
  CHECK(verdict(repeated("? a\n", kFull)) == "R008");
  CHECK(verdict("[" + repeated(",a", kFull - 2) + "]") == "R008");
  CHECK(verdict(kHead + ("start: [" + repeated("{},", 800'000) + "]\n")) == "R008");
}

TEST_CASE("many aliases, anchors, tags and documents") {
  CHECK(verdict("a: &a [x]\nb: [" + repeated("*a, ", 400'000) + "]\n") == "R010");
  CHECK(verdict(repeated("- &a x\n", 700'000)) == "R010");
  CHECK(verdict(repeated("- !a x\n", 700'000)) == "R011");
  CHECK(verdict(repeated("--- a\n", kFull)) == "R009");
}

TEST_CASE("long lines and large texts") {
  for (const char* bit :
       {"x", "x ", "\n", " ", "#", "# \n", "'", "\"", "|", ">",  "\\", "%", "!",
        "&", "*",  "@",  "`", "-", "?",    ":", "]",  "}", "\t", "\r", "ä", "...\n"}) {
    CAPTURE(bit);
    CHECK_FALSE(verdict(repeated(bit, kFull)).empty());
    CHECK_FALSE(verdict(kHead + ("title: " + repeated(bit, kFull - 100))).empty());
    CHECK_FALSE(verdict(kHead + ("title: |\n  " + repeated(bit, kFull - 100))).empty());
    CHECK_FALSE(verdict(kHead + ("title: \"" + repeated(bit, kFull - 100))).empty());
    CHECK_FALSE(verdict(kHead + ("start: [" + repeated(bit, kFull - 100))).empty());
  }
}

TEST_CASE("thousands of errors on one line") {
  CHECK(verdict(kHead + ("start: [" + repeated("0,", 200'000) + "]\n")) == "R103");
  CHECK(verdict("{" + repeated("a: 1, ", 500'000) + "}") == "R012");
}

TEST_CASE("drawings and structures of a megabyte") {
  const std::string bricks = std::string(kHead) + "bricks: {1: {color: \"#000000\"}}\n";
  const std::string rule =
      "start: [{at: [0, 0, 0], brick: 1}]\nrules:\n  - name: a\n    place: 1\n    when: |\n";
  CHECK(verdict(bricks + rule + repeated("      1 1 1\n", 900'000)) == "R201");
  CHECK(verdict(bricks + rule + "      " + repeated("1 ", 900'000) + "\n") == "R201");
  CHECK(verdict(bricks + "expect:\n  structure: |\n" + repeated("    ---\n", 900'000)) == "R102");
  CHECK(verdict(bricks + "expect:\n  structure: |\n    " + repeated("1 ", 900'000) + "\n") ==
        "R102");
}

TEST_CASE("files over the limit, and none") {
  CHECK(verdict(std::string(kFull + 1, ' ')) == "R002");
  CHECK(verdict(std::string(5'000'000, 'x')) == "R002");
  Diagnostics diagnostics;
  CHECK_FALSE(read_rule_set_file("/nonexistent/x.yaml", diagnostics));
  CHECK(diagnostics.all()[0].code == Code::R001);
  CHECK_FALSE(read_rule_set_file("/", diagnostics));
  CHECK(diagnostics.all()[1].code == Code::R001);
  const auto path = std::filesystem::temp_directory_path() / "stig-hostile.yaml";
  {
    const auto made = std::filesystem::exists(path) || std::ofstream(path).good();
    REQUIRE(made);
  }
  std::filesystem::resize_file(path, 233'000'000);
  CHECK_FALSE(read_rule_set_file(path.string(), diagnostics));
  CHECK(diagnostics.all()[2].code == Code::R002);
  std::filesystem::remove(path);
}

TEST_CASE("thousands of rules that all meet each other") {
  std::string text = std::string(kHead) + "symmetry: rotations+mirrors\nbricks:\n" +
                     "  1: {color: \"#000000\"}\n  2: {color: \"#ffffff\"}\n" +
                     "start: [{at: [0, 0, 0], brick: 1}]\nrules:\n";
  for (int i = 0; text.size() < kFull - 300; ++i) {
    const std::string number = std::to_string(i);
    text += "  - name: r" + number + "\n    place: " + (i % 2 == 0 ? "1" : "2") +
            "\n    when: |\n      ? ? # . ? # ? . ?\n      . ? 1 ? * ? # ? .\n      ? ? ? # ? ? . "
            "? ?\n" +
            "    height: {min: " + number + ", max: " + number + "}\n" +
            "    count: [{of: [1], max: " + std::to_string(3 + i % 9) + "}]\n";
  }
  const std::string code = verdict(text);
  CHECK((code == "R302" || code.empty()));
}

}  // namespace stig
