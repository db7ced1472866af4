// SPDX-License-Identifier: MIT
// A run or a structure as something that pictures are taken of, whatever its kind.
//
// Time is simulated seconds of physical runs and the number of bricks placed on the lattice. All
// pictures of one film have one size and one camera, which is set for the whole run and not for
// what a picture happens to show.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app.h"
#include "uses.h"

namespace stig::cli {

enum class FilmTime : std::uint8_t { seconds, bricks, none };

/// When a film's frames are, from first to last.
struct FilmTimes {
  double from = 0, to = 0;  ///< of the run
  double fps = 25, speed = 1;
  std::size_t frames = 1;

  /// The run's time at a frame, s.
  double at(std::size_t frame) const;
  /// The film's time at a frame, s.
  double seconds(std::size_t frame) const { return static_cast<double>(frame) / fps; }
};

struct Film {
  FilmTime time = FilmTime::none;
  double end = 0;  ///< of the run
  /// The bytes of a picture at a moment, the camera turned by so many rad; empty when it cannot be
  /// drawn. Moments do not fall from call to call.
  std::function<std::string(double time, double turn)> picture;
  /// An animated .glb; empty with `problem` set when there can be none.
  std::function<std::string(const FilmTimes& times, std::string& problem)> glb;
};

/// What can be written besides a folder of frames.
inline constexpr std::array<std::string_view, 6> kFilmEndings = {".png",  ".svg", ".mp4",
                                                                 ".webm", ".gif", ".glb"};
/// "film.mp4" is an .mp4; empty for a folder, which has a slash at its end, no ending, or is there.
std::string film_ending(const RenderOptions& options);
/// Width and height where the command line does not say them.
RenderOptions with_size(RenderOptions options);
/// Fills in what the command line does not say.
FilmTimes film_times(const RenderOptions& options, const Film& film);

}  // namespace stig::cli
