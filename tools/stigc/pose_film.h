// SPDX-License-Identifier: MIT
// Films of physical runs, from outside or through a robot's camera.
#pragma once

#include <memory>
#include <optional>

#include "film.h"
#include "physical/trace/pose_trace.h"
#include "uses.h"

namespace stig::cli {

/// The film of a trace of simulate; problems are reported, with an exit code that is not kOk.
std::optional<Film> pose_film(const RenderOptions& options,
                              const std::shared_ptr<const PoseTrace>& trace, const App& app,
                              int& code);

}  // namespace stig::cli
