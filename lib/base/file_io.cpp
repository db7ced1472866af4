// SPDX-License-Identifier: MIT
// Reading with limits and atomic writing. A write goes to a temporary file in the target's
// directory (a rename must not cross file systems), is synced, renamed, and the directory
// synced as well: after a crash there is the old file or the new one. Names of unfinished
// files stand in static memory, where a signal handler can remove them with
// async-signal-safe calls alone.
#include "base/file_io.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/file_guard.h"
#include "base/memory_file.h"
#include "base/text.h"

namespace stig {

namespace {

/// A file descriptor that closes itself; standard input is left open.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  // Standard streams are not ours to close.
  ~Descriptor() {
    if (fd_ > STDERR_FILENO) ::close(fd_);
  }
  int get() const { return fd_; }
  /// Closes now; false when the system reports a delayed error of writing. Errors of
  /// delayed writes (quotas, network file systems) may only be reported when a file is
  /// closed.
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

std::string reason() { return std::error_code(errno, std::generic_category()).message(); }

void fail(FileError& error, std::string_view doing, const std::string& path) {
  error.message = fmt::format("cannot {} {}: {}", doing, in_quotes(path), reason());
}

std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

bool too_large(FileError& error, const std::string& path, std::size_t most) {
  error.message =
      fmt::format("{} is larger than {} bytes, the most that is read", in_quotes(path), most);
  error.too_large = true;
  return false;
}

/// Reads to the end, or until there is more than `most`. The size that the system
/// reported is no limit: a file may grow while it is read, and /proc has files of size 0.
bool read_all(int fd, const std::string& path, std::size_t most, std::string& out,
              FileError& error) {
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return fail(error, "read", path), false;
    if (got == 0) return true;
    out.append(buffer.data(), static_cast<std::size_t>(got));
    if (out.size() > most) return too_large(error, path, most);
  }
}

/// Is this what it takes to be read or replaced: a plain file?
bool check_regular(const struct stat& status, std::string_view doing, const std::string& path,
                   FileError& error) {
  if (S_ISREG(status.st_mode)) return true;
  error.message =
      fmt::format("cannot {} {}: it is {}", doing, in_quotes(path), kind_of(status.st_mode));
  return false;
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(fd, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return true;
}

/// A name that a signal handler may read: plain memory, published by the flag.
struct Unfinished {
  std::atomic<bool> taken{false}, valid{false};
  std::array<char, PATH_MAX> name{};
};
/// A lock could be held by the thread that the signal interrupts.
static_assert(std::atomic<bool>::is_always_lock_free, "read by a signal handler");
/// More files than are written at a time; those beyond are not cleaned up.
std::array<Unfinished, 64> unfinished;

/// The slot that now holds the name; -1: none is free, or the name is too long.
int note_unfinished(const std::string& name) {
  if (name.size() >= PATH_MAX) return -1;
  for (std::size_t i = 0; i < unfinished.size(); ++i) {
    if (unfinished[i].taken.exchange(true)) continue;
    // The name is complete before `valid` is set; a handler that comes in between leaves it
    // alone.
    std::memcpy(unfinished[i].name.data(), name.c_str(), name.size() + 1);
    unfinished[i].valid.store(true);
    return static_cast<int>(i);
  }
  return -1;
}

/// In this order: a slot that another thread takes must not be valid yet.
void forget_unfinished(int slot) {
  if (slot < 0) return;
  unfinished[static_cast<std::size_t>(slot)].valid.store(false);
  unfinished[static_cast<std::size_t>(slot)].taken.store(false);
}

/// Locks a new file, so that remove_left_behind sees that its writer lives. False when that was
/// quicker. File systems without locks have no such files taken away.
bool keep(int fd) {
  struct stat status {};
  const bool locked = ::flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  return locked && ::fstat(fd, &status) == 0 && status.st_nlink > 0;
}

/// Makes a file with a name of its own beside the target; -1 with errno set. The
/// kernel applies the process's mask to the permissions. The name is noted first, since a signal
/// may come in between.
int open_temporary(const std::string& target, std::string& name, int& slot) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    name = fmt::format("{}.{}-{}.tmp", target, ::getpid(), attempt);
    slot = note_unfinished(name);
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 && keep(fd)) return fd;
    if (fd >= 0) ::close(fd);
    const int problem = fd >= 0 ? EEXIST : errno;
    forget_unfinished(std::exchange(slot, -1));
    errno = problem;
    if (problem != EEXIST) return fd;
  }
  return -1;
}

