// SPDX-License-Identifier: MIT
// The options of commands that make many runs of others.
#include "command_options.h"
#include "option_kinds.h"

namespace stig::cli {

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
  slice(sub, o.slice, "the I-th of N parts, for as many commands; stigc merge joins them");
  integer(sub, "--threads", o.threads, 0, 4096,
          "items at a time; 0: all cores (default). The results are the same for any");
  sub->add_flag("--json", o.json, "print one JSON object instead of the summary");
}

void add_merge(CLI::App& app, MergeOptions& o) {
  CLI::App* sub = command(app, "merge", "join the slices of a study or of a search",
                          "  stigc sweep studies/coral.yaml --slice 1/2 -o part-1.jsonl\n"
                          "  stigc sweep studies/coral.yaml --slice 2/2 -o part-2.jsonl\n"
                          "  stigc merge part-1.jsonl part-2.jsonl -o merged.jsonl -o merged.csv\n"
                          "  stigc search plans/drawn.yaml --slice 1/2 -o part-1.sqlite\n"
                          "  stigc search plans/drawn.yaml --slice 2/2 -o part-2.sqlite\n"
                          "  stigc merge part-1.sqlite part-2.sqlite -o drawn.sqlite\n");
  files(sub, o.files, "records of all slices (.jsonl), or results of all slices of a search");
  repeated(sub, "-o,--output", o.outputs, "FILE",
           "as stigc sweep has it; may be repeated. Of a search: one file of results")
      ->required();
  sub->add_flag("--json", o.json, "print one JSON object instead of the summary");
}

}  // namespace stig::cli
