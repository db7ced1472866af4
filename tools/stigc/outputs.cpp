// SPDX-License-Identifier: MIT
// All that can be told of an output before any work is done: is the name one, is it another output
// or an input under a second name, may it be written. Files are compared by device and inode where
// they exist, so that links and ./ make no difference.
#include "outputs.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "base/file_guard.h"
#include "base/file_io.h"
#include "lattice/structure_files.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

/// The folder of a path, without a slash at its end.
std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Whether a folder is another or lies below it.
bool is_within(const fs::path& folder, const fs::path& other) {
  return std::mismatch(other.begin(), other.end(), folder.begin(), folder.end()).first ==
         other.end();
}

/// What is wrong with where a file is to be, in words; empty: nothing. `made` is a folder that will
/// be there, with those below it.
std::string writing_problem(const std::string& path, const std::string& made) {
  // A link is followed to what will be replaced, or made.
  const std::string target = behind_links(path);
  // A device or a pipe would take bytes, but not be replaced by a rename.
  struct stat status {};
  if (stat(target.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    return fmt::format("cannot write '{}': it is {}", path,
                       S_ISDIR(status.st_mode) ? "a folder" : "no plain file");
  }
  std::string folder = folder_of(target);
  std::error_code ignored;
  // Up to the first folder that is there.
  while (!made.empty() && is_within(folder, made) && !fs::exists(folder, ignored)) {
    folder = folder_of(folder);
  }
  // With the dot, what is no folder is refused as such.
  if (access((folder + "/.").c_str(), W_OK | X_OK) == 0) return {};
  return fmt::format("cannot write '{}': {}", path, strerror(errno));
}

/// Files by what they are, with the names that they were given.
using KnownFiles = std::map<std::string, std::string>;

// Standard output may be a file too, as with > on the command line.
KnownFiles standard_output() {
  KnownFiles known;
  if (const auto file = file_number(STDOUT_FILENO)) {
    known.emplace(file_identity(*file), "standard output");
  }
  return known;
}

/// What is wrong with the name of a file to be written, in words; empty: nothing.
std::string naming_problem(const std::string& path, KnownFiles& known) {
  if (path.empty() || path == "-") return fmt::format("'{}' is no name for a file to write", path);
  if (was_read(path)) return fmt::format("'{}' would be written over what is read", path);
  const auto [other, fresh] = known.emplace(file_identity(path), fmt::format("'{}'", path));
  if (fresh) return {};
  if (other->second == fmt::format("'{}'", path)) return fmt::format("'{}' is given twice", path);
  return fmt::format("'{}' and {} are one file", path, other->second);
}

/// What is wrong with a file below another one that is to be written; empty: nothing. The other
/// would need to be a folder.
std::string folder_problem(const std::string& path, const KnownFiles& known) {
  std::string below = path;
  for (std::string folder = folder_of(path); folder != below; folder = folder_of(folder)) {
    const auto file = known.find(file_identity(folder));
    if (file != known.end()) {
      return fmt::format("{} cannot be a file and the folder of '{}'", file->second, path);
    }
    below = folder;
  }
  return {};
}

std::string without_last_slash(std::string path) {
  while (path.size() > 1 && path.ends_with('/')) path.pop_back();
  return path;
}

constexpr std::size_t kMostHead = 1 << 16;     ///< bytes
constexpr std::ptrdiff_t kMostComplaints = 8;  ///< of one kind: a film has thousands of frames

/// Complains of what is wrong.
int complain(std::vector<std::string> problems, int code, const App& app) {
  std::erase(problems, "");
  const auto count = std::ssize(problems);
  for (std::ptrdiff_t i = 0; i < std::min(count, kMostComplaints); ++i) {
    app.complain(printable(problems[static_cast<std::size_t>(i)]));
  }
  if (count > kMostComplaints) {
    app.complain(fmt::format("and {} more of the same", count - kMostComplaints));
  }
  return count == 0 ? kOk : code;
}

}  // namespace

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

int check_outputs(const std::vector<std::string>& paths, const App& app,
                  const std::string& folder) {
  KnownFiles known = standard_output();
  std::vector<std::string> problems;
  // Problems with names first: with them, whether a file can be written means nothing.
  for (const std::string& path : paths) problems.push_back(naming_problem(path, known));
  for (const std::string& path : paths) problems.push_back(folder_problem(path, known));
  if (const int code = complain(problems, kUsage, app); code != kOk) return code;
  problems.clear();
  for (const std::string& path : paths) {
    problems.push_back(writing_problem(path, without_last_slash(folder)));
  }
  return complain(problems, kRunFailed, app);
}

int make_folder(const std::string& folder, const App& app) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (!error) return kOk;
  app.complain(fmt::format("cannot make the folder '{}': {}", printable(folder), error.message()));
  return kRunFailed;
}

int prepare_folder(const FolderOutputs& outputs, const App& app) {
  std::vector<std::string> paths;
  for (const std::string& name : outputs.names) paths.push_back(outputs.folder + "/" + name);
  if (const int code = check_outputs(paths, app, outputs.folder); code != kOk) return code;
  std::error_code ignored;
  for (const std::string& path : paths) {
    if (outputs.ours || !fs::exists(path, ignored)) continue;
    app.complain(
        fmt::format("'{}' is there already, and no earlier {} wrote it: name a folder of its own",
                    printable(path), outputs.command));
    return kUsage;
  }
  return make_folder(outputs.folder, app);
}

bool has_words(const std::string& path, std::initializer_list<std::string_view> words) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;  // a pipe would be waited for
  std::ifstream file(path);
  std::string head(kMostHead, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return std::all_of(words.begin(), words.end(),
                     [&](std::string_view one) { return head.find(one) != std::string::npos; });
}

int write_output(const std::string& path, std::string_view bytes, const App& app) {
  FileError error;
  if (!write_file(path, bytes, error)) {
    app.complain(error.message);
    return kRunFailed;
  }
  app.say("wrote " + printable(path));
  return kOk;
}

bool write_structure(const std::string& path, const Structure& structure,
                     const std::vector<Brick>& bricks, const std::string& title, bool floor,
                     std::string& error, Palette palette) {
  StructureWriteOptions options;
  options.picture.title = printable(title);
  options.picture.floor = floor;
  options.picture.palette = palette;
  return write_structure_file(path, structure, bricks, options, error);
}

}  // namespace stig::cli
