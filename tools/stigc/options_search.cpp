// SPDX-License-Identifier: MIT
// The options of the commands that look for rule sets and at what was found. What a search does is
// said by its plan, so that its results can name it.
#include "archive_pictures.h"
#include "command_options.h"
#include "option_kinds.h"

namespace stig::cli {

void add_search(CLI::App& app, SearchFileOptions& o) {
  CLI::App* sub =
      command(app, "search", "look for rule sets, as a plan says; the same command goes on",
              "  stigc search plans/spread.yaml -o spread.sqlite\n"
              "  stigc search plans/spread.yaml -o spread.sqlite  # is complete, and says so\n");
  file(sub, "PLAN", o.plan, "what to look for, where and how");
  sub->add_option("-o,--output", o.output,
                  "the results, an SQLite file; one of the same plan is gone on with")
      ->type_name("FILE")
      ->required();
  slice(sub, o.slice,
        "the I-th of N parts of a plan by the method random; stigc merge joins their results");
  integer(sub, "--threads", o.threads, 0, 4096,
          "threads; 0: all cores (default). The results are the same for any");
}

void add_archive(CLI::App& app, ArchiveOptions& o) {
  CLI::App* sub =
      command(app, "archive", "look at what a search has found, and take rule sets out",
              "  stigc search plans/spread.yaml -o spread.sqlite\n"
              "  stigc archive spread.sqlite --top 5\n"
              "  stigc archive spread.sqlite --json > spread.json\n"
              "  stigc archive spread.sqlite --pick 0 -o found.yaml && stigc explore found.yaml "
              "--motion event --box 20,20,20 --deposits 500\n"
              "  stigc archive spread.sqlite --plot bricks,symmetry,score -o finds.svg\n"
              "  stigc archive spread.sqlite --plot evaluated,best -o curve.svg\n"
              "  stigc archive spread.sqlite --top 6 --gallery finds.html\n");
  file(sub, "FILE", o.results, "results of stigc search");
  integer(sub, "--top", o.top, 1, 1'000'000, "so many finds, by score (default: 10)");
  integer(sub, "--pick", o.pick, 0, kMostCount, "the rule set of the individual with this number");
  parsed(sub, "--plot", "X[,Y[,COLOUR]]",
         "a figure of the finds: a distribution, points, points with colours; or evaluated,best "
         "or mean or structures: how the search went on",
         [&o](const std::string& text) {
           o.plot = text;
           return plot_problem(text);
         });
  path(sub, "--gallery", o.gallery, "a page: curves, distributions, pictures of the --top finds");
  repeated(sub, "--beside", o.beside, "FILE",
           "further results in the figures, as of other seeds; curves then have a band of one "
           "deviation");
  path(sub, "-o,--output", o.output,
       "with --pick: the file of rules (default: standard output), or by its ending what they "
       "built: .txt .json .vox .png .svg; with --plot: the .svg");
  sub->add_flag("--json", o.json, "print one JSON object");
}

}  // namespace stig::cli
