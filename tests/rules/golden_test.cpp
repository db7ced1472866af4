// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "base/diagnostic_page.h"
#include "rules/rule_reader.h"
#include "rules/rule_schema.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {

TEST_CASE("the full text of diagnostics, for bad files of each group") {
  for (const char* name : {"R006-hash-in-brackets",
                           "R006-key-without-space",
                           "R006-no-bar",
                           "R006-rows-not-indented",
                           "R006-syntax-indent",
                           "R006-uneven-keys",
                           "R010-alias",
                           "R012-missing-dash",
                           "R101-unknown-key",
                           "R102-misspelt",
                           "R102-missing-key",
                           "R103-hash",
                           "R103-other-forms",
                           "R103-wrong-type",
                           "R105-out-of-range",
                           "R106-bad-text",
                           "R201-separators",
                           "R201-slices",
                           "R204-names",
                           "R204-unknown-symbol",
                           "R205-floor-not-whole",
                           "R208-name-twice",
                           "R301-conflict",
                           "R301-conflict-exact",
                           "R305-never-matches",
                           "R311-expectation"}) {
    Diagnostics diagnostics;
    const std::string file = std::string(name) + ".yaml";
    read_rule_set(std::make_shared<SourceFile>(file, project_file("tests/bad/" + file)),
                  diagnostics);
    check_golden("tests/golden/" + std::string(name) + ".txt", to_text(diagnostics));
  }
}

TEST_CASE("diagnostics as JSON") {
  Diagnostics diagnostics;
  const std::string file = "R208-name-twice.yaml";
  read_rule_set(std::make_shared<SourceFile>(file, project_file("tests/bad/" + file)), diagnostics);
  check_golden("tests/golden/R208-name-twice.json", to_json(diagnostics));
}

TEST_CASE("the JSON Schema") { check_golden("tests/golden/schema.json", json_schema()); }

TEST_CASE("the page of diagnostics") {
  check_golden("docs/diagnostics.md", diagnostics_markdown());
}

}  // namespace stig
