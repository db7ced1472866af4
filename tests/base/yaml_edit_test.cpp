// SPDX-License-Identifier: MIT
// Values put into YAML: all else stays as it was.
#include "base/yaml_edit.h"

#include <doctest/doctest.h>

#include "base/file_io.h"
#include "base/memory_file.h"
#include "support/uses.h"

namespace stig {
namespace {

const std::string kText =
    "name: x  # a name\nlist:\n  - name: one\n    value: 1\n  - {name: two, value: 2}\n"
    "text: |\n  a b\n  c\nlast: {}\n";

std::string put(const std::string& path, const std::string& value) {
  std::string problem;
  const auto out = with_value(kText, path, value, problem);
  return out ? *out : "! " + problem;
}

std::string replaced(std::string from, const std::string& to) {
  std::string out = kText;
  return out.replace(out.find(from), from.size(), to);
}

TEST_CASE("a value is replaced where it stands") {
  CHECK(put("name", "y") == replaced("name: x", "name: y"));
  CHECK(put("list.one.value", "7") == replaced("value: 1", "value: 7"));
  CHECK(put("list.two.value", "[7, 8]") == replaced("value: 2", "value: [7, 8]"));
  CHECK(put("list.2.value", "7") == replaced("value: 2", "value: 7"));
  CHECK(put("text", "d") == replaced("|\n  a b\n  c", "d"));
}

TEST_CASE("a key that was not there comes first in its mapping") {
  CHECK(put("list.one.more", "3") == replaced("- name: one", "- more: 3\n    name: one"));
  CHECK(put("list.two.more", "3") == replaced("{name: two", "{more: 3, name: two"));
  CHECK(put("last.more", "3") == replaced("{}", "{more: 3}"));
  CHECK(put("more", "3") == "more: 3\n" + kText);
}

TEST_CASE("a way that leads nowhere is said") {
  CHECK(put("list.three.value", "1") == "! there is no 'three' at 'list.three.value'");
  CHECK(put("list.0", "1") == "! there is no '0' at 'list.0'");
  CHECK(put("none.value", "1") == "! there is no 'none' at 'none.value'");
  CHECK(put("name.value", "1") == "! there is no 'value' at 'name.value'");
  std::string problem;
  CHECK_FALSE(with_value("a: [", "a", "1", problem));
  CHECK(problem == "it is no YAML");
}

TEST_CASE("a file in memory is read by its name while it lives") {
  FileError error;
  {
    const MemoryFile file("/nowhere/at/all", "text");
    CHECK(read_file("/nowhere/at/all", 100, error) == "text");
    CHECK_FALSE(read_file("/nowhere/at/all", 3, error));
    CHECK(error.too_large);
  }
  CHECK_FALSE(read_file("/nowhere/at/all", 100, error));
}

}  // namespace
}  // namespace stig
