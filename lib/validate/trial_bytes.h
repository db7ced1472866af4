// SPDX-License-Identifier: MIT
// A run that is over, as bytes and back: so that runs outlive the process that made them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "validate/trial.h"
#include "validate/uses.h"

namespace stig::validate {

std::string trial_bytes(const Trial& trial);
/// Nothing where the bytes are of no run.
std::optional<Trial> trial_of(std::string_view bytes);

}  // namespace stig::validate
