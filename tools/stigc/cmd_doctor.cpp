// SPDX-License-Identifier: MIT
// stigc doctor: is all there that the program leans on?
//
// Findings are tried rather than looked up where that is possible: a picture is drawn, a file is
// written. What fails has advice that a user can follow.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file_io.h"
#include "base/parallel.h"
#include "commands.h"
#include "encoder.h"
#include "lattice/picture.h"
#include "mesh_input.h"
#include "page_template.h"
#include "physical/dynamics/stock_step.h"
#include "report.h"
#include "rules/rule_reader.h"
#include "shipped_files.h"

namespace stig::cli {
namespace {

enum class Health : std::uint8_t { ok, warn, fail };

/// One thing looked at: how it is, and what to do if it is not well.
struct Finding {
  Health health = Health::ok;
  std::string what, found, advice;
};

std::string_view to_string(Health health) {
  return health == Health::ok ? "ok" : health == Health::warn ? "warn" : "fail";
}

// Which compiler: floating-point results are meant to be the same, and a report of a difference
// needs to say this.
Finding program() {
  return {
    Health::ok, "program",
        fmt::format("stigc {}, {} {}", STIG_VERSION,
#if defined(__clang__)
                    "clang", __clang_version__
#else
                    "gcc", __VERSION__
#endif
                    ),
    {
    }
  };
}

Finding libraries() {
  return {Health::ok,
          "libraries",
          fmt::format("fmt {}.{}.{}, JSON {}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                      FMT_VERSION % 100, NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                      NLOHMANN_JSON_VERSION_PATCH),
          {}};
}

// From the library that is loaded, not from the headers.
Finding physics() { return {Health::ok, "physics", "DART " + dart_version(), {}}; }

Finding processor() {
  // Those that the program may use, which --threads is by default.
  const int cores = thread_count(0);
  // Agents walk by vector instructions where there is AVX-512 (its foundation, as the kernel asks
  // for it); results do not depend on it.
  std::string features;
#if defined(__x86_64__)
  features = __builtin_cpu_supports("avx512f") ? ", AVX-512"
             : __builtin_cpu_supports("avx2")  ? ", AVX2, no AVX-512"
                                               : ", no AVX2";
#endif
  const std::string found = fmt::format("{} {}{}", cores, cores == 1 ? "core" : "cores", features);
  return {Health::ok, "processor", found, {}};
}

Finding memory() {
  const auto pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  const double gigabytes = pages * static_cast<double>(sysconf(_SC_PAGE_SIZE)) / 1e9;
  const std::string found = fmt::format("{:.1f} GB", gigabytes);
  if (gigabytes >= 2) return {Health::ok, "memory", found, {}};
  return {Health::warn, "memory", found, "boxes beyond 500×500×500 will not fit"};
}

/// Can pictures be drawn? Draws one. The smallest picture goes all the way through cairo.
Finding pictures() {
  const Structure brick(Lattice::cubic, {{{0, 0, 0}, 1}});
  const std::string png = draw_structure(brick, {{"1", "brick", "#4363d8", "", {}}});
  if (png.starts_with("\x89PNG")) {
    return {Health::ok, "pictures", fmt::format("drawn by cairo, {} bytes", png.size()), {}};
  }
  return {Health::fail, "pictures", "cairo could not draw", "install libcairo2"};
}

/// What makes films of pictures; nothing else needs it.
Finding video() {
  const auto ffmpeg = find_ffmpeg();
  return {Health::ok,
          "video",
          ffmpeg ? printable(*ffmpeg) : "no ffmpeg: films are written as their frames",
          {}};
}

/// What reads meshes; nothing else needs it.
Finding meshes() {
  const auto program = find_mesh_program();
  return {
      Health::ok,
      "meshes",
      program
          ? printable(*program) + ", with CGAL, GPL-3"
          : "no stigc-mesh: the package stigc-mesh has it; it is built where there is libcgal-dev",
      {}};
}

/// What `view` makes its pages of, and the playground; nothing else needs them.
Finding pages() {
  const bool viewer = shipped_page_template().has_value(), playground = !playground_path().empty();
  const std::string found =
      std::string(viewer ? "viewer" : "no viewer: it is built where there are node and npm") +
      "; " + (playground ? playground_path() : "no playground: it takes Emscripten too");
  return {Health::ok, "pages", printable(found), {}};
}

/// Legends are set in DejaVu Sans; with another font they look different.
Finding fonts() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  for (const char* folder : {"/usr/share/fonts", "/usr/local/share/fonts"}) {
    // Errors of folders that may not be entered end the search there, and not the program.
    for (auto it = fs::recursive_directory_iterator(folder, ignored);
         !ignored && it != fs::recursive_directory_iterator(); it.increment(ignored)) {
      if (it->path().filename() == "DejaVuSans.ttf") {
        return {Health::ok, "fonts", it->path().string(), {}};
      }
    }
  }
  return {Health::warn, "fonts", "DejaVu Sans not found",
          "install fonts-dejavu-core, or pictures' legends come out in another font"};
}

Finding temporary() {
  const std::string folder = temporary_folder();
  // The process number keeps two doctors apart.
  const std::string path = fmt::format("{}/stigc-doctor-{}", folder, getpid());
  FileError error;
  if (!write_file(path, "a line\n", error)) {
    return {Health::fail, "temporary", printable(error.message), "set TMPDIR to a folder of yours"};
  }
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  return {Health::ok, "temporary", printable(folder) + " takes files", {}};
}

Finding terminal(const App& app) {
  const bool out = isatty(STDOUT_FILENO) == 1, err = isatty(STDERR_FILENO) == 1;
  return {Health::ok,
          "terminal",
          fmt::format("results {}, messages {}, colours {}", out ? "on a terminal" : "redirected",
                      err ? "on a terminal" : "redirected",
                      app.color_out() || app.color_err() ? "on" : "off"),
          {}};
}

/// Files given, or the rule sets in the folder "rulesets" when there is one, or those that came
/// with the program.
Finding rule_sets(std::vector<std::string> files) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  std::vector<std::string> folders = shipped_folders("rulesets");
  folders.insert(folders.begin(), "rulesets");
  for (const std::string& folder : folders) {
    if (!files.empty()) break;
    for (auto it = fs::directory_iterator(folder, ignored);
         !ignored && it != fs::directory_iterator(); it.increment(ignored)) {
      if (it->path().extension() == ".yaml") files.push_back(it->path().string());
    }
  }
  if (files.empty()) {
    return {Health::warn, "rule sets", "none here to check", "name files: stigc doctor FILE…"};
  }
  std::string bad;
  for (const std::string& file : files) {
    Diagnostics diagnostics;
    if (!read_rule_set_file(file, diagnostics)) bad += (bad.empty() ? "" : ", ") + file;
  }
  if (bad.empty()) {
    return {Health::ok, "rule sets", fmt::format("{} checked, all good", files.size()), {}};
  }
  return {Health::fail, "rule sets", printable(bad) + " not good", "run stigc check on them"};
}

std::string coloured(Health health, bool color) {
  const std::string padded = fmt::format("{:<5}", to_string(health));
  return health == Health::ok     ? green(padded, color)
         : health == Health::warn ? yellow(padded, color)
                                  : red(padded, color);
}

}  // namespace

int run(const DoctorOptions& options, App& app) {
  // In the order in which things build upon each other.
  const std::vector<Finding> findings = {program(),
                                         libraries(),
                                         physics(),
                                         processor(),
                                         memory(),
                                         pictures(),
                                         video(),
                                         meshes(),
                                         pages(),
                                         fonts(),
                                         temporary(),
                                         terminal(app),
                                         rule_sets(options.files)};
  Json json = Json::array();
  bool failed = false;
  for (const Finding& finding : findings) {
    failed |= finding.health == Health::fail;
    if (options.json) {
      json.push_back({{"health", to_string(finding.health)},
                      {"what", finding.what},
                      {"found", finding.found},
                      {"advice", finding.advice}});
      continue;
    }
    const std::string advice = finding.advice.empty() ? "" : "; " + finding.advice;
    app.print(fmt::format("{} {:<11}{}{}\n", coloured(finding.health, app.color_out()),
                          finding.what, finding.found, advice));
  }
  if (options.json) app.print(dump({{"findings", json}, {"ok", !failed}}));
  return failed ? kFailed : kOk;
}

}  // namespace stig::cli
