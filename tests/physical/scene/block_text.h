// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "base/file_io.h"
#include "support/uses.h"

namespace stig {

/// The file of the paper's block, which scenes name.
inline std::string block_text() {
  FileError error;
  return read_file(STIG_SOURCE_DIR "/blocks/stigmergic.yaml", std::size_t{1} << 20, error).value();
}

}  // namespace stig
