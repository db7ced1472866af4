// SPDX-License-Identifier: MIT
// Certificates for one rule set whose only end is known: whatever is accepted claims that
// end, and whatever can be read prints and reads back as itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "certify/check.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "support/uses.h"

namespace {

using namespace stig;

// Stage 1: east of a 1 a 2, north of it a 3, in either order. Stage 2: a row east of the 2.
constexpr const char* kRules = R"(stigc: 1
name: fuzz
lattice: cubic
symmetry: none
bricks:
  1: {name: one, color: "#e6194b"}
  2: {name: two, color: "#3cb44b"}
  3: {name: three, color: "#4363d8"}
start:
  - {at: [0, 0, 0], brick: 1}
rules:
  - {name: east, place: 2, stage: 1, when: "? ? ? . . . ? ? ?\n? ? ? 1 * . ? ? ?\n? ? ? ? ? ? ? ? ?"}
  - {name: east second, place: 2, stage: 1, when: "? ? ? 3 . . ? ? ?\n? ? ? 1 * . ? ? ?\n? ? ? ? ? ? ? ? ?"}
  - {name: north, place: 3, stage: 1, when: "? ? ? . . . ? ? ?\n? ? ? . * . ? ? ?\n? ? ? . 1 . ? ? ?"}
  - {name: north second, place: 3, stage: 1, when: "? ? ? . . . ? ? ?\n? ? ? . * . ? ? ?\n? ? ? . 1 2 ? ? ?"}
  - {name: row, place: 3, stage: 2, when: "? ? ? ? ? ? ? ? ?\n? ? ? 2 * ? ? ? ?\n? ? ? ? ? ? ? ? ?"}
  - {name: row end, place: 1, stage: 2, when: "? ? ? ? . ? ? ? ?\n? ? ? 3 * . ? ? ?\n? ? ? ? . ? ? ? ?", height: {max: 0}}
box: {size: [4, 2, 1], origin: [0, 0, 0]}
)";

const std::vector<PlacedBrick> kEnd{
    {{0, 0, 0}, 1}, {{0, 1, 0}, 3}, {{1, 0, 0}, 2}, {{2, 0, 0}, 3}, {{3, 0, 0}, 1}};

const RuleSet& the_rules() {
  static const RuleSet set = [] {
    Diagnostics diagnostics;
    auto read = read_rule_set(std::make_shared<const SourceFile>("fuzz.yaml", kRules), diagnostics);
    if (!read) std::abort();
    return *read;
  }();
  return set;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  Diagnostics diagnostics;
  auto certificate = read_certificate("fuzz.cert", text, diagnostics);
  if (certificate.has_value() == diagnostics.has_errors()) std::abort();
  to_text(diagnostics);
  if (!certificate) return 0;
  const auto again = read_certificate("again.cert", print_certificate(*certificate), diagnostics);
  if (again != certificate) std::abort();
  // These two no mutation would ever find.
  certificate->rule_set_hash = rule_set_hash(the_rules());
  certificate->box = the_rules().box;
  const CheckReport report = check_certificate(the_rules(), *certificate);
  if (report.accepted != report.refusal.empty()) std::abort();
  if (report.accepted && report.structure != kEnd) std::abort();
  return 0;
}
