// SPDX-License-Identifier: MIT
#include "base/base64.h"
#include "support/uses.h"

#include <doctest/doctest.h>

namespace stig {
namespace {

TEST_CASE("base64 of RFC 4648, section 10") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfb") == "//77");
}

}  // namespace
}  // namespace stig
