// SPDX-License-Identifier: MIT
// A journal holds what was appended, whatever happened in between.
#include "base/journal.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <vector>

namespace stig {
namespace {

namespace fs = std::filesystem;

/// A name for a file that goes with the test.
struct Place {
  fs::path folder = fs::temp_directory_path() / ("stig-journal-" + std::to_string(::getpid()));
  std::string file = (folder / "work.journal").string();
  Place() { fs::create_directory(folder); }
  ~Place() { fs::remove_all(folder); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
};

using Lines = std::vector<std::string>;

/// The lines of a journal that is opened, or what was wrong.
Lines lines_in(Journal& journal, const std::string& path, const std::string& work = "w") {
  Lines out;
  FileError error;
  const bool good = journal.open(
      path, work, [&](std::string_view line) { return out.emplace_back(line), true; }, error);
  return good ? out : Lines{error.message};
}
void add(Journal& journal, std::string_view line) {
  FileError error;
  const bool good = journal.append(line, error);
  REQUIRE_MESSAGE(good, error.message);
}

TEST_CASE("lines come back, and more can follow") {
  const Place place;
  {
    Journal journal;
    CHECK(lines_in(journal, place.file).empty());
    add(journal, "one");
    add(journal, "two\nthree");
  }
  Journal journal;
  CHECK(lines_in(journal, place.file) == Lines{"one", "two", "three"});
  add(journal, "four");
  journal.close();
  CHECK(lines_in(journal, place.file) == Lines{"one", "two", "three", "four"});
  journal.remove();
  CHECK_FALSE(fs::exists(place.file));
}

TEST_CASE("cut anywhere, a journal has its whole lines and goes on") {
  CHECK(rc::check("", [] {
    const Place place;
    const auto count = *rc::gen::inRange(0, 6);
    {
      Journal journal;
      lines_in(journal, place.file);
      for (int i = 0; i < count; ++i) add(journal, std::string(static_cast<std::size_t>(i), 'x'));
    }
    const auto size = fs::file_size(place.file);
    const auto kept = *rc::gen::inRange<std::uintmax_t>(0, size + 1);
    fs::resize_file(place.file, kept);
    Journal journal;
    const Lines lines = lines_in(journal, place.file);
    RC_ASSERT(lines.size() <= static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < lines.size(); ++i) RC_ASSERT(lines[i] == std::string(i, 'x'));
    if (kept == size) RC_ASSERT(lines.size() == static_cast<std::size_t>(count));
    add(journal, "more");
    journal.close();
    Lines after = lines;
    after.emplace_back("more");
    RC_ASSERT(lines_in(journal, place.file) == after);
  }));
}

TEST_CASE("a line that is refused is dropped with all behind it") {
  const Place place;
  Journal journal;
  lines_in(journal, place.file);
  add(journal, "one\ntwo\nthree");
  journal.close();
  FileError error;
  REQUIRE(journal.open(
      place.file, "w", [](std::string_view line) { return line != "two"; }, error));
  journal.close();
  CHECK(lines_in(journal, place.file) == Lines{"one"});
}

TEST_CASE("one process at a time, one work a journal, and no other file") {
  const Place place;
  Journal one, other;
  CHECK(lines_in(one, place.file).empty());
  CHECK(lines_in(other, place.file).at(0).ends_with("is in use: the same command runs already"));
  one.close();
  CHECK(lines_in(other, place.file, "another").at(0).find("is of another command") !=
        std::string::npos);
  std::ofstream(place.file, std::ios::trunc) << "a,b\n1,2\n";
  CHECK(lines_in(other, place.file).at(0).ends_with("is there already, and no journal"));
  std::ofstream(place.file, std::ios::trunc) << "a";
  CHECK(lines_in(other, place.file).at(0).ends_with("is there already, and no journal"));
  fs::remove(place.file);
  fs::create_symlink(place.folder / "elsewhere", place.file);
  CHECK(lines_in(other, place.file).at(0).starts_with("cannot open"));
  CHECK(lines_in(other, (place.folder / "none" / "x").string()).at(0).starts_with("cannot open"));
}

TEST_CASE("where no more fits, nothing is lost that was taken") {
  const Place place;
  Journal journal;
  lines_in(journal, place.file);
  add(journal, "one");
  // A limit on the size of files stands for a full disk.
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto old = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100, before.rlim_max};
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  FileError error;
  const bool written = journal.append(std::string(500, 'y'), error);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old);
  CHECK_FALSE(written);
  CHECK(error.message.starts_with("cannot write"));
  add(journal, "two");
  journal.close();
  CHECK(lines_in(journal, place.file) == Lines{"one", "two"});
}

}  // namespace
}  // namespace stig
