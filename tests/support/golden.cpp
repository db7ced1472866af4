// SPDX-License-Identifier: MIT
#include "support/golden.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <sstream>
#include <string>
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

namespace {

/// The first line in which two texts that differ do so: its number, and what it is in either.
std::string first_difference(const std::string& is, const std::string& would_be) {
  std::istringstream left(is), right(would_be);
  std::string a, b;
  for (std::size_t line = 1;; ++line) {
    const bool more_a = static_cast<bool>(std::getline(left, a));
    const bool more_b = static_cast<bool>(std::getline(right, b));
    if (more_a == more_b && a == b && more_a) continue;
    return "line " + std::to_string(line) + "\n  is        " + (more_a ? a : "not there") +
           "\n  would be  " + (more_b ? b : "not there");
  }
}

}  // namespace

void check_golden(const std::string& path, const std::string& text) {
  const char* update = std::getenv("STIG_UPDATE_GOLDEN");
  if (update != nullptr && std::string_view(update) == "1") {
    FileError error;
    REQUIRE_MESSAGE(write_file(STIG_SOURCE_DIR "/" + path, text, error), error.message);
  }
  const std::string file = project_file(path);
  // Not the texts themselves, of which doctest would print hundreds of lines.
  const bool same = file == text;
  CHECK_MESSAGE(same, path, " differs, first in ", same ? "" : first_difference(file, text),
                "\nSTIG_UPDATE_GOLDEN=1 writes it anew: look at what has changed");
}

}  // namespace stig
