// SPDX-License-Identifier: MIT
// The frames of a film as files: pictures in a folder, or a video.
#pragma once

#include <string>

#include "film.h"
#include "uses.h"

namespace stig::cli {

/// Before the work: may the film be written? Makes the folder of frames. An exit code.
int prepare_film(const std::string& output, const std::string& ending, std::size_t frames,
                 const App& app);

/// Draws and writes the frames; an exit code. `ending` is film_ending's.
int write_film(const Film& film, const FilmTimes& times, bool orbit, const std::string& output,
               const std::string& ending, App& app);

/// Where the frames go when nothing makes a video of them: "run.mp4" becomes "run-frames".
std::string frames_folder(const std::string& output);

}  // namespace stig::cli
