// SPDX-License-Identifier: MIT
// Pages: what goes into them comes out again, and what does not fit is refused.
#include "view/page.h"
#include "support/uses.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>
#include <zlib.h>

#include <nlohmann/json.hpp>

#include "base/base64.h"
#include "base/bytes.h"
#include "rules/rule_reader.h"
#include "view/lattice_run.h"

namespace stig {
namespace {

std::string inflated(const std::string& bytes, std::size_t size) {
  std::string out(size, '\0');
  uLongf length = out.size();
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                     reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) == Z_OK);
  out.resize(length);
  return out;
}

/// As tools/viewer/src/packed_data.ts reads a column.
std::vector<std::int64_t> column_of(const nlohmann::ordered_json& place, const std::string& bytes) {
  ByteReader in(std::string_view(bytes).substr(place["at"].get<std::size_t>()));
  std::vector<std::int64_t> out;
  std::int64_t value = 0;
  for (std::size_t i = 0; i < place["count"].get<std::size_t>(); ++i) {
    out.push_back(value += in.zigzag());
  }
  return out;
}

constexpr const char* kLine =
    "stigc: 1\nname: line\nlattice: cubic\nsymmetry: none\nbricks:\n"
    "  1: {name: one, color: \"#e6194b\"}\nstart:\n  - {at: [0, 0, 0], brick: 1}\n"
    "rules:\n  - name: on\n    place: 1\n    when: |\n"
    "      . . .   . . .   . . .\n      . . .   1 * .   . . .\n      . . .   . . .   . . .\n";

RuleSet line_rules() {
  Diagnostics diagnostics;
  auto rules = read_rule_set(std::make_shared<const SourceFile>("line.yaml", kLine), diagnostics);
  REQUIRE(rules);
  return *rules;
}

Trace line_of(int length) {
  Trace trace;
  for (int i = 1; i < length; ++i) {
    trace.events.push_back({{i, 0, 0}, 1, {0, 0}, -1, static_cast<std::uint64_t>(i)});
  }
  return trace;
}

TEST_CASE("bytes are deflated without loss") {
  CHECK(rc::check("deflated", [](const std::string& bytes) {
    RC_ASSERT(inflated(deflated(bytes), bytes.size() + 1) == bytes);
  }));
}

TEST_CASE("columns hold any whole numbers, one after the other") {
  CHECK(rc::check("columns", [](const std::vector<std::int32_t>& first,
                                const std::vector<std::int32_t>& second) {
    const std::vector<std::int64_t> a(first.begin(), first.end()), b(second.begin(), second.end());
    PageColumns columns;
    const auto place_a = columns.add(a), place_b = columns.add(b);
    RC_ASSERT(column_of(place_a, columns.bytes()) == a);
    RC_ASSERT(column_of(place_b, columns.bytes()) == b);
  }));
}

TEST_CASE("a page is its template with title and data in their places") {
  PageContent content("a <b> & c");
  const auto page = page_of("<title>@TITLE@</title><data>@DATA@</data>", content);
  REQUIRE(page);
  CHECK(*page == "<title>a &lt;b&gt; &amp; c</title><data>" + content.data() + "</data>");
  CHECK(!page_of("<title>@TITLE@</title>", content));
  CHECK(!page_of("<data>@DATA@</data><title>@TITLE@</title>", content));
}

TEST_CASE("a player is the template's style, script and body, with the data in their place") {
  PageContent content("t");
  const std::string_view whole =
      "<meta content=\"script-src 'sha256-x'; style-src 'sha256-y'\"><title>@TITLE@</title>"
      "<style>a{}</style><body><i>@DATA@</i><script>1</script></body>";
  const auto parts = player_of(whole, content);
  REQUIRE(parts);
  CHECK(parts->script == "'sha256-x'");
  CHECK(parts->style == "a{}");
  CHECK(parts->body == "<i>" + content.data() + "</i><script>1</script>");
  for (const std::string_view part : {"script-src", "<style>", "</body>", "@DATA@"}) {
    std::string damaged(whole);
    damaged.erase(damaged.find(part), part.size());
    CHECK_MESSAGE(!player_of(damaged, content), part);
  }
}

TEST_CASE("the data of a run are its bricks in their order, and its rules' lines") {
  PageContent one("one"), two("two");
  CHECK(!add_lattice_run(line_of(2), line_rules(), "a.stigt", one));
  CHECK(!add_lattice_run(line_of(40), line_rules(), "a.stigt", two));
  CHECK(one.data() != two.data());
  CHECK(two.columns().bytes().size() > one.columns().bytes().size());
}

TEST_CASE("events that are none of the rules are refused by their number") {
  const RuleSet rules = line_rules();
  Trace twice = line_of(3), colour = line_of(3), rule = line_of(3), far = line_of(3);
  twice.events[1].site = {1, 0, 0};
  colour.events[0].colour = 2;
  rule.events[1].match.rule = 1;
  far.events[1].site.x = kMaxCoordinate + 1;
  PageContent content("t");
  CHECK(add_lattice_run(twice, rules, "t", content) == "event 2 is in a cell that has a brick");
  CHECK(add_lattice_run(colour, rules, "t", content) ==
        "event 1 places a brick that its rules do not have");
  CHECK(add_lattice_run(rule, rules, "t", content) == "event 2 is of a rule that there is not");
  CHECK(add_lattice_run(far, rules, "t", content) == "event 2 is too far away");
}

}  // namespace
}  // namespace stig
