// SPDX-License-Identifier: MIT
#include "rules/rule_schema.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/golden.h"
#include "support/uses.h"

namespace stig {

namespace {

/// The form with all that are mentioned in it, each once.
void add_forms(const Form& form, std::vector<const Form*>& out) {
  if (std::find(out.begin(), out.end(), &form) != out.end()) return;
  out.push_back(&form);
  for (const FormKey& key : form.keys) {
    if (key.form != nullptr) add_forms(*key.form, out);
    if (key.entry != nullptr && key.entry->form != nullptr) add_forms(*key.entry->form, out);
  }
}

}  // namespace

TEST_CASE("every key of a rule set is in the JSON Schema and on the page of the language") {
  const auto schema = nlohmann::json::parse(json_schema());
  const std::string page = project_file("docs/language.md");
  std::vector<const Form*> forms;
  add_forms(rule_set_form(), forms);
  CHECK(forms.size() == 9);
  for (const Form* form : forms) {
    std::string name(form->title);
    std::replace(name.begin(), name.end(), ' ', '_');
    const auto& own = form == &rule_set_form() ? schema : schema.at("definitions").at(name);
    for (const FormKey& key : form->keys) {
      CAPTURE(form->title);
      CAPTURE(key.name);
      REQUIRE(own.at("properties").contains(std::string(key.name)));
      CHECK(own["properties"][std::string(key.name)]["description"] == key.doc);
      // In a table's first column, or as it is written in a mapping on one line.
      const std::string word(key.name);
      CHECK((page.find("`" + word + "`") != std::string::npos ||
             page.find("{" + word + ":") != std::string::npos ||
             page.find(", " + word + ":") != std::string::npos));
    }
  }
}

}  // namespace stig
