// SPDX-License-Identifier: MIT
#include "base/diagnostic.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace stig {

namespace {

SourceRange at(const SourceRef& file, std::string_view what) {
  const auto begin = static_cast<std::uint32_t>(file->text().find(what));
  return {file, begin, begin + static_cast<std::uint32_t>(what.size())};
}

SourceRef file_of(std::string text) {
  return std::make_shared<SourceFile>("a.yaml", std::move(text));
}

}  // namespace

TEST_CASE("place, line, caret, suggestion, notes and summary") {
  const SourceRef file = file_of("bricks: pink\nplace: pnik\n");
  Diagnostics diagnostics;
  diagnostics.add(Code::R204, at(file, "pnik"), "unknown brick 'pnik'")
      .suggest("pink")
      .note(at(file, "bricks"), "bricks are here")
      .note("a word without a place");
  CHECK(to_text(diagnostics) ==
        "a.yaml:2:8: error[R204]: unknown brick 'pnik'\n"
        "    2 | place: pnik\n"
        "      |        ^~~~\n"
        "help: did you mean 'pink'?\n"
        "a.yaml:1:1: note: bricks are here\n"
        "    1 | bricks: pink\n"
        "      | ^~~~~~\n"
        "note: a word without a place\n"
        "1 error\n");
}

TEST_CASE("nothing to say, nothing said") { CHECK(to_text({}).empty()); }

TEST_CASE("sorted by place; those past the most are counted") {
  const SourceRef file = file_of("one\ntwo\nthree\n");
  Diagnostics diagnostics;
  diagnostics.add(Code::R306, at(file, "three"), "third");
  diagnostics.add(Code::R101, at(file, "one"), "first");
  diagnostics.add(Code::R101, at(file, "two"), "second");
  const std::string text = to_text(diagnostics, {.color = false, .most = 2});
  CHECK(text.find("first") < text.find("second"));
  CHECK(text.find("third") == std::string::npos);
  CHECK(text.substr(text.rfind("2 errors")) == "2 errors, 1 warning (2 shown)\n");
}

TEST_CASE("the caret stands under its symbol behind tabs and wide escapes") {
  const SourceRef file = file_of("a\tb\x01 pnik\n");
  Diagnostics diagnostics;
  diagnostics.add(Code::R204, at(file, "pnik"), "m");
  CHECK(to_text(diagnostics)
            .find("    1 | a       b\\x01 pnik\n"
                  "      |               ^~~~\n") != std::string::npos);
}

TEST_CASE("a long line is cut around the caret") {
  const SourceRef file = file_of(std::string(100000, 'x') + "pnik" + std::string(100000, 'y'));
  Diagnostics diagnostics;
  diagnostics.add(Code::R204, at(file, "pnik"), "m");
  const std::string text = to_text(diagnostics);
  CHECK(text.size() < 500);
  const std::string before = "    1 | …" + std::string(40, 'x');
  CHECK(text.find(before + "pnik") != std::string::npos);
  CHECK(text.find("      | " + std::string(41, ' ') + "^~~~\n") != std::string::npos);
}

TEST_CASE("a range at the end of the file or in an empty one") {
  for (const char* text : {"", "one\n", "one"}) {
    const SourceRef file = file_of(text);
    const auto end = static_cast<std::uint32_t>(file->text().size());
    Diagnostics diagnostics;
    diagnostics.add(Code::R006, {file, end, end}, "m");
    CHECK(to_text(diagnostics).find("a.yaml:") == 0);
    CHECK_NOTHROW(to_json(diagnostics));
  }
}

TEST_CASE("messages of several lines are indented, and nothing escapes") {
  Diagnostics diagnostics;
  diagnostics.add(Code::R001, {}, "evil \x1b[2J").note("drawn:\n. .\n* .\n");
  CHECK(to_text(diagnostics) ==
        "error[R001]: evil \\x1b[2J\n"
        "note: drawn:\n        . .\n        * .\n"
        "1 error\n");
}

TEST_CASE("colours only on request") {
  Diagnostics diagnostics;
  diagnostics.add(Code::R001, {}, "m");
  CHECK(to_text(diagnostics).find('\x1b') == std::string::npos);
  CHECK(to_text(diagnostics, {.color = true}).find("\x1b[1;31merror[R001]:") != std::string::npos);
}

TEST_CASE("JSON has the same data") {
  const SourceRef file = file_of("aä pnik\n");
  Diagnostics diagnostics;
  diagnostics.add(Code::R204, at(file, "pnik"), "m").suggest("pink").note("n");
  const auto json = nlohmann::json::parse(to_json(diagnostics));
  REQUIRE(json.size() == 1);
  CHECK(json[0]["code"] == "R204");
  CHECK(json[0]["slug"] == "unknown-symbol");
  CHECK(json[0]["line"] == 1);
  CHECK(json[0]["column"] == 4);
  CHECK(json[0]["end_column"] == 8);
  CHECK(json[0]["suggestion"] == "pink");
  CHECK(json[0]["notes"][0]["message"] == "n");
  CHECK(json[0]["notes"][0]["path"].is_null());
}

TEST_CASE("any number of diagnostics: the first are kept, all are counted") {
  Diagnostics diagnostics;
  for (int i = 0; i < 5000; ++i) diagnostics.add(Code::R101, {}, "m");
  CHECK(diagnostics.all().size() == Diagnostics::kMostKept);
  CHECK(diagnostics.count(Severity::error) == 5000);
  Diagnostics other;
  other.append(diagnostics);
  other.append(diagnostics);
  CHECK(other.all().size() == Diagnostics::kMostKept);
  CHECK(other.count(Severity::error) == 10000);
}

TEST_CASE("codes are unique, sorted into groups, and explained") {
  std::set<std::string_view> names, slugs;
  for (const CodeInfo& code : all_codes()) {
    CAPTURE(code.name);
    CHECK(names.insert(code.name).second);
    CHECK(slugs.insert(code.slug).second);
    CHECK(code.explanation.size() > 20);
    CHECK(info(code.code).name == code.name);
  }
}

TEST_CASE("edit distance counts slips, neighbours swapped too") {
  CHECK(edit_distance("pink", "pink", 5) == 0);
  CHECK(edit_distance("pnik", "pink", 5) == 1);
  CHECK(edit_distance("", "abc", 5) == 3);
  CHECK(edit_distance("kitten", "sitting", 5) == 3);
  CHECK(edit_distance("kitten", "sitting", 2) > 2);
}

TEST_CASE("suggestions are near or none") {
  CHECK(nearest("pnik", {"blue", "pink"}) == "pink");
  CHECK(nearest("symetry", {"source", "symmetry"}) == "symmetry");
  CHECK(nearest("zzz", {"pink", "blue"}).empty());
  CHECK(nearest("4", {"1", "2", "3"}).empty());
  CHECK(nearest("", {"a"}).empty());
}

}  // namespace stig
