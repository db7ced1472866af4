// SPDX-License-Identifier: MIT
// Checks a certificate against the rule set that it is of: stig::certify, which shares no code
// with stig::verify. A program that is given proofs by others needs this library alone.
//
//     check_proof RULESET CERTIFICATE
#include <fstream>
#include <iostream>
#include <iterator>

#include "certify/certificate.h"
#include "certify/check.h"
#include "rules/rule_reader.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: check_proof RULESET CERTIFICATE\n";
    return 2;
  }
  std::ifstream file(argv[2], std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), {});

  // Both readers take untrusted text: whatever is malformed becomes a diagnostic.
  stig::Diagnostics diagnostics;
  const auto rules = stig::rules::read_rule_set_file(argv[1], diagnostics);
  const auto certificate = stig::certify::read_certificate(argv[2], text, diagnostics);
  std::cerr << stig::to_text(diagnostics);
  if (!rules || !certificate) return 1;

  const stig::certify::CheckReport report = stig::certify::check_certificate(*rules, *certificate);
  if (!report.accepted) {
    std::cout << "refused: " << report.refusal << '\n';
    return 1;
  }
  std::cout << "accepted: " << report.structure.size() << " bricks in every order of events; "
            << report.sites << " sites and " << report.local_states << " local states checked\n";
}
