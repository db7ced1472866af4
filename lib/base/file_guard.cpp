// SPDX-License-Identifier: MIT
// Identifies files by device and inode, as the system does, and keeps a ledger of what the
// program has read and written. The ledger is global: a program is guarded as a whole,
// whichever library opens a file. A mutex serves threads; none of this is on a hot path.
#include "base/file_guard.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>
#include <mutex>
#include <set>

namespace stig {
namespace {

namespace fs = std::filesystem;

/// What the program has done so far; its threads read and write, too.
struct Ledger {
  std::mutex mutex;
  bool on = false;
  std::set<FileNumber> read, written, replaceable;
};

Ledger& ledger() {
  static Ledger one;
  return one;
}

FileNumber number_in(const struct stat& status) {
  return {static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino)};
}

/// Nothing is noted before guard_files(): libraries may be used by programs that rewrite
/// files on purpose.
void note(std::set<FileNumber> Ledger::*files, const FileNumber& file) {
  Ledger& all = ledger();
  const std::lock_guard lock(all.mutex);
  if (all.on) (all.*files).insert(file);
}

}  // namespace

std::optional<FileNumber> file_number(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return number_in(status);
}

/// Pipes and terminals have numbers too and are no files that could be written over.
std::optional<FileNumber> file_number(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return number_in(status);
}

/// The limit of hops is the kernel's own for symbolic links, which also ends cycles.
std::string behind_links(const std::string& path) {
  fs::path target = path;
  std::error_code error;
  for (int hops = 0; hops < 40 && fs::is_symlink(target, error); ++hops) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) break;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target.string();
}

std::string file_identity(const FileNumber& file) {
  return fmt::format("{}:{}", file.device, file.inode);
}

/// A file that does not exist has no inode; its folder's and its name identify it, unless
/// the folder is missing too.
std::string file_identity(const std::string& path) {
  if (const auto there = file_number(path)) return file_identity(*there);
  const fs::path target = behind_links(path);
  const fs::path folder = target.parent_path();
  if (const auto in = file_number(folder.empty() ? "." : folder.string())) {
    return file_identity(*in) + "/" + target.filename().string();
  }
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(target, ignored), ignored).string();
}

void guard_files() {
  const std::lock_guard lock(ledger().mutex);
  ledger().on = true;
}

void let_replace(const std::string& path) {
  if (const auto file = file_number(path)) note(&Ledger::replaceable, *file);
}

void let_rewrite(const std::string& path) {
  const auto file = file_number(path);
  Ledger& all = ledger();
  const std::lock_guard lock(all.mutex);
  if (file) all.written.erase(*file);
}

/// Replacing what was read is allowed only where a program has said so, for files that it
/// rewrites in place or continues.
bool was_read(const FileNumber& file) {
  Ledger& all = ledger();
  const std::lock_guard lock(all.mutex);
  return all.read.contains(file) && !all.replaceable.contains(file);
}

bool was_read(const std::string& path) {
  const auto file = file_number(path);
  return file && was_read(*file);
}

/// A second output to one file would silently replace the first.
std::string why_guarded(const FileNumber& file) {
  if (was_read(file)) return "it is what is read";
  Ledger& all = ledger();
  const std::lock_guard lock(all.mutex);
  return all.written.contains(file) ? "it has just been written" : "";
}

void note_read(const FileNumber& file) { note(&Ledger::read, file); }
void note_written(const FileNumber& file) { note(&Ledger::written, file); }

}  // namespace stig
