// SPDX-License-Identifier: MIT
// Certificates of robots' work: whatever can be read prints and reads back as itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "recheck/work_certificate.h"
#include "support/uses.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stig;
  const std::string text(reinterpret_cast<const char*>(data), size);
  Diagnostics diagnostics;
  const auto certificate = read_work_certificate("fuzz.cert", text, diagnostics);
  if (certificate.has_value() == diagnostics.has_errors()) std::abort();
  if (!certificate) return 0;
  const std::string printed = print_work_certificate(*certificate);
  if (read_work_certificate("again.cert", printed, diagnostics) != certificate) std::abort();
  return 0;
}
