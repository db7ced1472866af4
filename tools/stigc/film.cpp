// SPDX-License-Identifier: MIT
#include "film.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace stig::cli {
namespace {

constexpr double kUsualLength = 15;               ///< s of a film, at most unless more is asked for
constexpr double kRoundLength = 8;                ///< s, once round a structure
constexpr double kUsualRate = 5;                  ///< bricks a second, at least
constexpr double kVideoRate = 25, kGifRate = 10;  ///< frames a second

double usual_speed(FilmTime time, double span) {
  switch (time) {
    case FilmTime::bricks:
      return std::max(kUsualRate, span / kUsualLength);
    case FilmTime::seconds:
      // Never slower than the run was.
      return std::max(1.0, span / kUsualLength);
    case FilmTime::none:
      return 1;
  }
  return 1;
}

}  // namespace

double FilmTimes::at(std::size_t frame) const {
  return std::min(to, from + speed * seconds(frame));
}

std::string film_ending(const RenderOptions& options) {
  if (options.output.ends_with('/')) return {};
  const std::filesystem::path path(options.output);
  const std::string ending = path.extension().string();
  if (std::find(kFilmEndings.begin(), kFilmEndings.end(), ending) != kFilmEndings.end()) {
    return ending;
  }
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) ? std::string{} : ending;
}

RenderOptions with_size(RenderOptions options) {
  const bool small = film_ending(options) == ".gif";
  options.width = options.width.value_or(small ? 600 : 1200);
  options.height = options.height.value_or(small ? 400 : 800);
  return options;
}

FilmTimes film_times(const RenderOptions& options, const Film& film) {
  FilmTimes out;
  out.from = options.from.value_or(0);
  // What has no time of its own is turned.
  out.to = options.to.value_or(film.time == FilmTime::none ? out.from + kRoundLength : film.end);
  out.to = std::max(out.from, out.to);
  out.fps = options.fps.value_or(film_ending(options) == ".gif" ? kGifRate : kVideoRate);
  const double span = out.to - out.from;
  out.speed = options.speed.value_or(usual_speed(film.time, span));
  // The last frame is of the last moment; of sums of steps that hit it by a hair, none is more.
  const double steps = std::ceil(span / out.speed * out.fps - 1e-6);
  out.frames = static_cast<std::size_t>(std::clamp(steps, 0.0, 1e9)) + 1;
  return out;
}

}  // namespace stig::cli
