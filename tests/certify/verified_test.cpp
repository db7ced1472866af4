// SPDX-License-Identifier: MIT
// Certificates as the verifier writes them.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "certify/changes.h"
#include "certify/check.h"
#include "support/shipped.h"
#include "support/small_worlds.h"
#include "support/uses.h"
#include "verify/verify.h"

namespace stig {
namespace {

VerifyResult verified(const RuleSet& rules, std::uint64_t work) {
  VerifyOptions options;
  options.box = file_box(rules);
  options.work = work;
  return verify::verify(rules, options);
}

TEST_CASE("shipped sets that are proved have certificates that are accepted") {
  int proved = 0;
  for (const std::string& name : shipped_names()) {
    CAPTURE(name);
    const RuleSet rules = shipped(name);
    const VerifyResult result = verified(rules, 20'000'000'000);
    if (result.verdict != ProofVerdict::proved) continue;
    ++proved;
    const CheckReport report = check_certificate(rules, *result.certificate);
    CHECK(report.refusal == "");
    CHECK(report.structure == result.structure->bricks());
    // The proof of another set is none for this one.
    Certificate other = *result.certificate;
    other.rule_set_hash ^= 1;
    CHECK_FALSE(check_certificate(rules, other).accepted);
  }
  CHECK(proved >= 5);
}

void change_and_check(const RuleSet& rules, const VerifyResult& result, int& accepted,
                      int& refused) {
  const auto ends = all_ends(rules, 20'000);
  if (!ends) return;
  for (int change = 0; change < 20; ++change) {
    Certificate certificate = *result.certificate;
    change_somewhere(certificate);
    const CheckReport report = check_certificate(rules, certificate);
    (report.accepted ? accepted : refused) += 1;
    if (!report.accepted) continue;
    RC_ASSERT(ends->size() == 1U);
    RC_ASSERT(report.structure == result.structure->bricks());
  }
}

TEST_CASE("changed certificates of the verifier claim the only end or are refused") {
  int accepted = 0, refused = 0;
  CHECK(rc::check("changed", [&] {
    for (int world = 0; world < 5; ++world) {
      const auto seed = *rc::gen::resize(100, rc::gen::inRange<std::uint64_t>(0, 1'000'000));
      const RuleSet rules = small_world(seed);
      const VerifyResult result = verified(rules, 5'000'000'000);
      if (result.verdict != ProofVerdict::proved || result.run.size() < 3) continue;
      change_and_check(rules, result, accepted, refused);
    }
  }));
  MESSAGE("accepted " << accepted << ", refused " << refused);
  CHECK(accepted > 0);
  CHECK(refused > 100);
}

}  // namespace
}  // namespace stig
