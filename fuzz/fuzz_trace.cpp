// SPDX-License-Identifier: MIT
// Traces: the fuzzer's bytes are the payload, compressed here so that they reach the
// reader behind the decompressor; every other input is a whole file.
#include <cstdint>
#include <string>

#include "base/packed.h"
#include "lattice/trace.h"
#include "support/uses.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  if (!bytes.starts_with("stigtrc1")) bytes = "stigtrc1" + stig::packed(bytes);
  stig::Diagnostics diagnostics;
  stig::read_trace("fuzz.stigt", bytes, diagnostics);
  return 0;
}
