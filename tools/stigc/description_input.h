// SPDX-License-Identifier: MIT
// stigc import of URDF and SDF.
#pragma once

#include "app.h"
#include "base/source.h"
#include "uses.h"

namespace stig::cli {

/// An exit code. A scene's parts are written beside it.
int import_described(const ImportOptions& options, const SourceRef& source, App& app);

}  // namespace stig::cli
