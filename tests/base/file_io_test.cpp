// SPDX-License-Identifier: MIT
#include "base/file_io.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "base/left_behind.h"
#include "base/load.h"
#include "support/uses.h"

namespace stig {

namespace {

/// A folder of its own, gone at the end.
struct Folder {
  std::filesystem::path path;
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "stig-file-io-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string operator/(const char* name) const { return (path / name).string(); }
  std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(path), {});
  }
};

std::string read(const std::string& path) {
  FileError error;
  return read_file(path, 1000, error).value_or("error: " + error.message);
}

}  // namespace

TEST_CASE("what is written is read back, and nothing else is left behind") {
  const Folder folder;
  FileError error;
  REQUIRE(write_file(folder / "a", std::string("x\0y\n", 4), error));
  CHECK(read(folder / "a") == std::string("x\0y\n", 4));
  REQUIRE(write_file(folder / "a", "shorter", error));
  CHECK(read(folder / "a") == "shorter");
  CHECK(folder.files() == 1);
}

TEST_CASE("unfinished files are taken away on demand, whole ones stay") {
  const Folder folder;
  FileError error;
  GrowingFile whole, half;
  REQUIRE(whole.open(folder / "whole", error));
  REQUIRE(whole.commit(error));
  REQUIRE(half.open(folder / "half", error));
  REQUIRE(half.append("begun", error));
  CHECK(folder.files() == 2);
  remove_unfinished_files();
  CHECK(folder.files() == 1);
  CHECK(read(folder / "whole").empty());
  CHECK_FALSE(half.commit(error));
}

TEST_CASE("what a killed writer left is taken away, and nothing that a living one writes") {
  const Folder folder;
  FileError error;
  GrowingFile mine;
  REQUIRE(mine.open(folder / "mine", error));
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    GrowingFile trace, other;
    trace.open(folder / "trace", error);
    other.open(folder / "other", error);
    ::raise(SIGKILL);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(folder.files() == 3);
  // Names that are no temporary file's, or of no writer.
  for (const char* name : {"trace.tmp", "trace.7-.tmp", "trace.99999999-0", "trace.-1-0.tmp"}) {
    REQUIRE(write_file(folder / name, "", error));
  }
  remove_left_behind(folder.path.string(), {"mine", "trace"});
  CHECK(folder.files() == 6);  // all but the child's trace
  CHECK_FALSE(std::filesystem::exists(folder.path / fmt::format("trace.{}-0.tmp", child)));
  CHECK(mine.commit(error));
  remove_left_behind((folder.path / "nowhere").string(), {"mine"});
}

TEST_CASE("permissions of a replaced file are kept") {
  const Folder folder;
  FileError error;
  REQUIRE(write_file(folder / "a", "1", error));
  REQUIRE(::chmod((folder / "a").c_str(), 0640) == 0);
  REQUIRE(write_file(folder / "a", "2", error));
  struct stat status {};
  REQUIRE(::stat((folder / "a").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("a link is followed, also to a file that is not there yet") {
  const Folder folder;
  FileError error;
  std::filesystem::create_symlink("target", folder / "link");
  REQUIRE(write_file(folder / "link", "1", error));
  REQUIRE(write_file(folder / "link", "2", error));
  CHECK(std::filesystem::is_symlink(folder / "link"));
  CHECK(read(folder / "target") == "2");
}

TEST_CASE("what cannot be read or written says why") {
  const Folder folder;
  FileError error;
  CHECK_FALSE(read_file(folder / "none", 10, error));
  CHECK(error.message.find("No such file") != std::string::npos);
  CHECK_FALSE(error.too_large);
  CHECK_FALSE(read_file(folder.path.string(), 10, error));
  CHECK(error.message.find("a directory") != std::string::npos);
  CHECK_FALSE(write_file(folder.path.string(), "x", error));
  CHECK_FALSE(write_file(folder / "none/a", "x", error));
  CHECK_FALSE(read_file("/dev/zero", 10, error));
  CHECK_FALSE(write_file("/dev/null", "x", error));
  CHECK(error.message.find("a device") != std::string::npos);
}

TEST_CASE("a pipe is refused at once, without waiting for its other end") {
  const Folder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  FileError error;
  CHECK_FALSE(read_file(folder / "pipe", 10, error));
  CHECK_FALSE(write_file(folder / "pipe", "x", error));
  CHECK(error.message.find("a pipe") != std::string::npos);
}

TEST_CASE("a file that is too large is refused unread") {
  const Folder folder;
  FileError error;
  REQUIRE(write_file(folder / "a", "0123456789", error));
  CHECK(read_file(folder / "a", 10, error) == "0123456789");
  CHECK_FALSE(read_file(folder / "a", 9, error));
  CHECK(error.too_large);
  // Sparse: 233 MB that nobody stores.
  std::filesystem::resize_file(folder / "a", 233'000'000);
  CHECK_FALSE(read_file(folder / "a", 1000, error));
  CHECK(error.too_large);
}

TEST_CASE("a source that cannot be loaded is a diagnostic at its path") {
  const Folder folder;
  FileError error;
  REQUIRE(write_file(folder / "a", "0123456789", error));
  Diagnostics diagnostics;
  const SourceRef source = load_source(folder / "a", 10, diagnostics);
  REQUIRE(source);
  CHECK(source->path() == folder / "a");
  CHECK(source->text() == "0123456789");
  CHECK(diagnostics.all().empty());
  CHECK_FALSE(load_source(folder / "a", 9, diagnostics));
  CHECK_FALSE(load_source(folder / "none", 9, diagnostics));
  REQUIRE(diagnostics.all().size() == 2);
  CHECK(diagnostics.all()[0].code == Code::R002);
  CHECK(diagnostics.all()[1].code == Code::R001);
  CHECK(diagnostics.all()[1].range.file->path() == folder / "none");
}

}  // namespace stig
