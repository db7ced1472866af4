// SPDX-License-Identifier: MIT
// How programs of 2019 find their modules: by the templates in package.path, as Lua itself does,
// each tried from the folder that the program was started in (a scene's own, as that of an .argos
// file) and beside the program. No template leads out of either.
//
// A scene brings its programs' modules with it, so they must be found before anything runs. Names
// may be put together or come from parameters; therefore every text in quotes that could be the
// name of a module is tried, with every template that the program's texts write.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lua/lua_settings.h"
#include "lua/uses.h"

namespace stig::lua {

/// What package.path is before a program adds to it.
inline constexpr std::string_view kDefaultTemplates = "./?.lua;./?/init.lua";

/// Whether it can name a module of 2019: parts of letters, digits, _ and -, with dots or slashes
/// between them.
bool is_module_search_name(std::string_view name);

/// Files that a name may stand for, in the order in which they are tried: of each template first as
/// it is, then beside the program. Templates that are absolute, climb or have no '?' give none.
std::vector<std::string> module_candidates(std::string_view name, std::string_view templates,
                                           std::string_view program_path);

/// What a program's texts may ask for, as far as they are written out; each once.
struct WrittenModules {
  std::string templates{kDefaultTemplates};
  std::vector<std::string> names;

  /// Adds what stands between quotes in the text.
  void add_text(std::string_view text);
  void add_name(std::string_view name);
};

}  // namespace stig::lua
