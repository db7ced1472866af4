// SPDX-License-Identifier: MIT
#include "base/source.h"
#include "support/uses.h"

#include <doctest/doctest.h>

namespace stig {

TEST_CASE("lines, with either line end and without a last one") {
  const SourceFile file("f", "one\ntwo\r\n\nfour");
  CHECK(file.line_count() == 4);
  CHECK(file.line(1) == "one");
  CHECK(file.line(2) == "two");
  CHECK(file.line(3).empty());
  CHECK(file.line(4) == "four");
  CHECK(file.line(0).empty());
  CHECK(file.line(5).empty());
  CHECK(SourceFile("f", "one\n").line_count() == 1);
  CHECK(SourceFile("f", "").line_count() == 0);
}

TEST_CASE("positions count code points") {
  const SourceFile file("f", "aä…b\nxy");
  CHECK(file.position(0).column == 1);
  CHECK(file.position(6).column == 4);
  CHECK(file.position(8).line == 2);
  CHECK(file.position(8).column == 1);
  CHECK(file.position(999).line == 2);
  CHECK(file.position(999).column == 3);
  CHECK(file.line_start(2) == 8);
  CHECK(file.line_start(9) == 10);
  CHECK(SourceFile("f", "").position(3).line == 1);
}

}  // namespace stig
