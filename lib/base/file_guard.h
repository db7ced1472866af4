// SPDX-License-Identifier: MIT
// Which file a path leads to, and which files a program has read and written.
//
// A program that guards its files writes over nothing that it has read, and over nothing that it
// has written. The system is asked which file it is, so another spelling, a link or a hard link
// makes no difference. Nothing is guarded before guard_files(): a library does not know that what
// goes in and what comes out are to be different files, a program does.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace stig {

/// What the system tells a file apart by, whatever its names.
struct FileNumber {
  std::uint64_t device = 0, inode = 0;
  auto operator<=>(const FileNumber&) const = default;
};
/// The number of the file that a path leads to, or that is open; nothing when there is none.
std::optional<FileNumber> file_number(const std::string& path);
std::optional<FileNumber> file_number(int descriptor);

/// Two paths lead to one file exactly when this is the same for both. A file that is not there yet
/// is known by its folder and its name.
std::string file_identity(const std::string& path);
std::string file_identity(const FileNumber& file);

/// The file behind any symbolic links. A link to a file that is not there yet leads to where it
/// will be.
std::string behind_links(const std::string& path);

/// From now on it is remembered what is read and written.
void guard_files();
/// This file may be written over although it is read: it is rewritten in place, or gone on with.
void let_replace(const std::string& path);

/// What has been written there, if anything, may be written over: the newest of several is kept.
void let_rewrite(const std::string& path);

/// Has the file that this path leads to been read, and may it not be replaced?
bool was_read(const std::string& path);
bool was_read(const FileNumber& file);
/// Why a file must not be written over, in words; empty: it may be.
std::string why_guarded(const FileNumber& file);

/// For those who read and write files; both do nothing when nothing is guarded.
void note_read(const FileNumber& file);
void note_written(const FileNumber& file);

}  // namespace stig
