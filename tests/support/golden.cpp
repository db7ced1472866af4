// SPDX-License-Identifier: MIT
#include "support/golden.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string_view>

#include "base/file_io.h"
#include "support/uses.h"

namespace stig {

std::string project_file(const std::string& path) {
  FileError error;
  const auto text = read_file(STIG_SOURCE_DIR "/" + path, std::size_t{1} << 24, error);
  REQUIRE_MESSAGE(text.has_value(), error.message);
  return *text;
}

void check_golden(const std::string& path, const std::string& text) {
  const char* update = std::getenv("STIG_UPDATE_GOLDEN");
  if (update != nullptr && std::string_view(update) == "1") {
    FileError error;
    REQUIRE_MESSAGE(write_file(STIG_SOURCE_DIR "/" + path, text, error), error.message);
  }
  CHECK_MESSAGE(project_file(path) == text, path, " differs; it would be:\n", text);
}

}  // namespace stig
