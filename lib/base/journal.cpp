// SPDX-License-Identifier: MIT
#include "base/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

#include "base/text.h"

namespace stig {

namespace {

constexpr std::string_view kJournalHead = "stigc journal 1: ";
constexpr std::size_t kMostJournalLine = std::size_t{1}
                                         << 26;  ///< bytes; longer ones are none of ours

bool journal_failed(FileError& error, std::string_view doing, const std::string& path) {
  error.message = fmt::format("cannot {} {}: {}", doing, in_quotes(path),
                              std::error_code(errno, std::generic_category()).message());
  return false;
}

/// Calls with each whole line of a file and where the next one begins, until one is refused.
bool each_line(int fd, const std::function<bool(std::string_view line, std::size_t next)>& each) {
  std::string rest;
  std::array<char, 65536> buffer;
  std::size_t at = 0;  // of `rest` in the file
  for (off_t read_to = 0;;) {
    const ssize_t count = ::pread(fd, buffer.data(), buffer.size(), read_to);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    if (count == 0) return true;
    read_to += count;
    rest.append(buffer.data(), static_cast<std::size_t>(count));
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = rest.find('\n', begin)) != rest.npos; begin = end + 1) {
      if (!each(std::string_view(rest).substr(begin, end - begin), at + end + 1)) return true;
    }
    rest.erase(0, begin);
    at += begin;
    if (rest.size() > kMostJournalLine) return true;
  }
}

bool write_all_at(int fd, std::string_view bytes, std::size_t at) {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(fd, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
    at += static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

bool Journal::check_head(std::string_view work, FileError& error) {
  std::string head;
  std::size_t end = 0;
  each_line(fd_, [&](std::string_view line, std::size_t next) {
    head = line;
    end = next;
    return false;
  });
  const std::string wanted = std::string(kJournalHead) + std::string(work);
  struct stat status {};
  if (end == 0) {
    // Nothing but the beginning of a first line: that of a process that was killed right then.
    std::array<char, 16> begin{};
    const ssize_t count = ::pread(fd_, begin.data(), begin.size(), 0);
    const std::string_view there(begin.data(), count < 0 ? 0 : static_cast<std::size_t>(count));
    if (::fstat(fd_, &status) == 0 && (status.st_size == 0 || kJournalHead.starts_with(there))) {
      size_ = 0;
      return append(wanted, error);
    }
  }
  if (!head.starts_with(kJournalHead)) {
    error.message = fmt::format("{} is there already, and no journal", in_quotes(path_));
    return false;
  }
  if (head != wanted) {
    error.message = fmt::format(
        "{} is of another command, another version or other inputs; take it away to begin anew",
        in_quotes(path_));
    return false;
  }
  size_ = end;
  return true;
}

bool Journal::open(const std::string& path, std::string_view work,
                   const std::function<bool(std::string_view line)>& each, FileError& error) {
  assert(!is_open() && work.find('\n') == work.npos);
  path_ = path;
  fd_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (fd_ < 0) return journal_failed(error, "open", path);
  struct stat status {};
  if (::fstat(fd_, &status) != 0 || !S_ISREG(status.st_mode)) {
    error.message = fmt::format("{} is no file for a journal", in_quotes(path));
    close();
    return false;
  }
  // Of the open file, so that it ends with the process however that ends.
  if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) {
    error.message = fmt::format("{} is in use: the same command runs already", in_quotes(path));
    close();
    return false;
  }
  if (!check_head(work, error) || !read(each, error)) {
    close();
    return false;
  }
  // What is behind the last line that was taken: torn, or refused.
  if (::ftruncate(fd_, static_cast<off_t>(size_)) != 0) {
    journal_failed(error, "shorten", path);
    close();
    return false;
  }
  return true;
}

bool Journal::read(const std::function<bool(std::string_view line)>& each, FileError& error) {
  bool first = true;
  const bool good = each_line(fd_, [&](std::string_view line, std::size_t next) {
    if (!std::exchange(first, false) && !each(line)) return false;
    size_ = next;
    return true;
  });
  return good || journal_failed(error, "read", path_);
}

bool Journal::append(std::string_view lines, FileError& error) {
  assert(is_open());
  const std::string bytes = std::string(lines) + '\n';
  if (write_all_at(fd_, bytes, size_) && ::fdatasync(fd_) == 0) {
    size_ += bytes.size();
    return true;
  }
  journal_failed(error, "write", path_);
  // All or none: what a full disk took is given back.
  if (::ftruncate(fd_, static_cast<off_t>(size_)) != 0) error.message += ", nor shorten it again";
  return false;
}

void Journal::close() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

void Journal::remove() {
  assert(is_open());
  ::unlink(path_.c_str());
  close();
}

}  // namespace stig
