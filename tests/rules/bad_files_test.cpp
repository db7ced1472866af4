// SPDX-License-Identifier: MIT
// Every file in tests/bad says in comments what is wrong with it.
#include "support/bad_files.h"

#include <doctest/doctest.h>

#include <set>

#include "rules/rule_reader.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {

TEST_CASE("every bad file is told exactly what its comments say") {
  for (const std::string& name : bad_files("tests/bad")) {
    CAPTURE(name);
    const std::string text = project_file("tests/bad/" + name);
    Diagnostics diagnostics;
    const auto source = std::make_shared<SourceFile>(name, text);
    const bool read = read_rule_set(source, diagnostics).has_value();
    CHECK_MESSAGE(found(diagnostics) == expected(text), to_text(diagnostics));
    CHECK(read != diagnostics.has_errors());
    CHECK_FALSE(diagnostics.all().empty());
  }
}

TEST_CASE("every code of rule set files has a bad file named after it") {
  std::set<std::string> covered;
  for (const std::string& name : bad_files("tests/bad")) {
    const std::string code = name.substr(0, 4);
    for (const auto& [line, expected_code] : expected(project_file("tests/bad/" + name))) {
      if (expected_code == code) covered.insert(code);
    }
  }
  // These need a file that is missing, or too large to keep; hostile_input_test.cpp
  // has them. R318 needs a world: tests/lattice/never_fires_test.cpp.
  covered.insert({"R001", "R002", "R008", "R318"});
  for (const CodeInfo& code : all_codes()) {
    if (code.name[0] == 'R') CHECK_MESSAGE(covered.count(std::string(code.name)) == 1, code.name);
  }
}

}  // namespace stig
