// SPDX-License-Identifier: MIT
// The options of commands that make many runs of others.
#include "command_options.h"
#include "option_kinds.h"

namespace stig::cli {
namespace {

/// "2/8": the second of eight.
std::string parse_slice(const std::string& text, SliceOption& out) {
  const std::size_t slash = text.find('/');
  std::int64_t number = 0, of = 0;
  if (slash == text.npos || !parse_integer(text.substr(0, slash), 1, 1'000'000, number).empty() ||
      !parse_integer(text.substr(slash + 1), 1, 1'000'000, of).empty() || number > of) {
    return fmt::format("'{}' is not a slice, as 1/4", text);
  }
  out = {static_cast<std::uint64_t>(number), static_cast<std::uint64_t>(of)};
  return {};
}

}  // namespace

void add_sweep(CLI::App& app, SweepOptions& o) {
  CLI::App* sub = command(
      app, "sweep", "do a study: one command at every point of a grid of parameters",
      "  stigc sweep studies/coral.yaml -o coral.jsonl -o coral.csv\n"
      "  stigc sweep studies/coral.yaml --run 7\n"
      "  stigc sweep studies/coral.yaml --slice 1/2 -o part-1.jsonl\n"
      "  stigc sweep studies/coral.yaml --slice 2/2 -o part-2.jsonl\n"
      "  stigc merge part-1.jsonl part-2.jsonl -o merged.jsonl && cmp coral.jsonl merged.jsonl\n");
  file(sub, "PLAN", o.plan, "the study (.yaml)");
  repeated(sub, "-o,--output", o.outputs, "FILE",
           "records: .jsonl, an object a line, or .csv; may be repeated. Beside the first is a "
           "journal until all is done: after an interruption the same command goes on");
  integer(sub, "--run", o.run, 0, kMostCount, "this item alone, on standard output; from 0 on");
  parsed(sub, "--slice", "I/N", "the I-th of N parts, for as many commands; stigc merge joins them",
         [&o](const std::string& text) { return parse_slice(text, o.slice); });
  integer(sub, "--threads", o.threads, 0, 4096,
          "items at a time; 0: all cores (default). The results are the same for any");
  sub->add_flag("--json", o.json, "print one JSON object instead of the summary");
}

void add_merge(CLI::App& app, MergeOptions& o) {
  CLI::App* sub =
      command(app, "merge", "join the slices of a study",
              "  stigc sweep studies/coral.yaml --slice 1/2 -o part-1.jsonl\n"
              "  stigc sweep studies/coral.yaml --slice 2/2 -o part-2.jsonl\n"
              "  stigc merge part-1.jsonl part-2.jsonl -o merged.jsonl -o merged.csv\n");
  files(sub, o.files, "records of all slices (.jsonl)");
  repeated(sub, "-o,--output", o.outputs, "FILE", "as stigc sweep has it; may be repeated")
      ->required();
  sub->add_flag("--json", o.json, "print one JSON object instead of the summary");
}

}  // namespace stig::cli
