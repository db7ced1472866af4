// SPDX-License-Identifier: MIT
// Examples for every code, taken from base/examples_*.def, and small good files into which
// they fit. A static_assert demands one example for each code in the same order, so adding
// a code without one does not compile.
#include "base/diagnostic_example.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <vector>

namespace stig {
namespace {

constexpr CodeExample kExamples[] = {
#define STIG_EXAMPLE(code, form, wrong, right) \
  CodeExample{Code::code, ExampleForm::form, wrong, right},
#include "base/examples_rules.def"

#include "base/examples_files.def"

#include "base/examples_physical.def"
#undef STIG_EXAMPLE
};

constexpr Code kCodes[] = {
#define STIG_DIAGNOSTIC(code, severity, slug, explanation) Code::code,
#include "base/diagnostics.def"
#undef STIG_DIAGNOSTIC
};

static_assert(
    std::equal(std::begin(kExamples), std::end(kExamples), std::begin(kCodes), std::end(kCodes),
               [](const CodeExample& example, Code code) { return example.code == code; }),
    "every code of diagnostics.def has one example, in the same order");

/// The good files are as small as their formats allow, so that an example's keys stand out.
constexpr std::string_view kRules = R"(stigc: 1
name: example
lattice: cubic
bricks:
  a: {name: red, color: "#e6194b"}
  b: {name: green, color: "#3cb44b"}
start:
  - {at: [0, 0, 0], brick: a}
rules:
  - name: beside
    place: b
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   a * ?   ? ? ?
      ? ? ?   ? ? ?   ? ? ?
)";

constexpr std::string_view kCompiled = R"(stigc: 1
name: example
lattice: cubic
symmetry: none
floor: true
bricks:
  1: {name: Q1, color: "#e6194b", led: Q1}
  2: {name: Q2, color: "#3cb44b", led: Q2}
  3: {name: Q3, color: "#4363d8", led: Q3}
  4: {name: Q4, color: "#f58231", led: Q4}
start:
  - {at: [0, 0, 0], brick: 1}
physical: {sides: [+x]}
rules:
  - name: before
    place: 2
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   1 * ?   ? ? ?
      ? ? ?   ? ? ?   ? ? ?
)";

constexpr std::string_view kScene = R"(stigc_scene: 1
blocks:
  - {at: [0, 0, 0.0275]}
)";

constexpr std::string_view kRobot = R"(stigc_robot: 1
name: example
bodies:
  - {name: chassis, box: [0.1, 0.1, 0.1], mass: 1, base: [0, 0, 0]}
  - {name: wheel, sphere: {radius: 0.1}, mass: 1, center: [0, 0, 0.1]}
joints:
  - {parent: chassis, child: wheel,
     axes: [{turn: [0, 1, 0], actuator: velocity, most_force: 1}]}
)";

std::string_view good_file(ExampleForm form) {
  switch (form) {
    case ExampleForm::rules:
      return kRules;
    case ExampleForm::scene:
      return kScene;
    case ExampleForm::robot:
      return kRobot;
    case ExampleForm::compiled:
      return kCompiled;
    case ExampleForm::commands:
    case ExampleForm::words:
      break;
  }
  return {};
}

/// The lines of a text, without their ends.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// "rules" of the line "rules:"; empty for a line that goes on with what came before. Only
/// top-level keys count: they are what an example replaces.
std::string_view key_of(std::string_view line) {
  const bool begins = !line.empty() && line.front() >= 'a' && line.front() <= 'z';
  return begins ? line.substr(0, line.find(':')) : std::string_view();
}

std::string indented(std::string_view text, std::string_view indent) {
  std::string out;
  for (const std::string_view line : lines_of(text)) out += fmt::format("{}{}\n", indent, line);
  return out;
}

/// Words in lines of at most 80 columns. Greedy, word by word; explanations have no words
/// longer than a line.
std::string in_lines(std::string_view text) {
  constexpr std::size_t kWidth = 80;
  std::string out;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column > 0) out += column + 1 + end > kWidth ? '\n' : ' ';
    column = column > 0 && column + 1 + end <= kWidth ? column + 1 + end : end;
    out += text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out + '\n';
}

std::string_view word_of(Severity severity) {
  return severity == Severity::error ? "error" : "warning";
}

}  // namespace

const CodeExample& example_of(Code code) {
  assert(static_cast<std::size_t>(code) < std::size(kExamples));
  return kExamples[static_cast<std::size_t>(code)];
}

/// Keys that the example gives replace those of the good file, lines below them included.
std::string example_file(ExampleForm form, std::string_view keys) {
  std::vector<std::string_view> given;
  for (const std::string_view line : lines_of(keys)) given.push_back(key_of(line));
  std::string out;
  bool kept = true;
  for (const std::string_view line : lines_of(good_file(form))) {
    const std::string_view key = key_of(line);
    if (!key.empty()) kept = std::find(given.begin(), given.end(), key) == given.end();
    if (kept) out += fmt::format("{}\n", line);
  }
  return fmt::format("{}{}\n", out, keys);
}

/// Codes are accepted in lower case, slugs as they are.
const CodeInfo* find_code(std::string_view name) {
  const auto same = [](char a, char b) { return a == b || (b >= 'A' && b <= 'Z' && a == b + 32); };
  for (const CodeInfo& code : all_codes()) {
    const bool named =
        std::equal(name.begin(), name.end(), code.name.begin(), code.name.end(), same);
    if (named || name == code.slug) return &code;
  }
  return nullptr;
}

std::string example_text(const CodeInfo& code, std::string_view indent) {
  const CodeExample& example = example_of(code.code);
  std::string out = fmt::format("For example:\n\n{}", indented(example.wrong, indent));
  if (!example.right.empty()) {
    out += fmt::format("\nMended:\n\n{}", indented(example.right, indent));
  }
  return out;
}

std::string explanation_text(const CodeInfo& code) {
  return fmt::format("{}[{}]: {}\n\n{}\n{}", word_of(code.severity), code.name, code.slug,
                     in_lines(code.explanation), example_text(code, "    "));
}

std::string list_of_codes() {
  std::string out;
  for (const CodeInfo& code : all_codes()) {
    out += fmt::format("{}  {:<7}  {}\n", code.name, word_of(code.severity), code.slug);
  }
  return out;
}

}  // namespace stig
