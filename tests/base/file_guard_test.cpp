// SPDX-License-Identifier: MIT
#include "base/file_guard.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/file_io.h"
#include "support/uses.h"

namespace stig {

namespace {

namespace fs = std::filesystem;

/// A folder of its own with a file "a", a link, a hard link and a link to a file not there yet.
struct LinkedFolder {
  fs::path path;
  LinkedFolder() {
    std::string name = (fs::temp_directory_path() / "stig-file-guard-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
    std::ofstream(path / "a") << "text\n";
    fs::create_symlink("a", path / "link");
    fs::create_hard_link(path / "a", path / "hard");
    fs::create_directory(path / "sub");
    fs::create_symlink("../later", path / "sub" / "to-later");
  }
  ~LinkedFolder() { fs::remove_all(path); }
  std::string operator/(const char* name) const { return (path / name).string(); }
};

/// Guarding cannot be undone, so it is tried in a process of its own: what `work` returns there.
template <class Work>
int in_guarded_process(const Work& work) {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    guard_files();
    _exit(work());
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool reads(const std::string& path) {
  FileError error;
  return read_file(path, 1000, error).has_value();
}

std::string written(const std::string& path) {
  FileError error;
  return write_file(path, "new\n", error) ? "" : error.message;
}

constexpr const char* kNamesOfA[] = {"a", "./a", "link", "hard", "sub/../a"};

}  // namespace

TEST_CASE("a file has one identity, however it is named, and two files have two") {
  const LinkedFolder folder;
  for (const char* name : kNamesOfA) {
    CAPTURE(name);
    CHECK(file_identity(folder / name) == file_identity(folder / "a"));
  }
  CHECK(file_identity(folder / "later") == file_identity(folder / "sub/to-later"));
  CHECK(file_identity(folder / "later") == file_identity(folder / "sub/.././later"));
  CHECK(file_identity(folder / "later") != file_identity(folder / "sub/later"));
  CHECK(file_identity(folder / "later") != file_identity(folder / "a"));
  CHECK(file_identity(folder / "none/x") == file_identity(folder / "none/../none/x"));
  CHECK(file_identity(folder / "none/x") != file_identity(folder / "none/y"));
}

TEST_CASE("a guarded process writes over nothing that it has read, by no name") {
  const LinkedFolder folder;
  for (const char* name : kNamesOfA) {
    CAPTURE(name);
    CHECK(in_guarded_process([&] {
            return reads(folder / name) && was_read(folder / "a") &&
                           written(folder / "a").ends_with("it is what is read") &&
                           written(folder / name).ends_with("it is what is read")
                       ? 0
                       : 1;
          }) == 0);
    CHECK(reads(folder / "a"));
    std::string text;
    std::getline(std::ifstream(folder / "a"), text);
    CHECK(text == "text");
  }
}

TEST_CASE("a guarded process writes over nothing that it has written") {
  const LinkedFolder folder;
  CHECK(in_guarded_process([&] {
          return written(folder / "sub/to-later").empty() &&
                         written(folder / "later").ends_with("it has just been written")
                     ? 0
                     : 1;
        }) == 0);
}

TEST_CASE("what is read while a file grows is guarded when the file is done") {
  const LinkedFolder folder;
  CHECK(in_guarded_process([&] {
          GrowingFile file;
          FileError error;
          const bool begun = file.open(folder / "link", error) && file.append("new\n", error);
          return begun && reads(folder / "hard") && !file.commit(error) ? 0 : 1;
        }) == 0);
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 4);
}

TEST_CASE("a file that may be replaced is, others and unguarded processes are free") {
  const LinkedFolder folder;
  CHECK(in_guarded_process([&] {
          if (!reads(folder / "a")) return 1;
          let_replace(folder / "hard");
          return written(folder / "other").empty() && written(folder / "link").empty() ? 0 : 2;
        }) == 0);
  CHECK(reads(folder / "a"));
  CHECK_FALSE(was_read(folder / "a"));
  CHECK(written(folder / "a").empty());
  CHECK(written(folder / "a").empty());
}

}  // namespace stig
