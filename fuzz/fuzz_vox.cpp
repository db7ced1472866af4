// SPDX-License-Identifier: MIT
// MagicaVoxel files: whatever is accepted is written and read back as itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "lattice/vox.h"
#include "support/uses.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stig;
  const auto read = [](std::string_view bytes) {
    Diagnostics diagnostics;
    auto loaded = read_vox("fuzz.vox", bytes, diagnostics);
    if (loaded.has_value() == diagnostics.has_errors()) std::abort();
    return loaded;
  };
  const auto loaded = read({reinterpret_cast<const char*>(data), size});
  if (!loaded) return 0;
  const auto again = read(print_vox(loaded->structure, loaded->bricks));
  if (!again || !(again->structure == loaded->structure)) std::abort();
  return 0;
}
