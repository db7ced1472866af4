// SPDX-License-Identifier: MIT
// A page has no files but those that it is given.
#include "base/file_io.h"

namespace stig {

std::optional<std::string> read_file(const std::string& path, std::size_t, FileError& error) {
  error.message = "'" + path + "' cannot be read: a page has no files";
  return std::nullopt;
}

}  // namespace stig
