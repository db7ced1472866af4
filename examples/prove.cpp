// SPDX-License-Identifier: MIT
// Does every order of events end in the same structure? Proves it and writes the certificate, or
// says what stands against it: stig::verify.
//
//     prove RULESET [CERTIFICATE]
#include <fstream>
#include <iostream>

#include "certify/certificate.h"
#include "rules/rule_reader.h"
#include "verify/verify.h"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: prove RULESET [CERTIFICATE]\n";
    return 2;
  }
  stig::Diagnostics diagnostics;
  const auto rules = stig::rules::read_rule_set_file(argv[1], diagnostics);
  std::cerr << stig::to_text(diagnostics);
  if (!rules) return 1;

  // Without a box the claim is about unbounded space, which is the stronger one. How much is tried
  // is counted in steps, not in seconds, so that the verdict does not depend on the machine.
  stig::verify::VerifyOptions options;
  options.box = stig::verify::file_box(*rules);
  const stig::verify::VerifyResult result = stig::verify::verify(*rules, options);

  std::cout << rules->name << ": " << to_string(result.verdict) << '\n';
  switch (result.verdict) {
    case stig::verify::ProofVerdict::proved:
      std::cout << "every order of events ends in the same " << result.structure->size()
                << " bricks, by the method '" << to_string(result.method) << "'\n";
      break;
    case stig::verify::ProofVerdict::refuted:
      std::cout << "two orders part after " << result.refutation->common << " bricks\n";
      break;
    case stig::verify::ProofVerdict::endless:
      std::cout << "the last " << result.endless->period << " bricks repeat for ever\n";
      break;
    case stig::verify::ProofVerdict::unknown:
      std::cout << result.open << '\n';
      break;
  }
  // check_proof reads it again.
  if (argc > 2 && result.certificate) {
    std::ofstream(argv[2]) << stig::certify::print_certificate(*result.certificate);
  }
  return result.verdict == stig::verify::ProofVerdict::proved ? 0 : 1;
}
