// SPDX-License-Identifier: MIT
// Structures as JSON: whatever is accepted prints and reads back as itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "lattice/structure_json.h"
#include "support/uses.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stig;
  const auto read = [](std::string text) {
    Diagnostics diagnostics;
    const auto source = std::make_shared<SourceFile>("fuzz.json", std::move(text));
    auto loaded = read_structure_json(source, diagnostics);
    if (loaded.has_value() == diagnostics.has_errors()) std::abort();
    to_text(diagnostics);
    return loaded;
  };
  const auto loaded = read({reinterpret_cast<const char*>(data), size});
  if (!loaded) return 0;
  const auto again = read(print_structure_json(loaded->structure, loaded->bricks));
  if (!again || !(again->structure == loaded->structure)) std::abort();
  return 0;
}
