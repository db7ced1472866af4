// SPDX-License-Identifier: MIT
// The options of the commands that look at structures and runs, and at the program itself.
#include "command_options.h"
#include "option_kinds.h"

namespace stig::cli {

/// Those of --live.
static void live_options(CLI::App* sub, ViewOptions& o) {
  sub->add_flag(
      "--live", o.live,
      "run a scene or a rule set, and serve a page that shows it and takes a hand in it, at "
      "the address that is printed; Ctrl-C ends it");
  integer(sub, "--port", o.port, 1, 65535, "of 127.0.0.1, for --live (default: any that is free)");
  sub->add_flag("--paused", o.paused, "with --live: wait to be told to run");
  integer(sub, "--seed", o.seed, 0, kMostCount, "of the run, for --live");
  path(sub, "--trace", o.trace, "with --live: the run's trace, what was done by hand in it");
  path(sub, "--checkpoint", o.checkpoint,
       "with --live: where checkpoints go that are taken on the page; the last one stays");
}

void add_view(CLI::App& app, ViewOptions& o) {
  CLI::App* sub = command(
      app, "view", "make a page that shows structures and runs in 3-D, in any browser",
      "  stigc explore rulesets/staircase.yaml --trace run.stigt && stigc view run.stigt -o "
      "run.html\n"
      "  stigc explore rulesets/tiling.yaml --motion event --deposits 500 -o tiling.json\n"
      "  stigc view tiling.json -o tiling.html\n"
      "  stigc verify rulesets/order-dependent.yaml --witness two  # exit status 1: refuted\n"
      "  stigc view two -o two-ends.html\n"
      "  stigc simulate scenes/drop.yaml --duration 1 --trace drop.stigp\n"
      "  stigc view drop.stigp -o drop.html\n"
      "  stigc explore rulesets/stepped-pyramid.yaml -o all.txt\n"
      "  stigc explore rulesets/stepped-pyramid.yaml --deposits 6 --trace some.stigt\n"
      "  stigc view some.stigt --target all.txt -o some.html\n"
      "  timeout --foreground --preserve-status -s INT 2 stigc view --live "
      "rulesets/staircase.yaml\n"
      "  timeout --foreground --preserve-status -s INT 2 stigc view --live scenes/drop.yaml "
      "--trace "
      "live.stigp\n");
  sub->add_option("FILE", o.files,
                  "a structure file (.vox .json .txt), a mesh (.stl .obj .off .ply), a trace "
                  "(.stigt .stigp), a folder of validate, or the name that verify --witness was "
                  "given; several are shown together; with --live a scene or a rule set")
      ->type_name("FILE")
      ->required();
  sub->add_option("-o,--output", o.output, "the page, .html; nothing else is needed to open it")
      ->type_name("FILE");
  path(sub, "--target", o.target,
       "a structure file: what of it is missing stands as a ghost, where it fits best");
  path(sub, "--title", o.title, "what the page is called (default: the first file's title)")
      ->type_name("TEXT");
  lattice(sub, o.lattice);
  mesh_bricks(sub, o.mesh);
  live_options(sub, o);
}

void add_completions(CLI::App& app, CompletionsOptions& o) {
  CLI::App* sub = command(app, "completions", "print a completion script for a shell",
                          "  source <(stigc completions bash)\n"
                          "  mkdir -p ~/.zfunc && stigc completions zsh > ~/.zfunc/_stigc\n"
                          "  mkdir -p ~/.config/fish/completions\n"
                          "  stigc completions fish > ~/.config/fish/completions/stigc.fish\n");
  choice(sub, "SHELL", o.shell, {{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}},
         "the shell")
      ->required();
}

void add_doctor(CLI::App& app, DoctorOptions& o) {
  CLI::App* sub = command(app, "doctor", "look at the surroundings the program runs in",
                          "  stigc doctor\n"
                          "  stigc doctor rulesets/staircase.yaml\n");
  sub->add_option("FILE", o.files, "rule sets to check as well")->type_name("FILE");
  sub->add_flag("--json", o.json, "print one JSON object");
}

}  // namespace stig::cli
