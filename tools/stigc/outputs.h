// SPDX-License-Identifier: MIT
// The files that commands write. Every command asks check_outputs once it has read its input and
// before it works, so that a slip does not cost the work; each file is written whole or not at all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app.h"
#include "lattice/structure.h"

namespace stig {

/// "tower.vox", of "models/tower.vox".
std::string file_name(const std::string& path);

/// An exit code: kUsage when one of these would be written over what has been read, over another
/// or over standard output, or is no name for a file; kRunFailed when one cannot be written, as far
/// as can be told beforehand. Links are followed. `folder`: the command makes it if it is not
/// there.
int check_outputs(const std::vector<std::string>& paths, const App& app,
                  const std::string& folder = {});

/// Writes a file and says so; an exit code.
int write_output(const std::string& path, std::string_view bytes, const App& app);

/// Writes a structure with its picture titled; false with `error` set.
bool write_structure(const std::string& path, const Structure& structure,
                     const std::vector<Brick>& bricks, const std::string& title, bool floor,
                     std::string& error);

}  // namespace stig
