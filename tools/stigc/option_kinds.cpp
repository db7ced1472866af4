// SPDX-License-Identifier: MIT
#include "option_kinds.h"

namespace stig::cli {

CLI::App* command(CLI::App& app, const std::string& name, const std::string& summary,
                  const std::string& examples) {
  // With fallthrough, global options may stand behind the command.
  CLI::App* sub = app.add_subcommand(name, summary)->fallthrough();
  sub->footer(examples);
  return sub;
}

CLI::Option* parsed(CLI::App* app, const std::string& names, const std::string& value,
                    const std::string& doc, std::function<std::string(const std::string&)> parse) {
  // The first long name, if there is one: what messages call the option.
  const std::size_t at = names.find("--");
  const std::string shown = at == std::string::npos ? names.substr(names.rfind(',') + 1)
                                                    : names.substr(at, names.find(',', at) - at);
  return app
      ->add_option_function<std::string>(
          names,
          [parse = std::move(parse), shown](const std::string& text) {
            // What is wrong is told to CLI11 by an exception; the words are ours.
            const std::string problem = parse(text);
            if (!problem.empty()) throw CLI::ValidationError(shown, problem);
          },
          doc)
      ->type_name(value);
}

CLI::Option* path(CLI::App* app, const std::string& names, std::optional<std::string>& out,
                  const std::string& doc) {
  return parsed(app, names, "FILE", doc, [&out](const std::string& text) -> std::string {
    out = text;
    return text.empty() ? "a name is wanted" : "";
  });
}

CLI::Option* repeated(CLI::App* app, const std::string& names, std::vector<std::string>& out,
                      const std::string& value, const std::string& doc) {
  // Without allow_extra_args(false) CLI11 would take the next arguments too, up to an option.
  return app->add_option(names, out, doc)->type_name(value)->allow_extra_args(false);
}

CLI::Option* file(CLI::App* app, const std::string& name, std::string& out,
                  const std::string& doc) {
  return app->add_option(name, out, doc)->type_name(name)->required();
}

CLI::Option* files(CLI::App* app, std::vector<std::string>& out, const std::string& doc) {
  return app->add_option("FILE", out, doc)->type_name("FILE")->required();
}

CLI::Option* slice(CLI::App* app, SliceOption& out, const std::string& doc) {
  return parsed(app, "--slice", "I/N", doc, [&out](const std::string& text) -> std::string {
    const std::size_t slash = text.find('/');
    std::int64_t number = 0, of = 0;
    if (slash == text.npos || !parse_integer(text.substr(0, slash), 1, 1'000'000, number).empty() ||
        !parse_integer(text.substr(slash + 1), 1, 1'000'000, of).empty() || number > of) {
      return fmt::format("'{}' is not a slice, as 1/4", text);
    }
    out = {static_cast<std::uint64_t>(number), static_cast<std::uint64_t>(of)};
    return {};
  });
}

CLI::Option* seconds(CLI::App* app, const std::string& names, std::optional<double>& out,
                     const std::string& doc) {
  return parsed(app, names, "S", doc,
                [&out](const std::string& text) { return parse_seconds(text, out.emplace()); });
}

void world(CLI::App* sub, WorldOptions& out, const std::string& doc) {
  // "none" leaves `box` set but without a size: unbounded space is a choice, no default.
  parsed(sub, "--box", "X,Y,Z", doc, [&out](const std::string& text) -> std::string {
    BoxOption& box = out.box.emplace();
    return text == "none" ? "" : parse_size(text, box.size.emplace());
  });
  parsed(sub, "--origin", "X,Y,Z",
         "the lowest cell of the box, given here or in the file (default: where the file says for "
         "its own, else such that the start is in the middle)",
         [&out](const std::string& text) { return parse_cell(text, out.origin.emplace()); });
  sub->add_flag("--periodic", out.periodic, "the sides of the box wrap around");
}

void lattice(CLI::App* sub, std::optional<Lattice>& out) {
  choice<std::optional<Lattice>, Lattice>(
      sub, "--lattice", out, {{"cubic", Lattice::cubic}, {"hexagonal", Lattice::hexagonal}},
      "the lattice of a file that does not say it, as no .vox does (default: cubic)");
}

void add_sides(CLI::App& sub, std::vector<std::string>& sides, const char* what) {
  // One argument for each --sides: CLI11's lists go on until the next option, over files too.
  parsed(&sub, "--sides", "SIDES", what,
         [&sides](const std::string& text) { return parse_sides(text, sides); })
      ->allow_extra_args(false)
      ->trigger_on_parse();
}

CLI::Option* moment(CLI::App* app, const std::string& names, std::optional<double>& out,
                    const std::string& doc) {
  return parsed(app, names, "T", doc,
                [&out](const std::string& text) { return parse_moment(text, out.emplace()); });
}

void mesh_bricks(CLI::App* sub, MeshOptions& out) {
  integer(sub, "--bricks", out.bricks, 1, 1'000'000,
          "of a mesh (.stl .obj .off .ply): about so many; stigc voxelise has more options "
          "(default: 100)");
}

void palette(CLI::App* sub, Palette& out) {
  choice(sub, "--palette", out,
         {{"file", Palette::file},
          {"okabe-ito", Palette::okabe_ito},
          {"tol-bright", Palette::tol_bright}},
         "colours of bricks in pictures: the file's (default), or others that can be told apart "
         "with any kind of colour vision");
}

}  // namespace stig::cli
