// SPDX-License-Identifier: MIT
// The options of stigc render.
#include "command_options.h"
#include "option_kinds.h"
#include "render_values.h"

namespace stig::cli {

namespace {

void add_render_times(CLI::App* sub, RenderOptions& o) {
  moment(sub, "--time,--at", o.time, "of a picture: the moment (default: the end)");
  moment(sub, "--from", o.from, "of a film: where it begins (default: 0)");
  moment(sub, "--to", o.to,
         "of a film: where it ends (default: the end; beyond it, the end is held)");
  const auto rate = [sub](const std::string& name, std::optional<double>& out,
                          const std::string& doc) {
    parsed(sub, name, "N", doc,
           [&out](const std::string& text) { return parse_rate(text, out.emplace()); });
  };
  rate("--fps", o.fps, "frames a second (default: 25; of a .gif 10)");
  rate("--speed", o.speed,
       "seconds of the run, or bricks, that a second of film shows (default: such that it takes 15 "
       "s at most, but 1 second, or 5 bricks, at least)");
}

}  // namespace

void add_render(CLI::App& app, RenderOptions& o) {
  CLI::App* sub = command(
      app, "render", "draw pictures and films of runs and structures",
      "  stigc explore rulesets/staircase.yaml --trace run.stigt\n"
      "  stigc render run.stigt -o run.png --time 4 --ghost\n"
      "  stigc render run.stigt -o run.gif --speed 10 --fps 5 --view orbit\n"
      "  stigc render run.stigt -o run.svg --view -1,-2,1 --slice z=0..1 --palette tol-bright\n"
      "  stigc simulate scenes/drop.yaml --duration 1 --trace drop.stigp\n"
      "  stigc render drop.stigp -o drop-frames/ --speed 0.5 --fps 4 --size 600x400\n"
      "  stigc render drop.stigp -o drop.glb\n");
  file(sub, "FILE", o.file, "a trace (.stigt .stigp) or a structure file (.vox .json .txt)");
  sub->add_option("-o,--output", o.output,
                  "a picture (.png .svg), a film (.mp4 .webm .gif; without ffmpeg its frames), a "
                  "folder for a film's frames (DIR/), or an animated .glb")
      ->type_name("FILE")
      ->required();
  add_render_times(sub, o);
  parsed(sub, "--size", "WxH", "pixels (default: 1200x800; of a .gif 600x400)",
         [&o](const std::string& text) {
           return parse_pixels(text, o.width.emplace(), o.height.emplace());
         });
  parsed(
      sub, "--view", "iso|front|top|orbit|X,Y,Z",
      "where the camera is: iso (default); orbit: once round in the course of a film; or in that "
      "direction",
      [&o](const std::string& text) { return parse_view(text, o.view); });
  parsed(sub, "--slice", "AXIS=LOW..HIGH",
         "show this part alone, as z=0..3 or x=..0.2: cells, or metres of physical runs; may be "
         "repeated, for other axes",
         [&o](const std::string& text) { return parse_slice(text, o.slices.emplace_back()); })
      ->allow_extra_args(false)
      ->trigger_on_parse();
  sub->add_option("--camera", o.camera,
                  "what this camera of a robot sees; the scene is run again for it")
      ->type_name("ROBOT[:CAMERA]");
  sub->add_flag("--ghost", o.ghost, "show as well what will stand there at the end");
  palette(sub, o.palette);
  sub->add_flag("--no-title", o.no_title, "without title and time");
  sub->add_flag("--no-legend", o.no_legend, "without the legend of bricks and the axes");
  lattice(sub, o.lattice);
}

}  // namespace stig::cli
