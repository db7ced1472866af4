// SPDX-License-Identifier: MIT
// An installed program and one that was built in place know their folders by where they are
// themselves, so neither needs to be told, and both can be moved.
#include "shipped_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

fs::path& other_program_folder() {
  static fs::path folder;
  return folder;
}

/// Where this program's file is; empty when the system does not say.
fs::path program_folder() {
  if (!other_program_folder().empty()) return other_program_folder();
  std::error_code error;
  // Linux says so; elsewhere nothing is found, and names must lead somewhere themselves.
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

constexpr const char* kKinds[] = {"rulesets", "scenes", "robots", "blocks",
                                  "programs", "plans",  "studies"};

/// Where the shipped file of this name is; nothing when there is none, or the name leads to
/// something already.
std::optional<std::string> shipped_file(const std::string& name) {
  std::error_code error;
  const fs::path path(name);
  // What is there is meant, whatever ships under that name.
  if (path.is_absolute() || path.empty() || fs::exists(path, error)) return std::nullopt;
  const std::string kind = path.begin()->string();
  if (std::find(std::begin(kKinds), std::end(kKinds), kind) == std::end(kKinds)) return {};
  // Within the folder of its kind, or nowhere.
  if (std::find(path.begin(), path.end(), "..") != path.end()) return std::nullopt;
  for (const std::string& folder : shipped_folders(kind)) {
    const fs::path there = fs::path(folder) / path.lexically_relative(kind);
    if (fs::is_regular_file(there, error)) return there.lexically_normal().string();
  }
  return std::nullopt;
}

/// Looks up the names of the files that a command reads.
struct Finder {
  const App& app;

  void operator()(CheckOptions& o) const { find(o.files); }
  void operator()(FmtOptions& o) const {
    // What is rewritten in place must be the user's own.
    if (!o.write) find(o.files);
  }
  void operator()(ExploreOptions& o) const { find(o.file); }
  void operator()(ExplainOptions& o) const { find(o.file); }
  void operator()(TestOptions& o) const { find(o.files); }
  void operator()(VerifyFileOptions& o) const { find(o.file); }
  void operator()(CertifyOptions& o) const { find(o.file); }
  void operator()(GraphOptions& o) const { find(o.file); }
  void operator()(DoctorOptions& o) const { find(o.files); }
  void operator()(SchemaOptions& o) const { find(o.symbols_of); }
  void operator()(SynthOptions& o) const { find(o.robot); }
  void operator()(SimulateOptions& o) const { find(o.scene); }
  void operator()(DescribeOptions& o) const { find(o.robot); }
  void operator()(CompileFileOptions& o) const {
    find(o.file);
    find(o.robot);
  }
  void operator()(ValidateOptions& o) const {
    find(o.file);
    find(o.scene);
    find(o.robot);
  }
  void operator()(BuildOptions& o) const { find(o.robot); }
  void operator()(SearchFileOptions& o) const { find(o.plan); }
  void operator()(ViewOptions& o) const {
    if (o.live) find(o.files);
  }
  void operator()(SweepOptions& o) const { find(o.plan); }
  void operator()(ImportOptions& o) const { find(o.table); }
  /// Structures and traces do not come with the program.
  template <class Other>
  void operator()(Other&) const {}

  void find(std::string& name) const {
    std::optional<std::string> there = shipped_file(name);
    if (!there) return;
    // Said, so that nobody wonders which file it was.
    app.say(fmt::format("reading {}, which came with the program", printable(*there)));
    name = std::move(*there);
  }
  void find(std::optional<std::string>& name) const {
    if (name) find(*name);
  }
  void find(std::vector<std::string>& names) const {
    for (std::string& name : names) find(name);
  }
};

}  // namespace

void set_program_folder(const std::string& folder) { other_program_folder() = folder; }

std::vector<std::string> shipped_folders(const std::string& kind) {
  const fs::path program = program_folder();
  if (program.empty()) return {};
  // Installed as bin/stigc beside share/stig; built as build/NAME/stigc in the sources.
  return {(program / ".." / "share" / "stig" / kind).string(),
          (program / ".." / ".." / kind).string(), (program / kind).string()};
}

std::string shipped_name(const std::string& name) { return shipped_file(name).value_or(name); }

void find_shipped_files(CommandOptions& options, const App& app) {
  std::visit(Finder{app}, options);
}

}  // namespace stig::cli
