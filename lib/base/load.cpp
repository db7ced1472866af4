// SPDX-License-Identifier: MIT
#include "base/load.h"

#include <utility>

#include "base/file_io.h"

namespace stig {

SourceRef load_source(const std::string& path, std::size_t most, Diagnostics& diagnostics) {
  FileError error;
  auto text = read_file(path, most, error);
  // The source exists even when reading failed: the diagnostic needs a file to point at.
  auto source = std::make_shared<const SourceFile>(path == "-" ? "<stdin>" : path,
                                                   text ? std::move(*text) : std::string());
  if (text) return source;
  diagnostics.add(error.too_large ? Code::R002 : Code::R001, {std::move(source), 0, 0},
                  error.message);
  return nullptr;
}

}  // namespace stig
