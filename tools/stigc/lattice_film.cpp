// SPDX-License-Identifier: MIT
#include "lattice_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "lattice/growth_glb.h"
#include "lattice/run_pictures.h"
#include "outputs.h"
#include "structure_input.h"
#include "trace_rules.h"

namespace stig::cli {
namespace {

/// What is shown: bricks in the order in which they came, `start` of them there from the beginning.
struct Growth {
  Lattice lattice = Lattice::cubic;
  std::vector<PlacedBrick> bricks;
  std::size_t start = 0, events = 0;
  std::vector<Brick> kinds;
  std::string title;
  bool floor = false;
  /// For each event, how many bricks are shown behind it: a slice may leave some out.
  std::vector<std::size_t> shown;
};

bool is_shown(const std::vector<Slice>& slices, Cell cell) {
  const std::array<double, 3> at = {static_cast<double>(cell.x), static_cast<double>(cell.y),
                                    static_cast<double>(cell.z)};
  return std::all_of(slices.begin(), slices.end(), [&](const Slice& slice) {
    const double along = at.at(static_cast<std::size_t>(slice.axis));
    return along >= slice.low && along <= slice.high;
  });
}

Structure whole_of(const Growth& growth) { return Structure(growth.lattice, growth.bricks); }

Colour highest_colour(const Growth& growth) {
  Colour most = 0;
  for (const PlacedBrick& brick : growth.bricks) most = std::max(most, brick.brick);
  return most;
}

RunPictureOptions picture_options(const RenderOptions& options, const Growth& growth) {
  // As the usual camera has it (lattice/view.h).
  const double usual = growth.lattice == Lattice::cubic ? -52 : -30;
  RunPictureOptions out;
  out.format = film_ending(options) == ".svg" ? PictureFormat::svg : PictureFormat::png;
  out.width = *options.width;
  out.height = *options.height;
  if (!options.no_title) out.title = printable(growth.title);
  out.palette = options.palette;
  out.floor = growth.floor;
  out.ghost = options.ghost;
  out.legend = !options.no_legend;
  out.azimuth = options.view.azimuth.value_or(usual * std::numbers::pi / 180);
  out.elevation = options.view.elevation.value_or(std::numbers::pi / 6);
  out.orbit = options.view.orbit;
  return out;
}

/// Draws a growing structure moment by moment.
class GrowthPictures {
 public:
  GrowthPictures(const Growth& growth, const RenderOptions& options)
      : growth_(growth),
        with_words_(!options.no_title),
        pictures_(whole_of(growth), growth.kinds, picture_options(options, growth)),
        now_(growth.lattice) {}

  std::string draw(double time, double turn) {
    const std::size_t event =
        std::min(growth_.events, static_cast<std::size_t>(std::max(0.0, std::floor(time + 1e-9))));
    if (last_ == std::pair(event, turn)) return bytes_;
    const std::size_t shown = event == 0 ? growth_.start : growth_.shown[event - 1];
    for (; placed_ < shown; ++placed_) {
      now_.place(growth_.bricks[placed_].at, growth_.bricks[placed_].brick);
    }
    last_ = {event, turn};
    bytes_ = pictures_.draw(now_, caption(event), turn);
    return bytes_;
  }

 private:
  std::string caption(std::size_t event) const {
    if (!with_words_) return {};
    return growth_.events == 0 ? fmt::format("{} bricks", growth_.bricks.size())
                               : fmt::format("{} of {} bricks placed", event, growth_.events);
  }

  const Growth& growth_;
  bool with_words_;
  RunPictures pictures_;
  Structure now_;
  std::size_t placed_ = 0;
  std::optional<std::pair<std::size_t, double>> last_;  ///< of which the bytes are
  std::string bytes_;
};

/// Bricks that come between one frame and the next, at the second's time.
std::vector<GrowthStep> steps_of(const Growth& growth, const FilmTimes& times) {
  std::vector<GrowthStep> out;
  std::size_t placed = 0;
  for (std::size_t frame = 0; frame < times.frames; ++frame) {
    const double at = std::floor(std::max(0.0, times.at(frame)) + 1e-9);
    const std::size_t event = std::min(growth.events, static_cast<std::size_t>(at));
    const std::size_t shown = event == 0 ? growth.start : growth.shown[event - 1];
    if (shown == placed && frame > 0) continue;
    const auto begin = growth.bricks.begin();
    out.push_back({times.seconds(frame),
                   {begin + static_cast<std::ptrdiff_t>(placed),
                    begin + static_cast<std::ptrdiff_t>(shown)}});
    placed = shown;
  }
  return out;
}

Film film_of(const std::shared_ptr<const Growth>& growth, const RenderOptions& options) {
  Film film;
  film.time = growth->events > 0 ? FilmTime::bricks : FilmTime::none;
  film.end = static_cast<double>(growth->events);
  // Made with the first picture: a .glb takes none.
  auto pictures = std::make_shared<std::unique_ptr<GrowthPictures>>();
  film.picture = [growth, pictures, options](double time, double turn) {
    if (!*pictures) *pictures = std::make_unique<GrowthPictures>(*growth, options);
    return (*pictures)->draw(time, turn);
  };
  film.glb = [growth, options](const FilmTimes& times, std::string& problem) -> std::string {
    const std::vector<Brick> kinds =
        recoloured(growth->kinds, options.palette, highest_colour(*growth));
    if (growth->bricks.size() <= kMostGrowing) {
      return print_growth_glb(growth->lattice, steps_of(*growth, times), kinds);
    }
    problem = fmt::format("an animated .glb takes {} bricks at most, not {}: show fewer by --slice",
                          kMostGrowing, growth->bricks.size());
    return {};
  };
  return film;
}

}  // namespace

std::optional<Film> lattice_film(const RenderOptions& options, const std::string& bytes,
                                 const App& app) {
  Diagnostics diagnostics;
  const std::optional<Trace> trace = read_trace(options.file, bytes, diagnostics);
  app.report(diagnostics);
  const std::optional<RuleSet> rules = trace ? rules_of(*trace, options.file, app) : std::nullopt;
  if (!rules) return std::nullopt;
  if (const auto problem = problem_of_events(*trace, *rules)) {
    app.complain(fmt::format("'{}': {}", printable(options.file), *problem));
    return std::nullopt;
  }
  auto growth = std::make_shared<Growth>();
  growth->lattice = rules->lattice;
  growth->kinds = rules->bricks;
  growth->title = rules->title.empty() ? rules->name : rules->title;
  growth->floor = rules->floor;
  growth->events = trace->events.size();
  for (const PlacedBrick& brick : rules->start) {
    if (is_shown(options.slices, brick.at)) growth->bricks.push_back(brick);
  }
  growth->start = growth->bricks.size();
  for (const Deposit& event : trace->events) {
    if (is_shown(options.slices, event.site)) growth->bricks.push_back({event.site, event.colour});
    growth->shown.push_back(growth->bricks.size());
  }
  return film_of(growth, options);
}

std::optional<Film> structure_film(const RenderOptions& options, const App& app) {
  const auto loaded = read_structure(options.file, options.lattice, app);
  if (!loaded) return std::nullopt;
  auto growth = std::make_shared<Growth>();
  growth->lattice = loaded->structure.lattice();
  growth->kinds = loaded->bricks;
  growth->title = file_name(options.file);
  for (const PlacedBrick& brick : loaded->structure.bricks()) {
    if (is_shown(options.slices, brick.at)) growth->bricks.push_back(brick);
  }
  growth->start = growth->bricks.size();
  return film_of(growth, options);
}

}  // namespace stig::cli
