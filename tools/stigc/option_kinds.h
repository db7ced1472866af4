// SPDX-License-Identifier: MIT
// The kinds of options that commands declare, over CLI11. Numbers and words are read by functions
// of our own (numbers.h): CLI11's take "1e3" and " 7", and their messages are not ours.
//
// Every function returns the option as CLI11 has it; `out` is written while the command line is
// parsed and must outlive the parser. Include this from the files that declare options alone:
// CLI11 takes seconds to compile.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "numbers.h"
#include "options.h"
#include "uses.h"

namespace stig::cli {

// Counters of a run are 64-bit and signed, and the command line takes no more.
constexpr std::int64_t kMostCount = std::numeric_limits<std::int64_t>::max();
/// A run's number has 24 bits.
constexpr int kMostRuns = 1 << 24;

/// A command with its examples, which help prints and tests/stigc/help_test.cpp runs.
CLI::App* command(CLI::App& app, const std::string& name, const std::string& summary,
                  const std::string& examples);

/// An option whose text is read by `parse`, which returns what is wrong.
CLI::Option* parsed(CLI::App* app, const std::string& names, const std::string& value,
                    const std::string& doc, std::function<std::string(const std::string&)> parse);

/// A whole number from low to high.
template <class Integer>
CLI::Option* integer(CLI::App* app, const std::string& names, Integer& out, std::int64_t low,
                     std::int64_t high, const std::string& doc) {
  return parsed(app, names, "N", doc, [&out, low, high](const std::string& text) {
    std::int64_t value = 0;
    const std::string problem = parse_integer(text, low, high, value);
    if (problem.empty()) {
      // An optional's value is set, a number assigned.
      if constexpr (std::is_arithmetic_v<Integer>) {
        out = static_cast<Integer>(value);
      } else {
        out = static_cast<typename Integer::value_type>(value);
      }
    }
    return problem;
  });
}

template <class Enum>
using Words = std::vector<std::pair<std::string, Enum>>;

/// One of a few words; `value` of the option lists them, parted by bars.
template <class Out, class Enum = Out>
CLI::Option* choice(CLI::App* app, const std::string& names, Out& out, const Words<Enum>& words,
                    const std::string& doc) {
  std::string value;
  for (const auto& [word, meaning] : words) value += (value.empty() ? "" : "|") + word;
  return parsed(app, names, value, doc, [&out, words](const std::string& text) -> std::string {
    std::vector<std::string_view> known;
    for (const auto& [word, meaning] : words) {
      known.push_back(word);
      if (word != text) continue;
      out = meaning;
      return {};
    }
    const std::string_view near = nearest(text, known);
    const std::string hint = near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
    return fmt::format("'{}' is not one of {}{}", text, fmt::join(known, ", "), hint);
  });
}

/// A name for a file, or for several.
CLI::Option* path(CLI::App* app, const std::string& names, std::optional<std::string>& out,
                  const std::string& doc);

/// An option that takes one value and may be given several times.
CLI::Option* repeated(CLI::App* app, const std::string& names, std::vector<std::string>& out,
                      const std::string& value, const std::string& doc);

/// A file that has to be given, by its place in the line.
CLI::Option* file(CLI::App* app, const std::string& name, std::string& out, const std::string& doc);
CLI::Option* files(CLI::App* app, std::vector<std::string>& out, const std::string& doc);

/// A time in seconds.
CLI::Option* seconds(CLI::App* app, const std::string& names, std::optional<double>& out,
                     const std::string& doc);

/// A moment of a run: seconds, or bricks placed; 0 too.
CLI::Option* moment(CLI::App* app, const std::string& names, std::optional<double>& out,
                    const std::string& doc);

/// --slice: one of so many parts of the work.
CLI::Option* slice(CLI::App* app, SliceOption& out, const std::string& doc);

/// --box, --origin and --periodic; `doc` is that of --box.
void world(CLI::App* sub, WorldOptions& out, const std::string& doc);
void lattice(CLI::App* sub, std::optional<Lattice>& out);
void palette(CLI::App* sub, Palette& out);
/// --bricks, for commands that take a mesh as they take a structure file.
void mesh_bricks(CLI::App* sub, MeshOptions& out);
void add_sides(CLI::App& sub, std::vector<std::string>& sides, const char* what);

}  // namespace stig::cli
