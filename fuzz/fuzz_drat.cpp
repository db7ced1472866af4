// SPDX-License-Identifier: MIT
// A formula and, behind a zero byte, a proof: what is refuted has no solution.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "certify/clauses.h"
#include "certify/drat.h"
#include "support/uses.h"

namespace {

using namespace stig;

constexpr std::uint64_t kMostVariables = 10;

bool has_solution(std::string_view formula) {
  CnfReader reader(formula);
  std::vector<Literals> clauses;
  for (Literals clause; reader.next(clause) == Read::clause;) clauses.push_back(clause);
  for (std::uint32_t values = 0; values < 2U << reader.variables; ++values) {
    const auto holds = [&](Literal l) { return (values >> l / 2 & 1U) != (l & 1U); };
    if (std::all_of(clauses.begin(), clauses.end(), [&](const Literals& clause) {
          return std::any_of(clause.begin(), clause.end(), holds);
        })) {
      return true;
    }
  }
  return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t zero = std::min(bytes.find('\0'), size);
  const std::string_view formula = bytes.substr(0, zero);
  const DratReport report = check_drat(formula, bytes.substr(std::min(zero + 1, size)));
  if (report.refuted != report.refusal.empty()) std::abort();
  if (report.refuted && report.variables <= kMostVariables && has_solution(formula)) std::abort();
  return 0;
}