/// A rename is only safe from a power cut once its directory is on disk. Some
/// file systems cannot sync directories; that is no failure of the write.
void sync_directory(const std::filesystem::path& directory) {
  const Descriptor fd(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() >= 0) ::fsync(fd.get());
}

/// Remembers that an open file is read.
void note_open(int fd) {
  if (const auto file = file_number(fd)) note_read(*file);
}

/// May this file be replaced, if it is there?
bool check_unguarded(const std::string& target, const std::string& path, FileError& error) {
  const auto there = file_number(target);
  const std::string why = there ? why_guarded(*there) : "";
  if (!why.empty()) error.message = fmt::format("cannot write {}: {}", in_quotes(path), why);
  return why.empty();
}

}  // namespace

std::optional<std::string> read_file(const std::string& path, std::size_t most, FileError& error) {
  std::string out;
  if (path == "-") {
    note_open(STDIN_FILENO);
    if (!read_all(STDIN_FILENO, "standard input", most, out, error)) return std::nullopt;
    return out;
  }
  if (auto text = in_memory(path)) {
    if (text->size() <= most) return text;
    too_large(error, path, most);
    return std::nullopt;
  }
  // Without O_NONBLOCK the open itself would wait for the writer of a pipe.
  const Descriptor fd(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (fd.get() < 0 || ::fstat(fd.get(), &status) != 0) {
    fail(error, "open", path);
    return std::nullopt;
  }
  if (!check_regular(status, "read", path, error)) return std::nullopt;
  note_open(fd.get());
  // Refused by its size before it is read, where the size is known.
  if (status.st_size > 0 && static_cast<std::uintmax_t>(status.st_size) > most) {
    too_large(error, path, most);
    return std::nullopt;
  }
  out.reserve(static_cast<std::size_t>(status.st_size));
  if (!read_all(fd.get(), path, most, out, error)) return std::nullopt;
  return out;
}

bool write_file(const std::string& path, std::string_view bytes, FileError& error) {
  if (path == "-") {
    if (write_all(STDOUT_FILENO, bytes)) return true;
    fail(error, "write", "standard output");
    return false;
  }
  GrowingFile file;
  return file.open(path, error) && file.append(bytes, error) && file.commit(error);
}

bool GrowingFile::open(const std::string& path, FileError& error) {
  discard();
  path_ = path;
  target_ = behind_links(path);
  struct stat status {};
  const bool replaces = ::stat(target_.c_str(), &status) == 0;
  if (replaces && !check_regular(status, "write", path, error)) return false;
  if (!check_unguarded(target_, path, error)) return false;
  fd_ = open_temporary(target_, temporary_, slot_);
  // A replaced file keeps its permissions; a new one gets those of the process's mask.
  const bool good = fd_ >= 0 && (!replaces || ::fchmod(fd_, status.st_mode & 07777U) == 0);
  if (!good) {
    fail(error, "write", path_);
    discard();
  }
  return good;
}

bool GrowingFile::append(std::string_view bytes, FileError& error) {
  assert(is_open());
  if (write_all(fd_, bytes)) return true;
  fail(error, "write", path_);
  discard();
  return false;
}

/// Until the moment of the rename the old file is what stands there.
bool GrowingFile::commit(FileError& error) {
  assert(is_open());
  // Another may have been written there, or read, since this one was begun.
  if (!check_unguarded(target_, path_, error)) {
    discard();
    return false;
  }
  Descriptor fd(std::exchange(fd_, -1));
  const auto number = file_number(fd.get());
  const bool good =
      ::fsync(fd.get()) == 0 && fd.close() && ::rename(temporary_.c_str(), target_.c_str()) == 0;
  if (!good) {
    fail(error, "write", path_);
    ::unlink(temporary_.c_str());
  }
  forget_unfinished(std::exchange(slot_, -1));
  if (!good) return false;
  if (number) note_written(*number);
  const std::filesystem::path folder = std::filesystem::path(target_).parent_path();
  sync_directory(folder.empty() ? "." : folder);
  return true;
}

void GrowingFile::discard() {
  if (fd_ < 0) return;
  ::close(std::exchange(fd_, -1));
  ::unlink(temporary_.c_str());
  forget_unfinished(std::exchange(slot_, -1));
}

/// Called from a signal handler: no allocation, no lock, no destructor.
void remove_unfinished_files() {
  for (const Unfinished& one : unfinished) {
    if (one.valid.load()) ::unlink(one.name.data());
  }
}

}  // namespace stig
