// SPDX-License-Identifier: MIT
#include "base/form.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <algorithm>

#include <memory>
#include <nlohmann/json.hpp>

namespace stig {
namespace {

const Form& leg_form() {
  static const Form form{"leg",
                         {{.name = "at",
                           .kind = FormKind::numbers,
                           .required = true,
                           .low = -1,
                           .high = 1,
                           .least = 3,
                           .most = 3},
                          {.name = "foot", .kind = FormKind::choice, .words = {"wheel", "ball"}}}};
  return form;
}

const Form& table_form() {
  static const Form form{
      "table",
      {{.name = "stigc_table", .kind = FormKind::version, .required = true, .high = 1},
       {.name = "name", .kind = FormKind::name, .required = true},
       {.name = "mass", .kind = FormKind::number, .low = 0, .high = 10, .above_low = true},
       {.name = "tops", .kind = FormKind::integer, .low = 1, .high = 4},
       {.name = "round", .kind = FormKind::boolean},
       {.name = "color", .kind = FormKind::colour},
       {.name = "words", .kind = FormKind::names},
       {.name = "legs", .kind = FormKind::forms, .form = &leg_form(), .most = 3}}};
  return form;
}

struct Checked {
  YamlDocument document;
  BadNodes bad;
  Diagnostics diagnostics;

  explicit Checked(std::string text) {
    auto source = std::make_shared<const SourceFile>("table.yaml", std::move(text));
    auto parsed = parse_yaml(source, {}, diagnostics);
    REQUIRE(parsed);
    document = std::move(*parsed);
    bad = check_form(document, table_form(), diagnostics);
  }
  FormView view() const { return {document.root, bad}; }
  std::string codes() const {
    std::string out;
    for (const Diagnostic* one : sorted_by_place(diagnostics)) {
      out += std::string(info(one->code).name) + " ";
    }
    return out;
  }
};

TEST_CASE("a sound file gives its values, and defaults for what it does not say") {
  const Checked file(
      "stigc_table: 1\nname: desk \nmass: 2.5\nround: true\nwords: [a, b]\n"
      "legs: [{at: [0, 0.5, -1], foot: ball}]\n");
  CHECK(file.codes().empty());
  const FormView view = file.view();
  CHECK(view.text("name") == "desk");
  CHECK(view.number("mass") == 2.5);
  CHECK(view.number("tops", 3) == 3);
  CHECK(view.flag("round"));
  CHECK(view.names("words") == std::vector<std::string>{"a", "b"});
  REQUIRE(view.forms("legs").size() == 1);
  CHECK(view.forms("legs")[0].vector("at") == Vec3{0, 0.5, -1});
  CHECK(view.form("absent").number("x", 7) == 7);
}

TEST_CASE("true or false is meant by other words for them, and by no more") {
  const auto meant = [](const std::string& word) {
    const Checked file("stigc_table: 1\nname: desk\nround: " + word + "\n");
    const auto found = sorted_by_place(file.diagnostics);
    REQUIRE(found.size() == 1);
    return found.front()->suggestion;
  };
  for (const char* word : {"True", "yes", "ON"}) CHECK(meant(word) == "true");
  for (const char* word : {"FALSE", "no", "Off"}) CHECK(meant(word) == "false");
  for (const char* word : {"maybe", "1", "\"\"", "[]"}) CHECK(meant(word).empty());
}

TEST_CASE("every slip is told, and what is sound beside it is still read") {
  const Checked file(
      "stigc_table: 2\nmass: 0\ntops: 1.5\nround: yes\ncolor: red\nwords: 3\nmas: 1\n"
      "legs: [{at: [0, 0]}, {at: [0, 0, 3]}, {at: [0, 0, 1], foot: whel}]\n");
  CHECK(file.codes() == "R102 R108 R105 R103 R103 R106 R103 R101 R107 R105 R104 ");
  CHECK(file.view().forms("legs").empty());
  const auto& all = file.diagnostics.all();
  const auto unknown =
      std::find_if(all.begin(), all.end(), [](const auto& one) { return one.code == Code::R101; });
  CHECK(unknown->message == "unknown key 'mas' in a table");
  CHECK(unknown->suggestion == "mass");
}

TEST_CASE("a file that is no mapping") { CHECK(Checked("- 1\n").codes() == "R103 "); }

TEST_CASE("the schema says the same as the checks") {
  const auto json =
      nlohmann::json::parse(form_schema(table_form(), "stigc table, version 1", "A table."));
  CHECK(json["required"] == nlohmann::json{"stigc_table", "name"});
  CHECK(json["properties"]["mass"]["exclusiveMinimum"] == 0);
  CHECK(json["properties"]["legs"]["maxItems"] == 3);
  CHECK(json["definitions"]["leg"]["properties"]["foot"]["enum"].size() == 2);
  CHECK(json["additionalProperties"] == false);
}

}  // namespace
}  // namespace stig
