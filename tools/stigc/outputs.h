// SPDX-License-Identifier: MIT
// The files that commands write. Every command asks check_outputs once it has read its input and
// before it works, so that a slip does not cost the work; each file is written whole or not at all.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "app.h"
#include "lattice/structure.h"
#include "uses.h"

namespace stig::cli {

/// "tower.vox", of "models/tower.vox".
std::string file_name(const std::string& path);

/// An exit code: kUsage when one of these would be written over what has been read, over another
/// or over standard output, lies in another, or is no name for a file; kRunFailed when one cannot
/// be written, as far as can be told beforehand. Links are followed. `folder`: the command makes it
/// if it is not there.
int check_outputs(const std::vector<std::string>& paths, const App& app,
                  const std::string& folder = {});

/// A folder of results, made where it is not there. An exit code.
int make_folder(const std::string& folder, const App& app);

/// Files that a command writes into a folder, under names that the user did not choose: these are
/// no leave to write over files of the user's.
struct FolderOutputs {
  std::string folder;
  std::vector<std::string> names;  ///< in it
  bool ours = false;               ///< what lies there already is of an earlier such command
  std::string_view command;        ///< what such a command is called: "validation"
};
/// Before the work: checks the names as check_outputs does, and makes the folder. An exit code:
/// kUsage as well where files of these names are there that are not ours.
int prepare_folder(const FolderOutputs& outputs, const App& app);

/// Whether a regular file has all of these near its beginning, by which a command knows what it has
/// written itself. It is looked at and not read as an input is, over which nothing could be written
/// afterwards.
bool has_words(const std::string& path, std::initializer_list<std::string_view> words);

/// Writes a file and says so; an exit code.
int write_output(const std::string& path, std::string_view bytes, const App& app);

/// Writes a structure with its picture titled; false with `error` set.
bool write_structure(const std::string& path, const Structure& structure,
                     const std::vector<Brick>& bricks, const std::string& title, bool floor,
                     std::string& error, Palette palette = Palette::file);

}  // namespace stig::cli
