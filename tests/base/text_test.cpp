// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "support/uses.h"

#include <doctest/doctest.h>

namespace stig {

TEST_CASE("UTF-8: lengths 1 to 4, and what is none") {
  CHECK(decode_utf8("a").value == U'a');
  CHECK(decode_utf8("ä").value == U'ä');
  CHECK(decode_utf8("…").length == 3);
  CHECK(decode_utf8("\U0001F9F1").value == 0x1F9F1);
  for (const char* bad : {"\x80", "\xC0\x80", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80",
                          "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
    CHECK_FALSE(decode_utf8(bad).valid);
    CHECK(find_invalid_utf8(std::string("ok ä ") + bad) == 6);
  }
  CHECK(find_invalid_utf8("fine … ") == std::string_view::npos);
  CHECK(count_code_points("aä…\xFF") == 4);
}

TEST_CASE("what is shown cannot move the cursor or hide text") {
  CHECK(printable("a\x1b[31mb") == "a\\x1b[31mb");
  CHECK(printable("tab\t") == "tab\\x09");
  CHECK(printable("\xFF") == "\\xff");
  CHECK(printable("right \u202E left") == "right \\u202e left");
  CHECK(printable("ä …") == "ä …");
  CHECK(in_quotes("pink") == "'pink'");
  CHECK(in_quotes(std::string(100, 'x')) == "'" + std::string(60, 'x') + "…'");
}

}  // namespace stig
