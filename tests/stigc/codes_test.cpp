// SPDX-License-Identifier: MIT
// stigc --explain: every code has an example, which provokes it and, mended, does not.
#include <doctest/doctest.h>

#include "base/diagnostic_example.h"
#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

/// All that is said of an example, whole as a file or run as commands.
std::string said_of(ExampleForm form, std::string_view example) {
  const Workplace place;
  const bool commands = form == ExampleForm::commands;
  place.write("example.yaml", example_file(form, example));
  const std::string line = form == ExampleForm::compiled ? "stigc compile" : "stigc check";
  const Outcome outcome = place.shell(commands ? std::string(example) : line + " example.yaml");
  return outcome.out + outcome.err;
}

TEST_CASE("every example provokes its code, and does not once it is mended") {
  for (const CodeInfo& code : all_codes()) {
    const CodeExample& example = example_of(code.code);
    if (example.form == ExampleForm::words) continue;
    CAPTURE(code.name);
    const std::string label = "[" + std::string(code.name) + "]:";
    const std::string wrong = said_of(example.form, example.wrong);
    CHECK_MESSAGE(wrong.find(label) != std::string::npos, wrong);
    if (example.right.empty()) continue;
    const std::string right = said_of(example.form, example.right);
    CHECK_MESSAGE(right.find(label) == std::string::npos, right);
    CHECK_MESSAGE(right.find("error[") == std::string::npos, right);
  }
}

TEST_CASE("--explain knows codes and slugs, and says what was meant") {
  const Workplace place;
  const std::string text = place.stigc({"--explain", "R304"}).out;
  check_golden("tests/stigc/golden/explain-code.txt",
               transcript("stigc --explain R304", place.shell("stigc --explain R304")));
  for (const std::string line : {"--explain r304", "--explain fires-everywhere", "--explain=R304",
                                 "-q --explain R304", "check --explain R304"}) {
    CAPTURE(line);
    const Outcome same = place.shell("stigc " + line);
    CHECK(same.exit_code == 0);
    CHECK(same.out == text);
  }
  const Outcome unknown = place.stigc({"--explain", "fires-everywere"});
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.out.empty());
  CHECK(unknown.err ==
        "stigc: there is no diagnostic 'fires-everywere'; did you mean 'fires-everywhere'?\n"
        "'stigc --explain' lists them\n");
  CHECK(place.stigc({"--explain", "R3044"}).err.find("did you mean 'R304'?") != std::string::npos);
}

TEST_CASE("--explain alone lists every code, and each of them is explained") {
  const Workplace place;
  const std::string list = place.stigc({"--explain"}).out;
  for (const CodeInfo& code : all_codes()) {
    CAPTURE(code.name);
    CHECK(list.find(std::string(code.name) + "  ") != std::string::npos);
    CHECK(explanation_text(code).find("For example:") != std::string::npos);
  }
}

TEST_CASE("an error says where there is more, a warning and --quiet do not") {
  const Workplace place;
  const std::string more = "for more: stigc --explain R104\n";
  CHECK(place.shell("stigc check sets/bad.yaml").err.ends_with(more));
  CHECK(place.shell("stigc check -q sets/bad.yaml").err.find(more) == std::string::npos);
  CHECK(place.shell("stigc check --diagnostics json sets/bad.yaml").err.empty());
  place.write("warned.yaml", example_file(ExampleForm::rules, "legend: {x: [a]}"));
  const std::string warned = place.stigc({"check", "warned.yaml"}).err;
  CHECK(warned.find("warning[R313]") != std::string::npos);
  CHECK(warned.find("--explain") == std::string::npos);
}

}  // namespace
}  // namespace stig
