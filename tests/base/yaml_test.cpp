// SPDX-License-Identifier: MIT
#include "base/yaml.h"
#include "support/uses.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

namespace stig {

namespace {

std::optional<YamlDocument> parse(const std::string& text, Diagnostics& diagnostics) {
  return parse_yaml(std::make_shared<SourceFile>("f", text), {}, diagnostics);
}

YamlDocument parsed(const std::string& text) {
  Diagnostics diagnostics;
  auto document = parse(text, diagnostics);
  REQUIRE_MESSAGE(document.has_value(), to_text(diagnostics));
  REQUIRE(diagnostics.all().empty());
  return *std::move(document);
}

/// The source text that a node covers.
std::string covered(const YamlDocument& document, const YamlNode& node) {
  return document.source->text().substr(node.begin, node.end - node.begin);
}

std::string code_of(const std::string& text) {
  Diagnostics diagnostics;
  parse(text, diagnostics);
  return diagnostics.all().empty() ? "" : std::string(info(diagnostics.all()[0].code).name);
}

}  // namespace

TEST_CASE("values stay texts, whatever they look like") {
  const YamlDocument document = parsed("a: 010\nb: yes\nc: 1e3\nd: \"x\\ty\"\ne: 'it''s'\n");
  CHECK(document.root.find("a")->text == "010");
  CHECK(document.root.find("b")->text == "yes");
  CHECK(document.root.find("c")->style == YamlStyle::plain);
  CHECK(document.root.find("d")->text == "x\ty");
  CHECK(document.root.find("d")->style == YamlStyle::quoted);
  CHECK(document.root.find("e")->text == "it's");
  CHECK(document.root.find("f") == nullptr);
}

TEST_CASE("every node covers its own text") {
  const YamlDocument document = parsed(
      "plain: two words   # comment\n"
      "folded: a text\n  on two lines\n"
      "quoted: \"a \\\" b\"\n"
      "single: 'it''s' \n"
      "flow: [a, {b: c}, [ ] ] # ]\n"
      "block:\n  - x\n  - y: z\n"
      "literal: |\n    one\n     two\n\nlast: 1\n");
  const YamlNode& root = document.root;
  CHECK(covered(document, *root.find("plain")) == "two words");
  CHECK(covered(document, *root.find("folded")) == "a text\n  on two lines");
  CHECK(covered(document, *root.find("quoted")) == "\"a \\\" b\"");
  CHECK(covered(document, *root.find("single")) == "'it''s'");
  CHECK(covered(document, *root.find("flow")) == "[a, {b: c}, [ ] ]");
  CHECK(covered(document, root.find("flow")->items[1]) == "{b: c}");
  CHECK(covered(document, *root.find("block")) == "- x\n  - y: z");
  CHECK(covered(document, *root.find("literal")) == "|\n    one\n     two");
  CHECK(covered(document, root.pairs[0].key) == "plain");
}

TEST_CASE("nothing written and null are null, and have a place") {
  const YamlDocument document = parsed("a:\nb: ~\nc: null\nd: [x, ~]\n? e\n");
  for (const char* key : {"a", "b", "c", "e"}) {
    REQUIRE(document.root.find(key) != nullptr);
    CHECK(document.root.find(key)->kind == YamlKind::null);
    CHECK(document.root.find(key)->end <= document.source->text().size());
  }
  CHECK(document.root.find("d")->items[1].kind == YamlKind::null);
}

TEST_CASE("a part of a literal block is found in the file") {
  for (const char* text :
       {"k: |\n  ab cd\n  ef gh\n", "k: |2\n    ab cd\n  ef gh\n",
        "- k: |   # note\n    ab cd\n    ef gh\n", "k: |\r\n  ab cd\r\n  ef gh\r\n",
        "k: |\n\n\n  ab cd\n\n  ef gh", "\xEF\xBB\xBFk: |-\n  ä ab\n  ef gh\n"}) {
    CAPTURE(text);
    const YamlDocument document = parsed(text);
    const YamlNode& root = document.root;
    const YamlNode& node =
        root.kind == YamlKind::sequence ? *root.items[0].find("k") : *root.find("k");
    const std::size_t at = node.text.find("gh");
    const SourceRange range = YamlTextMap(document, node).range(at, at + 2);
    CHECK(document.source->text().substr(range.begin, range.end - range.begin) == "gh");
  }
}

TEST_CASE("comments, but not what only looks like one") {
  const YamlDocument document = parsed(
      "# first\n"
      "a: b#c  # behind\n"
      "d: \"# no\" # yes\n"
      "e: '# no'\n"
      "f: |  # header\n"
      "  # content\n"
      "# after\n"
      "g: [x, # inside\n  y]\n"
      "h: plain\n  folded # end\n");
  std::vector<std::string> found;
  for (const YamlComment& comment : document.comments) {
    found.push_back(document.source->text().substr(comment.begin, comment.end - comment.begin) +
                    (comment.trailing ? " <" : ""));
  }
  CHECK(found == std::vector<std::string>{"# first", "# behind <", "# yes <", "# header <",
                                          "# after", "# inside <", "# end <"});
}

TEST_CASE("what is no YAML, or not of this language's YAML") {
  CHECK(code_of("") == "R005");
  CHECK(code_of("# comment\n") == "R005");
  CHECK(code_of("\xEF\xBB\xBF") == "R005");
  CHECK(code_of("a: [1\n") == "R006");
  CHECK(code_of("a: b: c\n") == "R006");
  CHECK(code_of("a: \"x\n") == "R006");
  CHECK(code_of("\ta: b\n") == "R006");
  CHECK(code_of("[a]\nb: c\n") == "R006");
  CHECK(code_of("a: 1\n---\nb: 2\n") == "R009");
  CHECK(code_of("a: 1\n...\n").empty());
  CHECK(code_of("--- # start\na: 1\n").empty());
  CHECK(code_of("a: &x 1\n") == "R010");
  CHECK(code_of("a: !!str 1\n") == "R011");
  CHECK(code_of("a: 1\na: 2\n") == "R012");
  CHECK(code_of(std::string("a: \0", 4)) == "R003");
  // yaml-cpp takes this byte for the end of the text.
  CHECK(code_of("a: \x04\n") == "R003");
  CHECK(code_of("a: \xC3\n") == "R004");
}

TEST_CASE("law: any text printed as YAML reads back as itself, in and out of brackets") {
  CHECK(rc::check([](const std::string& bytes) {
    std::string text;
    for (const char c : bytes) text += static_cast<char>(c & 0x7F);
    text += *rc::gen::element("", "ä", "\u2028", " ", "\U0001F9F1", ": ", " #", "\n", "]", "-");
    const YamlDocument document =
        parsed("a: " + yaml_text(text) + "  # c\nb: [" + yaml_text(text, true) + "]\n" +
               yaml_text("k" + text) + ": 1\n");
    RC_ASSERT(document.root.find("a")->text == text);
    RC_ASSERT(document.root.find("b")->items.at(0).text == text);
    RC_ASSERT(document.root.find("k" + text) != nullptr);
  }));
}

}  // namespace stig
