// SPDX-License-Identifier: MIT
// Structure drawings: whatever is accepted prints and reads back as itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "lattice/structure_text.h"
#include "support/uses.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stig;
  const auto read = [](std::string text) {
    Diagnostics diagnostics;
    const auto source = std::make_shared<SourceFile>("fuzz.txt", std::move(text));
    auto structure = read_structure_text(source, Lattice::cubic, {}, diagnostics);
    if (structure.has_value() == diagnostics.has_errors()) std::abort();
    to_text(diagnostics);
    return structure;
  };
  const auto structure = read({reinterpret_cast<const char*>(data), size});
  if (structure && read(print_structure(*structure)) != to_origin(*structure)) std::abort();
  return 0;
}
